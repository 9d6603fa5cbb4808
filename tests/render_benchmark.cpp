// Times of a 1280 x 720 frame from scene to file, and how they split. The share is that of
// read-back and PNG in the whole.
//
// Milliseconds are the machine's, so quote a frame as a multiple of `yardstick` in the same run:
// the time in which stb, at its default settings and without the kit's hook, packs the box's film
// frame.
//
//                              the bar   of the yardstick
//   yardstick                   37 ms         1
//   box/film                    35 ms         0.95
//   box/draft                   18 ms         0.49
//   boxes/thousand_film         72 ms         1.95
#include <benchmark/benchmark.h>

#include <chrono>

#include "render/draw/renderer.hpp"
#include "render_gallery.hpp"
#include "render_picture.hpp"
#include "render_yardstick.hpp"

namespace {

render::Scene one_box() {
  render::Scene scene;
  const Eigen::AngleAxisd turn(0.7, render::Vec3(1.0, 2.0, 0.5).normalized());
  scene.boxes.push_back({{{0.0, 0.0, 1.0}, turn.toRotationMatrix()},
                         {0.7, 0.5, 0.3},
                         {render::palette::orange, render::palette::blue, 0.0F}});
  return scene;
}

const render::Bounds box_bounds{{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.9}};

render::Camera camera_of(const render::Bounds& bounds) {
  return render::camera_framing(bounds, {0.8, -2.0, 0.9}, 16.0 / 9.0);
}

void time_frames(benchmark::State& state, const render::Scene& scene, const render::Bounds& bounds,
                 render::Quality quality) {
  using Clock = std::chrono::steady_clock;
  const tests::ScratchFolder folder;
  const render::PictureOptions options{1280, 720, quality, false};
  const render::Camera camera = camera_of(bounds);
  render::Renderer renderer;
  renderer.picture(scene, camera, options);  // compiles the shaders
  double draw = 0.0;
  double read_back = 0.0;
  double png = 0.0;
  while (state.KeepRunning()) {
    const render::Image image = renderer.picture(scene, camera, options);
    const Clock::time_point start = Clock::now();
    render::write_png(image, folder.path() / "frame.png");
    png += std::chrono::duration<double>(Clock::now() - start).count();
    draw += renderer.last_timing().draw;
    read_back += renderer.last_timing().read_back;
  }
  const double milliseconds = 1e3 / static_cast<double>(state.iterations());
  state.counters["draw_ms"] = draw * milliseconds;
  state.counters["read_ms"] = read_back * milliseconds;
  state.counters["png_ms"] = png * milliseconds;
  state.counters["share_percent"] = 100.0 * (read_back + png) / (draw + read_back + png);
}

void box(benchmark::State& state, render::Quality quality) {
  time_frames(state, one_box(), box_bounds, quality);
}

void boxes(benchmark::State& state, render::Quality quality) {
  time_frames(state, tests::heap_of_boxes(10, 10), {{-5.0, -5.0, 0.0}, {5.0, 5.0, 10.0}}, quality);
}

void yardstick(benchmark::State& state) {
  const render::PictureOptions options{1280, 720, render::Quality::film, false};
  const render::Image image = render::Renderer().picture(one_box(), camera_of(box_bounds), options);
  while (state.KeepRunning()) benchmark::DoNotOptimize(tests::yardstick_png_size(image));
}

BENCHMARK_CAPTURE(box, film, render::Quality::film)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(box, draft, render::Quality::draft)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(boxes, thousand_film, render::Quality::film)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(yardstick)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();

#include "render/draw/renderer.hpp"

#include <chrono>
#include <stdexcept>

#include "render/draw/gl_context.hpp"
#include "render/draw/labels.hpp"
#include "render/draw/painter.hpp"
#include "render/draw/read_back.hpp"
#include "render/draw/scene_check.hpp"

namespace render {
namespace {

constexpr int report_samples = 64;

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> span = now - start_;
    start_ = now;
    return span.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

std::unique_ptr<GlContext> current_context() {
  std::unique_ptr<GlContext> context = open_gl_context();
  context->make_current();
  return context;
}

void check(const PictureOptions& options) {
  constexpr int longest_side = 8192;
  if (options.width < 1 || options.height < 1 || options.width > longest_side ||
      options.height > longest_side) {
    throw std::invalid_argument("a picture of " + std::to_string(options.width) + " x " +
                                std::to_string(options.height) +
                                " pixels; each side must be 1 to 8192");
  }
}

// The depths between which everything lies that the picture shows.
void set_depth_range(View& view, const Scene& scene) {
  const Bounds bounds = bounds_of(scene);
  const Vec3 half = (bounds.high - bounds.low) / 2;
  const double middle = view.depth(bounds.low + half);
  const double reach = view.axes.backward.cwiseAbs().dot(half);
  const double spare = 0.05 * (reach + view.distance);
  view.nearest_depth = std::max(middle - reach - spare, 0.01 * view.distance);
  view.farthest_depth = std::max(middle + reach + spare, view.distance + 2 * ground_reach(view));
}

}  // namespace

struct Renderer::Device {
  std::unique_ptr<GlContext> context = current_context();
  Gl gl = gl_functions([this](const char* name) { return context->procedure(name); });
  Painter painter{gl};
  Reader reader;
  Timing timing;
};

Renderer::Renderer() : device_(std::make_unique<Device>()) {}

Renderer::~Renderer() = default;

Image Renderer::picture(const Scene& scene, const Camera& camera, const PictureOptions& options) {
  check(options);
  check_scene(scene);
  Stopwatch stopwatch;
  Device& device = *device_;
  device.context->make_current();
  View view(camera, options.width, options.height);
  set_depth_range(view, scene);
  const int samples = options.quality == Quality::film ? 2 : 1;
  device.painter.load(scene, view, samples, options.white);
  device.timing = {};

  Image image;
  if (options.quality == Quality::report) {
    for (const LightSample& light : light_samples(view, report_samples)) {
      device.painter.draw_sampled(light);
      device.gl.Finish();
      device.timing.draw += stopwatch.lap();
      device.reader.add(device.painter.canvas(), options.width, options.height);
      device.timing.read_back += stopwatch.lap();
    }
    image = device.reader.mean(options.width, options.height);
  } else {
    device.painter.draw_filtered();
    device.gl.Finish();
    device.timing.draw = stopwatch.lap();
    image = device.reader.picture(device.painter.canvas(), options.width, options.height, samples);
  }
  device.timing.read_back += stopwatch.lap();
  draw_labels(image, view, scene);
  device.timing.labels = stopwatch.lap();
  return image;
}

std::string Renderer::device() const {
  const auto text = [this](GLenum name) {
    return std::string(reinterpret_cast<const char*>(device_->gl.GetString(name)));
  };
  device_->context->make_current();
  return device_->context->name() + ", " + text(GL_VERSION) + ", " + text(GL_RENDERER);
}

Timing Renderer::last_timing() const { return device_->timing; }

}  // namespace render

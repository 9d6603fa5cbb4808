// Draws the gallery: for eyes, and for the test that the number of threads changes no byte.
//   render_gallery_program FILE WIDTH HEIGHT draft|film|report
#include <iostream>
#include <stdexcept>
#include <string>

#include "common/course/run_main.hpp"
#include "render/draw/renderer.hpp"
#include "render_gallery.hpp"

namespace {

render::Quality quality_of(const std::string& name) {
  if (name == "draft") return render::Quality::draft;
  if (name == "film") return render::Quality::film;
  if (name == "report") return render::Quality::report;
  throw std::invalid_argument("quality " + name);
}

}  // namespace

int main(int argc, char** argv) {
  return common::run_main([&] {
    if (argc != 5) throw std::invalid_argument("usage: FILE WIDTH HEIGHT draft|film|report");
    render::PictureOptions options;
    options.width = std::stoi(argv[2]);
    options.height = std::stoi(argv[3]);
    options.quality = quality_of(argv[4]);
    render::Renderer renderer;
    std::cerr << renderer.device() << '\n';
    const render::Camera camera =
        tests::gallery_camera(static_cast<double>(options.width) / options.height);
    render::write_png(renderer.picture(tests::gallery_scene(), camera, options), argv[1]);
  });
}

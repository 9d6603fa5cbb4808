// Opens off-screen GL, says which, and draws one test frame:  render_doctor --out FILE
#include <iostream>
#include <stdexcept>
#include <string>

#include "common/course/run_main.hpp"
#include "render/draw/renderer.hpp"

int main(int argc, char** argv) {
  return common::run_main([&] {
    if (argc != 3 || std::string(argv[1]) != "--out") {
      throw std::invalid_argument(std::string("usage: ") + argv[0] + " --out FILE");
    }
    render::Renderer renderer;
    std::cout << renderer.device() << '\n';
    render::Scene scene;
    scene.boxes.emplace_back();
    scene.boxes.back().placement.position.z() = 1.0;
    const render::PictureOptions options{640, 360, render::Quality::film, false};
    const render::Camera camera =
        render::camera_framing(render::bounds_of(scene), {1.0, -2.0, 0.9}, 640.0 / 360.0);
    render::write_png(renderer.picture(scene, camera, options), argv[2]);
  });
}

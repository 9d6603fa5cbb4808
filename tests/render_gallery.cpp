#include "render_gallery.hpp"

#include <cmath>
#include <numbers>

namespace tests {
namespace {

using render::Mat3;
using render::Placement;
using render::Scene;
using render::Vec3;
namespace palette = render::palette;

Mat3 turn(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

void add_solids(Scene& scene) {
  scene.boxes.push_back({Placement{{0.0, 0.0, 1.0}, turn(0.7, {1.0, 2.0, 0.5})},
                         {0.6, 0.4, 0.22},
                         {palette::orange, palette::blue, 0.0F}});
  scene.spheres.push_back({Placement{{-1.5, 0.4, 0.45}, turn(0.5, {1.0, 0.3, 0.0})},
                           0.45,
                           {palette::green, palette::sky, 0.0F}});
  scene.cylinders.push_back({Placement{{-0.7, -1.1, 0.35}, Mat3::Identity()},
                             0.28,
                             0.35,
                             {palette::purple, palette::ink, 0.0F}});
  scene.capsules.push_back({Placement{{1.2, -1.0, 0.22}, turn(1.5708, {1.0, 0.6, 0.0})},
                            0.22,
                            0.4,
                            {palette::sky, palette::vermilion, 0.0F}});
  const Mat3 mirrored = turn(0.4, Vec3::UnitZ()) * Vec3(-1.0, 1.0, 1.4).asDiagonal();
  scene.boxes.push_back({Placement{{2.2, 0.6, 0.42}, mirrored},
                         Vec3::Constant(0.3),
                         {palette::vermilion, palette::yellow, 0.0F}});
}

void add_ghosts(Scene& scene) {
  for (int i = 0; i < 3; ++i) {
    const double x = 1.0 + 0.9 * i;
    const Placement placement{{x, 1.9, 0.9 - 0.15 * i}, turn(0.5 * i, {0.3, 1.0, 0.2})};
    scene.boxes.push_back(
        {placement,
         {0.35, 0.25, 0.12},
         {palette::orange, palette::blue, 0.75F - 0.25F * static_cast<float>(i)}});
  }
}

void add_sheets(Scene& scene) {
  render::Mesh pyramid;
  pyramid.placement.position = {-2.6, -0.8, 0.0};
  pyramid.vertices = {
      {-0.4, -0.4, 0.0}, {0.4, -0.4, 0.0}, {0.4, 0.4, 0.0}, {-0.4, 0.4, 0.0}, {0.0, 0.0, 0.8}};
  pyramid.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 3, 2}, {0, 2, 1}};
  pyramid.paint = {palette::yellow, palette::blue, 0.0F};
  pyramid.lit = {false, true, false, true, false, false};
  scene.meshes.push_back(pyramid);

  render::Cloth cloth;
  cloth.rows = 14;
  cloth.columns = 18;
  for (int row = 0; row < cloth.rows; ++row) {
    for (int column = 0; column < cloth.columns; ++column) {
      const double u = 0.08 * column;
      const double v = 0.08 * row;
      cloth.points.emplace_back(-2.9 + u, 1.2 + v, 0.9 + 0.12 * std::sin(5.0 * u + 2.0 * v));
    }
  }
  cloth.paint = {palette::sky, palette::vermilion, 0.0F};
  scene.cloths.push_back(cloth);
}

void add_decoration(Scene& scene) {
  const Vec3 centre(0.0, 0.0, 1.0);
  const Vec3 momentum = centre + Vec3(0.35, 0.1, 1.4);
  const Vec3 spin = centre + Vec3(-0.25, -0.1, 1.35);
  scene.arrows.push_back({centre, momentum, palette::vermilion, 0.05});
  scene.arrows.push_back({centre, spin, palette::green, 0.05});
  scene.labels.push_back({momentum, "L", palette::vermilion, 20.0});
  scene.labels.push_back({spin, "ω₀", palette::green, 20.0});
  scene.labels.push_back({{-1.5, 0.4, 0.95}, "m = 2 kg", palette::ink, 16.0});
  scene.contacts.push_back({{-1.5, 0.4, 0.0}, Vec3::UnitZ(), 0.5, palette::vermilion});
  render::Trail trail;
  for (int i = 0; i <= 60; ++i) {
    const double angle = -0.9 * std::numbers::pi + 0.02 * std::numbers::pi * i;
    trail.points.emplace_back(1.9 * std::cos(angle), 1.9 * std::sin(angle), 1.2);
  }
  trail.width = 3.0;
  scene.trails.push_back(trail);
}

}  // namespace

Scene gallery_scene() {
  Scene scene;
  add_solids(scene);
  add_ghosts(scene);
  add_sheets(scene);
  add_decoration(scene);
  return scene;
}

render::Camera gallery_camera(double aspect) {
  const render::Bounds bounds{{-3.0, -1.8, 0.0}, {3.0, 2.2, 2.4}};
  return render::camera_framing(bounds, {0.35, -2.0, 0.95}, aspect, 0.03);
}

Scene heap_of_boxes(int rows, int layers) {
  Scene scene;
  for (int i = 0; i < rows * rows * layers; ++i) {
    const double x = i % rows - 0.5 * (rows - 1);
    const double y = i / rows % rows - 0.5 * (rows - 1);
    const int layer = i / (rows * rows);
    const double z = 0.6 + layer;
    const Mat3 R = turn(0.37 * i, {std::sin(1.0 * i), std::cos(2.0 * i), 0.5});
    const render::Colour colour = i % 3 == 0   ? palette::orange
                                  : i % 3 == 1 ? palette::sky
                                               : palette::green;
    scene.boxes.push_back(
        {Placement{{x, y, z}, R}, {0.35, 0.28, 0.2}, {colour, palette::blue, 0.0F}});
  }
  return scene;
}

}  // namespace tests

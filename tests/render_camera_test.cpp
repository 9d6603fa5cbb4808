#include "render/draw/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "catch.hpp"
#include "render/draw/view.hpp"

namespace {

using render::Bounds;
using render::Camera;
using render::Mat3;
using render::Scene;
using render::Vec3;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("A framing camera sees every corner of its bounds and touches the margin",
          "[render_camera]") {
  const double aspect = GENERATE(0.3, 1.0, 16.0 / 9.0, 5.0);
  const Bounds bounds = GENERATE(Bounds{{-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}},
                                 Bounds{{-50.0, 3.0, 0.0}, {20.0, 3.5, 0.2}},
                                 Bounds{{1e4, 0.0, -1e-3}, {1e4 + 1.0, 0.0, 1e-3}});
  constexpr double margin = 0.08;
  for (int i = 0; i < 40; ++i) {
    // All around, and straight from above and below.
    const Vec3 direction(std::sin(0.7 * i), std::cos(0.7 * i), std::tan(1.57 * (i - 20) / 20.0));
    const Camera camera = render::camera_framing(bounds, direction, aspect, margin);
    const render::View view(camera, static_cast<int>(1000 * aspect), 1000);
    double largest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 point((corner & 1) != 0 ? bounds.high.x() : bounds.low.x(),
                       (corner & 2) != 0 ? bounds.high.y() : bounds.low.y(),
                       (corner & 4) != 0 ? bounds.high.z() : bounds.low.z());
      const Eigen::Vector4d clip = view.clip(point);
      REQUIRE(clip.w() > 0.0);
      largest = std::max({largest, std::abs(clip.x() / clip.w()), std::abs(clip.y() / clip.w())});
    }
    INFO("direction " << direction.transpose() << ", aspect " << aspect);
    CHECK(largest < 1.0 - margin + 1e-3);
    CHECK(largest > 1.0 - margin - 1e-2);
  }
}

TEST_CASE("A framing camera refuses what it cannot frame", "[render_camera]") {
  const Vec3 direction(1.0, -2.0, 1.0);
  CHECK_THROWS_AS(render::camera_framing({Vec3::Constant(no_number), Vec3::Ones()}, direction, 1.0),
                  std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({Vec3::Ones(), -Vec3::Ones()}, direction, 1.0),
                  std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({Vec3::Ones(), Vec3::Ones()}, direction, 1.0),
                  std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({}, Vec3::Zero(), 1.0), std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({}, {0.0, unbounded, 1.0}, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({}, direction, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(render::camera_framing({}, direction, no_number), std::invalid_argument);
}

TEST_CASE("Bounds hold turned and swollen solids tightly", "[render_camera]") {
  Scene scene;
  const Mat3 quarter = Eigen::AngleAxisd(std::acos(-1.0) / 2, Vec3::UnitZ()).toRotationMatrix();
  scene.capsules.push_back({{Vec3(1.0, 2.0, 3.0), 2.0 * quarter}, 0.25, 0.5, {}});
  const Bounds bounds = render::bounds_of(scene);
  CHECK((bounds.low - Vec3(0.5, 1.5, 1.5)).norm() < 1e-12);
  CHECK((bounds.high - Vec3(1.5, 2.5, 4.5)).norm() < 1e-12);
}

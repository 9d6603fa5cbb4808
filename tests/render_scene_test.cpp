#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "catch.hpp"
#include "random.hpp"
#include "render/draw/camera.hpp"
#include "render/draw/renderer.hpp"
#include "render/draw/view.hpp"
#include "render/text/text.hpp"
#include "render_gallery.hpp"
#include "render_picture.hpp"
#include "values.hpp"

namespace {

using render::Camera;
using render::Image;
using render::Mat3;
using render::PictureOptions;
using render::Quality;
using render::Renderer;
using render::Scene;
using render::Vec3;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Within this share of differing pixels, another processor's rounding is the likely cause.
constexpr double golden_tolerance = 0.001;

PictureOptions small(Quality quality) { return {320, 180, quality, false}; }

std::string refusal_of(const Scene& scene) {
  Renderer renderer;
  try {
    renderer.picture(scene, Camera{}, small(Quality::draft));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// Red, green and blue of the pixel where a point of the world shows.
std::array<int, 3> pixel_at(const Image& image, const Camera& camera, const Vec3& point) {
  const Eigen::Vector2d pixel = *render::View(camera, image.width, image.height).pixel(point);
  const auto index =
      3 * (static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(image.width) +
           static_cast<std::size_t>(pixel.x()));
  return {image.rgb[index], image.rgb[index + 1], image.rgb[index + 2]};
}

bool is_darker(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return a[0] < b[0] && a[1] < b[1] && a[2] < b[2];
}

Scene one_box(const Mat3& world_from_body) {
  Scene scene;
  scene.boxes.push_back({{Vec3(0.0, 0.0, 1.0), world_from_body},
                         Vec3(0.5, 0.4, 0.3),
                         {render::palette::green, render::palette::vermilion, 0.0F}});
  return scene;
}

}  // namespace

TEST_CASE("The z axis turns to any direction by the shortest way", "[render_scene]") {
  tests::Random random(11);
  std::vector<Vec3> directions{Vec3::UnitX(),     Vec3::UnitY(),        Vec3::UnitZ(),
                               -Vec3::UnitZ(),    {1e-9, 0.0, -1.0},    {0.0, -1e-200, -1.0},
                               {0.0, 0.0, 1e200}, {1e-200, 1e-200, 0.0}};
  for (int i = 0; i < 1000; ++i)
    directions.push_back(random.uniform(0.1, 10.0) * random.direction());
  for (const Vec3& direction : directions) {
    INFO(tests::text(direction));
    const Mat3 R = render::z_axis_towards(direction);
    const Vec3 u = direction.stableNormalized();
    CHECK(tests::difference(Mat3(R.transpose() * R), Mat3(Mat3::Identity())) <= 16.0 * tests::eps);
    CHECK(std::abs(R.determinant() - 1.0) <= 16.0 * tests::eps);
    CHECK(tests::difference(Vec3(R.col(2)), u) <= 4.0 * tests::eps);
    // The shortest way turns about an axis across z: the trace is 1 + 2 u_z, and the matrix is
    // symmetric in x and y.
    CHECK(std::abs(R.trace() - (1.0 + 2.0 * u.z())) <= 16.0 * tests::eps);
    CHECK(std::abs(R(0, 1) - R(1, 0)) <= 2.0 * tests::eps);
  }
}

TEST_CASE("Each body shows its colour where it stands", "[render_scene]") {
  const Quality quality = GENERATE(Quality::draft, Quality::film, Quality::report);
  Scene scene;
  const Vec3 left(-1.5, 0.0, 0.5);
  const Vec3 right(1.5, 0.0, 0.5);
  scene.boxes.push_back({{left, Mat3::Identity()},
                         Vec3::Constant(0.5),
                         {{1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, 0.0F}});
  scene.spheres.push_back(
      {{right, Mat3::Identity()}, 0.5, {{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}, 0.0F}});
  const Camera camera =
      render::camera_framing({{-2.2, -1.0, 0.0}, {2.2, 1.0, 1.2}}, {0.0, -2.0, 1.0}, 16.0 / 9.0);
  Renderer renderer;
  const Image image = renderer.picture(scene, camera, small(quality));
  const auto red = pixel_at(image, camera, left);
  const auto blue = pixel_at(image, camera, right);
  CHECK(red[0] > 120);
  CHECK(red[0] > 2 * red[2]);
  CHECK(blue[2] > 120);
  CHECK(blue[2] > 2 * blue[0]);

  // The light comes from the front left, so shadows fall to the back right of a body.
  const auto in_front = pixel_at(image, camera, {-0.3, -0.9, 0.0});
  const auto in_shadow = pixel_at(image, camera, {-0.9, 0.2, 0.0});
  CHECK_FALSE(is_darker(in_front, {244, 244, 244}));
  CHECK(is_darker(in_shadow, {220, 220, 220}));
}

TEST_CASE("A scene of nothing is a blank page", "[render_scene]") {
  Scene scene;
  scene.ground = false;
  Renderer renderer;
  const Quality quality = GENERATE(Quality::draft, Quality::film, Quality::report);
  const bool white = GENERATE(false, true);
  PictureOptions options = small(quality);
  options.white = white;
  const Image image = renderer.picture(scene, Camera{}, options);
  const Image page = white ? render::filled_image(320, 180, 255, 255, 255)
                           : render::filled_image(320, 180, 249, 249, 249);
  CHECK(image.rgb == page.rgb);
}

TEST_CASE("A mirrored box looks like the box", "[render_scene]") {
  const Camera camera =
      render::camera_framing({{-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}}, {0.7, -2.0, 1.0}, 16.0 / 9.0);
  Renderer renderer;
  const Image plain = renderer.picture(one_box(Mat3::Identity()), camera, small(Quality::film));
  for (int axis = 0; axis < 3; ++axis) {
    Mat3 mirror = Mat3::Identity();
    mirror(axis, axis) = -1.0;
    const Image image = renderer.picture(one_box(mirror), camera, small(Quality::film));
    CHECK(tests::share_that_differs(plain, image) <= golden_tolerance);
  }
}

TEST_CASE("A swollen box grows in the picture", "[render_scene]") {
  const Camera camera =
      render::camera_framing({{-2.0, -2.0, 0.0}, {2.0, 2.0, 2.0}}, {0.0, -2.0, 0.5}, 16.0 / 9.0);
  Renderer renderer;
  const Vec3 beside(0.9, -0.35, 1.0);
  const Mat3 swollen = Vec3(2.0, 1.0, 1.0).asDiagonal();
  const Image small_box = renderer.picture(one_box(Mat3::Identity()), camera, small(Quality::film));
  const Image large_box = renderer.picture(one_box(swollen), camera, small(Quality::film));
  CHECK(pixel_at(small_box, camera, beside)[0] > 200);
  CHECK(pixel_at(large_box, camera, beside)[0] < 100);
}

TEST_CASE("The same scene gives the same bytes again", "[render_scene]") {
  const Quality quality = GENERATE(Quality::draft, Quality::film, Quality::report);
  const Camera camera = tests::gallery_camera(16.0 / 9.0);
  Renderer renderer;
  const Image first = renderer.picture(tests::gallery_scene(), camera, small(quality));
  renderer.picture(tests::heap_of_boxes(3, 2), camera, {200, 100, Quality::film, true});
  const Image again = renderer.picture(tests::gallery_scene(), camera, small(quality));
  CHECK(first.rgb == again.rgb);
  Renderer other;
  CHECK(first.rgb == other.picture(tests::gallery_scene(), camera, small(quality)).rgb);
}

TEST_CASE("What is not finite is refused by name", "[render_scene]") {
  Scene scene = tests::gallery_scene();
  REQUIRE(refusal_of(scene).empty());
  SECTION("a box") {
    scene.boxes[3].placement.position.y() = not_a_number;
    CHECK(refusal_of(scene) == "box 3: position is not finite");
  }
  SECTION("an orientation") {
    scene.capsules[0].placement.world_from_body(1, 2) = infinity;
    CHECK(refusal_of(scene) == "capsule 0: orientation is not finite");
  }
  SECTION("a size") {
    scene.spheres[0].radius = infinity;
    CHECK(refusal_of(scene) == "sphere 0: radius is not finite");
  }
  SECTION("a colour") {
    scene.cylinders[0].paint.accent.green = std::numeric_limits<float>::quiet_NaN();
    CHECK(refusal_of(scene) == "cylinder 0: accent is not finite");
  }
  SECTION("a point of a cloth") {
    scene.cloths[0].points[7].x() = not_a_number;
    CHECK(refusal_of(scene) == "cloth 0: point is not finite");
  }
  SECTION("an arrow") {
    scene.arrows[1].tip.z() = -infinity;
    CHECK(refusal_of(scene) == "arrow 1: tip is not finite");
  }
  SECTION("a vertex that is not there") {
    scene.meshes[0].triangles[2][1] = 5;
    CHECK(refusal_of(scene) == "mesh 0: a triangle names a vertex that is not there");
  }
}

TEST_CASE("Pictures of absurd size or by a broken camera are refused", "[render_scene]") {
  Renderer renderer;
  CHECK_THROWS_AS(renderer.picture({}, Camera{}, {0, 10, Quality::draft, false}),
                  std::invalid_argument);
  CHECK_THROWS_AS(renderer.picture({}, Camera{}, {10, 8193, Quality::draft, false}),
                  std::invalid_argument);
  Camera camera;
  camera.eye.x() = not_a_number;
  CHECK_THROWS_AS(renderer.picture({}, camera, small(Quality::draft)), std::invalid_argument);
  camera.eye = camera.target;
  CHECK_THROWS_AS(renderer.picture({}, camera, small(Quality::draft)), std::invalid_argument);
}

TEST_CASE("The gallery looks as it did", "[render_golden]") {
  Renderer renderer;
  const bool is_comparable = renderer.device().find("llvmpipe") != std::string::npos &&
                             render::typeface(render::Weight::bold).is_outline();
  if (!is_comparable) {
    SUCCEED("not compared: needs llvmpipe and DejaVu");
    return;
  }
  const Camera camera = tests::gallery_camera(16.0 / 9.0);
  Scene scene = tests::gallery_scene();
  const Image image = renderer.picture(scene, camera, small(Quality::film));
  const Image golden = tests::read_png("golden/gallery.png");
  if (image.rgb == golden.rgb) SUCCEED("every byte is the same");
  CHECK(tests::share_that_differs(image, golden) <= golden_tolerance);

  // The rule has teeth: without any one of the bodies the picture fails it.
  for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
    Scene lacking = scene;
    lacking.boxes.erase(lacking.boxes.begin() + static_cast<std::ptrdiff_t>(i));
    const Image wrong = renderer.picture(lacking, camera, small(Quality::film));
    CHECK(tests::share_that_differs(wrong, golden) > golden_tolerance);
  }
}

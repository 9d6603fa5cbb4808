#include "render/draw/view.hpp"

#include <cmath>
#include <stdexcept>

namespace render {
namespace {

void require(bool is_right, const char* message) {
  if (!is_right) throw std::invalid_argument(message);
}

}  // namespace

CameraAxes camera_axes(const Vec3& towards_eye) {
  const Vec3 backward = towards_eye.stableNormalized();
  // Straight above or below, world z has no direction in the picture: world y is up there.
  constexpr double nearly_vertical = 1.0 - 1e-9;
  const bool is_vertical = std::abs(backward.z()) > nearly_vertical;
  const Vec3 upward = is_vertical ? Vec3::UnitY() : Vec3::UnitZ();
  const Vec3 right = upward.cross(backward).normalized();
  return {right, backward.cross(right), backward};
}

View::View(const Camera& camera, int picture_width, int picture_height)
    : eye(camera.eye),
      origin(camera.target),
      axes(camera_axes(camera.eye - camera.target)),
      width(picture_width),
      height(picture_height),
      distance((camera.eye - camera.target).norm()),
      tan_half(std::tan(camera.vertical_angle / 2)),
      radius(distance * tan_half),
      nearest_depth(0.1 * distance),
      farthest_depth(10.0 * distance) {
  require(camera.eye.allFinite() && camera.target.allFinite(), "camera: a point is not finite");
  require(distance > 0.0, "camera: eye and target coincide");
  require(camera.vertical_angle > 0.0 && camera.vertical_angle < 3.0,
          "camera: the vertical angle is not in (0, 3)");
}

double View::depth(const Vec3& world) const { return axes.backward.dot(eye - world); }

Eigen::Vector4d View::clip(const Vec3& world) const {
  const Vec3 ray = world - eye;
  const double w = -axes.backward.dot(ray);
  const double aspect = static_cast<double>(width) / height;
  const double range = farthest_depth - nearest_depth;
  return {axes.right.dot(ray) / (tan_half * aspect), axes.up.dot(ray) / tan_half,
          ((farthest_depth + nearest_depth) * w - 2.0 * farthest_depth * nearest_depth) / range, w};
}

std::optional<Eigen::Vector2d> View::pixel(const Vec3& world) const {
  const Eigen::Vector4d point = clip(world);
  if (point.w() < nearest_depth) return std::nullopt;
  return Eigen::Vector2d((0.5 + 0.5 * point.x() / point.w()) * width,
                         (0.5 - 0.5 * point.y() / point.w()) * height);
}

Eigen::Vector3f View::from_origin(const Vec3& world) const {
  return (world - origin).cast<float>();
}

double View::pixels_per_metre(double at_depth) const {
  return height / (2.0 * tan_half * at_depth);
}

Eigen::Matrix4f clip_from_origin(const View& view) {
  Eigen::Matrix4d matrix;
  // clip() is affine, so its values at the origin and one step along each axis hold all of it.
  matrix.col(3) = view.clip(view.origin);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = view.distance * Vec3::Unit(axis);
    matrix.col(axis) = (view.clip(view.origin + step) - matrix.col(3)) / view.distance;
  }
  return matrix.cast<float>();
}

}  // namespace render

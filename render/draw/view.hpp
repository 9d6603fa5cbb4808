#pragma once

#include <Eigen/Core>
#include <optional>

#include "render/draw/camera.hpp"

namespace render {

/// Unit vectors of a camera: an orthonormal right-handed frame in the world.
struct CameraAxes {
  Vec3 right;
  Vec3 up;
  Vec3 backward;  ///< from the scene to the eye
};

/// The axes of a camera that sits in direction `towards_eye` (any length but zero), world z up.
CameraAxes camera_axes(const Vec3& towards_eye);

/// A camera with its picture. GL computes in single precision, so all it gets is told from
/// `origin`, near which the scene is, rather than from the world's.
struct View {
  View(const Camera& camera, int picture_width, int picture_height);

  /// How far a point of the world is before the eye, along the camera's axis [m].
  [[nodiscard]] double depth(const Vec3& world) const;
  /// Clip coordinates of a point of the world; its depth is right once the range is set.
  [[nodiscard]] Eigen::Vector4d clip(const Vec3& world) const;
  /// Pixels right and down from the top left corner; none behind the eye.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Vec3& world) const;
  [[nodiscard]] Eigen::Vector3f from_origin(const Vec3& world) const;
  /// Pixels that a length [m] spans at this depth.
  [[nodiscard]] double pixels_per_metre(double at_depth) const;

  Vec3 eye;
  Vec3 origin;
  CameraAxes axes;
  int width;
  int height;
  double distance;        ///< from the eye to the camera's target [m]
  double tan_half;        ///< of the vertical angle
  double radius;          ///< half the height of what shows at the target [m]
  double nearest_depth;   ///< of what is drawn [m]
  double farthest_depth;  ///< [m]
};

/// From coordinates about the view's origin to GL's clip space.
Eigen::Matrix4f clip_from_origin(const View& view);

}  // namespace render

#pragma once

#include "render/scene.hpp"

namespace render {

/// A box along the world's axes that holds everything a picture must show.
struct Bounds {
  Vec3 low = Vec3::Constant(-1.0);  ///< world [m]
  Vec3 high = Vec3::Constant(1.0);  ///< world [m]
};

/// Returns the smallest bounds of a scene's solids, arrows, trails and labels (not of the ground).
Bounds bounds_of(const Scene& scene);

/// Returns the smallest bounds that hold both.
Bounds merged(const Bounds& a, const Bounds& b);

/// A pinhole camera. World z points up in its picture.
struct Camera {
  Vec3 eye = Vec3(4.0, -6.0, 3.0);  ///< world [m]
  Vec3 target = Vec3::Zero();       ///< world [m]
  double vertical_angle = 0.6;      ///< full field of view, top to bottom [rad]
};

/// Returns the nearest camera in the direction `towards_eye` (world, any length) that sees all of
/// `bounds` in a picture of width / height = `aspect`, and leaves `margin` of each half side free.
/// Throws std::invalid_argument if bounds, direction or aspect are not finite or are empty.
Camera camera_framing(const Bounds& bounds, const Vec3& towards_eye, double aspect,
                      double margin = 0.08);

}  // namespace render

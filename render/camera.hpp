#pragma once

#include "render/scene.hpp"

namespace render {

/// A box along the world's axes that holds what a picture must show.
struct Bounds {
  Vec3 low = Vec3::Constant(-1.0);  ///< world [m]
  Vec3 high = Vec3::Constant(1.0);  ///< world [m]
};

/// The smallest bounds that hold a scene's solids, arrows, trails and labels (not the ground).
Bounds bounds_of(const Scene& scene);

/// The smallest bounds that hold both.
Bounds merged(const Bounds& a, const Bounds& b);

/// A pinhole camera; world z is up in its picture.
struct Camera {
  Vec3 eye = Vec3(4.0, -6.0, 3.0);  ///< world [m]
  Vec3 target = Vec3::Zero();       ///< world [m]
  double vertical_angle = 0.6;      ///< full field of view, top to bottom [rad]
};

/// The nearest camera in direction `towards_eye` (world, any length) that sees all of `bounds` in a
/// picture of width / height = `aspect`, with `margin` of each half side left free.
/// Throws std::invalid_argument where bounds, direction or aspect are not finite or are empty.
Camera camera_framing(const Bounds& bounds, const Vec3& towards_eye, double aspect,
                      double margin = 0.08);

}  // namespace render

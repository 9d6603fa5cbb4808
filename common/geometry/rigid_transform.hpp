#pragma once

#include "common/geometry/triangle_mesh.hpp"
#include "common/types.hpp"

namespace common {

/// Maps the points of one frame to another; its name says which: a_from_b.
struct RigidTransform {
  Mat3 rotation = Mat3::Identity();  ///< R
  Vec3 translation = Vec3::Zero();   ///< t [m]
};

/// Returns ((R₀ x + R₁ y) + R₂ z) + t by component, with the columns R₀ … of R. It rounds after
/// every operation and nowhere else, so the bits are the same on every machine. No fused operation
/// rounds less, see common/cmake/ProjectFlags.cmake.
inline Vec3 transformed(const RigidTransform& transform, const Vec3& point) {
  const Mat3& R = transform.rotation;
  Vec3 q;
  for (Eigen::Index i = 0; i < 3; ++i) {
    q[i] = ((R(i, 0) * point.x() + R(i, 1) * point.y()) + R(i, 2) * point.z()) +
           transform.translation[i];
  }
  return q;
}
inline Triangle transformed(const RigidTransform& transform, const Triangle& triangle) {
  return {transformed(transform, triangle[0]), transformed(transform, triangle[1]),
          transformed(transform, triangle[2])};
}

/// Throws std::invalid_argument if an entry is NaN or infinite.
/// name  the caller's name of the transform
void require_finite(const RigidTransform& transform, const char* name);

}  // namespace common

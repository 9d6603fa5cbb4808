#pragma once

#include "common/triangle_mesh.hpp"
#include "common/types.hpp"

namespace common {

/// Leads the points of one frame to another, which its name tells: a_from_b.
struct RigidTransform {
  Mat3 rotation = Mat3::Identity();  ///< R
  Vec3 translation = Vec3::Zero();   ///< t [m]
};

/// ((R₀ x + R₁ y) + R₂ z) + t by component, R₀ … the columns of R, rounded after every operation
/// and nowhere else: the same bits on every machine. No fused operation rounds less, see
/// common/cmake/ProjectFlags.cmake.
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

/// Throws std::invalid_argument where an entry is NaN or infinite; `name` is what the caller calls
/// the transform.
void require_finite(const RigidTransform& transform, const char* name);

}  // namespace common

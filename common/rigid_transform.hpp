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
/// and nowhere else: the same bits on every machine.
Vec3 transformed(const RigidTransform& transform, const Vec3& point);
Triangle transformed(const RigidTransform& transform, const Triangle& triangle);

/// Throws std::invalid_argument where an entry is NaN or infinite; `name` is what the caller calls
/// the transform.
void require_finite(const RigidTransform& transform, const char* name);

}  // namespace common

#pragma once

#include "common/types.hpp"

namespace common {

/// How a rigid body turns about its centre of mass or about a fixed point. The body axes are the
/// principal axes of inertia, so the inertia is three moments, and they never change.
struct Spin {
  Quat world_from_body = Quat::Identity();     ///< q, unit
  Vec3 angular_velocity_body = Vec3::UnitZ();  ///< Rᵀ ω, body frame [rad/s]
};

/// Returns the principal moments of inertia if a body can have them: finite, above zero, and none
/// above the sum of the other two (equal to it for a flat body; a few ulp of rounding pass).
/// Otherwise throws std::invalid_argument, which names the moments and what is wrong with them.
Vec3 checked_moments(const Vec3& moments);

/// Returns the spin with its attitude normalised.
/// Throws std::invalid_argument if an entry is NaN or infinite, or if the attitude is zero.
Spin checked_spin(const Spin& spin);

}  // namespace common

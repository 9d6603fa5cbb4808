#pragma once

#include "common/types.hpp"

namespace common {

/// Returns the rotation by |a| about a / |a|, as in lab 1: (cos |a|/2, sin |a|/2 · a/|a|). It is
/// exact to a few ulp down to |a| = 1e-150. Below that, and for 0, it is the identity.
///
/// rotation_vector  a [rad]
Quat exponential_map(const Vec3& rotation_vector);

/// Returns the angle of the rotation that takes one attitude to the other, in [0, π] [rad]. It is
/// exact to rounding, even for small angles. Both are unit; q and −q are the same attitude.
double angle_between(const Quat& a, const Quat& b);

/// Returns |A − B| / √2 in the Frobenius norm [rad]. For two rotations that differ by a small angle
/// φ it is 2 sin(φ/2), never above 2. It also judges a matrix that is no longer a rotation.
double chordal_distance(const Mat3& a, const Mat3& b);

}  // namespace common

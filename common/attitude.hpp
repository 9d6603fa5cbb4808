#pragma once

#include "common/types.hpp"

namespace common {

/// The rotation by |a| about a / |a|, as lab 1 writes it: (cos |a|/2, sin |a|/2 · a/|a|); 0 gives
/// the identity. Exact to a few ulp down to |a| = 1e-150, below which it is the identity.
///
/// rotation_vector  a [rad]
Quat exponential_map(const Vec3& rotation_vector);

/// Angle of the rotation that leads from one attitude to the other, in [0, π] [rad]. Exact to
/// rounding for small angles too; q and −q are one attitude. Both unit.
double angle_between(const Quat& a, const Quat& b);

/// |A − B| / √2 in the Frobenius norm [rad]: for two rotations a small angle φ apart it is
/// 2 sin(φ/2), and never above 2. It judges a matrix that is no rotation any more as well.
double chordal_distance(const Mat3& a, const Mat3& b);

}  // namespace common

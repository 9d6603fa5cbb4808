#pragma once

#include <Eigen/Core>

#include "common/types.hpp"

/// These functions tell on which side a point lies, as in exact arithmetic. They take the sign of a
/// determinant in doubles if it is larger than its rounding error may be, and in exact numbers
/// otherwise. Coordinates are finite and may have any size.
namespace common {

using Vec2 = Eigen::Vector2d;

/// Returns the sign of (b − a) × (c − a) · (d − a): 1 if d is on the side of the plane from which
/// a, b, c turn to the left, −1 if d is on the other side, and 0 if all four are in one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns the sign of (b − a) × (c − a): 1 if a, b, c turn to the left, −1 if they turn to the
/// right, and 0 if they are on one line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace common

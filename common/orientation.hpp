#pragma once

#include <Eigen/Core>

#include "common/types.hpp"

/// On which side a point lies, as in exact arithmetic: the sign of a determinant in doubles where
/// that is larger than its rounding may be, and in exact numbers where it is not. Finite
/// coordinates of any size.
namespace common {

using Vec2 = Eigen::Vector2d;

/// The sign of (b − a) × (c − a) · (d − a): 1 where d is on the side of the plane from which a, b,
/// c turn to the left, −1 on the other, 0 where the four lie in one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The sign of (b − a) × (c − a): 1 where a, b, c turn to the left, −1 to the right, 0 on one line.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace common

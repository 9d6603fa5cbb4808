#include "render/scene.hpp"

namespace render {

// Rodrigues' formula about z × u, written out. Eigen's FromTwoVectors takes its half turns from a
// singular value decomposition, which costs every file that calls it seconds to compile.
Mat3 z_axis_towards(const Vec3& direction) {
  const Vec3 u = direction.stableNormalized();
  const double x = u.x();
  const double y = u.y();
  const double r_squared = x * x + y * y;
  const double one_and_cos = u.z() < 0.0 ? r_squared / (1.0 - u.z()) : 1.0 + u.z();
  if (one_and_cos == 0.0) return Vec3(1.0, -1.0, -1.0).asDiagonal();
  const double x_part = x / one_and_cos;
  const double y_part = y / one_and_cos;
  return Mat3{
      {1.0 - x * x_part, -x * y_part, x}, {-y * x_part, 1.0 - y * y_part, y}, {-x, -y, u.z()}};
}

}  // namespace render

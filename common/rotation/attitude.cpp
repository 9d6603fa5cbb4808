#include "common/rotation/attitude.hpp"

#include <cmath>

namespace common {

Quat exponential_map(const Vec3& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Quat::Identity();
  Quat turn;
  turn.w() = std::cos(0.5 * angle);
  turn.vec() = std::sin(0.5 * angle) / angle * rotation_vector;
  return turn;
}

double angle_between(const Quat& a, const Quat& b) {
  const Quat turn = a.conjugate() * b;
  return 2.0 * std::atan2(turn.vec().stableNorm(), std::abs(turn.w()));
}

double chordal_distance(const Mat3& a, const Mat3& b) { return (a - b).norm() / std::sqrt(2.0); }

}  // namespace common

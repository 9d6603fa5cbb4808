#include "common/attitude.hpp"

#include <cmath>

namespace common {

double angle_between(const Quat& a, const Quat& b) {
  const Quat turn = a.conjugate() * b;
  return 2.0 * std::atan2(turn.vec().stableNorm(), std::abs(turn.w()));
}

double chordal_distance(const Mat3& a, const Mat3& b) { return (a - b).norm() / std::sqrt(2.0); }

}  // namespace common

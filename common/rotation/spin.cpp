#include "common/rotation/spin.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace common {
namespace {

[[noreturn]] void refuse(const Vec3& moments, const char* why) {
  char text[160];
  std::snprintf(text, sizeof text, "moments of inertia (%g, %g, %g): %s", moments.x(), moments.y(),
                moments.z(), why);
  throw std::invalid_argument(text);
}

}  // namespace

Vec3 checked_moments(const Vec3& moments) {
  if (!moments.allFinite()) refuse(moments, "one is NaN or infinite");
  if (moments.minCoeff() <= 0.0) refuse(moments, "each must be above zero");
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * moments.maxCoeff();
  const double others = moments.sum() - moments.maxCoeff();
  if (moments.maxCoeff() > others + rounding) {
    refuse(moments, "one is above the sum of the other two, which no body can have");
  }
  return moments;
}

Spin checked_spin(const Spin& spin) {
  const double length = spin.world_from_body.coeffs().stableNorm();
  if (!spin.angular_velocity_body.allFinite() || !std::isfinite(length) || length == 0.0) {
    throw std::invalid_argument("spin: an entry is not finite, or the attitude is zero");
  }
  return {Quat(Eigen::Vector4d(spin.world_from_body.coeffs() / length)),
          spin.angular_velocity_body};
}

}  // namespace common

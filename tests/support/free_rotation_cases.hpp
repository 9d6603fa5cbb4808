#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/types.hpp"
#include "random.hpp"

/// Bodies and states for the tests of the exact rotation and of its step.
namespace tests {

inline constexpr double turn = 2.0 * std::numbers::pi;

/// Returns the entries in one of the six orders.
inline common::Vec3 permuted(const common::Vec3& v, int order) {
  const common::Vec3 turned(v[order % 3], v[(order + 1) % 3], v[(order + 2) % 3]);
  return order % 6 < 3 ? turned : common::Vec3(turned.y(), turned.x(), turned.z());
}

/// Returns the moments of masses on the three axes whose sizes span some decades.
inline common::Vec3 random_moments(Random& random, double decades) {
  common::Vec3 masses;
  for (double& mass : masses) mass = std::pow(10.0, random.uniform(-decades, 0.0));
  return {masses.y() + masses.z(), masses.z() + masses.x(), masses.x() + masses.y()};
}

/// Returns an angular velocity of one turn a second with (about) the given k'², for a body of three
/// distinct moments, around its major or its minor axis, at a random place in a random octant.
inline common::Vec3 velocity_near_separatrix(Random& random, const common::Vec3& moments,
                                             double complementary_parameter, bool circles_major) {
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(), [&](int i, int j) { return moments[i] < moments[j]; });
  if (!circles_major) std::swap(axes[0], axes[2]);
  const auto [c, s, d] = axes;
  const double d_c = std::abs(moments[d] - moments[c]);
  const double d_s = std::abs(moments[d] - moments[s]);
  const double s_c = std::abs(moments[s] - moments[c]);
  // On the polhode these two forms are 1 and s_c / (d_s k²).
  const double P_c = s_c / (d_s * (1.0 - complementary_parameter));
  const double u = random.uniform(-4.0, 4.0);
  const double sn = std::tanh(u);
  const double cn = 1.0 / std::cosh(u);
  const auto sign = [&] { return random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; };
  common::Vec3 velocity;
  velocity[c] = sign() * cn / std::sqrt(moments[c] * d_c);
  velocity[s] = sign() * sn / std::sqrt(moments[s] * d_s);
  velocity[d] = sign() * std::sqrt(P_c / (moments[d] * d_c)) *
                std::sqrt(cn * cn + complementary_parameter * sn * sn);
  return velocity * (turn / velocity.norm());
}

}  // namespace tests

#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "common/types.hpp"

namespace tests {

/// Seeded draws that are the same with every standard library. The hidden tests of a grader use
/// other seeds: the environment variable TUMBLE_SEED is mixed into every one.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  /// Returns a number in [low, high).
  double uniform(double low, double high);
  /// Returns a vector with each component in [−size, size).
  common::Vec3 vector(double size = 1.0);
  /// Returns a unit vector, uniform on the sphere.
  common::Vec3 direction();
  /// Returns an attitude, uniform over all attitudes and both signs.
  common::Quat attitude();
  /// Returns a symmetric, positive definite matrix of three distinct moments that obey the triangle
  /// inequality.
  common::Mat3 inertia();

 private:
  std::mt19937_64 engine_;
};

}  // namespace tests

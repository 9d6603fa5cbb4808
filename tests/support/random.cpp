#include "random.hpp"

#include <cstdlib>
#include <numbers>

namespace tests {
namespace {

std::uint64_t seed_of_course() {
  const char* text = std::getenv("TUMBLE_SEED");
  return text == nullptr ? 0 : std::strtoull(text, nullptr, 10);
}

}  // namespace

Random::Random(std::uint64_t seed) : engine_(seed ^ (seed_of_course() * 0x9E3779B97F4A7C15ULL)) {}

double Random::uniform(double low, double high) {
  constexpr double unit = 0x1p-53;
  return low + (high - low) * (static_cast<double>(engine_() >> 11U) * unit);
}

common::Vec3 Random::vector(double size) {
  const double x = uniform(-size, size);
  const double y = uniform(-size, size);
  const double z = uniform(-size, size);
  return {x, y, z};
}

common::Vec3 Random::direction() {
  // Archimedes: a slice of the sphere has an area in proportion to its height.
  const double z = uniform(-1.0, 1.0);
  const double longitude = uniform(0.0, 2.0 * std::numbers::pi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(longitude), r * std::sin(longitude), z};
}

common::Quat Random::attitude() {
  // Shoemake 1992.
  const double u = uniform(0.0, 1.0);
  const double a = uniform(0.0, 2.0 * std::numbers::pi);
  const double b = uniform(0.0, 2.0 * std::numbers::pi);
  common::Quat q(std::sqrt(1.0 - u) * std::sin(a), std::sqrt(1.0 - u) * std::cos(a),
                 std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b));
  q.normalize();
  return q;
}

common::Mat3 Random::inertia() {
  // A body with mass spread (a, b, c) along three axes has the moments b + c, a + c, a + b.
  const double a = uniform(0.2, 1.0);
  const double b = a + uniform(0.2, 1.0);
  const double c = b + uniform(0.2, 1.0);
  const common::Mat3 R = attitude().toRotationMatrix();
  common::Mat3 inertia = R * common::Vec3(b + c, a + c, a + b).asDiagonal() * R.transpose();
  inertia = (0.5 * (inertia + inertia.transpose())).eval();
  return inertia;
}

}  // namespace tests

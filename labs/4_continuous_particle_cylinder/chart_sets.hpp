#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "chart_reference.hpp"

/// The sets on which the charts judge: motions of a second with their times of impact.
namespace lab::continuous_particle_cylinder {

inline constexpr Cylinder cylinder{0.95};
inline constexpr double radius = 0.05;
inline constexpr double reach = 1.0;  ///< ρ
inline constexpr double dt = 1.0;

/// A motion with its time of impact, if it has one.
template <typename Moving>
struct Case {
  Moving moving;
  std::optional<DoubleDouble> time;
};

/// Random numbers that are the same on every machine.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(twister_() >> 11U) * 0x1p-53;
  }

 private:
  std::mt19937_64 twister_{4};
};

inline Vec3 in_plane(double angle) { return {0.0, std::cos(angle), std::sin(angle)}; }

/// Returns particles that come from up to `distance` away. A tenth of them pass by, at a fiftieth
/// of ρ or more.
inline std::vector<Case<MovingParticle>> particles(double least_distance, double distance) {
  constexpr int count = 500;
  Dice dice;
  std::vector<Case<MovingParticle>> all;
  for (int i = 0; i < count; ++i) {
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const double aside = i % 10 == 0 ? dice.between(1.02, 1.5) : dice.between(-0.999, 0.999);
    const double half_chord = std::sqrt(std::max(0.0, 1.0 - aside * aside));
    const double way = reach * (dice.between(least_distance, distance) - 1.0);
    const Vec3 along = in_plane(angle);
    const Vec3 across = in_plane(angle + 0.5 * std::numbers::pi);
    const MovingParticle particle{aside * reach * across - (way + half_chord * reach) * along,
                                  way / dice.between(0.1, 0.9) * along, radius};
    all.push_back({particle, reference_time(particle, cylinder, dt)});
  }
  return all;
}

/// Returns long edges that sweep across the cylinder while their ends pass by on both sides. A
/// tenth of them slide past on one side.
inline std::vector<Case<MovingEdge>> edges() {
  constexpr int count = 200;
  Dice dice;
  std::vector<Case<MovingEdge>> all;
  for (int i = 0; i < count; ++i) {
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const bool does_hit = i % 10 != 0;
    const double impact = dice.between(0.2, 0.8);
    const Vec3 normal = in_plane(angle);
    const Vec3 tangent = in_plane(angle + 0.5 * std::numbers::pi);
    const Vec3 foot = reach * (does_hit ? 1.0 : dice.between(1.02, 1.5)) * normal;
    const auto velocity = [&]() -> Vec3 {
      if (!does_hit) return dice.between(1.0, 3.0) * tangent;
      return dice.between(-3.0, -1.0) * normal + dice.between(-0.1, 0.1) * tangent;
    };
    const Vec3 velocity_a = velocity();
    const Vec3 velocity_b = velocity();
    const Vec3 a = foot + reach * dice.between(1.2, 3.0) * tangent - impact * velocity_a;
    const Vec3 b = foot - reach * dice.between(1.2, 3.0) * tangent - impact * velocity_b;
    const MovingEdge edge{a, b, velocity_a, velocity_b, radius};
    std::optional<DoubleDouble> time;
    if (does_hit) time = reference_time(edge, cylinder, 0.0, impact + 0.05);
    all.push_back({edge, time});
  }
  return all;
}

}  // namespace lab::continuous_particle_cylinder

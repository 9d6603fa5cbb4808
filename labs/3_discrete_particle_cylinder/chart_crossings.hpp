#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "discrete_particle_cylinder.hpp"

/// Particles that cross the cylinder: at all distances from its axis, in all phases of the steps.
namespace lab::discrete_particle_cylinder {

inline constexpr Cylinder cylinder{0.95};
inline constexpr double particle_radius = 0.05;
inline constexpr double reach = 1.0;  ///< ρ
inline constexpr int steps_a_path = 2;

struct Crossing {
  StraightPath path;
  double entry;   ///< time of first contact [s]
  double weight;  ///< its share of all crossings
};

/// Returns borders of strata of crossings by their half chord u, in units of ρ, falling. They are
/// at equal distances b = √(1 − u²) from the axis down to u = 1/2, and from there at equal ratios.
/// So the short chords, which are the only ones that short steps miss, are well represented.
inline std::vector<double> half_chords() {
  constexpr int deep = 64;
  constexpr int an_octave = 16;
  constexpr int octaves = 12;
  std::vector<double> borders;
  borders.reserve(deep + an_octave * octaves + 2);
  for (int i = 0; i < deep; ++i) borders.push_back(std::sqrt(1.0 - 0.75 * i * i / (deep * deep)));
  for (int i = 0; i <= an_octave * octaves; ++i) {
    borders.push_back(0.5 * std::exp2(-static_cast<double>(i) / an_octave));
  }
  borders.push_back(0.0);
  return borders;
}

/// Returns crossings at a speed that steps `diameters` diameters of the cylinder in a second. The
/// weight of a stratum is the share of the distance from the axis that it covers.
inline std::vector<Crossing> crossings(double diameters) {
  constexpr int phases = 25;                     // odd: even, too, at 2, 4, 8 … samples a step
  constexpr double golden = 0.6180339887498949;  // and others in each stratum
  const double step = 2.0 * reach * diameters;
  const std::vector<double> borders = half_chords();
  std::vector<Crossing> all;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    const double high = borders[i - 1];
    const double low = borders[i];
    const double u = 0.5 * (low + high);
    const double b = std::sqrt(1.0 - u * u);
    const double share =
        (high - low) * (high + low) / (std::sqrt(1.0 - low * low) + std::sqrt(1.0 - high * high));
    const double turns = golden * static_cast<double>(i);
    for (int phase = 0; phase < phases; ++phase) {
      const double start = -step * (0.5 + (phase + turns - std::floor(turns)) / phases);
      const StraightPath path{{0.0, start, b * reach}, {0.0, step, 0.0}, steps_a_path};
      all.push_back({path, (-u * reach - start) / step, share / phases});
    }
  }
  return all;
}

/// The result of sampling the crossings.
struct Findings {
  struct Found {
    double lateness;  ///< [s], that is, in steps
    double weight;
  };
  double missed = 0.0;       ///< share of all crossings
  std::vector<Found> found;  ///< the earliest first

  Findings(const std::vector<Crossing>& all, int samples) {
    for (const Crossing& crossing : all) {
      const auto contact = first_sampled_contact(crossing.path, samples, particle_radius, cylinder);
      if (contact) {
        found.push_back({contact->time - crossing.entry, crossing.weight});
      } else {
        missed += crossing.weight;
      }
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.lateness < b.lateness; });
  }

  [[nodiscard]] double median_lateness() const {
    double below = 0.0;
    for (const auto& [lateness, weight] : found) {
      below += weight;
      if (below >= 0.5 * (1.0 - missed)) return lateness;
    }
    return HUGE_VAL;
  }
  [[nodiscard]] double largest_lateness() const {
    return found.empty() ? HUGE_VAL : found.back().lateness;
  }
};

}  // namespace lab::discrete_particle_cylinder

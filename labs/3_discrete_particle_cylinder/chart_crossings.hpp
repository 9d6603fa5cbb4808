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
  double entry;   ///< when it comes to touch [s]
  double weight;  ///< its share of all crossings
};

/// Crossings at a speed that steps `diameters` diameters of the cylinder in a second. Their
/// half chords u, in units of ρ, lie in strata of equal ratio, so that the short chords, which
/// alone are missed by short steps, are well represented; a stratum weighs as much of the distance
/// b = √(1 − u²) from the axis as it holds.
inline std::vector<Crossing> crossings(double diameters) {
  constexpr int strata_an_octave = 16;
  constexpr int octaves = 13;
  constexpr int phases = 24;
  constexpr double golden = 0.6180339887498949;  // spreads phases evenly at every sample distance
  const double step = 2.0 * reach * diameters;
  std::vector<Crossing> all;
  double high = 1.0;
  for (int stratum = 1; high > 0.0; ++stratum) {
    const bool is_last = stratum > strata_an_octave * octaves;
    const double low = is_last ? 0.0 : std::exp2(-static_cast<double>(stratum) / strata_an_octave);
    const double u = 0.5 * (low + high);
    const double b = std::sqrt(1.0 - u * u);
    const double share =
        (high - low) * (high + low) / (std::sqrt(1.0 - low * low) + std::sqrt(1.0 - high * high));
    for (int phase = 0; phase < phases; ++phase) {
      const double turns = golden * static_cast<double>(all.size());
      const double start = -step * (0.5 + turns - std::floor(turns));
      const StraightPath path{{0.0, start, b * reach}, {0.0, step, 0.0}, steps_a_path};
      all.push_back({path, (-u * reach - start) / step, share / phases});
    }
    high = low;
  }
  return all;
}

/// What samples find of crossings.
struct Findings {
  struct Found {
    double lateness;  ///< [s], which are steps
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

#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "impulse_response.hpp"

/// The chart's motions, and their exact results by mechanics.
namespace lab::impulse_response {

inline constexpr double weight = 9.81;  // g [m/s²]
inline const Vec3 gravity(0.0, 0.0, -weight);

struct Outcome {
  double error = 0.0;
  int steps = 0;
};

/// A step of either option.
struct Step {
  Particle particle;
  bool pushed = false;  ///< by an impulse of option 2
  std::vector<Impact> impacts;
};

inline auto by_projection(const Corrections& corrections) {
  return
      [=](const Particle& particle, const Obstacle& obstacle, const Material& material, double dt) {
        const ProjectedStep next =
            step_by_projection(particle, obstacle, material, gravity, dt, corrections);
        return Step{next.particle, !next.impulse.isZero(0.0), {}};
      };
}

inline auto by_impacts(int max_impacts) {
  return [=](const Particle& particle, const Obstacle& obstacle, const Material& material,
             double dt) {
    const ImpactStep next = step_to_impact(particle, obstacle, material, gravity, dt, max_impacts);
    return Step{next.particle, false, next.impacts};
  };
}

// A particle that leaves the cylinder.

inline constexpr double radius = 1.0;
inline constexpr double first_start = 0.1;  // from the top [rad]
inline constexpr int starts = 8;            // evenly spread: luck in the last step must not show
inline constexpr double start_speed = 1.0;

/// Uses ½ v² = ½ v₀² + g R (cos θ₀ − cos θ). The particle leaves when v² = g R cos θ.
inline double exact_departure(double start_angle) {
  return std::acos(2.0 / 3.0 * std::cos(start_angle) +
                   start_speed * start_speed / (3.0 * weight * radius));
}

inline double angle_of(const Particle& particle) {
  return std::atan2(particle.position.y(), particle.position.z());
}

enum class Departure { last_contact, last_impulse };

/// Lets it slide without friction until it is outside for good.
template <typename Advance>
Outcome slide(const Advance& advance, Departure departure, double start_angle, double dt) {
  const Obstacle cylinder = common::Cylinder{radius};
  const Vec3 outward(0.0, std::sin(start_angle), std::cos(start_angle));
  const Vec3 along(0.0, std::cos(start_angle), -std::sin(start_angle));
  Particle particle{1.0, radius * outward, start_speed * along};
  double angle = start_angle;
  Outcome outcome;
  while (angle_of(particle) < 0.5 * std::numbers::pi && outcome.steps * dt < 2.0) {
    const Step step = advance(particle, cylinder, {0.0, 0.0}, dt);
    particle = step.particle;
    ++outcome.steps;
    constexpr double rounding = 1e-14;
    const bool touches = common::gap(cylinder, particle.position) < rounding;
    const bool holds = departure == Departure::last_contact ? touches : step.pushed;
    if (!touches || (!holds && angle > 2.0 * first_start)) break;
    if (holds) angle = angle_of(particle);
  }
  outcome.error = std::abs(angle - exact_departure(start_angle));
  return outcome;
}

/// Returns the largest error of all starts.
template <typename Advance>
auto letting_go(const Advance& advance, Departure departure) {
  return [=](double dt) {
    Outcome all;
    for (int i = 0; i < starts; ++i) {
      const Outcome one = slide(advance, departure, first_start + 0.01 * i / starts, dt);
      all.error = std::max(all.error, one.error);
      all.steps += one.steps;
    }
    return all;
  };
}

// A ball that bounces.

inline constexpr double height = 1.0;
inline constexpr double restitution = 0.8;
inline constexpr int bounces = 10;

/// The fall takes √(2 h/g), and the k-th flight takes 2 eᵏ v₀/g.
inline std::vector<double> exact_bounces() {
  const double fall = std::sqrt(2.0 * height / weight);
  std::vector<double> times{fall};
  double flight = 2.0 * fall;
  for (int k = 1; k < bounces; ++k) {
    flight *= restitution;
    times.push_back(times.back() + flight);
  }
  return times;
}

inline double last_flight() {
  const std::vector<double> times = exact_bounces();
  return times[bounces - 1] - times[bounces - 2];
}

template <typename Advance>
auto bouncing(const Advance& advance) {
  return [=, exact = exact_bounces()](double dt) {
    const Obstacle ground = common::Plane{};
    Particle particle{1.0, {0.0, 0.0, height}, Vec3::Zero()};
    std::vector<double> times;
    Outcome outcome;
    while (times.size() < bounces && outcome.steps * dt < exact.back() + 1.0) {
      const Step step = advance(particle, ground, {restitution, 0.0}, dt);
      particle = step.particle;
      for (const Impact& impact : step.impacts) times.push_back(outcome.steps * dt + impact.time);
      ++outcome.steps;
      if (step.pushed) times.push_back(outcome.steps * dt);
    }
    times.resize(bounces, HUGE_VAL);
    for (std::size_t k = 0; k < bounces; ++k) {
      outcome.error = std::max(outcome.error, std::abs(times[k] - exact[k]));
    }
    return outcome;
  };
}

// A particle on an incline.

inline constexpr double friction = 0.5;
inline constexpr double sliding_time = 1.0;

/// Returns the way from rest in the time: ½ g (sin θ − μ cos θ) t², or 0 if tan θ ≤ μ.
inline double exact_slide(double angle) {
  const double pull = std::sin(angle) - friction * std::cos(angle);
  return 0.5 * weight * std::max(0.0, pull) * sliding_time * sliding_time;
}

template <typename Advance>
auto sliding(const Advance& advance, double tangent) {
  return [=](double dt) {
    const double angle = std::atan(tangent);
    const Vec3 down_the_slope(std::cos(angle), 0.0, -std::sin(angle));
    const Obstacle slope = common::Plane{Vec3::Zero(), {std::sin(angle), 0.0, std::cos(angle)}};
    Particle particle{1.0, Vec3::Zero(), Vec3::Zero()};
    Outcome outcome;
    outcome.steps = static_cast<int>(std::lround(sliding_time / dt));
    for (int i = 0; i < outcome.steps; ++i) {
      particle = advance(particle, slope, {0.0, friction}, dt).particle;
    }
    outcome.error = std::abs(down_the_slope.dot(particle.position) - exact_slide(angle));
    return outcome;
  };
}

}  // namespace lab::impulse_response

#pragma once

#include <algorithm>
#include <cmath>

#include "chart_sets.hpp"

/// The methods that the charts compare with the lab's: samples, bisection, an edge's advancement.
namespace lab::continuous_particle_cylinder {

/// A time of impact, and the number of evaluations of the gap.
struct Found {
  std::optional<double> time;
  double evaluations = 0.0;
};

/// Returns the first sampled contact of a motion whose gap is `gap_at`, with its number in
/// `evaluations`.
template <typename GapAt>
Found first_sample(const GapAt& gap_at, double samples) {
  const int count = static_cast<int>(samples);
  for (int k = 0; k <= count; ++k) {
    const double time = k / samples * dt;
    if (gap_at(time) <= 0.0) return {time, k + 1.0};
  }
  return {std::nullopt, samples + 1.0};
}

inline double gap_at(const MovingParticle& particle, double time) {
  const double y = particle.position.y() + time * particle.velocity.y();
  const double z = particle.position.z() + time * particle.velocity.z();
  return std::sqrt(y * y + z * z) - (cylinder.radius + particle.radius);
}

inline double gap_at(const MovingEdge& edge, double time) {
  const double a_y = edge.a.y() + time * edge.velocity_a.y();
  const double a_z = edge.a.z() + time * edge.velocity_a.z();
  const double span_y = edge.b.y() + time * edge.velocity_b.y() - a_y;
  const double span_z = edge.b.z() + time * edge.velocity_b.z() - a_z;
  const double length_squared = span_y * span_y + span_z * span_z;
  const double s = std::clamp(-(a_y * span_y + a_z * span_z) / length_squared, 0.0, 1.0);
  const double y = a_y + s * span_y;
  const double z = a_z + s * span_z;
  return std::sqrt(y * y + z * z) - (cylinder.radius + edge.radius);
}

inline Found sampled(const MovingParticle& particle, double samples) {
  return first_sample([&](double time) { return gap_at(particle, time); }, samples);
}

/// Halves the time between the first sample inside and the one before it, down to 1e-12.
inline Found bisected(const MovingParticle& particle, double samples) {
  Found found = sampled(particle, samples);
  if (!found.time || *found.time <= 0.0) return found;
  double inside = *found.time;
  double outside = inside - dt / samples;
  while (inside - outside > 1e-12 * dt) {
    const double middle = 0.5 * (outside + inside);
    (gap_at(particle, middle) <= 0.0 ? inside : outside) = middle;
    found.evaluations += 1.0;
  }
  found.time = inside;
  return found;
}

inline Found advanced(const MovingParticle& particle, double tolerance) {
  const Advancement result = conservative_advancement(particle, cylinder, dt, tolerance);
  return {result.time, static_cast<double>(result.iterations)};
}

inline Found sampled_edge(const MovingEdge& edge, double samples) {
  return first_sample([&](double time) { return gap_at(edge, time); }, samples);
}

/// No point of an edge is faster than its faster end.
inline Found advanced_edge(const MovingEdge& edge, double tolerance) {
  const double speed = std::max(std::hypot(edge.velocity_a.y(), edge.velocity_a.z()),
                                std::hypot(edge.velocity_b.y(), edge.velocity_b.z()));
  Found found;
  double time = 0.0;
  while (time <= dt) {
    const double gap = gap_at(edge, time);
    found.evaluations += 1.0;
    const double next = time + gap / speed;
    if (gap <= tolerance || next == time) {
      found.time = time;
      return found;
    }
    time = next;
  }
  return found;
}

inline Found ends_alone(const MovingEdge& edge, double /*parameter*/) {
  const MovingParticle a{edge.a, edge.velocity_a, edge.radius};
  const MovingParticle b{edge.b, edge.velocity_b, edge.radius};
  const std::optional<double> time_a = time_of_impact(a, cylinder, dt);
  const std::optional<double> time_b = time_of_impact(b, cylinder, dt);
  if (time_a && time_b) return {std::min(*time_a, *time_b), 2.0};
  return {time_a ? time_a : time_b, 2.0};
}

}  // namespace lab::continuous_particle_cylinder

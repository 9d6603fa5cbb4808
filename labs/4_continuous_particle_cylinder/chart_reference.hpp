#pragma once

#include <cmath>
#include <optional>

#include "common/exact/exact_number.hpp"
#include "continuous_particle_cylinder.hpp"

/// Times of impact with about 30 digits, by other methods than the lab's: the expanded quadratic in
/// exact numbers, and bisection of the gap of the edge's inside in double-double.
namespace lab::continuous_particle_cylinder {

using common::DoubleDouble;

inline std::optional<DoubleDouble> reference_time(const MovingParticle& particle,
                                                  const Cylinder& cylinder, double dt) {
  using common::ExactNumber;
  const ExactNumber y(particle.position.y());
  const ExactNumber z(particle.position.z());
  const ExactNumber v(particle.velocity.y());
  const ExactNumber w(particle.velocity.z());
  const ExactNumber rho = ExactNumber(cylinder.radius) + ExactNumber(particle.radius);
  const ExactNumber a = v * v + w * w;
  const ExactNumber minus_half_b = ExactNumber() - y * v - z * w;
  const ExactNumber c = y * y + z * z - rho * rho;
  const ExactNumber quarter_discriminant = minus_half_b * minus_half_b - a * c;
  if (c.sign() <= 0) return DoubleDouble(0.0);
  if (minus_half_b.sign() <= 0 || quarter_discriminant.sign() < 0) return std::nullopt;
  const DoubleDouble time =
      c.rounded() / (minus_half_b.rounded() + sqrt(quarter_discriminant.rounded()));
  if ((time - DoubleDouble(dt)).high > 0.0) return std::nullopt;
  return time;
}

/// Returns the gap of the line through an edge. It is the gap of the edge itself if the line's
/// nearest point to the axis is between its ends.
inline DoubleDouble gap_of_line(const MovingEdge& edge, const Cylinder& cylinder,
                                const DoubleDouble& time) {
  const DoubleDouble a_y = edge.a.y() + time * edge.velocity_a.y();
  const DoubleDouble a_z = edge.a.z() + time * edge.velocity_a.z();
  const DoubleDouble b_y = edge.b.y() + time * edge.velocity_b.y();
  const DoubleDouble b_z = edge.b.z() + time * edge.velocity_b.z();
  const DoubleDouble span_y = b_y - a_y;
  const DoubleDouble span_z = b_z - a_z;
  const DoubleDouble cross = a_y * b_z - a_z * b_y;
  const DoubleDouble distance = cross / sqrt(span_y * span_y + span_z * span_z);
  const DoubleDouble rho = DoubleDouble(cylinder.radius) + edge.radius;
  return (distance.high < 0.0 ? -distance : distance) - rho;
}

/// Returns the impact of an edge whose line comes nearer from `before`, at which it is apart, to
/// `after`, at which it is inside.
inline DoubleDouble reference_time(const MovingEdge& edge, const Cylinder& cylinder, double before,
                                   double after) {
  DoubleDouble low(before);
  DoubleDouble high(after);
  constexpr int halvings = 105;
  for (int i = 0; i < halvings; ++i) {
    const DoubleDouble middle = (low + high) * 0.5;
    (gap_of_line(edge, cylinder, middle).high > 0.0 ? low : high) = middle;
  }
  return high;
}

}  // namespace lab::continuous_particle_cylinder

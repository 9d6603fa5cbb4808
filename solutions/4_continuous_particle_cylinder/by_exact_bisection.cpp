// The lab once more, built otherwise: the time of impact is searched among the doubles by the exact
// sign of the parabola, and no root is ever computed.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "by_exact_bisection_search.hpp"
#include "common/course/require.hpp"
#include "common/exact/double_double.hpp"
#include "common/exact/exact_number.hpp"
#include "common/exact/exact_roots.hpp"
#include "continuous_particle_cylinder.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

using common::DoubleDouble;
using common::two_product;
using common::two_sum;
using exact_bisection::first_time;
using exact_bisection::Path;
using exact_bisection::path_of;

void require_path(const MovingParticle& particle, const Cylinder& cylinder) {
  common::require_finite(particle.position, "position");
  common::require_finite(particle.velocity, "velocity");
  common::require_positive(particle.radius, "particle radius");
  common::require_positive(cylinder.radius, "cylinder radius");
}

void require_query(const MovingParticle& particle, const Cylinder& cylinder, double dt) {
  require_path(particle, cylinder);
  common::require_not_negative(dt, "dt");
}

}  // namespace

std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt) {
  require_query(particle, cylinder, dt);
  const Eigen::Vector2d x = particle.position.tail<2>();
  const Eigen::Vector2d v = particle.velocity.tail<2>();
  const double rho = particle.radius + cylinder.radius;
  const double c = x.squaredNorm() - rho * rho;
  if (c <= 0.0) return 0.0;
  const double b = 2.0 * v.dot(x);
  const double a = v.squaredNorm();
  const double time = (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);  // NaN where it has none
  if (time >= 0.0 && time <= dt) return time;
  return std::nullopt;
}

double difference_of_products(double a, double b, double c, double d) {
  const DoubleDouble first = two_product(a, b);
  const DoubleDouble second = two_product(c, d);
  const DoubleDouble high = two_sum(first.high, -second.high);
  const DoubleDouble low = two_sum(first.low, -second.low);
  return high.high + (high.low + low.high + low.low);
}

std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt) {
  return time_of_impact_certified(particle, cylinder, dt);
}

std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt) {
  require_query(particle, cylinder, dt);
  return first_time(path_of(particle, cylinder), dt);
}

Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance) {
  require_query(particle, cylinder, dt);
  common::require_positive(tolerance, "tolerance");
  const Path path = path_of(particle, cylinder);
  const double speed = std::hypot(path.vy, path.vz);
  int evaluations = 0;
  for (double time = 0.0; time <= dt;) {
    ++evaluations;
    const double y = std::fma(time, path.vy, path.y);
    const double z = std::fma(time, path.vz, path.z);
    const double gap = (std::hypot(y, z) - path.R) - path.r;
    if (gap <= tolerance) return {time, evaluations};
    if (speed == 0.0) break;
    const double next = time + gap / speed;
    if (next == time) return {time, evaluations};  // rounding hides what is left
    time = next;
  }
  return {std::nullopt, evaluations};
}

ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  require_path(particle, cylinder);
  common::require_finite(time, "time");
  const Vec3 center = particle.position + time * particle.velocity;
  const double angle = std::atan2(center.z() + 0.0, center.y() + 0.0);  // 0 on the axis, −0 too
  ParticleContact contact;
  contact.time = time;
  contact.normal = {0.0, std::cos(angle), std::sin(angle)};
  contact.point_on_cylinder = {center.x(), 0.0, 0.0};
  contact.point_on_cylinder += cylinder.radius * contact.normal;
  contact.point_on_particle = center - particle.radius * contact.normal;
  contact.gap = std::hypot(center.y(), center.z()) - (cylinder.radius + particle.radius);
  return contact;
}

std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt) {
  const std::size_t size = particles.y.size();
  if (particles.z.size() != size || particles.velocity_y.size() != size ||
      particles.velocity_z.size() != size) {
    throw std::invalid_argument("particles: the four arrays differ in length");
  }
  require_query({Vec3::Zero(), Vec3::Zero(), particles.radius}, cylinder, dt);
  std::vector<double> times(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Path path{particles.y[i],          particles.z[i],  particles.velocity_y[i],
                    particles.velocity_z[i], cylinder.radius, particles.radius};
    for (const double number : {path.y, path.z, path.vy, path.vz}) {
      common::require_finite(number, "particles");
    }
    times[i] = first_time(path, dt).value_or(std::numeric_limits<double>::infinity());
  }
  return times;
}

}  // namespace lab::continuous_particle_cylinder

// ---- Step 4.6 ----

namespace lab::continuous_particle_cylinder {
namespace {

using common::ExactNumber;
using common::ExactPolynomial;

/// 1, t: what a coordinate of an end is, without rounding.
ExactPolynomial path(double x, double v) { return {x, v}; }

/// What is known of the edge's inside: its line meets the disc where `line` ≤ 0, and the foot of
/// the perpendicular is inside where `foot` > 0.
struct InsidePolynomials {
  ExactPolynomial line, foot;
};

InsidePolynomials inside_polynomials(const MovingEdge& edge, const Cylinder& cylinder) {
  const ExactPolynomial p_y = path(edge.a.y(), edge.velocity_a.y());
  const ExactPolynomial p_z = path(edge.a.z(), edge.velocity_a.z());
  const ExactPolynomial q_y = path(edge.b.y(), edge.velocity_b.y());
  const ExactPolynomial q_z = path(edge.b.z(), edge.velocity_b.z());
  const ExactPolynomial rho{ExactNumber(cylinder.radius) + ExactNumber(edge.radius)};
  const ExactPolynomial p_p = p_y * p_y + p_z * p_z;
  const ExactPolynomial p_q = p_y * q_y + p_z * q_z;
  const ExactPolynomial q_q = q_y * q_y + q_z * q_z;
  // Lagrange's identity: (p × q)² = p² q² − (p · q)².
  const ExactPolynomial line = p_p * q_q - p_q * p_q - rho * rho * (p_p + q_q - (p_q + p_q));
  return {line, (p_p - p_q) * (q_q - p_q)};
}

/// All by counting: is there a touch up to a time? Then halve the time.
std::optional<double> first_touch_by_counting(const InsidePolynomials& inside, double dt) {
  const common::ExactRoots touches(inside.line, inside.foot);
  if (touches.count(0.0, dt) == 0) return std::nullopt;
  double before = 0.0;
  double after = dt;
  while (after - before > 1e-15 * dt) {
    const double middle = before + 0.5 * (after - before);
    if (middle == before || middle == after) break;
    (touches.count(0.0, middle) > 0 ? after : before) = middle;
  }
  return after;
}

}  // namespace

std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  const auto time_of_end = [&](const Vec3& x, const Vec3& v) {
    return time_of_impact_certified({x, v, edge.radius}, cylinder, dt)
        .value_or(std::numeric_limits<double>::infinity());
  };
  const double end =
      std::min(time_of_end(edge.a, edge.velocity_a), time_of_end(edge.b, edge.velocity_b));
  const InsidePolynomials inside = inside_polynomials(edge, cylinder);
  if (end == 0.0 || (inside.line[0].sign() <= 0 && inside.foot[0].sign() > 0)) return 0.0;

  // Just before an end touches, the foot is inside or not for certain.
  const auto touch = first_touch_by_counting(inside, std::min(end * (1.0 - 1e-15), dt));
  if (touch) return touch;
  return end <= dt ? std::optional(end) : std::nullopt;
}

}  // namespace lab::continuous_particle_cylinder

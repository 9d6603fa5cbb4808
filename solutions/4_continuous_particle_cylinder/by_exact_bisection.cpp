// The lab once more, built otherwise: the time of impact is searched among the doubles by the exact
// sign of the parabola, and no root is ever computed.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "common/double_double.hpp"
#include "common/exact_number.hpp"
#include "common/exact_roots.hpp"
#include "common/require.hpp"
#include "continuous_particle_cylinder.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

using common::DoubleDouble;
using common::ExactNumber;
using common::two_product;
using common::two_sum;

/// A path in the yz-plane and the circle that it is to meet.
struct Path {
  double y;
  double z;
  double vy;
  double vz;
  double R;
  double r;
};

Path path_of(const MovingParticle& particle, const Cylinder& cylinder) {
  const Vec3& x = particle.position;
  const Vec3& v = particle.velocity;
  return {x.y(), x.z(), v.y(), v.z(), cylinder.radius, particle.radius};
}

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

/// Sizes of which double-double loses nothing, whatever products of four are made of them.
bool is_moderate(double value) {
  const double size = std::abs(value);
  return size == 0.0 || (size >= 1e-60 && size <= 1e60);
}
bool is_moderate(const Path& path) {
  return is_moderate(path.y) && is_moderate(path.z) && is_moderate(path.vy) &&
         is_moderate(path.vz) && is_moderate(path.R) && is_moderate(path.r);
}

/// The sign of a value that is known to within `bound`; 2 where that leaves it open.
constexpr int unsure = 2;
int sign_beyond(DoubleDouble value, double bound) {
  if (std::abs(value.high) > bound) return value.high > 0.0 ? 1 : -1;
  return unsure;
}

/// Of a sum of a few products of four factors: some 30 u² of the terms, u² = 2⁻¹⁰⁶.
constexpr double rounding = 0x1p-100;

template <typename Number>
Number square(const Number& x) {
  return x * x;
}

/// The sign of |2 x + s v|² − 4 ρ² with s = earlier + later, and of its slope. Half of s is the
/// middle of two neighbours, which is no double.
struct Signs {
  int gap;
  int slope;
};

Signs exact_signs(const Path& path, double earlier, double later) {
  const ExactNumber s = ExactNumber(earlier) + ExactNumber(later);
  const ExactNumber two(2.0);
  const ExactNumber y = two * path.y + s * path.vy;
  const ExactNumber z = two * path.z + s * path.vz;
  const ExactNumber rho = two * (ExactNumber(path.R) + path.r);
  return {(y * y + z * z - rho * rho).sign(), (y * path.vy + z * path.vz).sign()};
}

Signs signs(const Path& path, bool moderate, double earlier, double later) {
  const double size = std::abs(later) * std::max(std::abs(path.vy), std::abs(path.vz));
  if (moderate && size <= 1e100) {
    const DoubleDouble s = two_sum(earlier, later);
    const DoubleDouble y = DoubleDouble(2.0 * path.y) + s * path.vy;
    const DoubleDouble z = DoubleDouble(2.0 * path.z) + s * path.vz;
    const DoubleDouble rho = two_sum(2.0 * path.R, 2.0 * path.r);
    const DoubleDouble distance = square(y) + square(z);
    const DoubleDouble along_y = y * path.vy;
    const DoubleDouble along_z = z * path.vz;
    // s v itself rounds to 5 u² of what may cancel against 2 x: y is off by 8 u² of both.
    const double reach = 2.0 * (std::abs(path.y) + std::abs(path.z)) + 4.0 * size;
    const double gap_bound =
        rounding * (distance.high + square(rho.high) + reach * std::sqrt(distance.high));
    const double slope_bound = rounding * reach * (std::abs(path.vy) + std::abs(path.vz));
    const int gap = sign_beyond(distance - square(rho), gap_bound);
    const int slope = sign_beyond(along_y + along_z, slope_bound);
    if (gap != unsure && (gap < 0 || slope != unsure)) return {gap, slope};
  }
  return exact_signs(path, earlier, later);
}

/// Whether the line comes within ρ of the axis at all: ρ² |v|² ≥ (x × v)².
bool line_meets(const Path& path, bool moderate) {
  if (moderate) {
    const DoubleDouble rho = two_sum(path.R, path.r);
    const DoubleDouble speed = two_product(path.vy, path.vy) + two_product(path.vz, path.vz);
    const DoubleDouble cross = two_product(path.y, path.vz) - two_product(path.z, path.vy);
    const DoubleDouble reach = square(rho) * speed;
    const DoubleDouble offset = square(cross);
    const int sign = sign_beyond(reach - offset, rounding * (reach.high + offset.high));
    if (sign != unsure) return sign > 0;
  }
  const ExactNumber rho = ExactNumber(path.R) + path.r;
  const ExactNumber speed = ExactNumber(path.vy) * path.vy + ExactNumber(path.vz) * path.vz;
  const ExactNumber cross = ExactNumber(path.y) * path.vz - ExactNumber(path.z) * path.vy;
  return (square(rho) * speed - square(cross)).sign() >= 0;
}

/// Whether the impact, of a line that meets and approaches at the start, is over at (s + s')/2.
bool has_met(const Path& path, bool moderate, double earlier, double later) {
  const Signs found = signs(path, moderate, earlier, later);
  return found.gap <= 0 || found.slope >= 0;
}

/// Doubles from zero up and their bits rise together.
std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
double value(std::uint64_t bits) { return std::bit_cast<double>(bits); }

/// A guess of t*, however bad: it only saves bisections.
double guess(const Path& path) {
  const double speed = std::hypot(path.vy, path.vz);
  const double along = -(path.y * (path.vy / speed) + path.z * (path.vz / speed));
  const double across = path.y * (path.vz / speed) - path.z * (path.vy / speed);
  const double rho = path.R + path.r;
  const double chord = std::sqrt(std::max(0.0, (rho - across) * (rho + across)));
  return (along - chord) / speed;
}

/// Two times as bits: at one the path has not met, at the other it has.
struct Bracket {
  std::uint64_t before;
  std::uint64_t met;
};

/// About the guess, of a path that meets in (0, dt]: wider and wider until it holds t*.
Bracket bracket(const Path& path, bool moderate, double dt) {
  Bracket all{0, bits(dt)};
  const double start = guess(path);
  if (!(start > 0.0 && start < dt)) return all;
  const std::uint64_t middle = bits(start);
  for (std::uint64_t width = 1; width <= all.met - all.before; width *= 4) {
    const std::uint64_t low = middle > width ? std::max(middle - width, all.before) : all.before;
    const std::uint64_t high = std::min(middle + width, all.met);
    if (has_met(path, moderate, value(low), value(low))) {
      all.met = low;
    } else if (has_met(path, moderate, value(high), value(high))) {
      return {low, high};
    } else {
      all.before = high;
    }
  }
  return all;
}

/// The double nearest to t*, of a path that meets in (0, dt].
double nearest_time(const Path& path, bool moderate, double dt) {
  auto [before, met] = bracket(path, moderate, dt);
  while (met - before > 1) {
    const std::uint64_t middle = before + (met - before) / 2;
    (has_met(path, moderate, value(middle), value(middle)) ? met : before) = middle;
  }
  return value(has_met(path, moderate, value(before), value(met)) ? before : met);
}

std::optional<double> first_time(const Path& path, double dt) {
  const bool moderate = is_moderate(path);
  const Signs start = signs(path, moderate, 0.0, 0.0);
  if (start.gap <= 0) return 0.0;
  if (start.slope >= 0 || !line_meets(path, moderate)) return std::nullopt;
  if (!has_met(path, moderate, dt, dt)) return std::nullopt;
  return nearest_time(path, moderate, dt);
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

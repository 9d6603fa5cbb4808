#include "continuous_particle_cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "common/course/require.hpp"
#include "common/exact/double_double.hpp"
#include "common/exact/exact_number.hpp"
#include "common/exact/exact_path.hpp"
#include "common/exact/exact_roots.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

using common::DoubleDouble;
using common::ExactNumber;
using common::ExactPolynomial;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double time_accuracy = 0x1p-50;  ///< of an edge's t*, in steps

void require_valid(const MovingParticle& particle, const Cylinder& cylinder, double dt) {
  common::require_finite(particle.position, "position");
  common::require_finite(particle.velocity, "velocity");
  common::require_positive(particle.radius, "particle radius");
  common::require_positive(cylinder.radius, "cylinder radius");
  common::require_not_negative(dt, "dt");
}

/// The motion in the yz-plane, which decides, and both radii, because R + r would be rounded.
struct Motion {
  double y, z, v_y, v_z;
  double R, r;
};

Motion motion(const MovingParticle& particle, const Cylinder& cylinder) {
  const auto& [x, v, r] = particle;
  return {x.y(), x.z(), v.y(), v.z(), cylinder.radius, r};
}

std::optional<double> if_finite(double time) {
  return time < infinity ? std::optional(time) : std::nullopt;
}

}  // namespace

// ---- Step 4.1: the textbook's quadratic ----

std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt) {
  require_valid(particle, cylinder, dt);
  const auto [y, z, v_y, v_z, R, r] = motion(particle, cylinder);
  const double rho = R + r;
  const double a = v_y * v_y + v_z * v_z;
  const double b = 2.0 * (y * v_y + z * v_z);
  const double c = y * y + z * z - rho * rho;
  if (c <= 0.0) return 0.0;
  const double t = (-b - std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);  // eq. (3)
  if (t >= 0.0 && t <= dt) return t;  // false if t is NaN: it passes by or is at rest
  return std::nullopt;
}

// ---- Step 4.2: a difference of products, and the cross form ----

double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double rest = std::fma(-c, d, cd);  // the rounding error of c d
  return std::fma(a, b, -cd) + rest;        // eq. (4)
}

std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt) {
  require_valid(particle, cylinder, dt);
  const auto [y, z, v_y, v_z, R, r] = motion(particle, cylinder);
  const DoubleDouble rho = common::two_sum(R, r);
  const double rho_squared = rho.high * rho.high;
  const double a = v_y * v_y + v_z * v_z;
  const double b = difference_of_products(y, v_y, -z, v_z);
  const double c = (common::two_product(y, y) + common::two_product(z, z) - rho * rho).high;
  const double w = std::abs(difference_of_products(y, v_z, z, v_y));
  const double w_touching = rho.high * std::sqrt(a);

  // Each test leans towards a hit by more than its rounding, so that none is missed.
  constexpr double lean = 1.0 + 8.0 * eps;
  if (c <= 8.0 * eps * eps * rho_squared) return 0.0;
  if (b >= 0.0 || w > lean * w_touching) return std::nullopt;
  const double y_end = std::fma(dt, v_y, y);
  const double z_end = std::fma(dt, v_z, z);
  const bool outside_at_end = y_end * y_end + z_end * z_end > lean * rho_squared;
  if (outside_at_end && -b > lean * (a * dt)) return std::nullopt;  // still approaching

  const double discriminant = (w_touching - w) * (w_touching + w);    // eq. (5)
  const double t = c / (std::sqrt(std::max(discriminant, 0.0)) - b);  // eq. (6)
  return std::min(t, dt);
}

// ---- Step 4.3: for certain, and by small steps ----

namespace {

/// The X whose signs decide, for any type of number. |x + t v|² − ρ² = a t² + 2 b t + c.
template <typename Number>
struct Quadratic {
  Number c, b, discriminant;
  Number at_end, slope;  ///< the parabola at dt, and half of its slope there
};

template <typename Number>
Quadratic<Number> quadratic(const Motion& m, double dt) {
  const Number y = m.y, z = m.z, v_y = m.v_y, v_z = m.v_z, t = dt;
  const Number rho = Number(m.R) + Number(m.r);
  const Number a = v_y * v_y + v_z * v_z;
  const Number b = y * v_y + z * v_z;
  const Number c = y * y + z * z - rho * rho;
  const Number w = y * v_z - z * v_y;
  return {c, b, rho * rho * a - w * w, (a * t + b + b) * t + c, a * t + b};
}

/// A number type for which the same formula gives the sum of the sizes of its terms.
struct Size {
  double value = 0.0;
  Size(double x) : value(std::abs(x)) {}  // NOLINT: a double has a size
};
Size operator+(Size a, Size b) { return a.value + b.value; }
Size operator-(Size a, Size b) { return a.value + b.value; }
Size operator*(Size a, Size b) { return a.value * b.value; }

/// Returns whether products of four such sizes are in the range of double-double.
bool is_moderate(double size) { return size == 0.0 || (size > 1e-60 && size < 1e60); }

/// Returns c/(−b + √D). It scales both to near 1, because only the quotient must fit into a double.
double exact_root(const Quadratic<ExactNumber>& q) {
  const int scale_c = q.c.exponent(), scale_b = q.b.exponent();  // √D is no greater than −b
  const DoubleDouble divisor = sqrt(q.discriminant.rounded(-2 * scale_b)) - q.b.rounded(-scale_b);
  return std::ldexp((q.c.rounded(-scale_c) / divisor).high, scale_c - scale_b);
}

/// Returns t* for certain, or infinity if there is no impact.
double certified_time(const Motion& m, double dt) {
  using Exact = Quadratic<ExactNumber>;
  const bool moderate = is_moderate(std::hypot(m.y, m.z)) && is_moderate(m.R + m.r) &&
                        is_moderate(std::hypot(m.v_y, m.v_z)) && is_moderate(dt);
  const auto x = quadratic<DoubleDouble>(m, dt);
  const auto terms = quadratic<Size>(m, dt);
  const auto sign = [&](const DoubleDouble& X, Size X_terms, ExactNumber Exact::*X_exact) {
    const bool sure = moderate && std::abs(X.high) > 1e-30 * X_terms.value + 1e-280;  // eq. (7)
    return sure ? (X.high > 0.0 ? 1 : -1) : (quadratic<ExactNumber>(m, dt).*X_exact).sign();
  };
  if (sign(x.c, terms.c, &Exact::c) <= 0) return 0.0;
  if (sign(x.b, terms.b, &Exact::b) >= 0) return infinity;
  if (sign(x.discriminant, terms.discriminant, &Exact::discriminant) < 0) return infinity;
  const int at_end = sign(x.at_end, terms.at_end, &Exact::at_end);
  if (at_end > 0 && sign(x.slope, terms.slope, &Exact::slope) < 0) return infinity;

  // A sign needs only one digit, but a time needs all of them.
  const DoubleDouble root = sqrt(x.discriminant);
  const bool has_digits = moderate && x.c.high > 1e-12 * terms.c.value &&
                          -x.b.high > 1e-12 * terms.b.value &&
                          root.high * -x.b.high > 1e-12 * terms.discriminant.value;
  const double time = has_digits ? (x.c / (root - x.b)).high  // eq. (6)
                                 : exact_root(quadratic<ExactNumber>(m, dt));
  return std::min(time, dt);
}

}  // namespace

std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt) {
  require_valid(particle, cylinder, dt);
  return if_finite(certified_time(motion(particle, cylinder), dt));
}

Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance) {
  require_valid(particle, cylinder, dt);
  common::require_positive(tolerance, "tolerance");
  const auto [y, z, v_y, v_z, R, r] = motion(particle, cylinder);
  const double speed = std::hypot(v_y, v_z);
  Advancement advancement;
  for (double t = 0.0; t <= dt;) {
    const double gap = std::hypot(y + t * v_y, z + t * v_z) - (R + r);
    ++advancement.iterations;
    const double next = t + gap / speed;  // eq. (8); infinite at rest
    if (gap <= tolerance || next == t) {  // or φ/|v| is too small to change t
      advancement.time = t;
      break;
    }
    t = next;
  }
  return advancement;
}

// ---- Step 4.4: the contact ----

ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  require_valid(particle, cylinder, 0.0);
  common::require_finite(time, "time");
  const auto& [x, v, r] = particle;
  const Vec3 p = x + time * v;
  const double size = std::max(std::abs(p.y()), std::abs(p.z()));
  const double y = p.y() / size, z = p.z() / size;  // near 1: the least doubles have few digits
  ParticleContact contact;                          // eq. (9)
  Vec3& n = contact.normal;
  if (size > 0.0) n = {0.0, y / std::hypot(y, z), z / std::hypot(y, z)};
  contact.point_on_cylinder = {p.x(), cylinder.radius * n.y(), cylinder.radius * n.z()};
  contact.point_on_particle = {p.x(), p.y() - r * n.y(), p.z() - r * n.z()};
  contact.gap = std::hypot(p.y(), p.z()) - (cylinder.radius + r);
  contact.time = time;
  return contact;
}

// ---- Step 4.5: many particles ----

std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt) {
  const auto& [y, z, v_y, v_z, r] = particles;
  if (z.size() != y.size() || v_y.size() != y.size() || v_z.size() != y.size()) {
    throw std::invalid_argument("particles: the arrays differ in length");
  }
  common::require_positive(r, "particle radius");
  common::require_positive(cylinder.radius, "cylinder radius");
  common::require_not_negative(dt, "dt");
  std::vector<double> times(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    for (const double entry : {y[i], z[i], v_y[i], v_z[i]}) common::require_finite(entry, "entry");
    times[i] = certified_time({y[i], z[i], v_y[i], v_z[i], cylinder.radius, r}, dt);
  }
  return times;
}

// ---- Step 4.6: a moving edge ----

namespace {

/// Polynomials in s = t/T from 0 to 1. The edge's inside touches if f ≤ 0 and p·d < 0 < q·d, with
/// d = q − p. Since q·d − p·d = |d|², the second condition is −(p·d)(q·d) > 0.            eq. (10)
struct Inside {
  ExactPolynomial f, foot;
};

Inside inside_of(const MovingEdge& edge, const Cylinder& cylinder, double T) {
  const auto p = common::exact_path(edge.a, edge.velocity_a, T);
  const auto q = common::exact_path(edge.b, edge.velocity_b, T);
  const auto d = q - p;
  const ExactPolynomial C = cross(p, q);
  const ExactPolynomial rho{ExactNumber(cylinder.radius) + ExactNumber(edge.radius)};
  return {C * C - rho * rho * dot(d, d), ExactPolynomial{} - dot(p, d) * dot(q, d)};
}

/// The same polynomials between two values of s, in Bernstein's form.                     eq. (11)
struct Piece {
  double from, to;
  common::Bernstein<DoubleDouble, 4> f, foot;
};

/// Returns the first s of a piece at which the inside begins to touch.
std::optional<double> first_touch(const Inside& inside, const Piece& piece) {
  constexpr double doubt = common::bernstein_error;
  const auto [f_lowest, f_highest] = common::range(piece.f);
  const auto [foot_lowest, foot_highest] = common::range(piece.foot);
  if (f_lowest > doubt || f_highest < -doubt || foot_highest < -doubt) return std::nullopt;

  const bool narrow = piece.to - piece.from <= time_accuracy;
  const bool falls = piece.f.front().high > doubt && piece.f.back().high < -doubt;
  if (narrow && falls && foot_lowest > doubt) return piece.to;
  if (narrow || (f_lowest > -doubt && f_highest < doubt)) {  // a tie: halving does not settle it
    const common::ExactRoots touches(inside.f, inside.foot);
    if (touches.count(piece.from, piece.to) == 0) return std::nullopt;
    return touches.first(piece.from, piece.to, time_accuracy);
  }
  const double middle = 0.5 * (piece.from + piece.to);
  const auto [f_left, f_right] = common::halves(piece.f);
  const auto [foot_left, foot_right] = common::halves(piece.foot);
  if (const auto s = first_touch(inside, {piece.from, middle, f_left, foot_left})) return s;
  return first_touch(inside, {middle, piece.to, f_right, foot_right});
}

}  // namespace

std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  const MovingParticle end_a{edge.a, edge.velocity_a, edge.radius};
  const MovingParticle end_b{edge.b, edge.velocity_b, edge.radius};
  require_valid(end_a, cylinder, dt);
  require_valid(end_b, cylinder, dt);
  const double end = std::min(certified_time(motion(end_a, cylinder), dt),
                              certified_time(motion(end_b, cylinder), dt));
  // Before T no end touches. Times closer to the ends' impact than the accuracy of t* do not count.
  const double T = std::min(end * (1.0 - time_accuracy), dt);
  const Inside inside = inside_of(edge, cylinder, T);
  if (inside.f[0].sign() <= 0 && inside.foot[0].sign() > 0) return 0.0;
  const auto s = first_touch(inside, {0.0, 1.0, bernstein(inside.f), bernstein(inside.foot)});
  return s ? *s * T : if_finite(end);
}

}  // namespace lab::continuous_particle_cylinder

#include "continuous_particle_cylinder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include "common/double_double.hpp"
#include "common/exact_number.hpp"
#include "common/not_implemented.hpp"
#include "common/require.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

using common::DoubleDouble;
using common::ExactNumber;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_sure = std::numeric_limits<double>::quiet_NaN();

void require_valid(const MovingParticle& particle, const Cylinder& cylinder, double dt) {
  common::require_finite(particle.position, "position");
  common::require_finite(particle.velocity, "velocity");
  common::require_positive(particle.radius, "particle radius");
  common::require_positive(cylinder.radius, "cylinder radius");
  common::require_not_negative(dt, "dt");
}

/// All that counts: the motion in the yz-plane, and the two radii, whose sum may not be a double.
struct Motion {
  double y, z, v_y, v_z;
  double R, r;
};

Motion motion(const MovingParticle& particle, const Cylinder& cylinder) {
  const Vec3& x = particle.position;
  const Vec3& v = particle.velocity;
  return {x.y(), x.z(), v.y(), v.z(), cylinder.radius, particle.radius};
}

std::optional<double> if_finite(double time) {
  return time < infinity ? std::optional(time) : std::nullopt;
}

/// A double-double, and how far off it may be.
struct Bounded {
  DoubleDouble value;
  double error = 0.0;
};

constexpr double u_squared = 0x1p-106;
constexpr double underflow = 1e-290;  ///< far above what a product loses below the least double

Bounded operator+(Bounded a, Bounded b) {
  const DoubleDouble sum = a.value + b.value;
  return {sum, a.error + b.error + 3.0 * u_squared * std::abs(sum.high)};
}

Bounded operator-(Bounded a, Bounded b) { return a + Bounded{-b.value, b.error}; }

Bounded operator*(Bounded a, Bounded b) {
  const DoubleDouble product = a.value * b.value;
  const double size_a = std::abs(a.value.high);
  const double size_b = std::abs(b.value.high);
  return {product, size_a * b.error + (size_b + b.error) * a.error +
                       5.0 * u_squared * std::abs(product.high) + underflow};
}

/// The bounds are themselves rounded, so a sign is sure from twice the bound on. It never is where
/// something overflows: NaN compares false.
bool surely_positive(Bounded a) { return a.value.high > 2.0 * a.error; }
bool surely_negative(Bounded a) { return a.value.high < -2.0 * a.error; }

template <typename Number>
Number sum(double a, double b) {
  return ExactNumber(a) + ExactNumber(b);
}
template <>
Bounded sum(double a, double b) {
  return {common::two_sum(a, b), 0.0};
}

template <typename Number>
Number product(double a, double b) {
  return ExactNumber(a) * ExactNumber(b);
}
template <>
Bounded product(double a, double b) {
  return {common::two_product(a, b), underflow};
}

/// |x + t v|² − ρ² = a t² + 2 b t + c, and b² − a c as the cross form has it.
template <typename Number>
struct Quadratic {
  Number a, b, c, discriminant;
};

template <typename Number>
[[gnu::always_inline]] inline Quadratic<Number> quadratic(Motion m) {
  const Number rho = sum<Number>(m.R, m.r);
  const Number rho_squared = rho * rho;
  const Number a = product<Number>(m.v_y, m.v_y) + product<Number>(m.v_z, m.v_z);
  const Number b = product<Number>(m.y, m.v_y) + product<Number>(m.z, m.v_z);
  const Number c = product<Number>(m.y, m.y) + product<Number>(m.z, m.z) - rho_squared;
  const Number w = product<Number>(m.y, m.v_z) - product<Number>(m.z, m.v_y);
  return {a, b, c, rho_squared * a - w * w};
}

/// t* to 1 ulp, infinity where there is none, NaN where double-double is not sure. In line and
/// without a branch, so that a compiler can do many at a time.
[[gnu::always_inline]] inline double quick_time(Motion m, double dt) {
  constexpr double slack = 0x1p-57;  // of the relative errors of c and of −b + √: t to 5/8 ulp
  const auto [a, b, c, discriminant] = quadratic<Bounded>(m);
  const DoubleDouble root = sqrt(discriminant.value);
  const DoubleDouble divisor = root - b.value;
  const double t = (c.value / divisor).high;

  const bool accurate =
      (c.error < slack * c.value.high) & (t > underflow) &
      (discriminant.error + b.error * root.high < slack * divisor.high * root.high);
  const bool known = surely_positive(discriminant) & accurate;
  const bool hit = known & (t < (1.0 - 2.0 * eps) * dt);
  const bool late = known & (t > (1.0 + 2.0 * eps) * dt);
  const bool at_rest = (m.v_y == 0.0) & (m.v_z == 0.0);
  const bool outside = surely_positive(c);
  const bool missed = outside & (at_rest | surely_positive(b) | surely_negative(discriminant));
  const double outcome = (late | missed) ? infinity : hit ? t : not_sure;
  return surely_negative(c) ? 0.0 : outcome;
}

/// t* to 1 ulp, infinity where there is none.
double exact_time(const Motion& m, double dt) {
  const auto [a, b, c, discriminant] = quadratic<ExactNumber>(m);
  if (c.sign() <= 0) return 0.0;
  if (b.sign() >= 0 || discriminant.sign() < 0) return infinity;
  const ExactNumber half_slope = a * dt + b;  // of the quadratic, at dt
  const bool inside_at_end = (c + dt * (b + half_slope)).sign() <= 0;
  if (half_slope.sign() < 0 && !inside_at_end) return infinity;

  // Only the quotient need be within the range of a double: take both of its parts near one.
  const int scale_c = c.exponent();
  const int scale = b.exponent();  // the root is no greater than −b
  const DoubleDouble divisor = sqrt(discriminant.rounded(-2 * scale)) - b.rounded(-scale);
  const double t = (c.rounded(-scale_c) / divisor).high;
  return std::min(std::ldexp(t, scale_c - scale), dt);
}

double certified_time(const Motion& m, double dt) {
  const double t = quick_time(m, dt);
  return std::isnan(t) ? exact_time(m, dt) : t;
}

constexpr std::size_t block = 256;  ///< particles whose numbers the nearest cache holds

struct Block {
  const double *y, *z, *v_y, *v_z;
  std::size_t size;
};

void require_finite(const Block& p) {
  bool finite = true;
  for (std::size_t i = 0; i < p.size; ++i) {
    finite = finite & std::isfinite(p.y[i]) & std::isfinite(p.z[i]) & std::isfinite(p.v_y[i]) &
             std::isfinite(p.v_z[i]);
  }
  if (!finite) throw std::invalid_argument("particles: an entry is not finite");
}

/// Many at a time where double-double is sure, the few others one by one.
void find_times(const Block& p, double R, double r, double dt, double* times) {
  std::array<double, block> quick;
  for (std::size_t i = 0; i < p.size; ++i) {
    quick[i] = quick_time({p.y[i], p.z[i], p.v_y[i], p.v_z[i], R, r}, dt);
  }
  for (std::size_t i = 0; i < p.size; ++i) {
    times[i] = std::isnan(quick[i]) ? exact_time({p.y[i], p.z[i], p.v_y[i], p.v_z[i], R, r}, dt)
                                    : quick[i];
  }
}

}  // namespace

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
  if (t >= 0.0 && t <= dt) return t;  // neither where it is NaN: a path that passes by, or at rest
  return std::nullopt;
}

double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double rest = std::fma(-c, d, cd);  // what rounding took from c d
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
  if (outside_at_end && -b > lean * (a * dt)) return std::nullopt;  // and still nearing

  const double discriminant = (w_touching - w) * (w_touching + w);    // eq. (5)
  const double t = c / (std::sqrt(std::max(discriminant, 0.0)) - b);  // eq. (6)
  return std::min(t, dt);
}

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
  double t = 0.0;
  while (t <= dt) {
    const double gap = std::hypot(y + t * v_y, z + t * v_z) - (R + r);
    ++advancement.iterations;
    const double next = t + gap / speed;  // eq. (8); infinite at rest
    if (gap <= tolerance || next == t) {  // or too near for t to tell
      advancement.time = t;
      break;
    }
    t = next;
  }
  return advancement;
}

ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  require_valid(particle, cylinder, 0.0);
  common::require_finite(time, "time");
  const Vec3 x = particle.position + time * particle.velocity;
  const double size = std::max(std::abs(x.y()), std::abs(x.z()));
  ParticleContact contact;
  if (size > 0.0) contact.normal = Vec3(0.0, x.y() / size, x.z() / size).normalized();
  contact.point_on_cylinder = Vec3(x.x(), 0.0, 0.0) + cylinder.radius * contact.normal;
  contact.point_on_particle = x - particle.radius * contact.normal;
  contact.gap = std::hypot(x.y(), x.z()) - (cylinder.radius + particle.radius);
  contact.time = time;
  return contact;
}

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
  for (std::size_t i = 0; i < y.size(); i += block) {
    const Block particles_here{&y[i], &z[i], &v_y[i], &v_z[i], std::min(block, y.size() - i)};
    require_finite(particles_here);
    find_times(particles_here, cylinder.radius, r, dt, &times[i]);
  }
  return times;
}

std::optional<double> time_of_impact_of_edge(const MovingEdge& /*edge*/,
                                             const Cylinder& /*cylinder*/, double /*dt*/) {
  throw common::NotImplemented("4.6 time_of_impact_of_edge");
}

}  // namespace lab::continuous_particle_cylinder

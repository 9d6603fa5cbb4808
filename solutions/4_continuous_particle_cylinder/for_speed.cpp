// The lab once more, built for speed: as right as the plain reference beside it, by more code. Its
// tricks, how many lines each takes, and the time of a query without and with it, in ns: measured
// once, g++ 12 at -O3, one core with registers of eight doubles, shared with other programs.
//
//   what                                 where                    lines  of            without with
//   a bound of the error goes along
//     with each number: no terms apart   Bounded                     33  a particle        101   81
//   no branch: one instruction does
//     the same for eight particles       quick_time, find_times      37  one of many        75   11
//   blocks whose numbers stay near: no
//     array of doubts, but no time       block, Block                19  one of many        11   11
//   doubles with margins tell of most
//     edges, exact numbers of ties       edge_piece to sure_signs    99  a cloth's edge  12700  182
//   a straight line between edge and
//     disc: then no quartic at all       is_kept_off                 18  a cloth's edge    182   26
//   doubles first, then double-double    TouchSearch<double>          8  a long sweep     1120  800
//   Newton's method where there is one
//     root, with a bound of its error    TouchSearch::root           36  a long sweep    15600  800
#include "continuous_particle_cylinder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "common/course/require.hpp"
#include "common/exact/bernstein.hpp"
#include "common/exact/double_double.hpp"
#include "common/exact/exact_number.hpp"
#include "common/exact/exact_roots.hpp"

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
template <typename Number>
struct Motion {
  Number y, z, v_y, v_z;
  Number R, r;
};

Motion<double> motion(const MovingParticle& particle, const Cylinder& cylinder) {
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

inline Bounded operator+(Bounded a, Bounded b) {
  const DoubleDouble sum = a.value + b.value;
  return {sum, a.error + b.error + 3.0 * u_squared * std::abs(sum.high)};
}

inline Bounded operator-(Bounded a, Bounded b) { return a + Bounded{-b.value, b.error}; }

inline Bounded operator*(Bounded a, Bounded b) {
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

inline Bounded sum(double a, double b) { return {common::two_sum(a, b), 0.0}; }
inline Bounded product(double a, double b) { return {common::two_product(a, b), underflow}; }

ExactNumber sum(const ExactNumber& a, const ExactNumber& b) { return a + b; }
ExactNumber product(const ExactNumber& a, const ExactNumber& b) { return a * b; }

/// |x + t v|² − ρ² = a t² + 2 b t + c, and b² − a c as the cross form has it.
template <typename Number>
struct Quadratic {
  Number a, b, c, discriminant;
};

/// In Bounded for a motion in double, in ExactNumber for one in ExactNumber.
template <typename Number>
[[gnu::always_inline]] inline auto quadratic(const Motion<Number>& m) {
  const auto rho = sum(m.R, m.r);
  const auto rho_squared = rho * rho;
  const auto a = product(m.v_y, m.v_y) + product(m.v_z, m.v_z);
  const auto b = product(m.y, m.v_y) + product(m.z, m.v_z);
  const auto c = product(m.y, m.y) + product(m.z, m.z) - rho_squared;
  const auto w = product(m.y, m.v_z) - product(m.z, m.v_y);
  return Quadratic<std::decay_t<decltype(a)>>{a, b, c, rho_squared * a - w * w};
}

/// t* to 1 ulp, infinity where there is none, NaN where double-double is not sure. In line and
/// without a branch, so that a compiler can do many at a time.
[[gnu::always_inline]] inline double quick_time(const Motion<double>& m, double dt) {
  constexpr double slack = 0x1p-57;  // of the relative errors of c and of −b + √: t to 5/8 ulp
  const auto [a, b, c, discriminant] = quadratic(m);
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
  const bool leaves = surely_positive(b);
  const bool passes = surely_negative(discriminant);
  const bool missed = surely_positive(c) & (at_rest | leaves | passes);
  const bool never = late | missed;
  // NOLINTNEXTLINE(bugprone-narrowing-conversions): NaN is unlike itself, but it is no loss here
  const double outcome = never ? infinity : hit ? t : not_sure;
  return surely_negative(c) ? 0.0 : outcome;
}

/// t* to 1 ulp, infinity where there is none.
double exact_time(const Motion<double>& m, double dt) {
  const auto [a, b, c, discriminant] =
      quadratic(Motion<ExactNumber>{m.y, m.z, m.v_y, m.v_z, m.R, m.r});
  if (c.sign() <= 0) return 0.0;
  if (b.sign() >= 0 || discriminant.sign() < 0) return infinity;
  const ExactNumber end = dt;
  const ExactNumber half_slope = a * end + b;  // of the quadratic, at dt
  const bool inside_at_end = (c + end * (b + half_slope)).sign() <= 0;
  if (half_slope.sign() < 0 && !inside_at_end) return infinity;

  // Only the quotient need be within the range of a double: take both of its parts near one.
  const int scale_c = c.exponent();
  const int scale = b.exponent();  // the root is no greater than −b
  const DoubleDouble divisor = sqrt(discriminant.rounded(-2 * scale)) - b.rounded(-scale);
  const double t = (c.rounded(-scale_c) / divisor).high;
  return std::min(std::ldexp(t, scale_c - scale), dt);
}

double certified_time(const Motion<double>& m, double dt) {
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
  for (const double* numbers : {p.y, p.z, p.v_y, p.v_z}) {
    for (std::size_t i = 0; i < p.size; ++i) {
      const bool this_one = std::isfinite(numbers[i]);
      finite = finite & this_one;
    }
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

}  // namespace lab::continuous_particle_cylinder

// ---- Step 4.6 ----

namespace lab::continuous_particle_cylinder {
namespace {

using common::Bernstein;
using common::ExactPolynomial;

struct EdgeQuery {
  const MovingEdge& edge;
  const Cylinder& cylinder;
  double dt;
};

template <typename Number>
struct Plane {
  Number y, z;
};

template <typename Number>
Number dot(const Plane<Number>& a, const Plane<Number>& b) {
  return a.y * b.y + a.z * b.z;
}

template <typename Number>
Number cross(const Plane<Number>& a, const Plane<Number>& b) {
  return a.y * b.z - a.z * b.y;
}

template <typename Number>
Plane<Number> moved(const Plane<Number>& x, const Plane<Number>& v, double t) {
  return {x.y + v.y * Number(t), x.z + v.z * Number(t)};
}

/// One end p + t v, and from it to the other d + t w.
template <typename Number>
struct EdgeMotion {
  Plane<Number> p, v, d, w;
  Number rho_squared;
};

template <typename Number>
EdgeMotion<Number> edge_motion(const EdgeQuery& query) {
  const auto plane = [](const Vec3& x) { return Plane<Number>{x.y(), x.z()}; };
  const auto difference = [](const Vec3& x, const Vec3& y) {
    return Plane<Number>{Number(x.y()) - Number(y.y()), Number(x.z()) - Number(y.z())};
  };
  const MovingEdge& edge = query.edge;
  const Number rho = Number(query.cylinder.radius) + Number(edge.radius);
  return {plane(edge.a), plane(edge.velocity_a), difference(edge.b, edge.a),
          difference(edge.velocity_b, edge.velocity_a), rho * rho};
}

/// The edge's inside between two times. With C = p × d and D = d · d:
///
///   f = C² − ρ² D         the edge's line meets the disc where f ≤ 0                    eq. (10)
///   p · d < 0 < q · d     the foot of the perpendicular is inside the edge              eq. (11)
template <typename Number>
struct Piece {
  double from, to;
  Bernstein<Number, 4> six_f;
  Bernstein<Number, 2> p_d, q_d;
};

template <typename Number>
Piece<Number> edge_piece(const EdgeMotion<Number>& m, double from, double to) {
  using common::half;
  const Plane<Number> p_from = moved(m.p, m.v, from);
  const Plane<Number> p_to = moved(m.p, m.v, to);
  const Plane<Number> d_from = moved(m.d, m.w, from);
  const Plane<Number> d_to = moved(m.d, m.w, to);
  const Bernstein<Number, 2> C{cross(p_from, d_from),
                               half(cross(p_from, d_to) + cross(p_to, d_from)), cross(p_to, d_to)};
  const Bernstein<Number, 2> D{dot(d_from, d_from), dot(d_from, d_to), dot(d_to, d_to)};
  const Bernstein<Number, 2> p_d{dot(p_from, d_from), half(dot(p_from, d_to) + dot(p_to, d_from)),
                                 dot(p_to, d_to)};
  const auto term = [&](double k, const Number& C_squared, const Number& d_squared) {
    return Number(k) * (C_squared - m.rho_squared * d_squared);
  };
  const Bernstein<Number, 4> six_f{
      term(6.0, C[0] * C[0], D[0]), term(3.0, C[0] * (C[1] + C[1]), D[0] + D[1]),
      term(2.0, C[1] * (C[1] + C[1]) + C[0] * C[2], half(D[0] + D[2]) + (D[1] + D[1])),
      term(3.0, C[2] * (C[1] + C[1]), D[1] + D[2]), term(6.0, C[2] * C[2], D[2])};
  return {from, to, six_f, p_d, {p_d[0] + D[0], p_d[1] + D[1], p_d[2] + D[2]}};
}

/// Bounds of |p|, |d| and ρ over the step.
struct EdgeSizes {
  double path, length, rho;
};

EdgeSizes edge_sizes(const EdgeMotion<double>& m, const EdgeQuery& query) {
  const auto size = [](const Plane<double>& x) { return std::abs(x.y) + std::abs(x.z); };
  return {size(m.p) + query.dt * size(m.v), size(m.d) + query.dt * size(m.w),
          query.cylinder.radius + query.edge.radius};
}

/// How far rounding can have moved the coefficients of a piece: those of 6f by 120 roundings of
/// terms of this size and by 24 more at each of at most 50 halvings, an operation of double-double
/// counting as five of u².
struct Margins {
  double six_f, along;
};

template <typename Number>
Margins margins(const EdgeSizes& size) {
  const double u = std::is_same_v<Number, double> ? 0x1p-53 : 0x1p-103;
  const double length_squared = size.length * size.length;
  return {1400.0 * u * (size.path * size.path + size.rho * size.rho) * length_squared,
          150.0 * u * (size.path + size.length) * size.length};
}

double leading(double x) { return x; }
double leading(const DoubleDouble& x) { return x.high; }

int sure_sign(double value, double margin) { return value > margin ? 1 : value < -margin ? -1 : 0; }

template <std::size_t size>
struct SureSigns {
  std::array<int, size> signs;

  /// The polynomial's sign all over its piece, 0 where the coefficients do not tell.
  [[nodiscard]] int throughout() const {
    return std::all_of(signs.begin(), signs.end(), [&](int s) { return s == signs[0]; }) ? signs[0]
                                                                                         : 0;
  }
  /// Whether it comes down through zero once, and all the rest is sure.
  [[nodiscard]] bool fall_once() const {
    return signs.front() == 1 && signs.back() == -1 &&
           std::is_sorted(signs.rbegin(), signs.rend()) &&
           std::count(signs.begin(), signs.end(), 0) == 0;
  }
  [[nodiscard]] bool none() const {
    return std::all_of(signs.begin(), signs.end(), [](int s) { return s == 0; });
  }
};

template <typename Number, std::size_t size>
SureSigns<size> sure_signs(const std::array<Number, size>& coefficients, double margin) {
  SureSigns<size> result{};
  for (std::size_t i = 0; i < size; ++i) {
    result.signs[i] = sure_sign(leading(coefficients[i]), margin);
  }
  return result;
}

/// (a + t v_a) ∘ (b + t v_b), where ∘ is a product of vectors.
template <typename Product>
ExactPolynomial exact_product(Product product, const Plane<ExactNumber>& a,
                              const Plane<ExactNumber>& v_a, const Plane<ExactNumber>& b,
                              const Plane<ExactNumber>& v_b) {
  return {product(a, b), product(a, v_b) + product(v_a, b), product(v_a, v_b)};
}

ExactPolynomial exact_f(const EdgeMotion<ExactNumber>& m) {
  const ExactPolynomial C = exact_product(cross<ExactNumber>, m.p, m.v, m.d, m.w);
  const ExactPolynomial D = exact_product(dot<ExactNumber>, m.d, m.w, m.d, m.w);
  return C * C - ExactPolynomial{m.rho_squared} * D;
}

/// −(p · d) (q · d): above zero where the foot is inside the edge.
ExactPolynomial exact_foot(const EdgeMotion<ExactNumber>& m) {
  const Plane<ExactNumber> q{m.p.y + m.d.y, m.p.z + m.d.z};
  const Plane<ExactNumber> v_q{m.v.y + m.w.y, m.v.z + m.w.z};
  const ExactPolynomial p_d = exact_product(dot<ExactNumber>, m.p, m.v, m.d, m.w);
  const ExactPolynomial q_d = exact_product(dot<ExactNumber>, q, v_q, m.d, m.w);
  return ExactPolynomial{} - p_d * q_d;
}

bool touches_at_start_exactly(const EdgeQuery& query) {
  const auto motion = edge_motion<ExactNumber>(query);
  return exact_f(motion)[0].sign() <= 0 && exact_foot(motion)[0].sign() > 0;
}

constexpr double time_accuracy = 0x1p-50;  ///< of t*, in steps

std::optional<double> first_touch_exactly(const EdgeQuery& query, double from, double to,
                                          bool foot_inside) {
  const auto motion = edge_motion<ExactNumber>(query);
  const common::ExactRoots touches(exact_f(motion),
                                   foot_inside ? ExactPolynomial{1.0} : exact_foot(motion));
  if (touches.count(from, to) == 0) return std::nullopt;
  return touches.first(from, to, time_accuracy * query.dt);
}

/// The first time at which the edge's inside touches while its ends do not: f comes down to zero
/// with the foot inside. What Number cannot decide goes to the next: double, double-double, exact.
template <typename Number>
class TouchSearch {
 public:
  TouchSearch(const EdgeQuery& query, const EdgeSizes& sizes)
      : query_(query),
        sizes_(sizes),
        motion_(edge_motion<Number>(query)),
        margins_(margins<Number>(sizes)) {}

  [[nodiscard]] std::optional<double> first_touch(double from, double to) const {
    return first_touch(edge_piece(motion_, from, to));
  }

  [[nodiscard]] std::optional<double> first_touch(const Piece<Number>& piece) const {
    const auto f = sure_signs(piece.six_f, margins_.six_f);
    const int foot = foot_inside(piece);
    if (f.throughout() != 0 || foot == -1) return std::nullopt;
    if (f.fall_once() && foot == 1) {
      if (const auto time = root(piece)) return time;
    }
    if (f.none() || piece.to - piece.from <= narrowest()) return decide(piece, foot == 1);

    const auto [f_left, f_right] = common::halves(piece.six_f);
    const auto [p_left, p_right] = common::halves(piece.p_d);
    const auto [q_left, q_right] = common::halves(piece.q_d);
    const double middle = piece.from + 0.5 * (piece.to - piece.from);
    const Piece<Number> left{piece.from, middle, f_left, p_left, q_left};
    const Piece<Number> right{middle, piece.to, f_right, p_right, q_right};
    if (const auto time = first_touch(left)) return time;
    return first_touch(right);
  }

 private:
  static constexpr bool is_first = std::is_same_v<Number, double>;

  /// 1 where it is all over the piece, −1 where it is nowhere, 0 where the coefficients do not
  /// tell.
  [[nodiscard]] int foot_inside(const Piece<Number>& piece) const {
    const int p_d = sure_signs(piece.p_d, margins_.along).throughout();
    const int q_d = sure_signs(piece.q_d, margins_.along).throughout();
    return p_d < 0 && q_d > 0 ? 1 : p_d * q_d > 0 ? -1 : 0;
  }

  [[nodiscard]] double narrowest() const {
    return (is_first ? 0x1p-22 : time_accuracy) * query_.dt;
  }

  [[nodiscard]] std::optional<double> decide(const Piece<Number>& piece, bool foot_inside) const {
    if constexpr (is_first) {
      return TouchSearch<DoubleDouble>(query_, sizes_).first_touch(piece.from, piece.to);
    } else {
      return first_touch_exactly(query_, piece.from, piece.to, foot_inside);
    }
  }

  /// The root of a piece that falls all the way, by Newton's method; none where it is not sure to
  /// the accuracy wanted: |t − t*| ≤ |f(t)| / least slope.
  [[nodiscard]] std::optional<double> root(const Piece<Number>& piece) const {
    Bernstein<double, 4> f{};
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = leading(piece.six_f[i]);
    Bernstein<double, 3> slope{};
    for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = 4.0 * (f[i + 1] - f[i]);
    const double least = -*std::max_element(slope.begin(), slope.end()) - 9.0 * margins_.six_f;
    if (!(least > 0.0)) return std::nullopt;

    const double width = piece.to - piece.from;
    const double tolerance = least * time_accuracy * query_.dt / width;
    const auto next = [&](double s, double value) {
      return std::clamp(s - value / common::value_at(slope, s), 0.0, 1.0);
    };
    double s = f[0] / (f[0] - f[4]);
    for (int i = 0; i < 4; ++i) s = next(s, common::value_at(f, s));
    for (int i = 0; i < 3; ++i) {
      const double t = std::min(piece.from + s * width, piece.to);
      const double value = precise_value(t);
      if (std::abs(value) + margins<DoubleDouble>(sizes_).six_f <= tolerance) return t;
      s = next(s, value);
    }
    return std::nullopt;
  }

  [[nodiscard]] double precise_value(double t) const {
    const auto m = edge_motion<DoubleDouble>(query_);
    const auto d = moved(m.d, m.w, t);
    const auto C = cross(moved(m.p, m.v, t), d);
    return 6.0 * leading(C * C - m.rho_squared * dot(d, d));
  }

  const EdgeQuery& query_;
  EdgeSizes sizes_;
  EdgeMotion<Number> motion_;
  Margins margins_;
};

/// Where squares neither overflow nor lose their last parts.
bool in_range(const EdgeSizes& size) {
  return size.rho > 1e-60 && size.length > 1e-60 && size.path + size.length + size.rho < 1e60;
}

std::optional<double> first_touch_of_inside(const EdgeQuery& query, double horizon) {
  const auto motion = edge_motion<double>(query);
  const EdgeSizes sizes = edge_sizes(motion, query);
  if (!in_range(sizes)) {
    if (touches_at_start_exactly(query)) return 0.0;
    return first_touch_exactly(query, 0.0, horizon, false);
  }
  const Margins margin = margins<double>(sizes);
  const Piece<double> whole = edge_piece(motion, 0.0, horizon);
  const bool off = sure_sign(whole.six_f[0], margin.six_f) > 0 ||
                   sure_sign(whole.p_d[0], margin.along) > 0 ||
                   sure_sign(whole.q_d[0], margin.along) < 0;
  if (!off && touches_at_start_exactly(query)) return 0.0;
  return TouchSearch<double>(query, sizes).first_touch(whole);
}

/// Whether a straight line keeps the edge off the disc all the time, for certain: the one across
/// the way from the axis to the edge's nearest point. It spares most edges of a cloth the rest.
bool is_kept_off(const EdgeQuery& query) {
  const auto m = edge_motion<double>(query);
  const EdgeSizes size = edge_sizes(m, query);
  const double s = std::clamp(-dot(m.p, m.d) / dot(m.d, m.d), 0.0, 1.0);
  const Plane<double> n{m.p.y + s * m.d.y, m.p.z + s * m.d.z};
  const double n_v = dot(n, m.v);
  const double a = dot(n, m.p) + std::min(query.dt * n_v, 0.0);
  const double b = dot(n, m.p) + dot(n, m.d) + std::min(query.dt * (n_v + dot(n, m.w)), 0.0);
  const double n_squared = dot(n, n);
  const double n_size = std::sqrt(n_squared);
  // Some 20 roundings of terms of these sizes.
  const double margin = 0x1p-48 * n_size * (size.path + size.length + size.rho);
  return n_squared > 1e-280 && std::min(a, b) > n_size * size.rho + margin;
}

}  // namespace

std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  const MovingParticle end_a{edge.a, edge.velocity_a, edge.radius};
  const MovingParticle end_b{edge.b, edge.velocity_b, edge.radius};
  require_valid(end_a, cylinder, dt);
  require_valid(end_b, cylinder, dt);
  const EdgeQuery query{edge, cylinder, dt};
  if (is_kept_off(query)) return std::nullopt;

  const auto time_a = time_of_impact_certified(end_a, cylinder, dt);
  const auto time_b = time_of_impact_certified(end_b, cylinder, dt);
  const auto end = time_a && time_b ? std::min(time_a, time_b) : time_a ? time_a : time_b;
  if (end == 0.0) return end;
  // Up to here the ends do not touch; what is nearer to their impact than t* must be does not
  // count.
  const double horizon = end ? *end * (1.0 - time_accuracy) : dt;
  const auto inside = first_touch_of_inside(query, horizon);
  return inside ? inside : end;
}

}  // namespace lab::continuous_particle_cylinder

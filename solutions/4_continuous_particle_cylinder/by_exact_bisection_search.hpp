#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "common/exact/double_double.hpp"
#include "common/exact/exact_number.hpp"
#include "continuous_particle_cylinder.hpp"

/// Of by_exact_bisection.cpp: the time of impact, searched among the doubles by exact signs.
namespace lab::continuous_particle_cylinder::exact_bisection {

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

inline Path path_of(const MovingParticle& particle, const Cylinder& cylinder) {
  const Vec3& x = particle.position;
  const Vec3& v = particle.velocity;
  return {x.y(), x.z(), v.y(), v.z(), cylinder.radius, particle.radius};
}

/// Whether double-double loses nothing of a product of four numbers of this size.
inline bool is_moderate(double value) {
  const double size = std::abs(value);
  return size == 0.0 || (size >= 1e-60 && size <= 1e60);
}
inline bool is_moderate(const Path& path) {
  return is_moderate(path.y) && is_moderate(path.z) && is_moderate(path.vy) &&
         is_moderate(path.vz) && is_moderate(path.R) && is_moderate(path.r);
}

/// The sign of a value that is known to within `bound`; 2 where that leaves it open.
constexpr int unsure = 2;
inline int sign_beyond(DoubleDouble value, double bound) {
  if (std::abs(value.high) > bound) return value.high > 0.0 ? 1 : -1;
  return unsure;
}

/// Of a sum of a few products of four factors: some 30 u² of the terms, u² = 2⁻¹⁰⁶.
constexpr double rounding = 0x1p-100;

template <typename Number>
inline Number square(const Number& x) {
  return x * x;
}

/// The sign of |2 x + s v|² − 4 ρ² with s = earlier + later, and of its slope. Half of s is the
/// middle of two neighbours, which is no double.
struct Signs {
  int gap;
  int slope;
};

inline Signs exact_signs(const Path& path, double earlier, double later) {
  const ExactNumber s = ExactNumber(earlier) + ExactNumber(later);
  const ExactNumber two(2.0);
  const ExactNumber y = two * path.y + s * path.vy;
  const ExactNumber z = two * path.z + s * path.vz;
  const ExactNumber rho = two * (ExactNumber(path.R) + path.r);
  return {(y * y + z * z - rho * rho).sign(), (y * path.vy + z * path.vz).sign()};
}

inline Signs signs(const Path& path, bool moderate, double earlier, double later) {
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
inline bool line_meets(const Path& path, bool moderate) {
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
inline bool has_met(const Path& path, bool moderate, double earlier, double later) {
  const Signs found = signs(path, moderate, earlier, later);
  return found.gap <= 0 || found.slope >= 0;
}

/// Doubles from zero up and their bits rise together.
inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
inline double value(std::uint64_t bits) { return std::bit_cast<double>(bits); }

/// A guess of t*, however bad: it only saves bisections.
inline double guess(const Path& path) {
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
inline Bracket bracket(const Path& path, bool moderate, double dt) {
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
inline double nearest_time(const Path& path, bool moderate, double dt) {
  auto [before, met] = bracket(path, moderate, dt);
  while (met - before > 1) {
    const std::uint64_t middle = before + (met - before) / 2;
    (has_met(path, moderate, value(middle), value(middle)) ? met : before) = middle;
  }
  return value(has_met(path, moderate, value(before), value(met)) ? before : met);
}

inline std::optional<double> first_time(const Path& path, double dt) {
  const bool moderate = is_moderate(path);
  const Signs start = signs(path, moderate, 0.0, 0.0);
  if (start.gap <= 0) return 0.0;
  if (start.slope >= 0 || !line_meets(path, moderate)) return std::nullopt;
  if (!has_met(path, moderate, dt, dt)) return std::nullopt;
  return nearest_time(path, moderate, dt);
}

}  // namespace lab::continuous_particle_cylinder::exact_bisection

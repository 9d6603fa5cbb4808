#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <vector>

/// Times of impact in whole numbers: hit or miss without any rounding, the time in 50 digits.
namespace tests {

using boost::multiprecision::cpp_int;
using Digits100 = boost::multiprecision::cpp_bin_float_100;
/// Of a time, which rounds only after all that cancels is summed in whole numbers: to 2⁻¹⁶⁰ of it,
/// where an ulp is 2⁻⁵² and bounds are counted in parts of one.
using Digits50 = boost::multiprecision::cpp_bin_float_50;

/// One coordinate of a path x + t v.
struct Coordinate {
  double position;
  double velocity;
};

/// The power of two of the last bit that any of the values may have; 0 where all are zero.
inline int last_bit(const std::vector<double>& values) {
  int bit = std::numeric_limits<int>::max();
  for (const double value : values) {
    if (value != 0.0) bit = std::min(bit, std::ilogb(value) - 52);
  }
  return bit == std::numeric_limits<int>::max() ? 0 : bit;
}

/// value / 2^bit.
inline cpp_int whole(double value, int bit) {
  if (value == 0.0) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
  return cpp_int(mantissa) << static_cast<unsigned>(exponent - 53 - bit);
}

/// |x + t v|² − ρ² = 2^(…) (a s² + 2 b s + c) with t = s 2^unit.
struct Quadratic {
  cpp_int a = 0;
  cpp_int b = 0;
  cpp_int c = 0;
  cpp_int rho_squared = 0;  ///< in the unit of c
  int unit = 0;
};

inline Quadratic quadratic(const std::vector<Coordinate>& path, double R, double r) {
  std::vector<double> lengths{R, r};
  std::vector<double> speeds;
  for (const Coordinate& coordinate : path) {
    lengths.push_back(coordinate.position);
    speeds.push_back(coordinate.velocity);
  }
  const int length = last_bit(lengths);
  const int speed = last_bit(speeds);
  const cpp_int rho = whole(R, length) + whole(r, length);
  Quadratic f;
  f.rho_squared = rho * rho;
  f.c = -f.rho_squared;
  f.unit = length - speed;
  for (const Coordinate& coordinate : path) {
    const cpp_int x = whole(coordinate.position, length);
    const cpp_int v = whole(coordinate.velocity, speed);
    f.a += v * v;
    f.b += x * v;
    f.c += x * x;
  }
  return f;
}

inline cpp_int discriminant(const Quadratic& f) { return f.b * f.b - f.a * f.c; }

inline Digits50 root_of_discriminant(const Quadratic& f) { return sqrt(Digits50(discriminant(f))); }

/// The first of two roots. It must be that of an approach: b < 0, discriminant ≥ 0.
inline Digits50 first_root(const Quadratic& f) {
  return ldexp(Digits50(Digits50(f.c) / (root_of_discriminant(f) - Digits50(f.b))), f.unit);
}
inline Digits50 later_root(const Quadratic& f) {
  return ldexp(Digits50((root_of_discriminant(f) - Digits50(f.b)) / Digits50(f.a)), f.unit);
}

/// Whether the first root, that of an approach, is at dt or before it.
inline bool arrives(const Quadratic& f, double dt) {
  const int bit = last_bit({dt});
  const int shift = bit - f.unit;
  const cpp_int numerator = whole(dt, bit) << static_cast<unsigned>(std::max(shift, 0));
  const auto denominator = static_cast<unsigned>(std::max(-shift, 0));
  const cpp_int slope = (f.b << denominator) + f.a * numerator;  // half that of the parabola at dt
  return slope >= 0 || slope * slope <= (discriminant(f) << (2 * denominator));
}

/// t* of a parabola, as the contract says it.
inline std::optional<Digits50> first_time(const Quadratic& f, double dt) {
  if (f.c <= 0) return Digits50(0);
  if (f.b >= 0 || discriminant(f) < 0 || !arrives(f, dt)) return std::nullopt;
  return first_root(f);
}

/// The distance of neighbouring doubles at a time.
template <typename Digits>
Digits ulp(const Digits& time) {
  int exponent = 0;
  frexp(time, &exponent);
  return ldexp(Digits(1), time == 0 ? -1074 : std::max(exponent - 53, -1074));
}

/// How many ulp of the exact value lie between it and a double.
template <typename Digits>
double ulps(double got, const Digits& exact) {
  return static_cast<double>(Digits(abs(Digits(got) - exact) / ulp(exact)));
}

}  // namespace tests

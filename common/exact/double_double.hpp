#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace common {

/// An unevaluated sum high + low with |low| ≤ ulp(high)/2, which has about 106 bits. Each operation
/// states its largest relative error in units of u² = 2⁻¹⁰⁶. This holds if nothing overflows and if
/// no product's last part falls below 1e-290. Joldes, Muller, Popescu 2017, ACM TOMS 44(2).
///
/// No operation has a branch, so a compiler can do many at a time.
struct DoubleDouble {
  double high = 0.0;
  double low = 0.0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: a double is one, exactly
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
};

/// Returns a + b without rounding, if |a| ≥ |b| or a = 0.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// Returns a + b without rounding.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  return {sum, (a - (sum - from_b)) + (b - from_b)};
}

/// Returns a b without rounding.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

/// The error is at most 3 u² of the sum, even if it cancels.
inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_sum(a.high, b.high);
  const DoubleDouble low = two_sum(a.low, b.low);
  const DoubleDouble once = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(once.high, once.low + low.low);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }

/// The error is at most 5 u².
inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = two_product(a.high, b.high);
  const double cross = std::fma(a.high, b.low, a.low * b.high);
  return quick_two_sum(high.high, high.low + cross);
}

/// The error is at most 12 u².
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double first = a.high / b.high;
  const double rest = std::fma(-first, b.high, a.high) + std::fma(-first, b.low, a.low);
  return quick_two_sum(first, rest / b.high);
}

/// The error is at most 4 u², for a ≥ 0.
inline DoubleDouble sqrt(DoubleDouble a) {
  constexpr double least = std::numeric_limits<double>::min();  // 0 has the root 0
  const double root = std::sqrt(a.high);
  const double rest = std::fma(-root, root, a.high) + a.low;
  return quick_two_sum(root, rest / std::max(2.0 * root, least));
}

}  // namespace common

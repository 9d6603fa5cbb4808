#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "common/exact/double_double.hpp"

namespace common {

/// A polynomial over an interval, by its Bernstein coefficients from the interval's start to its
/// end. The first and the last coefficient are the polynomial's values there. If all coefficients
/// have one sign, so has the polynomial. It has at most as many roots as its coefficients change
/// sign, and any lower number of roots differs from that by an even number.
template <typename Number, std::size_t degree>
using Bernstein = std::array<Number, degree + 1>;

inline double half(double x) { return 0.5 * x; }
inline DoubleDouble half(DoubleDouble x) { return {0.5 * x.high, 0.5 * x.low}; }

/// The same polynomial over the first half of its interval, and over the second.
template <typename Polynomial>
struct Halves {
  Polynomial first;
  Polynomial second;
};

/// Halves by De Casteljau's means of neighbours. No mean grows, so its rounding does not grow.
template <typename Number, std::size_t size>
Halves<std::array<Number, size>> halves(std::array<Number, size> coefficients) {
  Halves<std::array<Number, size>> parts;
  for (std::size_t level = 0; level < size; ++level) {
    parts.first[level] = coefficients[0];
    parts.second[size - 1 - level] = coefficients[size - 1 - level];
    for (std::size_t i = 0; i + 1 < size - level; ++i) {
      coefficients[i] = half(coefficients[i] + coefficients[i + 1]);
    }
  }
  return parts;
}

/// A range that holds all values of a polynomial over its interval: the range of its coefficients.
struct Range {
  double lowest, highest;
};

template <std::size_t size>
Range range(const std::array<DoubleDouble, size>& coefficients) {
  Range all{coefficients[0].high, coefficients[0].high};
  for (const DoubleDouble& c : coefficients) {
    all = {std::min(all.lowest, c.high), std::max(all.highest, c.high)};
  }
  return all;
}

/// Returns the value of the polynomial at the share s of its interval, in [0, 1].
template <std::size_t size>
double value_at(std::array<double, size> coefficients, double s) {
  for (std::size_t left = size - 1; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) {
      coefficients[i] += s * (coefficients[i + 1] - coefficients[i]);
    }
  }
  return coefficients[0];
}

}  // namespace common

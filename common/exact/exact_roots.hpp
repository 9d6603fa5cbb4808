#pragma once

#include <vector>

#include "common/exact/exact_number.hpp"

namespace common {

/// The coefficients of 1, t, t², ...
using ExactPolynomial = std::vector<ExactNumber>;

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);
ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b);
ExactPolynomial operator-(const ExactPolynomial& a, const ExactPolynomial& b);

/// Counts real roots without any rounding. It also finds the roots that rounding cannot tell from
/// none: double ones, at which f touches zero, and pairs closer than a double resolves. It uses
/// Sturm's theorem and its extension by Tarski; Basu, Pollack, Roy 2006, Algorithms in Real
/// Algebraic Geometry, 2.2.2. A quartic takes tens to hundreds of microseconds.
class ExactRoots {
 public:
  /// Selects the roots of f at which g > 0. At most one root of f may also be a root of g.
  ExactRoots(const ExactPolynomial& f, const ExactPolynomial& g);

  /// Returns the number of these roots in (from, to]; a multiple one counts once. It is 0 if f is
  /// zero everywhere.
  [[nodiscard]] int count(double from, double to) const;

  /// Returns the first of these roots in (from, to], which must have one. The result is above the
  /// root by less than `width`, or it is the next double if that is further.
  [[nodiscard]] double first(double from, double to, double width) const;

 private:
  using Chain = std::vector<ExactPolynomial>;

  Chain roots_;  ///< their changes of sign count the roots
  Chain signs_;  ///< they give the sum of the signs of g at the roots; empty if all count
};

}  // namespace common

#pragma once

#include <vector>

#include "common/exact_number.hpp"

namespace common {

/// Coefficients of 1, t, t², ...
using ExactPolynomial = std::vector<ExactNumber>;

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b);
ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b);
ExactPolynomial operator-(const ExactPolynomial& a, const ExactPolynomial& b);

/// Counts real roots without any rounding, also those that rounding cannot tell from none: double
/// ones, where f touches zero, and pairs closer than a double resolves. By Sturm's theorem and its
/// extension by Tarski; Basu, Pollack, Roy 2006, Algorithms in Real Algebraic Geometry, 2.2.2. Tens
/// to hundreds of microseconds for a quartic.
class ExactRoots {
 public:
  /// The roots of f at which g > 0. At most one root of f may be one of g, too.
  ExactRoots(const ExactPolynomial& f, const ExactPolynomial& g);

  /// How many there are in (from, to], a multiple one once; 0 where f is zero throughout.
  [[nodiscard]] int count(double from, double to) const;

  /// The first of those in (from, to], of which there is one at least, from above: by less than
  /// `width`, or to the next double where that is wider.
  [[nodiscard]] double first(double from, double to, double width) const;

 private:
  using Chain = std::vector<ExactPolynomial>;

  Chain roots_;  ///< whose changes of sign count the roots
  Chain signs_;  ///< and the sum of the signs of g at them; empty where all count
};

}  // namespace common

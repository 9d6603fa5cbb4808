#pragma once

#include <memory>

#include "common/double_double.hpp"

namespace common {

/// A number that sums, differences and products of doubles leave exact, whatever their sizes: a
/// whole number times a power of two. For the few decisions that double-double cannot take; some 50
/// ns an operation.
class ExactNumber {
 public:
  ExactNumber();
  ExactNumber(double value);  // NOLINT: a finite double is one, exactly
  ExactNumber(const ExactNumber& other);
  ExactNumber(ExactNumber&& other) noexcept;
  ExactNumber& operator=(const ExactNumber& other);
  ExactNumber& operator=(ExactNumber&& other) noexcept;
  ~ExactNumber();

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  /// −1, 0 or 1.
  [[nodiscard]] int sign() const;
  /// e where the number's size is in [2^(e−1), 2^e); far below any other for zero.
  [[nodiscard]] int exponent() const;
  /// The number times 2^shift as the nearest double-double, but for an ulp of its low part: 0 or
  /// infinite outside a double's range.
  [[nodiscard]] DoubleDouble rounded(int shift = 0) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace common

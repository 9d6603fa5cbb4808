#pragma once

#include <cstdint>
#include <vector>

#include "common/exact/double_double.hpp"

namespace common {

/// A number for which sums, differences and products of doubles are exact, whatever their sizes. It
/// is for the few decisions for which double-double is too coarse. An operation takes about 30 ns.
class ExactNumber {
 public:
  ExactNumber(double value);  // NOLINT: a finite double is one, exactly

  // A formula makes and frees many numbers. Defined once in the source, these compile faster.
  ExactNumber();
  ~ExactNumber();
  ExactNumber(const ExactNumber& other);
  ExactNumber(ExactNumber&& other) noexcept;
  ExactNumber& operator=(const ExactNumber& other);
  ExactNumber& operator=(ExactNumber&& other) noexcept;

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  /// Returns −1, 0 or 1.
  [[nodiscard]] int sign() const;
  /// Returns e if the number's size, as the nearest double of unbounded exponent, is in
  /// [2^(e−1), 2^e), and 0 for zero.
  [[nodiscard]] int exponent() const;
  /// Returns the number times 2^shift to 4 u² of double-double: 0 or infinite outside its range.
  [[nodiscard]] DoubleDouble rounded(int shift = 0) const;

 private:
  using Digits = std::vector<std::int64_t>;

  /// Takes digits of any size and carries them.
  ExactNumber(Digits digits, int lowest);

  static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b);
  [[nodiscard]] int end() const { return lowest_ + static_cast<int>(digits_.size()); }
  /// Returns the number over 2^(32 end()).
  [[nodiscard]] DoubleDouble fraction() const;

  Digits digits_;   ///< base 2³², each in [−2³¹, 2³¹), lowest first; neither end is zero
  int lowest_ = 0;  ///< the first digit counts 2^(32 lowest_)
};

}  // namespace common

#pragma once

#include <cstdint>
#include <vector>

#include "common/double_double.hpp"

namespace common {

/// A number that sums, differences and products of doubles leave exact, whatever their sizes. For
/// the few decisions that double-double cannot take; some 30 ns an operation.
class ExactNumber {
 public:
  ExactNumber(double value);  // NOLINT: a finite double is one, exactly

  // A formula makes and frees many: once in common they are quicker to compile.
  ExactNumber();
  ~ExactNumber();
  ExactNumber(const ExactNumber& other);
  ExactNumber(ExactNumber&& other) noexcept;
  ExactNumber& operator=(const ExactNumber& other);
  ExactNumber& operator=(ExactNumber&& other) noexcept;

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  /// −1, 0 or 1.
  [[nodiscard]] int sign() const;
  /// e where the number's size, as the nearest double of unbounded exponent, is in [2^(e−1), 2^e);
  /// 0 for zero.
  [[nodiscard]] int exponent() const;
  /// The number times 2^shift to 4 u² of double-double: 0 or infinite outside a double's range.
  [[nodiscard]] DoubleDouble rounded(int shift = 0) const;

 private:
  using Digits = std::vector<std::int64_t>;

  /// Of digits of any size, which are carried.
  ExactNumber(Digits digits, int lowest);

  static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b);
  [[nodiscard]] int end() const { return lowest_ + static_cast<int>(digits_.size()); }
  /// The number over 2^(32 end()).
  [[nodiscard]] DoubleDouble fraction() const;

  Digits digits_;   ///< base 2³², each in [−2³¹, 2³¹), lowest first; neither end is zero
  int lowest_ = 0;  ///< the first digit counts 2^(32 lowest_)
};

}  // namespace common

#include "common/exact/exact_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace common {
namespace {

constexpr int digit_bits = 32;
constexpr std::int64_t base = std::int64_t{1} << digit_bits;

/// What a digit hands on to the next so that the rest is in [−base/2, base/2). Digits of both signs
/// need no borrowing: 2^1000 − 1 has two that are not zero.
std::int64_t carry_of(std::int64_t digit) { return ((digit >> (digit_bits - 1)) + 1) >> 1; }

}  // namespace

ExactNumber::ExactNumber(double value) {
  if (value == 0.0) return;
  constexpr int mantissa_bits = 53;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, mantissa_bits));
  exponent -= mantissa_bits;
  const int lowest = exponent >> 5;  // rounded down, of either sign
  const std::int64_t factor = std::int64_t{1} << (exponent - digit_bits * lowest);
  const std::int64_t high = mantissa >> digit_bits;
  *this = ExactNumber({(mantissa - high * base) * factor, high * factor, 0}, lowest);
}

ExactNumber::ExactNumber() = default;
ExactNumber::~ExactNumber() = default;
ExactNumber::ExactNumber(const ExactNumber& other) = default;
ExactNumber::ExactNumber(ExactNumber&& other) noexcept = default;
ExactNumber& ExactNumber::operator=(const ExactNumber& other) = default;
ExactNumber& ExactNumber::operator=(ExactNumber&& other) noexcept = default;

ExactNumber::ExactNumber(Digits digits, int lowest) : digits_(std::move(digits)), lowest_(lowest) {
  std::int64_t carry = 0;
  for (std::int64_t& digit : digits_) {
    if (digit == 0 && carry == 0) continue;  // most are, where sizes differ by much
    digit += carry;
    carry = carry_of(digit);
    digit = static_cast<std::int32_t>(digit);  // what is left: the lowest bits, with their sign
  }
  if (carry != 0) digits_.push_back(carry);
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  const auto first = std::find_if(digits_.begin(), digits_.end(), [](auto d) { return d != 0; });
  lowest_ = digits_.empty() ? 0 : lowest + static_cast<int>(first - digits_.begin());
  digits_.erase(digits_.begin(), first);
}

ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b) {
  const int lowest = std::min(a.lowest_, b.lowest_);
  Digits digits(static_cast<std::size_t>(std::max(a.end(), b.end()) - lowest) + 1);
  const auto a_first = digits.begin() + (a.lowest_ - lowest);
  const auto b_first = digits.begin() + (b.lowest_ - lowest);
  std::copy(a.digits_.begin(), a.digits_.end(), a_first);
  std::transform(b.digits_.begin(), b.digits_.end(), b_first, b_first,
                 [&](std::int64_t added, std::int64_t to) { return to + sign_of_b * added; });
  return {std::move(digits), lowest};
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  return ExactNumber::sum(a, b, 1);
}

ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
  return ExactNumber::sum(a, b, -1);
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber::Digits digits(a.digits_.size() + b.digits_.size());
  for (std::size_t i = 0; i < a.digits_.size(); ++i) {
    if (a.digits_[i] == 0) continue;
    for (std::size_t j = 0; j < b.digits_.size(); ++j) {
      const std::int64_t product = a.digits_[i] * b.digits_[j];
      digits[i + j] += product & (base - 1);  // in halves: a thousand of them do not overflow
      digits[i + j + 1] += product >> digit_bits;
    }
  }
  return {std::move(digits), a.lowest_ + b.lowest_};
}

int ExactNumber::sign() const {
  if (digits_.empty()) return 0;
  return digits_.back() < 0 ? -1 : 1;
}

DoubleDouble ExactNumber::fraction() const {
  constexpr std::size_t enough = 5;  // the first holds a bit at least, each further one 32
  const std::size_t count = std::min(enough, digits_.size());
  DoubleDouble sum;
  for (auto digit = digits_.end() - static_cast<std::ptrdiff_t>(count); digit != digits_.end();
       ++digit) {
    sum = (DoubleDouble(static_cast<double>(*digit)) + sum) * DoubleDouble(1.0 / base);
  }
  return sum;
}

int ExactNumber::exponent() const {
  if (digits_.empty()) return 0;
  int exponent = 0;
  std::frexp(fraction().high, &exponent);
  return exponent + digit_bits * end();
}

DoubleDouble ExactNumber::rounded(int shift) const {
  const DoubleDouble value = fraction();
  const double high = std::ldexp(value.high, digit_bits * end() + shift);
  if (!std::isfinite(high)) return {high};
  return quick_two_sum(high, std::ldexp(value.low, digit_bits * end() + shift));
}

}  // namespace common

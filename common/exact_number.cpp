#include "common/exact_number.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <utility>

namespace common {

using boost::multiprecision::cpp_int;

/// mantissa 2^exponent.
struct ExactNumber::Parts {
  cpp_int mantissa;
  int exponent = 0;
};

namespace {

constexpr int digits_of_double = 53;

/// The double nearest to mantissa 2^exponent towards zero, and what that leaves of the mantissa.
double leading_double(cpp_int& mantissa, int exponent) {
  if (mantissa.is_zero()) return 0.0;
  const bool negative = mantissa < 0;
  const cpp_int size = negative ? cpp_int(-mantissa) : mantissa;
  const int excess = static_cast<int>(msb(size)) + 1 - digits_of_double;
  cpp_int leading = size;
  if (excess > 0)
    leading = (size >> static_cast<unsigned>(excess)) << static_cast<unsigned>(excess);
  mantissa = negative ? cpp_int(leading - size) : cpp_int(size - leading);
  const int shift = excess > 0 ? excess : 0;
  const double value = std::ldexp(
      static_cast<double>(cpp_int(leading >> static_cast<unsigned>(shift))), exponent + shift);
  return negative ? -value : value;
}

}  // namespace

ExactNumber::ExactNumber() : parts_(std::make_unique<Parts>()) {}

ExactNumber::ExactNumber(double value) : ExactNumber() {
  const double whole = std::ldexp(std::frexp(value, &parts_->exponent), digits_of_double);
  parts_->mantissa = static_cast<long long>(whole);
  parts_->exponent = value == 0.0 ? 0 : parts_->exponent - digits_of_double;
}

ExactNumber::ExactNumber(const ExactNumber& other)
    : parts_(std::make_unique<Parts>(*other.parts_)) {}
ExactNumber::ExactNumber(ExactNumber&& other) noexcept = default;
ExactNumber& ExactNumber::operator=(ExactNumber&& other) noexcept = default;
ExactNumber::~ExactNumber() = default;

ExactNumber& ExactNumber::operator=(const ExactNumber& other) {
  if (this != &other) parts_ = std::make_unique<Parts>(*other.parts_);
  return *this;
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  const ExactNumber::Parts& high = a.parts_->exponent >= b.parts_->exponent ? *a.parts_ : *b.parts_;
  const ExactNumber::Parts& low = a.parts_->exponent >= b.parts_->exponent ? *b.parts_ : *a.parts_;
  if (high.mantissa.is_zero()) return &low == a.parts_.get() ? a : b;
  ExactNumber sum;
  sum.parts_->mantissa =
      (high.mantissa << static_cast<unsigned>(high.exponent - low.exponent)) + low.mantissa;
  sum.parts_->exponent = low.exponent;
  return sum;
}

ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber opposite = b;
  opposite.parts_->mantissa = -opposite.parts_->mantissa;
  return a + opposite;
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber product;
  product.parts_->mantissa = a.parts_->mantissa * b.parts_->mantissa;
  product.parts_->exponent = a.parts_->exponent + b.parts_->exponent;
  return product;
}

int ExactNumber::sign() const { return parts_->mantissa.sign(); }

int ExactNumber::exponent() const {
  constexpr int below_all = -1000000;
  if (parts_->mantissa.is_zero()) return below_all;
  const cpp_int size = abs(parts_->mantissa);
  return parts_->exponent + static_cast<int>(msb(size)) + 1;
}

DoubleDouble ExactNumber::rounded(int shift) const {
  cpp_int mantissa = parts_->mantissa;
  const double high = leading_double(mantissa, parts_->exponent + shift);
  const double low = leading_double(mantissa, parts_->exponent + shift);
  return std::isfinite(high) ? two_sum(high, low) : DoubleDouble(high);
}

}  // namespace common

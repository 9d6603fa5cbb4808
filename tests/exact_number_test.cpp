#include "common/exact/exact_number.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "random.hpp"

using common::DoubleDouble;
using common::ExactNumber;

namespace {

using boost::multiprecision::cpp_rational;
using Digits = boost::multiprecision::cpp_bin_float_100;

/// Any finite double: of any size, subnormal, whole, a power of two, zero, the greatest or the
/// least.
double any_double(tests::Random& random) {
  const double mantissa = random.uniform(-1.0, 1.0);
  const double extremes[] = {0.0,
                             -0.0,
                             5e-324,
                             -5e-324,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             1.0,
                             -3.0};
  switch (static_cast<int>(random.uniform(0.0, 5.0))) {
    case 0:
      return std::ldexp(mantissa, static_cast<int>(random.uniform(-1080.0, 1024.0)));
    case 1:
      return std::ldexp(mantissa, static_cast<int>(random.uniform(-1074.0, -1022.0)));
    case 2:
      return std::floor(1000.0 * mantissa);
    case 3:
      return std::ldexp(mantissa < 0.0 ? -1.0 : 1.0, static_cast<int>(random.uniform(-1074, 1024)));
    default:
      return extremes[static_cast<int>(random.uniform(0.0, 8.0))];
  }
}

int sign(const cpp_rational& a) { return a.sign(); }
int sign(const ExactNumber& a) { return a.sign(); }

/// Polynomials of degree four in four numbers, as the labs' decisions are.
template <typename Number>
std::vector<Number> polynomials(double a, double b, double c, double d) {
  const Number p = Number(a) * Number(b) - Number(c) * Number(d);
  const Number q = Number(a) + Number(b) - (Number(c) + Number(d));
  return {p, q, p * p - q, q * q * p, p * q - q * p, p - p, p * p - Number(a) * q * Number(d)};
}

/// 2^e as a rational.
cpp_rational power_of_two(int e) {
  const boost::multiprecision::cpp_int size = boost::multiprecision::cpp_int(1)
                                              << static_cast<unsigned>(std::abs(e));
  return e < 0 ? cpp_rational(1, size) : cpp_rational(size);
}

}  // namespace

TEST_CASE("Signs of polynomials are those of rational arithmetic", "[exact_number]") {
  tests::Random random(1);
  int wrong = 0;
  int zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    double a = any_double(random);
    const double b = any_double(random);
    const double c = i % 3 == 0 ? b : any_double(random);
    const double d = i % 6 == 0 ? std::nextafter(a, 1.0) : i % 3 == 0 ? a : any_double(random);
    const auto got = polynomials<ExactNumber>(a, b, c, d);
    const auto wanted = polynomials<cpp_rational>(a, b, c, d);
    for (std::size_t j = 0; j < got.size(); ++j) {
      wrong += sign(got[j]) != sign(wanted[j]) ? 1 : 0;
      zeros += sign(wanted[j]) == 0 ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
  CHECK(zeros > 6000);
}

TEST_CASE("A number lies within the powers of two that its exponent says", "[exact_number]") {
  tests::Random random(2);
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = any_double(random);
    const double b = i % 4 == 0 ? std::ldexp(1.0, i) : any_double(random);
    const cpp_rational wanted = abs(cpp_rational(a) * cpp_rational(b) - cpp_rational(a));
    if (wanted == 0) continue;
    const int e = (ExactNumber(a) * ExactNumber(b) - ExactNumber(a)).exponent();
    const cpp_rational rounding = 1 - power_of_two(-54);
    wrong += wanted < power_of_two(e) && wanted >= power_of_two(e - 1) * rounding ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("A rounded number is a double-double as near as it says", "[exact_number]") {
  tests::Random random(3);
  double worst = 0.0;
  bool normalized = true;
  for (int i = 0; i < 3000; ++i) {
    const double a = any_double(random);
    const double b = any_double(random);
    const ExactNumber number = ExactNumber(a) * ExactNumber(b) - ExactNumber(b);
    if (number.sign() == 0) continue;
    const Digits wanted = (Digits(a) * Digits(b) - Digits(b)) * pow(Digits(2), -number.exponent());
    const DoubleDouble got = number.rounded(-number.exponent());
    const Digits error = (Digits(got.high) + Digits(got.low) - wanted) / wanted;
    worst = std::max(worst, std::abs(static_cast<double>(error)));
    normalized = normalized && got.high + got.low == got.high;
  }
  CHECK(worst <= 4.0 * 0x1p-106);
  CHECK(normalized);
}

TEST_CASE("Rounding gives back a double and leaves its range on both sides", "[exact_number]") {
  tests::Random random(4);
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const double a = any_double(random);
    const DoubleDouble got = ExactNumber(a).rounded();
    wrong += got.high == a && got.low == 0.0 ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(ExactNumber().rounded().high == 0.0);
  CHECK((ExactNumber(1e300) * ExactNumber(-1e300)).rounded().high ==
        -std::numeric_limits<double>::infinity());
  CHECK((ExactNumber(1e-300) * ExactNumber(1e-300)).rounded().high == 0.0);
  CHECK((ExactNumber(1e-300) * ExactNumber(1e-300)).sign() == 1);
}

TEST_CASE("A copy and a moved number keep their value", "[exact_number]") {
  ExactNumber a = ExactNumber(3.0);
  const ExactNumber copy = a;
  a = ExactNumber(5.0);
  CHECK((copy - ExactNumber(3.0)).sign() == 0);
  const ExactNumber moved = std::move(a);
  CHECK((moved - ExactNumber(5.0)).sign() == 0);
  ExactNumber assigned;
  assigned = copy;
  CHECK((assigned + copy - ExactNumber(6.0)).sign() == 0);
}

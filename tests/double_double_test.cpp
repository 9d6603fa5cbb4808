#include "common/exact/double_double.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "catch.hpp"
#include "random.hpp"

using common::DoubleDouble;

namespace {

using Digits = boost::multiprecision::cpp_bin_float_100;

constexpr double u_squared = 0x1p-106;
constexpr int draws = 50000;

Digits exact(DoubleDouble a) { return Digits(a.high) + Digits(a.low); }

/// In u² of the exact value.
double error(DoubleDouble got, const Digits& wanted) {
  if (wanted == 0) return got.high == 0.0 && got.low == 0.0 ? 0.0 : 1e300;
  return static_cast<double>(Digits(abs((exact(got) - wanted) / wanted))) / u_squared;
}

/// Of either sign, within 2^±exponent; the low part anything from nothing to half an ulp.
DoubleDouble any(tests::Random& random, int exponent) {
  const double high =
      std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.uniform(-exponent, exponent)));
  const double sizes[] = {0.0, 0x1p-53, 0x1p-54, 0x1p-90, -0x1p-53};
  const double low = high * sizes[static_cast<int>(random.uniform(0.0, 5.0))];
  return common::quick_two_sum(high, low * random.uniform(0.9, 1.0));
}

/// Near −a, so that their sum cancels: in the last bits of the high parts, or of the low ones.
DoubleDouble nearly_opposite(tests::Random& random, DoubleDouble a) {
  const double change =
      std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.uniform(-110.0, 0.0)));
  return common::quick_two_sum(-a.high, -a.low + change * a.high);
}

bool is_normalized(DoubleDouble a) { return a.high + a.low == a.high; }

}  // namespace

TEST_CASE("Sums and products of two doubles are exact", "[double_double]") {
  tests::Random random(1);
  int wrong = 0;
  for (int i = 0; i < draws; ++i) {
    const double a = any(random, 300).high;
    const double b = any(random, 300).high;
    wrong += exact(common::two_sum(a, b)) != Digits(a) + Digits(b) ? 1 : 0;
    wrong += exact(common::two_product(a, b)) != Digits(a) * Digits(b) ? 1 : 0;
    const double small = std::ldexp(a, -static_cast<int>(random.uniform(0.0, 60.0)));
    wrong += exact(common::quick_two_sum(a, small)) != Digits(a) + Digits(small) ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("A sum of double-doubles errs by what it says also where it cancels", "[double_double]") {
  tests::Random random(2);
  double worst = 0.0;
  bool normalized = true;
  for (int i = 0; i < draws; ++i) {
    const DoubleDouble a = any(random, 30);
    for (const DoubleDouble b : {any(random, 30), nearly_opposite(random, a), -a}) {
      worst = std::max(worst, error(a + b, exact(a) + exact(b)));
      worst = std::max(worst, error(a - b, exact(a) - exact(b)));
      normalized = normalized && is_normalized(a + b) && is_normalized(a - b);
    }
  }
  CHECK(worst <= 3.0);
  CHECK(worst > 0.5);  // or nothing was tried
  CHECK(normalized);
}

TEST_CASE("A product and a quotient of double-doubles err by what they say", "[double_double]") {
  tests::Random random(3);
  double worst_product = 0.0;
  double worst_quotient = 0.0;
  bool normalized = true;
  for (int i = 0; i < draws; ++i) {
    const DoubleDouble a = any(random, 200);
    const DoubleDouble b = any(random, 200);
    if (b.high == 0.0) continue;
    worst_product = std::max(worst_product, error(a * b, exact(a) * exact(b)));
    worst_quotient = std::max(worst_quotient, error(a / b, exact(a) / exact(b)));
    normalized = normalized && is_normalized(a * b) && is_normalized(a / b);
  }
  CHECK(worst_product <= 5.0);
  CHECK(worst_quotient <= 12.0);
  CHECK((worst_product > 0.5 && worst_quotient > 0.5));
  CHECK(normalized);
}

TEST_CASE("A root of a double-double errs by what it says and zero has the root zero",
          "[double_double]") {
  tests::Random random(4);
  double worst = 0.0;
  for (int i = 0; i < draws; ++i) {
    DoubleDouble a = any(random, 400);
    if (a.high < 0.0) a = -a;
    worst = std::max(worst, error(sqrt(a), sqrt(exact(a))));
  }
  CHECK(worst <= 4.0);
  CHECK(worst > 0.5);
  CHECK(sqrt(DoubleDouble(0.0)).high == 0.0);
  CHECK(sqrt(DoubleDouble(0.0)).low == 0.0);
  CHECK(std::isnan(sqrt(DoubleDouble(-1.0)).high));
}

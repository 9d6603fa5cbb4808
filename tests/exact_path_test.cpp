#include "common/exact/exact_path.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "random.hpp"

using common::Bernstein;
using common::DoubleDouble;
using common::ExactPath;
using common::ExactPolynomial;
using common::Vec3;

namespace {

double value(const ExactPolynomial& a, double s) {
  double sum = 0.0;
  for (std::size_t i = a.size(); i-- > 0;) sum = sum * s + a[i].rounded().high;
  return sum;
}

double largest(const Bernstein<DoubleDouble, 4>& coefficients) {
  const auto [lowest, highest] = common::range(coefficients);
  return std::max(-lowest, highest);
}

}  // namespace

TEST_CASE("Products of paths are those of the places on them") {
  tests::Random random(53);
  for (int i = 0; i < 20; ++i) {
    const Vec3 x = random.vector();
    const Vec3 v = random.vector();
    const Vec3 w = random.vector();
    const ExactPath a = common::exact_path(x, v, 0.5);
    const ExactPath b = common::exact_path(v, w, 2.0);
    const Vec3 a_there = x + 0.25 * 0.5 * v;
    const Vec3 b_there = v + 0.25 * 2.0 * w;
    const double y = a_there.y() - b_there.y();
    // Some ten roundings of numbers below 5.
    CHECK(std::abs(value(dot(a, b), 0.25) - a_there.tail<2>().dot(b_there.tail<2>())) < 1e-14);
    CHECK(std::abs(value(cross(a, b), 0.25) - a_there.cross(b_there).x()) < 1e-14);
    CHECK(std::abs(value((a - b).y, 0.25) - y) < 1e-14);
  }
}

TEST_CASE("A polynomial in Bernstein form is itself times a number above zero") {
  tests::Random random(54);
  for (int degree = 0; degree <= 4; ++degree) {
    for (const double size : {1.0, 1e-200, 1e200}) {
      ExactPolynomial polynomial;
      for (int i = 0; i <= degree; ++i) polynomial.emplace_back(size * random.uniform(-1.0, 1.0));
      const auto coefficients = common::bernstein(polynomial);
      CHECK((largest(coefficients) >= 0.5 && largest(coefficients) <= 1.0));
      Bernstein<double, 4> rounded{};
      for (std::size_t i = 0; i < 5; ++i) rounded[i] = coefficients[i].high;
      const double scale = rounded[0] / value(polynomial, 0.0);
      CHECK(scale > 0.0);
      for (const double s : {0.25, 0.5, 1.0}) {
        // Sums of some ten numbers below 2, and the scale's own rounding.
        const double wanted = scale * value(polynomial, s);
        const double room = 1e-14 * (1.0 + scale * size);
        CHECK(std::abs(common::value_at(rounded, s) - wanted) < room);
      }
    }
  }
}

TEST_CASE("Coefficients keep 106 bits also where they cancel") {
  // 1 - s (1 + 2^-80) at its end is -2^-80, in five coefficients that fall by a quarter each.
  const ExactPolynomial line{1.0, common::ExactNumber(-1.0) - std::ldexp(1.0, -80)};
  const auto coefficients = common::bernstein(line);
  const double scale = coefficients[0].high;
  CHECK(coefficients[4].high == -std::ldexp(scale, -80));
}

TEST_CASE("Zero has coefficients of zero") {
  CHECK(largest(common::bernstein({})) == 0.0);
  CHECK(largest(common::bernstein({0.0, 0.0, 0.0, 0.0, 0.0})) == 0.0);
}

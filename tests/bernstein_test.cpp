#include "common/exact/bernstein.hpp"

#include <cmath>

#include "catch.hpp"
#include "random.hpp"

using common::DoubleDouble;
using common::value_at;

TEST_CASE("The halves of a polynomial are the polynomial over either half") {
  tests::Random random(51);
  for (int i = 0; i < 100; ++i) {
    common::Bernstein<double, 4> polynomial{};
    for (double& c : polynomial) c = random.uniform(-1.0, 1.0);
    const auto [first, second] = common::halves(polynomial);
    for (const double s : {0.0, 0.25, 0.5, 1.0}) {
      // Means of numbers below 1, some 20 of them one on the other.
      CHECK(std::abs(value_at(first, s) - value_at(polynomial, 0.5 * s)) < 1e-14);
      CHECK(std::abs(value_at(second, s) - value_at(polynomial, 0.5 + 0.5 * s)) < 1e-14);
    }
  }
}

TEST_CASE("The coefficients of a square are halved in double-double as in double") {
  // (1 - 2 s)²: 1, −1, 1, whose halves are (1 − s)² and s².
  const common::Bernstein<DoubleDouble, 2> square{DoubleDouble(1.0), DoubleDouble(-1.0),
                                                  DoubleDouble(1.0)};
  const auto [first, second] = common::halves(square);
  const common::Bernstein<double, 2> wanted{1.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(first[i].high == wanted[i]);
    CHECK(second[2 - i].high == wanted[i]);
  }
}

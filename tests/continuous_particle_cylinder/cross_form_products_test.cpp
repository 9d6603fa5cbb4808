#include "cases.hpp"
#include "catch.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::Digits100;

namespace {

struct Products {
  double a;
  double b;
  double c;
  double d;
};

void expect_difference(const Products& p, int index, int count) {
  const auto& [a, b, c, d] = p;
  // Two products of 106 bits within 1e-290 and 1e300 of each other's size lose nothing that counts
  // in 332.
  const Digits100 ab = Digits100(a) * Digits100(b);
  const Digits100 cd = Digits100(c) * Digits100(d);
  const Digits100 exact = ab - cd;
  const auto wanted = static_cast<double>(exact);
  const double bound = static_cast<double>(Digits100(2 * tests::ulp(exact)));
  const double got = difference_of_products(a, b, c, d);
  const auto trial = tests::Trial("4.2 difference_of_products", index, count)
                         .given("a", a)
                         .given("b", b)
                         .given("c", c)
                         .given("d", d);
  trial.expect(
      got, wanted, {bound, "2 ulp of the difference"},
      {{a * b - c * d, "both products are rounded before they cancel: use std::fma"},
       {static_cast<double>(Digits100(ab + cd)), "the second product is added: subtract it"},
       {static_cast<double>(Digits100(cd - ab)),
        "it is the wrong way round: return a b - c d, not c d - a b"},
       {std::fma(a, b, -(c * d)), "the rounding error of c d is not put back: add it"},
       {static_cast<double>(Digits100(Digits100(a) * Digits100(b) - 2 * Digits100(c * d) + cd)),
        "the rounding error of c d is put back with the wrong sign: change the sign"}});
  trial.expect_small("ulp from a b - c d", exact == 0 ? std::abs(got) : tests::ulps(got, exact),
                     {2.0, "2 ulp of the difference"});
}

}  // namespace

TEST_CASE("Whole products are subtracted exactly", "[4.2]") {
  expect_difference({7.0, 9.0, 4.0, 5.0}, 1, 4);
  expect_difference({-3.0, 4.0, 4.0, 3.0}, 2, 4);
  expect_difference({0.0, 5.0, 2.0, -3.0}, 3, 4);
  expect_difference({2.0, 6.0, 3.0, 4.0}, 4, 4);
}

TEST_CASE("Random products are subtracted to two ulp", "[4.2]") {
  tests::Random random(421);
  const auto number = [&](double decades) {
    return random.uniform(-1.0, 1.0) * tests::power_of_ten(random, -decades, decades);
  };
  for (int i = 1; i <= 400; ++i) {
    const double decades = i % 2 == 0 ? 0.5 : 70.0;
    const double a = number(decades);
    const double b = number(decades);
    const double c = number(decades);
    expect_difference({a, b, c, number(decades)}, i, 400);
  }
}

TEST_CASE("Products that nearly cancel are subtracted to two ulp", "[4.2]") {
  tests::Random random(422);
  for (int i = 1; i <= 400; ++i) {
    const double a = random.uniform(1.0, 2.0) * tests::power_of_ten(random, -60.0, 60.0);
    const double b = random.uniform(1.0, 2.0) * tests::power_of_ten(random, -60.0, 60.0);
    const double d = random.uniform(-2.0, -1.0) * tests::power_of_ten(random, -60.0, 60.0);
    const double c = tests::nudged(random, a * b / d, i % 4);
    expect_difference({a, b, c, d}, i, 400);
  }
}

TEST_CASE("Products that cancel to all digits leave zero", "[4.2]") {
  tests::Random random(423);
  for (int i = 1; i <= 50; ++i) {
    const double a = random.uniform(-2.0, 2.0);
    const double b = random.uniform(-2.0, 2.0);
    expect_difference({a, b, i % 2 == 0 ? b : -b, i % 2 == 0 ? a : -a}, i, 50);
  }
}

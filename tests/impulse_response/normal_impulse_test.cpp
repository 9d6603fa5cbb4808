#include "catch.hpp"
#include "likely.hpp"
#include "particle_cases.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::NormalCase;

namespace {

void expect_impulse(const NormalCase& c, const tests::Bound& bound, int index = 1, int count = 1) {
  tests::trial_of("6.1 normal_impulse", index, count)
      .given("mass", c.mass)
      .given("velocity", c.velocity)
      .given("normal", c.normal)
      .given("restitution", c.restitution)
      .expect(normal_impulse(c.mass, c.velocity, c.normal, c.restitution), tests::exact_normal(c),
              bound);
}

NormalCase random_case(tests::Random& random) {
  const double mass = random.uniform(0.2, 5.0);
  const Vec3 velocity = random.vector(3.0);
  const Vec3 normal = random.direction();
  return {mass, velocity, normal, random.uniform(0.0, 1.0)};
}

tests::Bound normal_rounding(const NormalCase& c) {
  return {16.0 * eps * c.mass * c.velocity.norm(), "a dot product and three factors"};
}

}  // namespace

TEST_CASE("A mass of 3 at 2 inwards with e one half gets 9", "[6.1]") {
  expect_impulse({3.0, Vec3(4.0, 5.0, -2.0), Vec3::UnitZ(), 0.5}, {0.0, "small whole numbers"});
}

TEST_CASE("A particle that moves away or slides gets no impulse", "[6.1]") {
  const tests::Bound none{0.0, "there is nothing to stop, and zero is exact"};
  expect_impulse({3.0, Vec3(4.0, 5.0, 2.0), Vec3::UnitZ(), 0.5}, none, 1, 3);
  expect_impulse({3.0, Vec3(4.0, 5.0, 0.0), Vec3::UnitZ(), 0.5}, none, 2, 3);
  expect_impulse({3.0, Vec3(-2.0, 0.0, 0.0), -Vec3::UnitX(), 1.0}, none, 3, 3);
}

TEST_CASE("The normal impulse is right for any mass and direction", "[6.1]") {
  tests::Random random(621);
  int impacts = 0;
  for (int i = 1; i <= 100; ++i) {
    const NormalCase c = random_case(random);
    impacts += tests::exact_normal(c) > 0.0 ? 1 : 0;
    expect_impulse(c, normal_rounding(c), i, 100);
  }
  REQUIRE(impacts > 20);
  REQUIRE(impacts < 80);
}

TEST_CASE("The particle leaves e times as fast as it came", "[6.1]") {
  tests::Random random(622);
  for (const double e : {0.0, 0.5, 1.0}) {
    for (int i = 1; i <= 20; ++i) {
      NormalCase c = random_case(random);
      c.restitution = e;
      if (c.normal.dot(c.velocity) > 0.0) c.normal = -c.normal;
      const double j = normal_impulse(c.mass, c.velocity, c.normal, e);
      const Vec3 after = c.velocity + j / c.mass * c.normal;
      tests::trial_of("6.1 normal_impulse", i, 20)
          .given("mass", c.mass)
          .given("velocity", c.velocity)
          .given("normal", c.normal)
          .given("restitution", e)
          .of("the normal speed afterwards")
          .expect(c.normal.dot(after), -e * c.normal.dot(c.velocity),
                  {16.0 * eps * c.velocity.norm(), "some ten operations"});
    }
  }
}

TEST_CASE("A slower particle gets a smaller impulse and no speed is too small", "[6.1]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15, 1e-100, 1e100}) {
    const NormalCase c{0.8, Vec3(0.0, -speed, 0.0), Vec3::UnitY(), 0.25};
    expect_impulse(c, normal_rounding(c), ++index, 6);
  }
}

TEST_CASE("There is no impulse if a particle moves away even very slowly", "[6.1]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15, 1e-100}) {
    const NormalCase c{2.0, Vec3(3.0, speed, 0.0), Vec3::UnitY(), 0.25};
    expect_impulse(c, {0.0, "there is nothing to stop, and zero is exact"}, ++index, 5);
  }
}

TEST_CASE("A restitution near 0 or 1 is not rounded", "[6.1]") {
  int index = 0;
  for (const double e : {1e-3, 1e-9, 1e-12, 1.0 - 1e-3, 1.0 - 1e-9, 1.0 - 1e-12}) {
    expect_impulse({1.0, Vec3(2.0, 0.0, -1.0), Vec3::UnitZ(), e},
                   {4.0 * eps, "1 + e, and products with one"}, ++index, 6);
  }
}

#include "catch.hpp"
#include "oracle.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::Trial;

namespace {

struct NormalCase {
  double mass;
  Vec3 velocity;
  Vec3 normal;
  double restitution;
};

double exact_normal(const NormalCase& c) {
  const auto v_n = tests::wide(c.normal).dot(tests::wide(c.velocity));
  const auto e = tests::wide(c.restitution);
  return v_n < 0 ? static_cast<double>(-(1 + e) * tests::wide(c.mass) * v_n) : 0.0;
}

std::vector<tests::Suspect<double>> normal_suspects(const NormalCase& c) {
  const double v_n = c.normal.dot(c.velocity);
  const double m = c.mass;
  const double e = c.restitution;
  return {{v_n < 0.0 ? 0.0 : (1.0 + e) * m * v_n,
           "the normal is taken the other way round: what parts gets an impulse"},
          {0.0, "there is no impulse at all"},
          {-(1.0 + e) * m * v_n, "the impulse of a particle that parts is not skipped"},
          {v_n < 0.0 ? -e * m * v_n : 0.0, "e stands where 1 + e belongs"},
          {v_n < 0.0 ? -(1.0 - e) * m * v_n : 0.0, "1 - e stands where 1 + e belongs"},
          {v_n < 0.0 ? -(1.0 + e) * v_n : 0.0, "the mass is missing"},
          {v_n < 0.0 ? (1.0 + e) * m * v_n : 0.0, "the impulse points inwards: its sign"},
          {v_n < 0.0 ? (1.0 + e) * m * c.velocity.norm() : 0.0,
           "the whole speed counts, not its normal part"}};
}

void expect_impulse(const NormalCase& c, const tests::Bound& bound, int index, int count,
                    const std::vector<tests::Suspect<double>>& suspects) {
  Trial("6.1 normal_impulse", index, count)
      .given("mass", c.mass)
      .given("velocity", c.velocity)
      .given("normal", c.normal)
      .given("restitution", c.restitution)
      .expect(normal_impulse(c.mass, c.velocity, c.normal, c.restitution), exact_normal(c), bound,
              suspects);
}
void expect_impulse(const NormalCase& c, const tests::Bound& bound, int index = 1, int count = 1) {
  expect_impulse(c, bound, index, count, normal_suspects(c));
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

TEST_CASE("A particle that parts or slides gets no impulse", "[6.1]") {
  const tests::Bound none{0.0, "there is nothing to stop, and zero is exact"};
  expect_impulse({3.0, Vec3(4.0, 5.0, 2.0), Vec3::UnitZ(), 0.5}, none, 1, 3);
  expect_impulse({3.0, Vec3(4.0, 5.0, 0.0), Vec3::UnitZ(), 0.5}, none, 2, 3);
  expect_impulse({3.0, Vec3(-2.0, 0.0, 0.0), -Vec3::UnitX(), 1.0}, none, 3, 3);
}

TEST_CASE("The normal impulse is that of any mass and direction", "[6.1]") {
  tests::Random random(621);
  int impacts = 0;
  for (int i = 1; i <= 100; ++i) {
    const NormalCase c = random_case(random);
    impacts += exact_normal(c) > 0.0 ? 1 : 0;
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
      Trial("6.1 normal_impulse", i, 20)
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

TEST_CASE("The slower a particle the smaller the impulse and no speed is too small", "[6.1]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-100, 1e100}) {
    const NormalCase c{2.0, Vec3(0.0, -speed, 0.0), Vec3::UnitY(), 0.25};
    auto suspects = normal_suspects(c);
    suspects.push_back({0.0, "a small speed is taken for none: no speed is too small"});
    expect_impulse(c, normal_rounding(c), ++index, 4, suspects);
  }
}

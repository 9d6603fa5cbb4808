#include "catch.hpp"
#include "likely.hpp"
#include "particle_cases.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::FrictionCase;
using tests::wide;

namespace {

tests::Trial friction_trial(const FrictionCase& c, int index = 1, int count = 1) {
  return tests::trial_of("6.2 friction_impulse", index, count)
      .given("mass", c.mass)
      .given("velocity", c.velocity)
      .given("normal", c.normal)
      .given("normal_impulse", c.normal_impulse)
      .given("friction", c.friction);
}

void expect_friction(const FrictionCase& c, const tests::Bound& bound, int index = 1,
                     int count = 1) {
  friction_trial(c, index, count)
      .expect(friction_impulse(c.mass, c.velocity, c.normal, c.normal_impulse, c.friction),
              tests::exact_friction(c), bound);
}

/// m |v_t| is what stops the slip; the cone allows `share` of it.
FrictionCase random_case(tests::Random& random, double share) {
  FrictionCase c{random.uniform(1.5, 5.0), random.vector(3.0), random.direction(), 0.0,
                 random.uniform(0.2, 0.9)};
  c.normal_impulse = share * c.mass * static_cast<double>(tests::slip(c).norm()) / c.friction;
  return c;
}

tests::Bound rounding(const FrictionCase& c) {
  return {32.0 * eps * c.mass * c.velocity.norm(),
          "v_t errs by 3 eps |v|, and its direction by as much over |v_t|"};
}

}  // namespace

TEST_CASE("A particle that slips is braked by mu times the normal impulse", "[6.2]") {
  // v_t = (3, 4, 0): m |v_t| = 10 is more than the cone's 0.5 · 4 = 2.
  expect_friction({2.0, Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 4.0, 0.5},
                  {8.0 * eps * 2.0, "a root and a division"});
}

TEST_CASE("A particle that slips little is stopped and not reversed", "[6.2]") {
  // m |v_t| = 10 is less than the cone's 0.5 · 40 = 20.
  expect_friction({2.0, Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 40.0, 0.5},
                  {8.0 * eps * 10.0, "a root and a division"});
}

TEST_CASE("Friction is that of maximum dissipation for any slip", "[6.2]") {
  tests::Random random(631);
  for (int i = 1; i <= 100; ++i) {
    const FrictionCase c =
        random_case(random, i % 2 == 0 ? random.uniform(0.05, 0.95) : random.uniform(1.05, 4.0));
    expect_friction(c, rounding(c), i, 100);
  }
}

TEST_CASE("Friction does not change the normal speed and stays in the cone", "[6.2]") {
  tests::Random random(632);
  for (int i = 1; i <= 50; ++i) {
    const FrictionCase c = random_case(random, random.uniform(0.05, 4.0));
    const Vec3 j = friction_impulse(c.mass, c.velocity, c.normal, c.normal_impulse, c.friction);
    const tests::Trial trial = friction_trial(c, i, 50);
    trial.expect_small("|n.j_t|", std::abs(c.normal.dot(j)), rounding(c));
    trial.expect_small("|j_t| - mu j_n", j.norm() - c.friction * c.normal_impulse, rounding(c));
  }
}

TEST_CASE("No other impulse in the cone takes as much energy", "[6.2]") {
  tests::Random random(633);
  for (int i = 1; i <= 50; ++i) {
    const FrictionCase c = random_case(random, i % 2 == 0 ? 0.5 : 1.5);
    const Vec3 j = friction_impulse(c.mass, c.velocity, c.normal, c.normal_impulse, c.friction);
    const auto energy = [&](const Vec3& impulse) {
      return 0.5 * c.mass * (c.velocity + impulse / c.mass).squaredNorm();
    };
    double least = HUGE_VAL;
    const auto [s, t] = tests::across(wide(c.normal));
    for (int k = 0; k < 72; ++k) {
      const double angle = k * std::acos(0.0) / 18.0;
      for (const double size : {0.25, 0.5, 0.75, 1.0}) {
        const double limit = size * c.friction * c.normal_impulse;
        const Vec3 other = tests::narrow(std::cos(angle) * s + std::sin(angle) * t) * limit;
        least = std::min(least, energy(other));
      }
    }
    friction_trial(c, i, 50).expect_small(
        "energy left, minus the least with 288 other impulses", energy(j) - least,
        {32.0 * eps * energy(Vec3::Zero()), "rounding of two energies"});
  }
}

TEST_CASE("Without slip or normal impulse or mu there is no friction", "[6.2]") {
  const tests::Bound none{0.0, "one factor is zero"};
  expect_friction({2.0, Vec3(0.0, 0.0, -3.0), Vec3::UnitZ(), 9.0, 0.5}, none, 1, 4);
  expect_friction({2.0, Vec3::Zero(), Vec3::UnitZ(), 9.0, 0.5}, none, 2, 4);
  expect_friction({2.0, Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 0.0, 0.5}, none, 3, 4);
  expect_friction({2.0, Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 9.0, 0.0}, none, 4, 4);
}

TEST_CASE("Even a very slow slip is braked", "[6.2]") {
  int index = 0;
  for (const double speed : {1e-6, 1e-9, 1e-12, 1e-15, 1e-100}) {
    const FrictionCase c{2.0, Vec3(3.0 * speed, 4.0 * speed, 0.0), Vec3::UnitZ(), 1.0, 0.5};
    expect_friction(c, rounding(c), ++index, 5);
  }
}

TEST_CASE("A very small normal impulse or mu still brakes by mu j_n", "[6.2]") {
  // On the cone: mu j_n along (3, 4, 0)/5, whatever part of m |v_t| = 10 it is.
  int index = 0;
  for (const double small : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    const tests::Bound bound{8.0 * eps * small, "a root, a division and products"};
    const Vec3 v(3.0, 4.0, -1.0);
    expect_friction({2.0, v, Vec3::UnitZ(), small, 0.5}, bound, ++index, 10);
    expect_friction({2.0, v, Vec3::UnitZ(), 0.5, small}, bound, ++index, 10);
  }
}

TEST_CASE("It stops just inside the cone and slips on just outside", "[6.2]") {
  int index = 0;
  for (const double share : {1.0 - 1e-9, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.0 + 1e-9}) {
    expect_friction({2.0, Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 20.0 * share, 0.5},
                    {8.0 * eps * 10.0, "a root and a division"}, ++index, 5);
  }
}

TEST_CASE("A straight hit has no friction at any mu", "[6.2]") {
  int index = 0;
  for (const double mu : {0.0, 0.5}) {
    for (const double j_n : {0.0, 3.0}) {
      for (const double speed : {0.0, -2.0}) {
        expect_friction({1.0, Vec3(0.0, 0.0, speed), Vec3::UnitZ(), j_n, mu},
                        {0.0, "v_t is zero, and has no direction"}, ++index, 8);
      }
    }
  }
}

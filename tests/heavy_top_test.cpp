#include "common/rotation/heavy_top.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "common/rotation/free_rotation.hpp"
#include "precise_spin.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;

namespace {

constexpr HeavyTop top{1.25, 0.5, 9.81};

Quat tilted(double angle, double azimuth = 0.0) {
  return {std::cos(0.5 * angle), std::sin(0.5 * angle) * std::cos(azimuth),
          std::sin(0.5 * angle) * std::sin(azimuth), 0.0};
}

double error_of(const HeavyTop& heavy_top, const Spin& start, double time) {
  const Vec3 moments(heavy_top.transverse_moment, heavy_top.transverse_moment,
                     heavy_top.axial_moment);
  tests::PreciseSpin exact({moments, heavy_top.weight_moment}, start);
  exact.run(time, 1e-28);
  const Spin spin = LagrangeTop(heavy_top, start).at(time);
  return std::max(exact.angle_to(spin.world_from_body),
                  exact.velocity_error(spin.angular_velocity_body));
}

/// Some 50 roundings, relative to 60 rad of turning: 50 * 60 * eps / 2.
constexpr double few_turns_of_top = 4e-13;

double worst_top(std::uint64_t seed) {
  tests::Random random(seed);
  double worst = 0.0;
  for (int i = 0; i < 150; ++i) {
    const double transverse = random.uniform(0.3, 2.0);
    const HeavyTop heavy_top{transverse, transverse * random.uniform(0.1, 2.0),
                             std::pow(10.0, random.uniform(-3.0, 2.0))};
    const Spin start{random.attitude(), random.vector(8.0)};
    worst = std::max(worst, error_of(heavy_top, start, random.uniform(-3.0, 3.0)));
  }
  return worst;
}

/// φ' of the slow or the fast steady precession: I₁ cos θ φ'² − I₃ ω₃ φ' + m g l = 0.
double steady_precession(double tilt, double spin, bool fast) {
  const double a = top.transverse_moment * std::cos(tilt);
  const double b = top.axial_moment * spin;
  const double root = b + std::sqrt(b * b - 4.0 * a * top.weight_moment);
  return fast ? root / (2.0 * a) : 2.0 * top.weight_moment / root;
}

}  // namespace

TEST_CASE("Random tops move as the series says - first 150", "[heavy_top]") {
  CHECK(worst_top(31) < few_turns_of_top);
}
TEST_CASE("Random tops move as the series says - second 150", "[heavy_top]") {
  CHECK(worst_top(32) < few_turns_of_top);
}

TEST_CASE("A top released at rest follows its cusps for fifty turns of spin", "[heavy_top]") {
  const Spin start{tilted(std::numbers::pi / 6.0), Vec3(0.0, 0.0, 30.0)};
  CHECK(error_of(top, start, 0.0) < 1e-15);
  CHECK(error_of(top, start, 10.472) < 4e-13);  // 314 rad
  CHECK(error_of(top, start, -1.0) < few_turns_of_top);
}

TEST_CASE("A top in steady precession keeps its tilt", "[heavy_top]") {
  for (const bool fast : {false, true}) {
    for (const double tilt : {0.3, 1.0, 2.0}) {
      const double rate = steady_precession(tilt, 20.0, fast);
      for (const double nudge : {0.0, 1e-14, 1e-8, 1e-3}) {
        const Spin start{tilted(tilt), Vec3(nudge, rate * std::sin(tilt), 20.0)};
        CHECK(error_of(top, start, 2.0) < few_turns_of_top);
      }
      const Spin start{tilted(tilt), Vec3(0.0, rate * std::sin(tilt), 20.0)};
      const Spin later = LagrangeTop(top, start).at(2.0);
      const Vec3 axis = later.world_from_body * Vec3::UnitZ();
      CHECK(std::abs(axis.z() - std::cos(tilt)) < 1e-14);
      // The axis has gone round by φ' t from where it leant, along −y.
      const Vec3 wanted(std::sin(rate * 2.0), -std::cos(rate * 2.0), 0.0);
      CHECK(tests::difference(Vec3(axis.x(), axis.y(), 0.0), Vec3(std::sin(tilt) * wanted)) <
            1e-12);
    }
  }
}

TEST_CASE("A top without spin is a spherical pendulum", "[heavy_top]") {
  tests::Random random(33);
  for (int i = 0; i < 20; ++i) {
    Spin start{tilted(random.uniform(0.5, 3.0), random.uniform(0.0, 6.0)), random.vector(5.0)};
    start.angular_velocity_body.z() = 0.0;
    CHECK(error_of(top, start, 3.0) < few_turns_of_top);
  }
}

TEST_CASE("A top that passes near the vertical loses no more than the tilt explains",
          "[heavy_top]") {
  for (const double tilt : {1e-1, 1e-2, 1e-3}) {
    for (const double spin : {5.0, 13.0, 15.0, 40.0}) {
      const Spin released{tilted(tilt, 1.0), Vec3(0.0, 0.0, spin)};
      CHECK(error_of(top, released, 2.0) < few_turns_of_top);
      const Spin thrown{tilted(tilt, 1.0), Vec3(0.1, -0.5, spin)};
      CHECK(error_of(top, thrown, 2.0) < few_turns_of_top + 2e-14 / tilt);
      const Spin hanging{tilted(std::numbers::pi - tilt, 1.0), Vec3(0.1, -0.5, spin)};
      CHECK(error_of(top, hanging, 2.0) < few_turns_of_top);
    }
  }
}

TEST_CASE("A top on the vertical or through it is refused", "[heavy_top]") {
  CHECK_THROWS_AS(LagrangeTop(top, {Quat::Identity(), Vec3(0.0, 0.0, 20.0)}),
                  std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop(top, {Quat(0.0, 1.0, 0.0, 0.0), Vec3(0.1, 0.0, 20.0)}),
                  std::invalid_argument);
  // A plane pendulum swings through the downward vertical.
  CHECK_THROWS_AS(LagrangeTop(top, {tilted(1.0), Vec3::Zero()}), std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop(top, {tilted(0.5e-4), Vec3(0.0, 0.0, 5.0)}), std::invalid_argument);
}

TEST_CASE("What is no top or no motion is refused", "[heavy_top]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Spin start{tilted(0.5), Vec3(0.0, 0.0, 20.0)};
  CHECK_THROWS_AS(LagrangeTop({1.0, 2.5, 9.81}, start), std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop({1.0, 1.0, -1.0}, start), std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop({1.0, 1.0, nan}, start), std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop(top, {tilted(0.5), Vec3(nan, 0.0, 1.0)}), std::invalid_argument);
  CHECK_THROWS_AS(LagrangeTop(top, {Quat(0.0, 0.0, 0.0, 0.0), Vec3::UnitZ()}),
                  std::invalid_argument);
}

TEST_CASE("Without weight the symmetric step is the free rotation", "[heavy_top]") {
  tests::Random random(34);
  for (int i = 0; i < 100; ++i) {
    const HeavyTop body{1.0, random.uniform(0.1, 2.0), 0.0};
    const Spin start{random.attitude(), random.vector(6.0)};
    const double dt = random.uniform(-2.0, 2.0);
    const Spin wanted = FreeRotation({1.0, 1.0, body.axial_moment}, start).at(dt);
    for (const Spin& found :
         {free_symmetric_step(body, start, dt), LagrangeTop(body, start).at(dt)}) {
      CHECK(angle_between(found.world_from_body, wanted.world_from_body) < 1e-13);
      CHECK(tests::difference(found.angular_velocity_body, wanted.angular_velocity_body) < 2e-13);
    }
  }
}

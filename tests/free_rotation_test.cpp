#include "common/rotation/free_rotation.hpp"

#include <limits>
#include <numbers>

#include "catch.hpp"
#include "common/rotation/attitude.hpp"
#include "free_rotation_cases.hpp"
#include "precise_spin.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;
using tests::eps;
using tests::turn;

namespace {

/// The larger of the angle and the relative error of the angular velocity, against the series.
double error_of(const Vec3& moments, const Spin& start, double time, double tolerance = 1e-30) {
  tests::PreciseSpin exact({moments, 0.0}, start);
  exact.run(time, tolerance);
  const Spin spin = FreeRotation(moments, start).at(time);
  return std::max(exact.angle_to(spin.world_from_body),
                  exact.velocity_error(spin.angular_velocity_body));
}

/// The closed form rounds some 50 times on the way, relative to 20 rad of turning: 50 * 20 * eps/2.
constexpr double few_turns = 2e-13;

double worst_of_random(std::uint64_t seed) {
  tests::Random random(seed);
  double worst = 0.0;
  for (int i = 0; i < 250; ++i) {
    const Vec3 moments = tests::random_moments(random, i % 2 == 0 ? 1.0 : 2.5);
    const Spin start{random.attitude(), turn * random.direction()};
    worst = std::max(worst, error_of(moments, start, random.uniform(-3.0, 3.0), 1e-24));
  }
  return worst;
}

double worst_near_separatrix(double complementary_parameter, bool circles_major) {
  tests::Random random(7);
  double worst = 0.0;
  for (int i = 0; i < 6; ++i) {
    const Vec3 moments = tests::permuted(Vec3(1.0, random.uniform(1.5, 2.0), 2.5), i);
    const Spin start{
        random.attitude(),
        tests::velocity_near_separatrix(random, moments, complementary_parameter, circles_major)};
    const FreeRotation exact(moments, start);
    // The state really is as near as asked; otherwise the law below would say nothing.
    CHECK(exact.polhode().complementary_parameter < 1.2 * complementary_parameter + 3e-16);
    CHECK(exact.polhode().complementary_parameter > 0.8 * complementary_parameter - 3e-16);
    worst = std::max(worst, error_of(moments, start, 0.6 * exact.period()));
  }
  return worst;
}

}  // namespace

TEST_CASE("The series agrees with itself at two step sizes in 25 digits", "[free_rotation]") {
  const Spin start{Quat(0.5, 0.1, -0.7, 0.3), Vec3(0.01, turn, 0.01)};
  tests::PreciseSpin coarse({Vec3(1.0, 2.0, 3.0), 0.0}, start);
  tests::PreciseSpin fine = coarse;
  coarse.run(3.0, 1e-30);
  fine.run(3.0, 1e-34);
  CHECK(coarse.angle_to(fine) < 1e-25);
  CHECK(coarse.angle_to(start.world_from_body) > 0.1);
}

TEST_CASE("Random bodies turn as the series says - first 250", "[free_rotation]") {
  CHECK(worst_of_random(11) < few_turns);
}
TEST_CASE("Random bodies turn as the series says - second 250", "[free_rotation]") {
  CHECK(worst_of_random(12) < few_turns);
}
TEST_CASE("Random bodies turn as the series says - third 250", "[free_rotation]") {
  CHECK(worst_of_random(13) < few_turns);
}
TEST_CASE("Random bodies turn as the series says - last 250", "[free_rotation]") {
  CHECK(worst_of_random(14) < few_turns);
}

TEST_CASE("Near the separatrix the flip comes in time about the major axis", "[free_rotation]") {
  // Up to 50 rad of turning; any rounding of k'^2 alone would cost eps / k'^2.
  for (const double k : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    CHECK(worst_near_separatrix(k, true) < 5e-13);
  }
}
TEST_CASE("Near the separatrix the flip comes in time about the minor axis", "[free_rotation]") {
  for (const double k : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    CHECK(worst_near_separatrix(k, false) < 5e-13);
  }
}

TEST_CASE("On the separatrix the body flips once and then rests on its middle axis",
          "[free_rotation]") {
  // D = 2.25 * 0.25 * 1 - 1 * 1 * 0.75^2 = 0, exactly.
  const Vec3 moments(1.0, 2.0, 2.25);
  for (int order = 0; order < 6; ++order) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 I = tests::permuted(moments, order);
      const Spin start{Quat(0.5, 0.5, -0.5, 0.5),
                       tests::permuted(Vec3(0.75 * side, -20.0, 1.0), order)};
      const FreeRotation exact(I, start);
      CHECK(exact.polhode().complementary_parameter == 0.0);
      CHECK(exact.period() == std::numeric_limits<double>::infinity());
      CHECK(error_of(I, start, 1.0) < 2e-13);  // 20 rad
      CHECK(error_of(I, start, -1.0) < 2e-13);
      const Vec3 later = exact.at(50.0).angular_velocity_body;
      const Vec3 before = exact.at(-50.0).angular_velocity_body;
      CHECK(later.normalized().dot(before.normalized()) < -0.999999);
    }
  }
}

TEST_CASE("A principal spin keeps its angular velocity and turns at its rate", "[free_rotation]") {
  const Vec3 moments(3.0, 1.0, 2.0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double rate : {-turn, turn}) {
      const Spin start{Quat(0.5, 0.5, -0.5, 0.5), rate * Vec3::Unit(axis)};
      const Spin later = FreeRotation(moments, start).at(1.3);
      const Quat wanted = start.world_from_body * exponential_map(1.3 * rate * Vec3::Unit(axis));
      CHECK(angle_between(later.world_from_body, wanted) < 8.0 * eps);
      CHECK(tests::difference(later.angular_velocity_body, start.angular_velocity_body) == 0.0);
    }
  }
}

TEST_CASE("Next to a principal spin nothing is lost", "[free_rotation]") {
  tests::Random random(3);
  for (const double tilt : {1e-3, 1e-8, 1e-16, 1e-150, 1e-300}) {
    for (int axis = 0; axis < 3; ++axis) {
      Spin start{random.attitude(), tilt * random.direction()};
      start.angular_velocity_body[axis] = turn;
      CHECK(error_of(Vec3(1.7, 1.0, 2.2), start, 2.0) < few_turns);
    }
  }
}

TEST_CASE("Bodies with equal or nearly equal moments turn as the series says", "[free_rotation]") {
  tests::Random random(4);
  for (const double gap : {0.0, eps, 1e-12, 1e-8, 1e-4}) {
    for (const double third : {1.0 - 3.0 * gap, 0.3, 1.9}) {
      for (int order = 0; order < 6; ++order) {
        const Vec3 moments = tests::permuted(Vec3(1.0, 1.0 + gap, third), order);
        Spin start{random.attitude(), turn * random.direction()};
        CHECK(error_of(moments, start, 2.0, 1e-26) < few_turns);
        // About the equator a difference of an ulp decides which way the axis drifts.
        const Vec3 tilt(1.0, 1.0, std::sqrt(gap) * random.uniform(-2.0, 2.0));
        start.angular_velocity_body = turn * tests::permuted(tilt, order);
        CHECK(error_of(moments, start, 2.0, 1e-30) < few_turns);
      }
    }
  }
}

TEST_CASE("A body at rest stays and a sphere turns about its angular velocity", "[free_rotation]") {
  const Quat q(0.5, 0.5, -0.5, 0.5);
  const Vec3 omega(1.0, -2.0, 0.5);
  const FreeRotation rest(Vec3(1.0, 2.0, 2.5), {q, Vec3::Zero()});
  CHECK(tests::difference(rest.at(1e6).world_from_body, q) == 0.0);
  CHECK(rest.at(1e6).angular_velocity_body.norm() == 0.0);
  CHECK(rest.period() == std::numeric_limits<double>::infinity());
  const FreeRotation sphere(Vec3(2.0, 2.0, 2.0), {q, omega});
  CHECK(angle_between(sphere.at(3.0).world_from_body, q * exponential_map(3.0 * omega)) <
        16.0 * eps);
  CHECK(sphere.period() == std::numeric_limits<double>::infinity());
}

TEST_CASE("After a period the angular velocity recurs and not before", "[free_rotation]") {
  const Spin start{Quat::Identity(), turn * Vec3(0.01, 1.0, 0.01).normalized()};
  const FreeRotation racket(Vec3(1.0, 2.0, 3.0), start);
  CHECK(std::abs(racket.period() - 6.2245) < 1e-4);  // 4 K / λ, tabulated to five digits
  for (const double periods : {-2.0, 1.0, 3.0}) {
    const Vec3 recurred = racket.at(periods * racket.period()).angular_velocity_body;
    CHECK(tests::difference(recurred, start.angular_velocity_body) < 1e-12);
  }
  CHECK(racket.at(0.5 * racket.period()).angular_velocity_body.y() < -6.2);
  // ω √((3 - 1)(3 - 2) / (1 * 2)) = ω for small wobbles about the major axis.
  const FreeRotation spin(Vec3(1.0, 2.0, 3.0), {Quat::Identity(), turn * Vec3::UnitZ()});
  CHECK(std::abs(spin.period() - 1.0) < 8.0 * eps);
}

TEST_CASE("The unit of time and of inertia does not matter", "[free_rotation]") {
  const Vec3 moments(1.0, 2.0, 2.5);
  const Spin start{Quat(0.5, 0.5, -0.5, 0.5), Vec3(1.0, 2.0, 3.0)};
  const Spin wanted = FreeRotation(moments, start).at(2.0);
  for (const int power : {-600, -3, 500}) {
    const double unit = std::ldexp(1.0, power);
    const Spin scaled{start.world_from_body, start.angular_velocity_body * unit};
    const Spin found = FreeRotation(moments * unit, scaled).at(2.0 / unit);
    CHECK(tests::difference(found.world_from_body, wanted.world_from_body) == 0.0);
    CHECK(tests::difference(Vec3(found.angular_velocity_body / unit),
                            wanted.angular_velocity_body) == 0.0);
  }
}

TEST_CASE("What is no body or no motion is refused", "[free_rotation]") {
  const Vec3 moments(1.0, 2.0, 2.5);
  const Vec3 bad(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  CHECK_THROWS_AS(FreeRotation(Vec3(1.0, 2.0, 3.5), Spin{}), std::invalid_argument);
  CHECK_THROWS_AS(FreeRotation(moments, Spin{Quat::Identity(), bad}), std::invalid_argument);
  CHECK_THROWS_AS(FreeRotation(moments, Spin{Quat(0, 0, 0, 0), bad}), std::invalid_argument);
}

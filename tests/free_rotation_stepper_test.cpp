#include "common/rotation/free_rotation_stepper.hpp"

#include <numbers>
#include <string>

#include "catch.hpp"
#include "common/rotation/attitude.hpp"
#include "free_rotation_cases.hpp"
#include "precise_spin.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;
using tests::turn;

namespace {

Spin spun(const Vec3& direction) {
  return {Quat(0.5, 0.1, -0.7, 0.3).normalized(), turn * direction.normalized()};
}

/// The largest angle to the series at each of the turns, with some steps to a turn.
double worst_angle(const Vec3& moments, const Spin& start, int turns, int steps_per_turn) {
  tests::PreciseSpin exact({moments, 0.0}, start);
  FreeRotationStepper stepper(FreeRotation(moments, start), 1.0 / steps_per_turn);
  double worst = 0.0;
  for (int i = 0; i < turns; ++i) {
    exact.run(1.0);
    for (int step = 0; step < steps_per_turn; ++step) stepper.advance();
    worst = std::max(worst, exact.angle_to(stepper.spin().world_from_body));
    worst = std::max(worst, exact.velocity_error(stepper.spin().angular_velocity_body));
  }
  return worst;
}

/// 3200 products of quaternions round by 3200 * eps = 7e-13 if all err to one side.
constexpr double fifty_turns = 1e-12;

void check_fifty_turns(const Vec3& moments, const Vec3& direction) {
  for (const int steps : {1, 8, 64}) {
    CHECK(worst_angle(moments, spun(direction), 50, steps) < fifty_turns);
  }
}

/// Against the closed form, at the end of some steps.
double error_after(const FreeRotation& rotation, double dt, int steps) {
  FreeRotationStepper stepper(rotation, dt);
  for (int step = 0; step < steps; ++step) stepper.advance();
  const Spin wanted = rotation.at(dt * steps);
  const double velocity = wanted.angular_velocity_body.norm();
  const double error =
      tests::difference(stepper.spin().angular_velocity_body, wanted.angular_velocity_body);
  return std::max(angle_between(stepper.spin().world_from_body, wanted.world_from_body),
                  velocity == 0.0 ? error : error / velocity);
}

}  // namespace

TEST_CASE("Fifty turns of a racket that flips come out exact at any step", "[stepper]") {
  check_fifty_turns({1.0, 2.0, 3.0}, {0.01, 1.0, 0.01});
}
TEST_CASE("Fifty turns of a tumbling body come out exact at any step", "[stepper]") {
  check_fifty_turns({1.0, 2.0, 3.0}, {1.0, 1.0, 1.0});
}
TEST_CASE("Fifty turns of a nearly symmetric body come out exact at any step", "[stepper]") {
  check_fifty_turns({1.0, 1.01, 2.0}, {0.01, 1.0, 0.01});
}
TEST_CASE("Fifty turns of a slender body come out exact at any step", "[stepper]") {
  check_fifty_turns({1.0, 10.0, 10.5}, {0.01, 1.0, 0.01});
}

TEST_CASE("Steps of several turns and steps back are exact as well", "[stepper]") {
  const FreeRotation racket({3.0, 1.0, 2.0}, spun({0.01, -0.01, 1.0}));
  for (const double dt : {-0.1, 0.7, 2.3, 10.0, -33.0, 1e3}) {
    CHECK(error_after(racket, dt, 1) < 1e-14 * (10.0 + turn * std::abs(dt)));
    CHECK(error_after(racket, dt, 5) < 1e-14 * (10.0 + 5.0 * turn * std::abs(dt)));
  }
  CHECK(error_after(racket, 0.0, 100) < 1e-14);
}

TEST_CASE("A million steps drift no more than their rounding", "[stepper]") {
  const FreeRotation racket({1.0, 2.0, 3.0}, spun({0.01, 1.0, 0.01}));
  CHECK(error_after(racket, 1.0 / 64.0, 1'000'000) < 1e6 * tests::eps);
}

TEST_CASE("In every order of the moments a random body steps along the closed form", "[stepper]") {
  tests::Random random(21);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 moments = tests::random_moments(random, 1.5);
    const FreeRotation rotation(moments, {random.attitude(), turn * random.direction()});
    CHECK(error_after(rotation, random.uniform(-0.3, 0.3), 30) < 3e-13);
  }
}

TEST_CASE("Bodies that hardly swing step along the closed form", "[stepper]") {
  const double tiny = 1e-12;
  for (int order = 0; order < 6; ++order) {
    for (const Vec3& I : {Vec3(1.0, 2.0, 2.5), Vec3(1.0, 1.0, 1.5), Vec3(1.0, 1.0, 0.5),
                          Vec3(1.0, 1.0 + tiny, 1.5), Vec3(2.0, 2.0, 2.0)}) {
      for (const Vec3& w : {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 1.0, 0.0), Vec3(tiny, tiny, 1.0),
                            Vec3(1.0, 2.0, 0.0), Vec3(1.0, 2.0, 3.0), Vec3(1.0, 1.0, tiny)}) {
        const FreeRotation rotation(tests::permuted(I, order), spun(tests::permuted(w, order)));
        CHECK(error_after(rotation, 0.01, 300) < 1e-13);
      }
    }
  }
  const FreeRotation rest({1.0, 2.0, 2.5}, {Quat(0.5, 0.5, 0.5, 0.5), Vec3::Zero()});
  CHECK(error_after(rest, 0.1, 10) < 1e-15);
}

TEST_CASE("On the separatrix the steps lead onto the middle axis and stay", "[stepper]") {
  // D = 2.25 * 0.25 * 1 - 1 * 1 * 0.75^2 = 0, exactly; 20 turns is as long as 33 digits follow.
  for (const double side : {-1.0, 1.0}) {
    const Spin start{Quat(0.5, 0.5, -0.5, 0.5), Vec3(0.75 * side, -5.0, 1.0)};
    for (const int steps : {1, 8, 64}) {
      CHECK(worst_angle({1.0, 2.0, 2.25}, start, 20, steps) < 1e-12);
    }
    CHECK(error_after(FreeRotation({1.0, 2.0, 2.25}, start), 0.1, 3000) < 1e-12);
    CHECK(error_after(FreeRotation({1.0, 2.0, 2.25}, start), 300.0, 1) < 1e-12);
  }
}

TEST_CASE("Near the separatrix the steps flip in time", "[stepper]") {
  tests::Random random(22);
  for (const double k : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    for (int order = 0; order < 6; ++order) {
      const Vec3 I = tests::permuted(Vec3(1.0, 1.7, 2.5), order);
      const bool major = order % 2 == 0;
      const FreeRotation rotation(
          I, {random.attitude(), tests::velocity_near_separatrix(random, I, k, major)});
      const int steps = static_cast<int>(0.6 * rotation.period() * 16.0);
      CHECK(error_after(rotation, 1.0 / 16.0, steps) < 1e-12);
      CHECK(error_after(rotation, 1.0, steps / 16) < 1e-12);
      CHECK(error_after(rotation, 4.0, steps / 64) < 1e-12);  // λ dt beyond what one sum bears
    }
  }
}

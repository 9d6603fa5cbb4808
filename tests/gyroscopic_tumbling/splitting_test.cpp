#include "catch.hpp"
#include "splitting_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::Real;
using tests::times;
using tests::Trial;
using tests::wide;

namespace {

constexpr const char* splitting_function = "2.5 step_splitting";

tests::SpinStep splitting_step(const Vec3& moments) {
  return [moments](const Spin& spin, double dt) { return step_splitting(moments, spin, dt); };
}

/// Why nothing happens at some pace.
std::string why_at_rest() {
  const Spin got = step_about_axis(tests::tumble_moments, tests::tumble_start, 2, 0.1);
  const bool never =
      tests::difference(tests::value_of(got), tests::value_of(tests::tumble_start)) < 1e-12;
  return never ? tests::half_is_zero : tests::guarded;
}

/// |trace| of the map that a step makes of a small wobble about axis 3 (or 1) of moments that rise:
/// the wobble is held while it is below 2. About axis 3 the body turns by X = 2 atan(x/2) in one
/// sub-rotation, about axis 1 in two of half the length.
double wobble_trace(const tests::Wobble& wobble, double x) {
  const Vec3& I = wobble.moments;
  const bool about_third = wobble.axis == 2;
  const double X = about_third ? 2.0 * std::atan(0.5 * x) : 4.0 * std::atan(0.25 * x);
  const double a = x * (about_third ? I.z() / I.x() : I.x() / I.z());
  const double b = x * (about_third ? I.z() / I.y() : I.x() / I.y());
  return std::abs((2.0 - a * b) * std::cos(X) + (a + b - 0.25 * a * b * b) * std::sin(X));
}

double first_limit(const tests::Wobble& wobble) {
  double x = 0.1;
  while (wobble_trace(wobble, x) <= 2.0) x += 1e-5;
  return x;
}

}  // namespace

std::string tests::likely_of_sub_rotation() {
  struct Input {
    SpinCase in;
    int axis;
  };
  std::vector<Input> inputs;
  for (const SpinCase& in : spin_cases()) {
    for (int axis = 0; axis < 3; ++axis) inputs.push_back({in, axis});
  }
  return likely_over<SpinValue>(
      inputs,
      [](const Input& i) {
        return value_of(step_about_axis(i.in.moments, i.in.spin, i.axis, i.in.dt));
      },
      [](const Input& i) {
        return sub_rotation_suspects(i.in.moments, i.in.spin, i.axis, i.in.dt);
      });
}

std::string tests::likely_of_splitting_step() {
  return likely_over<SpinValue>(
      spin_cases(),
      [](const auto& in) { return value_of(step_splitting(in.moments, in.spin, in.dt)); },
      [](const auto& in) { return splitting_suspects(in.moments, in.spin, in.dt); });
}

TEST_CASE("A sub-rotation turns by twice the arc tangent of half of omega dt", "[2.5]") {
  // omega_3 dt = 2: a quarter turn about z. m = (1, 0, 6) turns back to (0, -1, 6).
  const Vec3 moments(1.0, 2.0, 3.0);
  const Spin spin{Quat::Identity(), Vec3(1.0, 0.0, 2.0)};
  tests::spin_trial("2.5 step_about_axis", moments, spin)
      .given("axis", 2.0)
      .given("dt", 1.0)
      .expect(
          tests::value_of(step_about_axis(moments, spin, 2, 1.0)),
          tests::SpinValue{{Quat(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)), Vec3(0.0, -0.5, 2.0)}},
          {32.0 * eps, "some 30 operations on numbers up to 6"},
          tests::sub_rotation_suspects(moments, spin, 2, 1.0));
}

TEST_CASE("A sub-rotation turns the attitude forwards and the momentum back", "[2.5]") {
  tests::Random random(251);
  for (int i = 1; i <= 90; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random, 4.0);
    const int axis = i % 3;
    const double dt = random.uniform(-0.5, 0.5);
    tests::spin_trial("2.5 step_about_axis", moments, spin, i, 90)
        .given("axis", static_cast<double>(axis))
        .given("dt", dt)
        .expect(tests::value_of(step_about_axis(moments, spin, axis, dt)),
                narrow(tests::about_axis(wide(moments), wide(spin), axis, wide(dt))),
                {512.0 * eps, "some 50 operations, and moments a factor 12 apart at most"},
                tests::sub_rotation_suspects(moments, spin, axis, dt));
  }
}

TEST_CASE("The splitting takes the axes in the order 1 2 3 2 1", "[2.5]") {
  tests::Random random(252);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random, 4.0);
    const double dt = random.uniform(-0.2, 0.2);
    tests::spin_trial(splitting_function, moments, spin, i, 100)
        .given("dt", dt)
        .expect(tests::value_of(step_splitting(moments, spin, dt)),
                narrow(tests::splitting(moments, spin, wide(dt))),
                {2048.0 * eps, "five times some 50 operations, moments a factor 12 apart at most"},
                tests::splitting_suspects(moments, spin, dt));
  }
}

TEST_CASE("The splitting keeps the angular momentum as a world vector to rounding", "[2.5]") {
  tests::Random random(253);
  for (int i = 1; i <= 10; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin start = tests::random_spin(random, 4.0);
    const auto momentum = [&](const Spin& spin) {
      return Vec3(spin.world_from_body * moments.cwiseProduct(spin.angular_velocity_body));
    };
    Spin spin = start;
    for (int k = 0; k < 1000; ++k) spin = step_splitting(moments, spin, 0.1);
    tests::spin_trial(splitting_function, moments, start, i, 10)
        .of("L after 1000 steps of 0.1 s")
        .expect(momentum(spin), momentum(start),
                {1000.0 * 32.0 * eps * momentum(start).norm(),
                 "32 ulp per step, all in the same direction"});
  }
}

TEST_CASE("A sub-rotation follows its formula at any speed", "[2.5]") {
  tests::Random random(255);
  for (int i = 1; i <= 90; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const tests::Paced paced = tests::random_pace(random, 3.0);
    const int axis = i % 3;
    tests::expect_paced(
        tests::spin_trial("2.5 step_about_axis", moments, paced.spin, i, 90)
            .given("axis", static_cast<double>(axis)),
        paced, [&] { return step_about_axis(moments, paced.spin, axis, paced.dt); },
        tests::about_axis(wide(moments), wide(paced.spin), axis, static_cast<Real>(paced.dt)),
        why_at_rest());
  }
}

TEST_CASE("A splitting step follows its formula at any speed", "[2.5]") {
  tests::Random random(256);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const tests::Paced paced = tests::random_pace(random, 1.0);
    tests::expect_paced(
        tests::spin_trial(splitting_function, moments, paced.spin, i, 100), paced,
        [&] { return step_splitting(moments, paced.spin, paced.dt); },
        tests::splitting(moments, paced.spin, wide(paced.dt)), why_at_rest());
  }
}

TEST_CASE("A step back undoes a splitting step", "[2.5]") {
  tests::Random random(254);
  for (int i = 1; i <= 20; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin start = tests::random_spin(random, 4.0);
    const Spin there = step_splitting(moments, start, 0.2);
    const Trial trial =
        tests::spin_trial(splitting_function, moments, start, i, 20).given("dt", 0.2);
    trial.expect(
        tests::value_of(step_splitting(moments, there, -0.2)), tests::value_of(start),
        {4096.0 * eps, "the rounding of two steps; the order 1-2-3-2-1 is the same backwards"},
        {{tests::value_of(there),
          "a negative dt is taken for a positive one or for zero: use it as it is"}});
    trial.expect_small("0.01 - angle of the step there",
                       0.01 - common::angle_between(start.world_from_body, there.world_from_body),
                       {0.0, "a step that does nothing is undone, too"});
  }
}

TEST_CASE("The splitting holds a wobble up to the limit of its trace", "[2.5]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    const tests::Wobble wobble{.axis = axis};
    const double limit = first_limit(wobble);  // omega is 1, so x is dt
    const Trial trial =
        tests::spin_trial(splitting_function, wobble.moments, wobble.start(1e-5), ++index, 2)
            .given("theta at the limit", limit);
    trial.expect_small("growth at 0.9 of the limit",
                       tests::growth(wobble, splitting_step(wobble.moments), 0.9 * limit, 10000),
                       {10.0, "|trace| < 2: the wobble runs on an ellipse"});
    trial.expect_small(
        "100 - growth at 1.1 of the limit",
        100.0 - tests::growth(wobble, splitting_step(wobble.moments), 1.1 * limit, 10000),
        {0.0, "|trace| > 2: one direction of the wobble grows with every step"});
  }
}

TEST_CASE("The splitting converges with order two on a tumble", "[2.5]") {
  tests::expect_order(splitting_function, splitting_step(tests::tumble_moments), 256, 2.0);
}

#include "catch.hpp"
#include "implicit_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* implicit_function = "2.3 step_implicit";
tests::SpinStep implicit_step(const Vec3& moments) {
  return [moments](const Spin& spin, double dt) { return step_implicit(moments, spin, dt); };
}

Trial equation_trial(const char* name, const Vec3& moments, const Vec3& omega, double dt, int index,
                     int count) {
  return tests::trial_of(name, index, count)
      .given("moments", moments)
      .given("next_angular_velocity_body", omega)
      .given("dt", dt);
}

}  // namespace

std::string tests::likely_of_residual() {
  return likely_over<Vec3>(
      spin_cases(),
      [](const auto& in) {
        return implicit_residual(in.moments, in.spin.angular_velocity_body, in.other, in.dt);
      },
      [](const auto& in) {
        return residual_suspects(in.moments, in.spin.angular_velocity_body, in.other, in.dt);
      });
}

std::string tests::likely_of_jacobian() {
  return likely_over<Mat3>(
      spin_cases(), [](const auto& in) { return implicit_jacobian(in.moments, in.other, in.dt); },
      [](const auto& in) { return jacobian_suspects(in.moments, in.other, in.dt); });
}

std::string tests::likely_of_implicit_step() {
  return likely_over<SpinValue>(
      spin_cases(),
      [](const auto& in) { return value_of(step_implicit(in.moments, in.spin, in.dt)); },
      [](const auto& in) { return implicit_suspects(in.moments, in.spin, in.dt); });
}

TEST_CASE("At an unchanged velocity the residual is the gyroscopic impulse", "[2.3]") {
  // (1, 1, 1) x (1, 2, 3) = (1, -2, 1), for half a second.
  const Vec3 ones = Vec3::Ones();
  const Vec3 moments(1.0, 2.0, 3.0);
  equation_trial("2.3 implicit_residual", moments, ones, 0.5, 1, 1)
      .given("angular_velocity_body", ones)
      .expect(implicit_residual(moments, ones, ones, 0.5), Vec3(0.5, -1.0, 0.5),
              {8.0 * eps, "a few roundings of numbers near one"},
              tests::residual_suspects(moments, ones, ones, 0.5));
}

TEST_CASE("The residual takes the gyroscopic term at the new velocity", "[2.3]") {
  tests::Random random(231);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Vec3 old = random.vector(4.0);
    const Vec3 next = random.vector(4.0);
    const double dt = random.uniform(0.01, 0.3);
    const VecL I = wide(moments);
    equation_trial("2.3 implicit_residual", moments, next, dt, i, 100)
        .given("angular_velocity_body", old)
        .expect(implicit_residual(moments, old, next, dt),
                narrow(tests::residual(I, wide(old), wide(next), wide(dt))),
                {32.0 * eps * 100.0, "some 15 operations on terms up to 100"},
                tests::residual_suspects(moments, old, next, dt));
  }
}

TEST_CASE("The Jacobian is the derivative of the residual", "[2.3]") {
  tests::Random random(232);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Vec3 omega = random.vector(4.0);
    const double dt = random.uniform(0.01, 0.3);
    const tests::MatL wanted = tests::jacobian(wide(moments), wide(omega), wide(dt));
    equation_trial("2.3 implicit_jacobian", moments, omega, dt, i, 100)
        .expect(implicit_jacobian(moments, omega, dt), Mat3(wanted.cast<double>()),
                {16.0 * eps * 20.0, "a few operations per entry, on terms up to 20"},
                tests::jacobian_suspects(moments, omega, dt));
  }
}

TEST_CASE("An implicit step is one Newton step and a turn by the new velocity", "[2.3]") {
  tests::Random random(233);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random, 4.0);
    const double dt = random.uniform(-0.1, 0.1);
    const double condition = moments.maxCoeff() / moments.minCoeff();
    tests::spin_trial(implicit_function, moments, spin, i, 100)
        .given("dt", dt)
        .expect(tests::value_of(step_implicit(moments, spin, dt)),
                narrow(tests::implicit(moments, spin, wide(dt))),
                {256.0 * eps * condition,
                 "some 100 operations and a 3 x 3 system of condition "
                 "about that of the moments"},
                tests::implicit_suspects(moments, spin, dt));
  }
}

TEST_CASE("An implicit step follows its formula at any speed", "[2.3]") {
  tests::Random random(234);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const tests::Paced paced = tests::random_pace(random, 0.3);
    tests::expect_paced(
        tests::spin_trial(implicit_function, moments, paced.spin, i, 100), paced,
        [&] { return step_implicit(moments, paced.spin, paced.dt); },
        tests::implicit(moments, paced.spin, wide(paced.dt)));
  }
}

TEST_CASE("A body of equal moments does not tumble in the implicit step", "[2.3]") {
  tests::expect_no_tumble_of_a_sphere(implicit_function, implicit_step(Vec3::Constant(2.0)));
}

TEST_CASE("An implicit step makes the wobble shrink by the root of one plus y squared", "[2.3]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    const tests::Wobble wobble{.axis = axis};
    const double y = wobble.precession() * 0.1;
    const double got = tests::growth_factor(wobble, implicit_step(wobble.moments), 0.1, 100);
    tests::spin_trial(implicit_function, wobble.moments, wobble.start(1e-5), ++index, 2)
        .given("dt", 0.1)
        .of("the wobble's growth per step")
        .expect(got, 1.0 / std::sqrt(1.0 + y * y),
                {1e-9, "the wobble's own square, 1e-10, and rounding"},
                {{std::sqrt(1.0 + y * y), tests::explicit_step}, {1.0, tests::forgotten}});
  }
}

TEST_CASE("An implicit wobble has shrunk to a tenth after the steps of the formula", "[2.3]") {
  const tests::Wobble wobble;
  const double y = wobble.precession() * 0.1;
  const double steps = std::log(10.0) / (0.5 * std::log1p(y * y));
  const auto after = [&](double share) {
    Spin spin = wobble.start(1e-5);
    for (int i = 0; i < static_cast<int>(share * steps); ++i) {
      spin = step_implicit(wobble.moments, spin, 0.1);
    }
    return wobble.amplitude(spin) / wobble.amplitude(wobble.start(1e-5));
  };
  const Trial trial = tests::spin_trial(implicit_function, wobble.moments, wobble.start(1e-5))
                          .given("steps to a tenth", steps);
  trial.expect_small("0.1 - the wobble after 0.9 of these steps", 0.1 - after(0.9),
                     {0.0, "10^-0.9 by the closed form: more than a tenth is left"});
  trial.expect_small("the wobble after 1.1 of these steps", after(1.1),
                     {0.1, "10^-1.1 by the closed form: less than a tenth is left"});
}

TEST_CASE("In ten minutes the implicit step loses a fifth of the angular momentum of a tumble",
          "[2.3]") {
  // At 60 steps a second and a turn a second: it ends in a spin about the major axis, where
  // 2 E I3 = L^2, with 0.788 of |L| left.
  const Vec3 moments(1.0, 2.0, 3.0);
  const Spin start{Quat::Identity(), Vec3::Constant(2.0 * std::acos(-1.0) / std::sqrt(3.0))};
  Spin spin = start;
  for (int i = 0; i < 36000; ++i) spin = step_implicit(moments, spin, 1.0 / 60.0);
  const Vec3 m = moments.cwiseProduct(spin.angular_velocity_body);
  const double left = m.norm() / moments.cwiseProduct(start.angular_velocity_body).norm();
  const double energy = spin.angular_velocity_body.dot(m);  // twice
  const Trial trial = tests::spin_trial(implicit_function, moments, start).given("steps", 36000.0);
  trial.of("the share of |L| that is left")
      .expect(left, 0.788, {1e-3, "measured with other code, to three digits"},
              {{1.0, "nothing is lost: this is not the implicit step, which damps the wobble"}});
  trial.of("2 E I3 / L^2")
      .expect(energy * 3.0 / m.squaredNorm(), 1.0, {1e-6, "the wobble has died out"});
}

TEST_CASE("The implicit step converges with order one on a tumble", "[2.3]") {
  tests::expect_order(implicit_function, implicit_step(tests::tumble_moments), 1024, 1.0);
}

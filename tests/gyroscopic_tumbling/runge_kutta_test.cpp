#include <complex>

#include "catch.hpp"
#include "runge_kutta_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* rk4_function = "2.4 step_rk4";

tests::SpinStep rk4_step(const Vec3& moments) {
  return [moments](const Spin& spin, double dt) { return step_rk4(moments, spin, dt); };
}

/// |1 + z + z²/2 + z³/6 + z⁴/24| at z = i y: what RK4 makes of an undamped oscillation.
double amplification(double y) {
  const std::complex<double> z(0.0, y);
  return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
}

void expect_rate(const Trial& trial, const Vec3& moments, const Spin& spin) {
  const SpinRate got = spin_rate(moments, spin);
  const VecL I = wide(moments);
  const auto attitude = [&](const tests::Rk4Variation& v) {
    return narrow(tests::rate(I, wide(spin), v).q);
  };
  const double speed = spin.angular_velocity_body.norm();
  trial.of("the attitude's rate")
      .expect(
          Eigen::Vector4d(got.attitude.coeffs()).norm(),
          Eigen::Vector4d(attitude({}).coeffs()).norm(), {32.0 * eps * speed, "some 10 operations"},
          {{attitude({.half = 1}).norm(), "the factor 1/2 is missing in dq/dt: multiply by 0.5"},
           {0.0, "q does not change, because 1/2 is 0 in whole numbers: write 0.5"}});
  // q and -q are one attitude, but a rate has a sign: shifted by q it cannot be mistaken.
  const auto shifted = [&](const Quat& dq) {
    return Quat(4.0 * (1.0 + speed) * spin.world_from_body.coeffs() + dq.coeffs());
  };
  trial.of("the attitude's rate, added to a multiple of q")
      .expect(shifted(got.attitude), shifted(attitude({})),
              {64.0 * eps * (1.0 + speed), "some 10 operations"},
              {{shifted(attitude({.world_side = true})),
                "omega stands on the left of q, but it is in body axes: put it on the right"}});
  trial.of("the angular acceleration")
      .expect(got.angular_acceleration_body,
              narrow(tests::euler_rate(I, wide(spin.angular_velocity_body))),
              {32.0 * eps * 12.0 * speed * speed,
               "some 10 operations, and moments at most a factor 12 apart"},
              tests::rate_suspects(moments, spin));
}

}  // namespace

std::string tests::likely_of_rate() {
  return likely_over<Vec3>(
      spin_cases(),
      [](const auto& in) { return spin_rate(in.moments, in.spin).angular_acceleration_body; },
      [](const auto& in) { return rate_suspects(in.moments, in.spin); });
}

std::string tests::likely_of_rk4_step() {
  return likely_over<SpinValue>(
      spin_cases(), [](const auto& in) { return value_of(step_rk4(in.moments, in.spin, in.dt)); },
      [](const auto& in) { return rk4_suspects(in.moments, in.spin, in.dt); });
}

TEST_CASE("The rate of a spin is half of q omega and the equations of Euler", "[2.4]") {
  tests::Random random(241);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random);
    expect_rate(tests::spin_trial("2.4 spin_rate", moments, spin, i, 100), moments, spin);
  }
}

TEST_CASE("The rate of a quaternion of length two is twice as large", "[2.4]") {
  tests::Random random(242);
  for (int i = 1; i <= 10; ++i) {
    const Vec3 moments = tests::random_moments(random);
    Spin spin = tests::random_spin(random);
    spin.world_from_body.coeffs() *= 2.0;
    expect_rate(tests::spin_trial("2.4 spin_rate", moments, spin, i, 10), moments, spin);
  }
}

TEST_CASE("A Runge-Kutta step mixes four rates with weights 1 2 2 1", "[2.4]") {
  tests::Random random(243);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random, 4.0);
    const double dt = random.uniform(-0.2, 0.2);
    tests::spin_trial(rk4_function, moments, spin, i, 100)
        .given("dt", dt)
        .expect(tests::value_of(step_rk4(moments, spin, dt)),
                narrow(tests::rk4(moments, spin, wide(dt))),
                {1024.0 * eps, "some 150 operations, and rates up to ten times the state"},
                tests::rk4_suspects(moments, spin, dt));
  }
}

TEST_CASE("A Runge-Kutta step follows its formula at any speed", "[2.4]") {
  tests::Random random(244);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const tests::Paced paced = tests::random_pace(random, 1.0);
    tests::expect_paced(
        tests::spin_trial(rk4_function, moments, paced.spin, i, 100), paced,
        [&] { return step_rk4(moments, paced.spin, paced.dt); },
        tests::rk4(moments, paced.spin, wide(paced.dt)));
  }
}

TEST_CASE("A body of equal moments does not tumble in a Runge-Kutta step", "[2.4]") {
  tests::expect_no_tumble_of_a_sphere(rk4_function, rk4_step(Vec3::Constant(2.0)));
}

TEST_CASE("A Runge-Kutta step amplifies the wobble as its stability polynomial says", "[2.4]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    for (const double y : {0.1, 1.0, 2.0, 2.7, 3.0}) {
      const tests::Wobble wobble{.axis = axis};
      const double dt = y / wobble.precession();
      const double got = tests::growth_factor(wobble, rk4_step(wobble.moments), dt, 4);
      tests::spin_trial(rk4_function, wobble.moments, wobble.start(1e-5), ++index, 10)
          .given("y", y)
          .of("the wobble's growth per step")
          .expect(got, amplification(y),
                  {3e-7, "the wobble's own square, 1e-10, times up to y^4 and 1/|R|^4"});
    }
  }
}

TEST_CASE("Runge-Kutta holds the wobble below two root two and loses it above", "[2.4]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    const tests::Wobble wobble{.axis = axis};
    const double limit = 2.0 * std::sqrt(2.0) / wobble.precession();
    const Trial trial =
        tests::spin_trial(rk4_function, wobble.moments, wobble.start(1e-5), ++index, 2)
            .given("dt at the limit", limit);
    trial.expect_small("growth at 0.9 of the limit",
                       tests::growth(wobble, rk4_step(wobble.moments), 0.9 * limit, 1000),
                       {1.01, "|R(i y)| < 1 for y < 2 sqrt2: it can only shrink"});
    trial.expect_small("100 - growth at 1.1 of the limit",
                       100.0 - tests::growth(wobble, rk4_step(wobble.moments), 1.1 * limit, 1000),
                       {0.0, "|R(i y)| = 1.6 per step at y = 3.1"});
  }
}

TEST_CASE("The Runge-Kutta step converges with order four on a tumble", "[2.4]") {
  tests::expect_order(rk4_function, rk4_step(tests::tumble_moments), 128, 4.0);
}

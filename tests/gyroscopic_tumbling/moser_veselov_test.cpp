#include "catch.hpp"
#include "motions.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::corrected;
using tests::eps;
using tests::narrow;
using tests::QuatL;
using tests::SpinL;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* moser_veselov_function = "2.8 step_moser_veselov";

struct StepVariation {
  bool forwards = false;    ///< m turns with the body
  bool rests = false;       ///< m does not turn
  bool undivided = false;   ///< m is returned for ω
  Vec3 by = Vec3::Zero();   ///< divides m, if not zero
  bool world_side = false;  ///< p on the left of q
};

SpinL stepped(const Vec3& moments, const Spin& spin, const Quat& p, const StepVariation& v = {}) {
  const VecL I = wide(moments);
  const SpinL old = wide(spin);
  const QuatL turn = wide(p);
  VecL m = tests::times(I, old.omega);
  if (!v.rests) m = (v.forwards ? turn : turn.conjugate()) * m;
  const VecL by = v.by.isZero() ? I : wide(v.by);
  return {v.world_side ? turn * old.q : old.q * turn, v.undivided ? m : m.cwiseQuotient(by)};
}

/// The increment by Newton's method in extended precision.
Quat exact_increment(const Vec3& moments, const Vec3& momentum, double dt) {
  const VecL I = wide(moments);
  const VecL half = wide(momentum) * wide(dt) / 2;
  const VecL spread(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());
  VecL e = VecL::Zero();
  for (int i = 0; i < 60; ++i) {
    const VecL products(e.y() * e.z(), e.z() * e.x(), e.x() * e.y());
    const VecL F =
        tests::times(I, e) + tests::times(spread, products) - half * (1 + e.squaredNorm());
    tests::MatL J;
    J << I.x(), spread.x() * e.z(), spread.x() * e.y(), spread.y() * e.z(), I.y(),
        spread.y() * e.x(), spread.z() * e.y(), spread.z() * e.x(), I.z();
    J -= 2 * half * e.transpose();
    e -= J.inverse() * F;
  }
  return narrow(QuatL(1, e.x(), e.y(), e.z()).normalized());
}

std::vector<tests::Suspect<tests::SpinValue>> step_suspects(const Vec3& moments,
                                                            const MomentCorrection& correction,
                                                            const Spin& spin, double dt) {
  const Vec3 tilde =
      narrow(corrected(wide(moments), wide(correction.scale), wide(correction.shift)));
  const Vec3& omega = spin.angular_velocity_body;
  const Vec3 momentum = moments.cwiseProduct(omega);
  const Quat p = exact_increment(tilde, momentum, dt);
  const auto with = [&](const StepVariation& v) { return narrow(stepped(moments, spin, p, v)); };
  return {{with({.forwards = true}),
           "m turns with the body: L is constant in the world, so turn m the other way"},
          {with({.rests = true}), "m does not turn: turn it by p backwards"},
          {with({.undivided = true}), "the new m is returned as omega: divide it by the moments"},
          {narrow(stepped(moments, spin, exact_increment(moments, momentum, dt))),
           "the correction is not used: find p with the corrected moments"},
          {narrow(stepped(tilde, spin, exact_increment(tilde, tilde.cwiseProduct(omega), dt))),
           "m is computed with the corrected moments: use the body's own"},
          {with({.by = tilde}),
           "the new omega is computed with the corrected moments: use the body's own"},
          {narrow(stepped(moments, spin, exact_increment(tilde, omega, dt))),
           "p is computed from omega: compute it from m = I0 omega"},
          {with({.world_side = true}),
           "p stands on the left of q, but it turns about body axes: put it on the right"}};
}

tests::SpinStep step_of(const Vec3& moments, int order) {
  return [moments, order](const Spin& spin, double dt) {
    const MomentCorrection correction =
        common::moser_veselov_correction(moments, tests::tumble_start, dt, order);
    return step_moser_veselov(moments, correction, spin, dt);
  };
}

}  // namespace

std::string tests::likely_of_moser_veselov_step() {
  const MomentCorrection correction{-0.03, 0.01};
  return likely_over<SpinValue>(
      spin_cases(),
      [&](const auto& in) {
        return value_of(step_moser_veselov(in.moments, correction, in.spin, in.dt));
      },
      [&](const auto& in) { return step_suspects(in.moments, correction, in.spin, in.dt); });
}

TEST_CASE("A step turns the attitude by the increment and the momentum back", "[2.8]") {
  tests::Random random(283);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random, 3.0);
    const double dt = random.uniform(0.01, 0.12);
    const MomentCorrection correction{random.uniform(-0.05, 0.0), random.uniform(0.0, 0.02)};
    const Vec3 tilde =
        narrow(corrected(wide(moments), wide(correction.scale), wide(correction.shift)));
    const Quat p = exact_increment(tilde, moments.cwiseProduct(spin.angular_velocity_body), dt);
    tests::spin_trial(moser_veselov_function, moments, spin, i, 100)
        .given("correction.scale", correction.scale)
        .given("correction.shift", correction.shift)
        .given("dt", dt)
        .expect(tests::value_of(step_moser_veselov(moments, correction, spin, dt)),
                narrow(stepped(moments, spin, p)),
                {1024.0 * eps, "some 200 operations, moments a factor 12 apart"},
                step_suspects(moments, correction, spin, dt));
  }
}

TEST_CASE("A step of Moser and Veselov follows its formula at any speed", "[2.8]") {
  tests::Random random(286);
  for (int i = 1; i <= 60; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const tests::Paced paced = tests::random_pace(random, 0.2);
    const Vec3 momentum = moments.cwiseProduct(paced.spin.angular_velocity_body);
    tests::expect_paced(
        tests::spin_trial(moser_veselov_function, moments, paced.spin, i, 60), paced,
        [&] { return step_moser_veselov(moments, {}, paced.spin, paced.dt); },
        stepped(moments, paced.spin, exact_increment(moments, momentum, paced.dt)));
  }
}

TEST_CASE("A step at rest or for no time changes nothing", "[2.8]") {
  tests::Random random(287);
  for (int i = 1; i <= 20; ++i) {
    const Vec3 moments = tests::random_moments(random);
    Spin spin = tests::random_spin(random, 3.0);
    if (i % 2 == 0) spin.angular_velocity_body.setZero();
    const double dt = i % 2 == 0 ? random.uniform(-0.2, 0.2) : 0.0;
    const Trial trial =
        tests::spin_trial(moser_veselov_function, moments, spin, i, 20).given("dt", dt);
    const Spin got = trial.returned([&] { return step_moser_veselov(moments, {}, spin, dt); });
    trial.expect(tests::value_of(got), tests::value_of(spin),
                 {64.0 * eps, "a turn by 1, m times I and divided by it, q normalised"});
  }
}

TEST_CASE("Energy and angular momentum are kept to rounding at any step that exists", "[2.8]") {
  tests::Random random(284);
  for (int i = 1; i <= 10; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin start{random.attitude(), random.direction()};
    const double dt = 0.6 * moments.minCoeff() / moments.maxCoeff();
    Spin spin = start;
    for (int k = 0; k < 1000; ++k) spin = step_moser_veselov(moments, {}, spin, dt);
    const auto energy = [&](const Spin& s) {
      return s.angular_velocity_body.dot(moments.cwiseProduct(s.angular_velocity_body));
    };
    const auto momentum = [&](const Spin& s) {
      return Vec3(s.world_from_body * moments.cwiseProduct(s.angular_velocity_body));
    };
    const Trial trial =
        tests::spin_trial(moser_veselov_function, moments, start, i, 10).given("dt", dt);
    const double rounding = 1000.0 * 64.0 * eps * moments.maxCoeff() / moments.minCoeff();
    trial.of("the energy after 1000 steps, relative to the first")
        .expect(energy(spin) / energy(start), 1.0,
                {rounding, "64 ulp per step, all in the same direction"});
    trial.of("L after 1000 steps")
        .expect(momentum(spin), momentum(start),
                {rounding * momentum(start).norm(), "64 ulp per step, all in the same direction"});
    trial.expect_small(
        "0.01 - angle of a step",
        0.01 - common::angle_between(start.world_from_body,
                                     step_moser_veselov(moments, {}, start, dt).world_from_body),
        {0.0, "a step that does nothing keeps them, too"});
  }
}

TEST_CASE("Without a correction the step converges with order two on a tumble", "[2.8]") {
  tests::expect_order(moser_veselov_function, step_of(tests::tumble_moments, 2), 128, 2.0);
}

TEST_CASE("With the first correction the step converges with order four on a tumble", "[2.8]") {
  tests::expect_order(moser_veselov_function, step_of(tests::tumble_moments, 4), 64, 4.0);
}

TEST_CASE("With four corrections the step converges with order ten on a tumble", "[2.8]") {
  tests::expect_order(moser_veselov_function, step_of(tests::tumble_moments, 10), 12, 10.0);
}

#include <complex>

#include "catch.hpp"
#include "motions.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::QuatL;
using tests::Real;
using tests::SpinL;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* rk4_function = "2.4 step_rk4";

struct Rk4Variation {
  Real gyroscopic = 1;           ///< times the gyroscopic term
  Real half = 0.5L;              ///< in dq/dt
  bool world_side = false;       ///< ω q for q ω
  bool equal_weights = false;    ///< 1, 1, 1, 1 for 1, 2, 2, 1
  bool short_last = false;       ///< the fourth rate at the middle
  bool unit_stages = false;      ///< q normalised in between
  bool unit_end = true;          ///< q normalised at the end
  bool one_exponential = false;  ///< q turned once, by the mean of the stages' ω
};

struct RateL {
  QuatL q;
  VecL omega;
};

RateL rate(const VecL& I, const SpinL& spin, const Rk4Variation& v) {
  const QuatL product =
      v.world_side ? tests::pure(spin.omega) * spin.q : spin.q * tests::pure(spin.omega);
  return {QuatL(Eigen::Matrix<Real, 4, 1>(v.half * product.coeffs())),
          tests::euler_rate(I, spin.omega, v.gyroscopic)};
}

SpinL moved(const SpinL& spin, const RateL& k, Real dt, bool unit) {
  SpinL next{tests::sum(spin.q, dt, k.q), VecL(spin.omega + dt * k.omega)};
  if (unit) next.q.normalize();
  return next;
}

SpinL rk4(const Vec3& moments, const Spin& spin, Real dt, const Rk4Variation& v = {}) {
  const VecL I = wide(moments);
  const SpinL s1 = wide(spin);
  const RateL k1 = rate(I, s1, v);
  const SpinL s2 = moved(s1, k1, dt / 2, v.unit_stages);
  const RateL k2 = rate(I, s2, v);
  const SpinL s3 = moved(s1, k2, dt / 2, v.unit_stages);
  const RateL k3 = rate(I, s3, v);
  const SpinL s4 = moved(s1, k3, v.short_last ? dt / 2 : dt, v.unit_stages);
  const RateL k4 = rate(I, s4, v);
  const Real outer = v.equal_weights ? dt / 4 : dt / 6;
  const Real inner = v.equal_weights ? dt / 4 : dt / 3;
  SpinL next = moved(moved(s1, k1, outer, false), k2, inner, false);
  next = moved(moved(next, k3, inner, false), k4, outer, v.unit_end);
  if (v.one_exponential) {
    const VecL mean = (s1.omega + 2 * s2.omega + 2 * s3.omega + s4.omega) / 6;
    next.q = s1.q * tests::turn(dt * mean);
  }
  return next;
}

std::vector<tests::Suspect<tests::SpinValue>> rk4_suspects(const Vec3& moments, const Spin& spin,
                                                           double dt) {
  const auto with = [&](const Rk4Variation& v) { return narrow(rk4(moments, spin, wide(dt), v)); };
  return {
      {with({.gyroscopic = -1}), tests::flipped},
      {with({.gyroscopic = 0}), tests::forgotten},
      {with({.half = 1}), "the factor 1/2 is missing in dq/dt: multiply by 0.5"},
      {with({.half = 0}), "q does not change, because 1/2 is 0 in whole numbers: write 0.5"},
      {narrow(wide(spin)),
       "nothing changes, because 1/6 and 1/3 are 0 in whole numbers: write 1.0 / 6.0"},
      {with({.world_side = true}),
       "omega stands on the left of q, but it is in body axes: put it on the right"},
      {with({.equal_weights = true}), "the four rates have equal weights: use 1, 2, 2, 1"},
      {with({.short_last = true}), "the fourth rate is taken at the middle: take it at the end"},
      {with({.unit_stages = true}),
       "q is normalised between the rates, which spoils them: normalise only at the end"},
      {with({.unit_end = false}), "the quaternion is not normalised: divide it by its length"},
      {with({.one_exponential = true}),
       "q turns once by the mean of omega, which has only order two: average the rates dq/dt"}};
}

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
  const auto attitude = [&](const Rk4Variation& v) { return narrow(rate(I, wide(spin), v).q); };
  const auto spinning = [&](Real sign) {
    return narrow(rate(I, wide(spin), {.gyroscopic = sign}).omega);
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
      .expect(got.angular_acceleration_body, spinning(1),
              {32.0 * eps * 12.0 * speed * speed,
               "some 10 operations, and moments at most a factor 12 apart"},
              {{spinning(-1), tests::flipped}, {spinning(0), tests::forgotten}});
}

}  // namespace

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
        .expect(tests::value_of(step_rk4(moments, spin, dt)), narrow(rk4(moments, spin, wide(dt))),
                {1024.0 * eps, "some 150 operations, and rates up to ten times the state"},
                rk4_suspects(moments, spin, dt));
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
        rk4(moments, paced.spin, wide(paced.dt)));
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

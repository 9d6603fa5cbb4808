#include "catch.hpp"
#include "loop.hpp"
#include "motions.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::Trial;

/// Every function of the lab obeys the same law: with moments k times as large, and s times as fast
/// for 1/s of the time, all comes out as before, in units of k and s. Powers of two round nothing
/// on the way, so what differs there is lost above or below the range of a double.
namespace {

/// The contract's range is 1e-60 to 1e60; here moments and speeds are within a factor 100 of one.
struct Sizes {
  double k, s;
};
const std::vector<Sizes> ends{{0x1p192, 1.0},      {0x1p-192, 1.0},     {1.0, 0x1p192},
                              {1.0, 0x1p-192},     {0x1p192, 0x1p192},  {0x1p192, 0x1p-192},
                              {0x1p-192, 0x1p192}, {0x1p-192, 0x1p-192}};

constexpr const char* nothing =
    "nothing changes, because what is small is taken for zero: test only for exactly zero";
const tests::Bound same{1024.0 * eps, "the same numbers up to powers of two"};

struct Case {
  Vec3 moments;
  Spin spin;
  double dt;
};

/// Turns from 1e-3 to 0.2 a step.
Case random_case(tests::Random& random) {
  const Vec3 moments = tests::random_moments(random);
  const Spin spin{random.attitude(), random.uniform(0.1, 1.0) * random.direction()};
  return {moments, spin, random.uniform(0.01, 0.2)};
}

Case scaled(const Case& c, const Sizes& by) {
  return {
      by.k * c.moments, {c.spin.world_from_body, by.s * c.spin.angular_velocity_body}, c.dt / by.s};
}

Spin in_units(const Spin& spin, double speed) {
  return {spin.world_from_body, spin.angular_velocity_body / speed};
}

/// Calls judge(trial of the scaled case, case, the same scaled, sizes) for all ends.
template <typename Judge>
void at_all_ends(const std::string& function, std::uint64_t seed, const Judge& judge) {
  tests::Random random(seed);
  const auto count = static_cast<int>(4 * ends.size());
  for (int i = 0; i < count; ++i) {
    const Sizes by = ends[static_cast<std::size_t>(i) % ends.size()];
    const Case c = random_case(random);
    const Case large = scaled(c, by);
    judge(
        tests::spin_trial(function, large.moments, large.spin, i + 1, count).given("dt", large.dt),
        c, large, by);
  }
}

/// Requires the law of a step (moments, spin, dt) -> Spin.
template <typename Step>
void expect_scaled(const std::string& function, std::uint64_t seed, const Step& step) {
  at_all_ends(function, seed,
              [&](const Trial& trial, const Case& c, const Case& large, const Sizes& by) {
                const Spin got =
                    trial.returned([&] { return step(large.moments, large.spin, large.dt, by); });
                trial.of("the step in units of its sizes")
                    .expect(tests::value_of(in_units(got, by.s)),
                            tests::value_of(step(c.moments, c.spin, c.dt, Sizes{1.0, 1.0})), same,
                            {{tests::value_of(c.spin), nothing}});
              });
}

/// The loops of 2.2 and 2.7, pushed off their centre of mass by a force that suits the sizes.
template <typename Loop>
Spin looped(const Loop& loop, const Vec3& moments, const Spin& spin, double dt, const Sizes& by) {
  RigidBodyState state;
  state.world_from_body = spin.world_from_body;
  state.angular_velocity = spin.angular_velocity_body;
  const Vec3 force = by.k * by.s * by.s * Vec3(0.1, -0.2, 0.3);
  const RigidBodyState next =
      loop(RigidBody{by.k, moments}, state, {{force, Vec3(0.3, 0.1, -0.2)}}, dt);
  return {next.world_from_body, next.angular_velocity};
}

}  // namespace

TEST_CASE("The acceleration is right for all sizes from 1e-60 to 1e60", "[2.1]") {
  at_all_ends("2.1 angular_acceleration", 291,
              [](const Trial& trial, const Case& c, const Case& large, const Sizes& by) {
                const Mat3 R = c.spin.world_from_body.toRotationMatrix();
                const Mat3 inertia = R * c.moments.asDiagonal() * R.transpose();
                const Vec3& omega = c.spin.angular_velocity_body;
                const Vec3 torque(0.1, -0.2, 0.3);
                const Vec3 got = angular_acceleration(
                    by.k * inertia, large.spin.angular_velocity_body, by.k * by.s * by.s * torque);
                trial.of("the acceleration in units of its sizes")
                    .expect(Vec3(got / by.s / by.s), angular_acceleration(inertia, omega, torque),
                            same, {{Vec3(Vec3::Zero()), nothing}});
              });
}

TEST_CASE("Energy and momentum are right for all sizes from 1e-60 to 1e60", "[2.1]") {
  at_all_ends("2.1 rotational_energy", 292,
              [](const Trial& trial, const Case& c, const Case& large, const Sizes& by) {
                trial.of("the energy in units of its sizes")
                    .expect(rotational_energy(large.moments, large.spin) / by.k / by.s / by.s,
                            rotational_energy(c.moments, c.spin), same);
                trial.of("the momentum in units of its sizes")
                    .expect(Vec3(angular_momentum(large.moments, large.spin) / by.k / by.s),
                            angular_momentum(c.moments, c.spin), same);
              });
}

TEST_CASE("The loop is right for all sizes from 1e-60 to 1e60", "[2.2]") {
  expect_scaled("2.2 step_explicit", 293,
                [](const auto&... arguments) { return looped(step_explicit, arguments...); });
}

TEST_CASE("The implicit step is right for all sizes from 1e-60 to 1e60", "[2.3]") {
  expect_scaled("2.3 step_implicit", 294,
                [](const Vec3& moments, const Spin& spin, double dt, const Sizes&) {
                  return step_implicit(moments, spin, dt);
                });
}

TEST_CASE("The Runge-Kutta step is right for all sizes from 1e-60 to 1e60", "[2.4]") {
  expect_scaled("2.4 step_rk4", 295,
                [](const Vec3& moments, const Spin& spin, double dt, const Sizes&) {
                  return step_rk4(moments, spin, dt);
                });
}

TEST_CASE("The splitting is right for all sizes from 1e-60 to 1e60", "[2.5]") {
  expect_scaled("2.5 step_splitting", 296,
                [](const Vec3& moments, const Spin& spin, double dt, const Sizes&) {
                  return step_splitting(moments, spin, dt);
                });
}

TEST_CASE("The step of a top is right for all sizes from 1e-60 to 1e60", "[2.6]") {
  expect_scaled("2.6 step_kick_drift_kick", 297,
                [](const Vec3& moments, const Spin& spin, double dt, const Sizes& by) {
                  const HeavyTop top{moments.x(), 0.5 * moments.x(), by.k * by.s * by.s * 0.3};
                  return step_kick_drift_kick(top, spin, dt);
                });
}

TEST_CASE("The constrained step is right for all sizes from 1e-60 to 1e60", "[2.7]") {
  expect_scaled("2.7 step_constrained", 298,
                [](const auto&... arguments) { return looped(step_constrained, arguments...); });
}

TEST_CASE("The step of Moser and Veselov is right for all sizes from 1e-60 to 1e60", "[2.8]") {
  expect_scaled("2.8 step_moser_veselov", 299,
                [](const Vec3& moments, const Spin& spin, double dt, const Sizes&) {
                  const MomentCorrection correction = fourth_order_correction(moments, spin, dt);
                  return step_moser_veselov(moments, correction, spin, dt);
                });
}

TEST_CASE("A spin of 1e-60 for 1e-60 seconds is not a step that is too long", "[2.8]") {
  const Vec3 moments(1.0, 2.0, 2.5);
  const Spin spin{Quat(0.5, 0.5, -0.5, 0.5), 1e-60 * Vec3(0.6, 0.0, -0.8)};
  const Trial trial = tests::spin_trial("2.8 step_moser_veselov", moments, spin).given("dt", 1e-60);
  const Spin got = trial.returned([&] { return step_moser_veselov(moments, {}, spin, 1e-60); });
  trial.expect(tests::value_of(got), tests::value_of(spin), {16.0 * eps, "it turns by 1e-120"});
}

TEST_CASE("The correction of order four is right for all sizes from 1e-60 to 1e60", "[2.8]") {
  at_all_ends("2.8 fourth_order_correction", 2910,
              [](const Trial& trial, const Case& c, const Case& large, const Sizes& by) {
                const auto got = fourth_order_correction(large.moments, large.spin, large.dt);
                const auto wanted = fourth_order_correction(c.moments, c.spin, c.dt);
                trial.of("(scale, shift) in units of its sizes")
                    .expect(Vec3(got.scale, got.shift * by.k, 0.0),
                            Vec3(wanted.scale, wanted.shift, 0.0), same);
              });
}

#include <numbers>

#include "catch.hpp"
#include "heavy_top_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::Trial;
using tests::wide;

namespace {

constexpr const char* kick_drift_kick_function = "2.6 step_kick_drift_kick";
constexpr HeavyTop course_top{1.25, 0.5, 9.81};

Trial top_trial(const HeavyTop& top, const Spin& spin, int index = 1, int count = 1) {
  return tests::spin_trial(kick_drift_kick_function, narrow(tests::moments_of(top)), spin, index,
                           count)
      .given("top.weight_moment", top.weight_moment);
}

/// Leant over by `angle`, spinning about its own axis, the axis at rest.
Spin leaning(double angle, double axial_speed) {
  return {Quat(std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0),
          Vec3(0.0, 0.0, axial_speed)};
}

/// How far a nearly upright top leans within `duration`, at most [rad].
double greatest_lean(double axial_speed, double dt, double duration) {
  Spin spin = leaning(1e-6, axial_speed);
  double greatest = 0.0;
  for (int i = 0; i * dt < duration; ++i) {
    spin = step_kick_drift_kick(course_top, spin, dt);
    const Vec3 axis = spin.world_from_body * Vec3::UnitZ();
    if (!axis.allFinite()) return HUGE_VAL;
    greatest = std::max(greatest, std::hypot(axis.x(), axis.y()));
    if (axis.z() < 0.0) return 1.0;
  }
  return greatest;
}

/// The slowest spin that sleeps: c tan(c h/4) = h m g l / I1 with c = I3 ω3 / I1; for h → 0 it is
/// 2 √(I1 m g l) / I3.
double sleeping_speed(const HeavyTop& top, double h) {
  double low = 0.0;
  double high = 4.0 / h;
  for (int i = 0; i < 100; ++i) {
    const double c = 0.5 * (low + high);
    const bool enough = c * std::tan(0.25 * c * h) > h * top.weight_moment / top.transverse_moment;
    (enough ? high : low) = c;
  }
  return 0.5 * (low + high) * top.transverse_moment / top.axial_moment;
}

/// Why a top stays as it was: at rest and leaning, the weight must set it going.
std::string why_at_rest() {
  const Spin start{Quat(0.8, 0.6, 0.0, 0.0), Vec3::Zero()};
  if (weight_torque_body(course_top, start.world_from_body).isZero()) return tests::zero_torque;
  const bool never = step_kick_drift_kick(course_top, start, 0.1).angular_velocity_body.isZero();
  return never ? tests::weightless : tests::guarded;
}

double top_error(int steps) {
  const Spin start = leaning(0.5, 20.0);
  const common::LagrangeTop exact(course_top, start);
  Spin spin = start;
  double largest = 0.0;
  for (int i = 1; i <= steps; ++i) {
    spin = step_kick_drift_kick(course_top, spin, 1.0 / steps);
    if (!is_finite(tests::value_of(spin))) return std::nan("");
    const Quat wanted = exact.at(static_cast<double>(i) / steps).world_from_body;
    largest = std::max(largest, common::angle_between(spin.world_from_body, wanted));
  }
  return largest;
}

struct TopInput {
  HeavyTop top;
  Spin spin;
  double dt;
};

std::vector<TopInput> top_inputs() {
  std::vector<TopInput> all;
  for (const tests::SpinCase& in : tests::spin_cases()) {
    all.push_back({{in.moments.x(), 0.7 * in.moments.y(), 3.0 * in.moments.z()}, in.spin, in.dt});
  }
  return all;
}

}  // namespace

std::string tests::likely_of_weight_torque() {
  return likely_over<Vec3>(
      top_inputs(),
      [](const auto& in) { return weight_torque_body(in.top, in.spin.world_from_body); },
      [](const auto& in) { return torque_suspects(in.top, in.spin.world_from_body); });
}

std::string tests::likely_of_kick_drift_kick() {
  return likely_over<SpinValue>(
      top_inputs(),
      [](const auto& in) { return value_of(step_kick_drift_kick(in.top, in.spin, in.dt)); },
      [](const auto& in) { return kick_drift_kick_suspects(in.top, in.spin, in.dt); });
}

TEST_CASE("The weight of a top that lies along y turns it about minus x", "[2.6]") {
  // Turned by -90 degrees about x the body's z axis is the world's y; y x (-z) = -x in both.
  const Quat q(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0);
  tests::trial_of("2.6 weight_torque_body")
      .given("top.weight_moment", course_top.weight_moment)
      .given("world_from_body", q)
      .expect(weight_torque_body(course_top, q), Vec3(-9.81, 0.0, 0.0),
              {16.0 * eps * 9.81, "a turn and a product"});
}

TEST_CASE("The torque of the weight is the arm times the weight seen from the body", "[2.6]") {
  tests::Random random(261);
  for (int i = 1; i <= 100; ++i) {
    const HeavyTop top{1.0, 0.5, random.uniform(0.5, 10.0)};
    const Quat q = random.attitude();
    tests::trial_of("2.6 weight_torque_body", i, 100)
        .given("top.weight_moment", top.weight_moment)
        .given("world_from_body", q)
        .expect(weight_torque_body(top, q), narrow(tests::weight_torque(top, wide(q))),
                {32.0 * eps * top.weight_moment, "a turn of some 20 operations, and a product"},
                tests::torque_suspects(top, q));
  }
}

TEST_CASE("The step of a top kicks for half a step and drifts and kicks again", "[2.6]") {
  tests::Random random(262);
  for (int i = 1; i <= 100; ++i) {
    const HeavyTop top{random.uniform(0.8, 2.0), random.uniform(0.3, 1.2),
                       random.uniform(1.0, 9.0)};
    const Spin spin = tests::random_spin(random, 4.0);
    const double dt = random.uniform(-0.2, 0.2);
    top_trial(top, spin, i, 100)
        .given("dt", dt)
        .expect(tests::value_of(step_kick_drift_kick(top, spin, dt)),
                narrow(tests::kick_drift_kick(top, spin, wide(dt))),
                {512.0 * eps, "two kicks and two turns: some 100 operations on rates up to 30"},
                tests::kick_drift_kick_suspects(top, spin, dt));
  }
}

TEST_CASE("The same step moves a top that starts at rest or slowly", "[2.6]") {
  tests::Random random(264);
  for (int i = 1; i <= 40; ++i) {
    const HeavyTop top{1.25, 0.5, random.uniform(1.0, 9.0)};
    const double speed = i == 1 ? 0.0 : std::pow(10.0, random.uniform(-12.0, 0.0));
    const tests::Paced paced{{random.attitude(), speed * random.direction()},
                             random.uniform(-0.5, 0.5)};
    tests::expect_paced(
        top_trial(top, paced.spin, i, 40), paced,
        [&] { return step_kick_drift_kick(top, paced.spin, paced.dt); },
        tests::kick_drift_kick(top, paced.spin, wide(paced.dt)), why_at_rest());
  }
}

TEST_CASE("The momentum about the vertical and the spin about the axis are kept", "[2.6]") {
  const Spin start = leaning(0.5, 20.0);
  const Vec3 moments = narrow(tests::moments_of(course_top));
  Spin spin = start;
  const auto vertical = [&](const Spin& s) {
    return (s.world_from_body * moments.cwiseProduct(s.angular_velocity_body)).z();
  };
  for (int i = 0; i < 1000; ++i) spin = step_kick_drift_kick(course_top, spin, 0.01);
  const Trial trial = top_trial(course_top, start).given("steps of 0.01 s", 1000.0);
  trial.of("L along the vertical")
      .expect(vertical(spin), vertical(start),
              {1000.0 * 32.0 * eps * 12.0,
               "the weight has no torque about the vertical: 32 ulp per step"});
  trial.of("the axial speed")
      .expect(spin.angular_velocity_body.z(), 20.0,
              {1000.0 * 16.0 * eps * 20.0, "the weight has no torque about the top's axis"});
  const double tilt = common::angle_between(start.world_from_body, spin.world_from_body);
  trial.expect_small("0.1 - angle turned", 0.1 - tilt, {0.0, "the top must turn, too"});
}

TEST_CASE("Without weight the step of a top is the free motion", "[2.6]") {
  tests::Random random(263);
  for (int i = 1; i <= 20; ++i) {
    const HeavyTop top{1.25, 0.5, 0.0};
    const Spin spin = tests::random_spin(random, 4.0);
    top_trial(top, spin, i, 20)
        .given("dt", 0.3)
        .expect(tests::value_of(step_kick_drift_kick(top, spin, 0.3)),
                narrow(tests::drift(top, wide(spin), 0.3L)), {256.0 * eps, "two turns"});
  }
}

TEST_CASE("A sleeping top wakes at the limit of the step", "[2.6]") {
  int index = 0;
  for (const double h : {0.01, 0.1}) {
    const double limit = sleeping_speed(course_top, h);
    const Trial trial = top_trial(course_top, leaning(1e-6, limit), ++index, 2)
                            .given("dt", h)
                            .given("axial speed at the limit", limit);
    trial.expect_small(
        "lean at 1.1 of the limit", greatest_lean(1.1 * limit, h, 20.0),
        {1e-4, "it circles the vertical at a few times its lean at the start, 1e-6"});
    trial.expect_small("0.1 - lean at 0.9 of the limit", 0.1 - greatest_lean(0.9 * limit, h, 20.0),
                       {0.0, "it falls at the rate sqrt(1 - 0.81) sqrt(m g l / I1) = 1.2/s"});
  }
}

TEST_CASE("The step of the top converges with order two on the heavy top", "[2.6]") {
  const double coarse = top_error(256);
  const double fine = top_error(512);
  top_trial(course_top, leaning(0.5, 20.0))
      .given("coarse error", coarse)
      .given("fine error", fine)
      .expect(std::log2(coarse / fine), 2.0,
              {0.1,
               "the slope from 256 to 512 steps a second; the square of the turn per step, 6e-3, "
               "bends it"});
}

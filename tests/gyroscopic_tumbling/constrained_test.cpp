#include <limits>

#include "catch.hpp"
#include "loop.hpp"
#include "motions.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::QuatL;
using tests::Real;
using tests::Trial;
using tests::wide;

namespace {

constexpr const char* half_is_zero =
    "q does not change, because 1/2 is 0 in whole numbers: write 0.5";

constexpr const char* sign_changed =
    "the sign of q_pred is changed, so this is the farthest unit quaternion: leave the sign as it "
    "is";
constexpr const char* backwards =
    "q is predicted backwards: add dt omega q / 2, do not subtract it";

/// Four numbers whose sign counts, unlike an attitude's.
double distance(const Quat& a, const Quat& b) {
  return tests::length(Quat(a.coeffs() - b.coeffs()));
}

/// What the projection makes of a quaternion of that length in a known direction.
struct Projected {
  double off = HUGE_VAL;  ///< of the result from that direction
  bool threw = false;
};
Projected projected(double size) {
  try {
    const Quat got = project(Quat(0.6 * size, 0.0, -0.8 * size, 0.0));
    const double off = distance(got, Quat(0.6, 0.0, -0.8, 0.0));
    return {tests::is_finite(got) ? off : HUGE_VAL, false};
  } catch (const std::invalid_argument&) {
    return {HUGE_VAL, true};
  }
}

/// What is wrong with the projection of a quaternion of that length. Squares go wrong at both ends
/// of the range. A test of the length that is too wide throws at one end.
std::string why_projected_wrong(double size) {
  const auto is_right = [](double length) { return projected(length).off < 1e-9; };
  if (!is_right(2.0)) return "";
  if (projected(size).threw && size < 1.0 && is_right(1e150) && is_right(1e300)) {
    return "a short quaternion is taken for zero: only zero has no direction, so test for that "
           "alone";
  }
  if (!is_right(size) && is_right(1e-140) && is_right(1e140)) {
    return "the square of a component underflows or overflows: scale first";
  }
  return "";
}

Quat predicted(const Quat& q, const Vec3& omega, double dt, Real half = 0.5L,
               bool body_side = false) {
  const QuatL rate =
      body_side ? wide(q) * tests::pure(wide(omega)) : tests::pure(wide(omega)) * wide(q);
  return narrow(tests::sum(wide(q), half * wide(dt), rate));
}

Quat turned(const Quat& q, const Vec3& omega, double dt) {
  return common::exponential_map(dt * omega) * q;
}

}  // namespace

std::string tests::likely_of_constrained_step() { return likely_of_loop(step_constrained); }

TEST_CASE("The predicted attitude of two radians about z is Quat 1 0 0 1", "[2.7]") {
  const Vec3 omega(0.0, 0.0, 8.0);
  const Quat q = predicted_attitude(Quat::Identity(), omega, 0.25);
  tests::trial_of("2.7 predicted_attitude")
      .given("angular_velocity", omega)
      .given("dt", 0.25)
      .expect_small(
          "distance from Quat(1, 0, 0, 1)", distance(q, Quat(1.0, 0.0, 0.0, 1.0)),
          {4.0 * eps, "two products and a sum"},
          distance(q, Quat(1.0, 0.0, 0.0, 2.0)) < 1e-9
              ? "the factor 1/2 is missing: use half of dt omega q"
          : distance(q, Quat::Identity()) == 0.0                      ? half_is_zero
          : distance(q, turned(Quat::Identity(), omega, 0.25)) < 1e-9 ? tests::by_exponential
          : std::abs(q.norm() - 1.0) < 1e-9 ? "it is projected already: leave that to project"
                                            : "");
}

TEST_CASE("The predicted attitude goes along half of omega q and leaves the sphere", "[2.7]") {
  tests::Random random(271);
  for (int i = 1; i <= 100; ++i) {
    const Quat q = random.attitude();
    const Vec3 omega = random.vector(5.0);
    const double dt = random.uniform(0.05, 0.3);
    const Quat got = predicted_attitude(q, omega, dt);
    const Quat wanted = predicted(q, omega, dt);
    std::string likely;
    if (distance(got, predicted(q, omega, dt, 1)) < 1e-12)
      likely = "the factor 1/2 is missing: use half of dt omega q";
    if (distance(got, q) == 0.0) likely = half_is_zero;
    if (distance(got, wanted.normalized()) < 1e-12)
      likely = "it is projected already: leave that to project";
    if (distance(got, turned(q, omega, dt)) < 1e-12) likely = tests::by_exponential;
    if (distance(got, predicted(q, omega, dt, -0.5L)) < 1e-12) likely = backwards;
    if (distance(got, predicted(q, omega, dt, 0.5L, true)) < 1e-12) {
      likely = "omega stands on the right of q, which suits omega in body axes: put it on the left";
    }
    tests::trial_of("2.7 predicted_attitude", i, 100)
        .given("world_from_body", q)
        .given("angular_velocity", omega)
        .given("dt", dt)
        .expect_small("distance from q + dt omega q / 2", distance(got, wanted),
                      {32.0 * eps, "some 30 operations on numbers up to 2"}, likely);
  }
}

TEST_CASE("The projection is the unit quaternion in the same direction", "[2.7]") {
  tests::Random random(272);
  for (int i = 1; i <= 100; ++i) {
    const Quat q = random.attitude();
    const double size = std::pow(10.0, random.uniform(-3.0, 3.0));
    const Quat q_pred(size * q.coeffs());
    const QuatL exact = wide(q_pred).normalized();
    const Trial trial = tests::trial_of("2.7 project", i, 100).given("q_pred", q_pred);
    const Quat got = trial.returned([&] { return project(q_pred); });
    const Quat square(q_pred.coeffs() / q_pred.squaredNorm());
    std::string likely;
    if (distance(got, square) <= 1e-9 * square.norm())
      likely = "it is divided by |q|^2: divide by |q|";
    if (distance(got, q_pred) <= 1e-9 * size)
      likely = "nothing is projected: divide q by its length";
    if (distance(Quat(-got.coeffs()), narrow(exact)) <= 1e-9) likely = sign_changed;
    trial.expect_small("distance from the nearest unit quaternion", distance(got, narrow(exact)),
                       {8.0 * eps, "a sum of four squares, a root and a division"}, likely);
  }
}

TEST_CASE("No unit quaternion is nearer than the projection", "[2.7]") {
  tests::Random random(273);
  for (int i = 1; i <= 10; ++i) {
    const Quat q_pred(random.uniform(0.2, 2.0) * random.attitude().coeffs());
    const Quat got = project(q_pred);
    const Trial trial = tests::trial_of("2.7 project", i, 10).given("q_pred", q_pred);
    trial.expect_small(
        "||q| - 1|", std::abs(got.norm() - 1.0), {8.0 * eps, "a unit quaternion"},
        distance(got, q_pred) == 0.0 ? "nothing is projected: divide q by its length" : "");
    double nearest = distance(got, q_pred);
    for (int k = 0; k < 500; ++k) {
      const Vec3 off = std::pow(10.0, random.uniform(-3.0, 0.5)) * random.direction();
      nearest = std::min(nearest, distance(common::exponential_map(off) * got, q_pred));
    }
    trial.expect_small("distance minus that of a nearer one", distance(got, q_pred) - nearest,
                       {16.0 * eps, "500 others, near and far"});
  }
}

TEST_CASE("The projection holds for lengths from 1e-300 to 1e300", "[2.7]") {
  int index = 0;
  for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const Quat q_pred(0.6 * size, 0.0, -0.8 * size, 0.0);
    const Trial trial =
        tests::trial_of("2.7 project", ++index, 5).given("q_pred", q_pred).suspecting([size] {
          return why_projected_wrong(size);
        });
    const Quat got = trial.returned([&] { return project(q_pred); });
    trial.expect_small("distance from Quat(0.6, 0, -0.8, 0)",
                       distance(got, Quat(0.6, 0.0, -0.8, 0.0)),
                       {8.0 * eps, "if scaled first, nothing underflows or overflows"});
  }
}

TEST_CASE("Zero has no nearest unit quaternion and NaN has none either", "[2.7]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  int index = 0;
  for (const Quat& bad :
       {Quat(0.0, 0.0, 0.0, 0.0), Quat(1.0, nan, 0.0, 0.0), Quat(infinity, 0.0, 0.0, 0.0)}) {
    tests::trial_of("2.7 project", ++index, 3)
        .given("q_pred", bad)
        .expect_throw([&] { return project(bad); }, "no unit quaternion is nearest",
                      tests::length(bad) == 0.0
                          ? "zero is not refused: throw std::invalid_argument for it"
                          : "what is not finite is not refused: throw std::invalid_argument for "
                            "it");
  }
}

TEST_CASE("The prediction and the constrained step turn by the spin even if it is very slow",
          "[2.7]") {
  tests::Random random(275);
  for (int i = 1; i <= 40; ++i) {
    const RigidBody body{1.0, tests::random_moments(random)};
    const RigidBodyState state = tests::slow_state(random);
    const Vec3& omega = state.angular_velocity;
    const double dt = tests::dt_of_turn(random, omega.norm());
    const Quat& q = state.world_from_body;
    const Quat got = predicted_attitude(q, omega, dt);
    tests::trial_of("2.7 predicted_attitude", i, 40)
        .given("world_from_body", q)
        .given("angular_velocity", omega)
        .given("dt", dt)
        .expect_small("distance from q + dt omega q / 2", distance(got, predicted(q, omega, dt)),
                      {32.0 * eps, "some 30 operations on numbers up to 2"},
                      distance(got, q) > 0.0 ? ""
                      : distance(predicted_attitude(q, omega, 1.0 / omega.norm()), q) == 0.0
                          ? half_is_zero
                          : "nothing changes, because a guard against small numbers is too wide: "
                            "test only for exactly zero");
    tests::expect_loop(tests::loop_trial("2.7 step_constrained", body, state, {}, dt, i, 40), body,
                       state, {}, dt, step_constrained(body, state, {}, dt));
  }
}

TEST_CASE("The constrained step gives the same result as the loop of 2.2", "[2.7]") {
  tests::Random random(274);
  for (int i = 1; i <= 100; ++i) {
    const RigidBody body{random.uniform(0.5, 3.0), tests::random_moments(random)};
    const RigidBodyState state = tests::random_state(random);
    const std::vector<AppliedForce> forces{
        {random.vector(3.0), state.position + random.vector(1.0)}};
    const double dt = random.uniform(0.02, 0.2);
    tests::expect_loop(tests::loop_trial("2.7 step_constrained", body, state, forces, dt, i, 100),
                       body, state, forces, dt, step_constrained(body, state, forces, dt));
  }
}

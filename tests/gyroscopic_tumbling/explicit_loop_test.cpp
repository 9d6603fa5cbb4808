#include "catch.hpp"
#include "loop.hpp"
#include "motions.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::Trial;

namespace {

constexpr const char* explicit_function = "2.2 step_explicit";

/// The loop as a step of a body free of forces.
tests::SpinStep free_step(const Vec3& moments) {
  return [moments](const Spin& spin, double dt) {
    RigidBodyState state;
    state.world_from_body = spin.world_from_body;
    state.angular_velocity = spin.world_from_body * spin.angular_velocity_body;
    const RigidBodyState next = step_explicit({1.0, moments}, state, {}, dt);
    return Spin{next.world_from_body, next.world_from_body.conjugate() * next.angular_velocity};
  };
}

/// Steps until an explicit wobble has grown tenfold: √(1 + y²) a step.
double steps_to_tenfold(double y) { return std::log(10.0) / (0.5 * std::log1p(y * y)); }

}  // namespace

std::string tests::likely_of_explicit_step() { return likely_of_loop(step_explicit); }

TEST_CASE("A thrown body falls by its new velocity", "[2.2]") {
  RigidBodyState state;
  state.velocity = {1.0, 0.0, 2.0};
  const RigidBody body{2.0, Vec3(1.0, 2.0, 3.0)};
  const std::vector<AppliedForce> weight{{{0.0, 0.0, -20.0}, state.position}};
  const RigidBodyState got = step_explicit(body, state, weight, 0.5);
  const Trial trial = tests::loop_trial(explicit_function, body, state, weight, 0.5);
  trial.of("the velocity")
      .expect(got.velocity, Vec3(1.0, 0.0, -3.0), {16.0 * eps, "a product and a sum"},
              {{Vec3(1.0, 0.0, -8.0), "the force is not divided by the mass: divide it by m"}});
  trial.of("the position")
      .expect(
          got.position, Vec3(0.5, 0.0, -1.5), {16.0 * eps, "two products and sums"},
          {{Vec3(0.5, 0.0, 1.0), "the old velocity moves the body: update the velocity first"},
           {Vec3(0.5, 0.0, -0.25), "the mean of both velocities moves the body: use the new one"}});
}

TEST_CASE("A force off the centre of mass starts a spin about its torque", "[2.2]") {
  // r x f = (1, 0, 0) x (0, 6, 0) = (0, 0, 6) about the centre; I3 = 3, dt = 0.5.
  RigidBodyState state;
  state.position = {5.0, 0.0, 0.0};
  const RigidBody body{2.0, Vec3(1.0, 2.0, 3.0)};
  const std::vector<AppliedForce> push{{{0.0, 6.0, 0.0}, {6.0, 0.0, 0.0}}};
  const RigidBodyState got = step_explicit(body, state, push, 0.5);
  tests::loop_trial(explicit_function, body, state, push, 0.5)
      .of("the angular velocity")
      .expect(
          got.angular_velocity, Vec3(0.0, 0.0, 1.0), {16.0 * eps, "a few roundings"},
          {{Vec3(0.0, 0.0, 6.0), "the torque is about the world's origin: use p - x, not p"},
           {Vec3(0.0, 0.0, -1.0), tests::torque_flipped},
           {Vec3(0.0, 0.0, 3.0), "the torque is not divided by the inertia: multiply it by I^-1"}});
}

TEST_CASE("The loop updates velocities first and then moves the body by the new ones", "[2.2]") {
  tests::Random random(221);
  for (int i = 1; i <= 100; ++i) {
    const RigidBody body{random.uniform(0.5, 3.0), tests::random_moments(random)};
    const RigidBodyState state = tests::random_state(random);
    std::vector<AppliedForce> forces;
    for (int k = 0; k < 3; ++k) {
      forces.push_back({random.vector(3.0), state.position + random.vector(1.0)});
    }
    const double dt = random.uniform(-0.2, 0.2);
    tests::expect_loop(tests::loop_trial(explicit_function, body, state, forces, dt, i, 100), body,
                       state, forces, dt, step_explicit(body, state, forces, dt));
  }
}

TEST_CASE("Without forces only the gyroscopic term changes the spin in the loop", "[2.2]") {
  tests::Random random(222);
  for (int i = 1; i <= 50; ++i) {
    const RigidBody body{1.0, tests::random_moments(random)};
    const RigidBodyState state = tests::random_state(random);
    tests::expect_loop(tests::loop_trial(explicit_function, body, state, {}, 0.1, i, 50), body,
                       state, {}, 0.1, step_explicit(body, state, {}, 0.1));
  }
}

TEST_CASE("The loop turns by the spin even if spin and step are very small", "[2.2]") {
  tests::Random random(223);
  for (int i = 1; i <= 40; ++i) {
    const RigidBody body{1.0, tests::random_moments(random)};
    const RigidBodyState state = tests::slow_state(random);
    const double dt = tests::dt_of_turn(random, state.angular_velocity.norm());
    tests::expect_loop(tests::loop_trial(explicit_function, body, state, {}, dt, i, 40), body,
                       state, {}, dt, step_explicit(body, state, {}, dt));
  }
}

TEST_CASE("The loop keeps the attitude a unit quaternion", "[2.2]") {
  const tests::SpinStep step = free_step(tests::tumble_moments);
  Spin spin = tests::tumble_start;
  for (int i = 1; i <= 200; ++i) {
    const Spin before = spin;
    spin = step(spin, 0.01);
    tests::spin_trial(explicit_function, tests::tumble_moments, before, i, 200)
        .expect_small("||q| - 1|", std::abs(spin.world_from_body.norm() - 1.0),
                      {4.0 * eps, "normalised to a few ulp"},
                      spin.angular_velocity_body.norm() < 100.0
                          ? "the quaternion is not normalised: divide it by its length"
                          : "");
  }
}

TEST_CASE("A body of equal moments does not tumble in the loop", "[2.2]") {
  tests::expect_no_tumble_of_a_sphere(explicit_function, free_step(Vec3::Constant(2.0)));
}

TEST_CASE("An explicit step makes the wobble grow by the root of one plus y squared", "[2.2]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    const tests::Wobble wobble{.axis = axis};
    const double y = wobble.precession() * 0.1;
    const double got = tests::growth_factor(wobble, free_step(wobble.moments), 0.1, 100);
    tests::spin_trial(explicit_function, wobble.moments, wobble.start(1e-5), ++index, 2)
        .given("dt", 0.1)
        .of("the wobble's growth per step")
        .expect(
            got, std::sqrt(1.0 + y * y), {1e-9, "the wobble's own square, 1e-10, and rounding"},
            {{1.0 / std::sqrt(1.0 + y * y),
              "this is the factor of the implicit step: take the gyroscopic term at the old omega"},
             {1.0,
              "nothing wobbles: the gyroscopic term is missing, so add the torque -omega x I "
              "omega"}});
  }
}

TEST_CASE("An explicit wobble has grown tenfold after the steps of the formula", "[2.2]") {
  int index = 0;
  for (const int axis : {2, 0}) {
    const tests::Wobble wobble{.axis = axis};
    const double steps = steps_to_tenfold(wobble.precession() * 0.1);
    const auto after = [&](double share) {
      return tests::growth(wobble, free_step(wobble.moments), 0.1, static_cast<int>(share * steps));
    };
    const Trial trial =
        tests::spin_trial(explicit_function, wobble.moments, wobble.start(1e-5), ++index, 2)
            .given("steps to tenfold", steps);
    trial.expect_small("growth after 0.9 of these steps", after(0.9),
                       {10.0, "10^0.9 by the closed form: the wobble has not grown tenfold yet"});
    trial.expect_small("10 - growth after 1.1 of these steps", 10.0 - after(1.1),
                       {0.0, "10^1.1 by the closed form: the wobble has grown tenfold"});
  }
}

TEST_CASE("The loop converges with order one on a tumble", "[2.2]") {
  tests::expect_order(explicit_function, free_step(tests::tumble_moments), 1024, 1.0);
}

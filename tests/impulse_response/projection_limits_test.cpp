// Where option 2 fails, in closed form.
#include "catch.hpp"
#include "oracle.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::StepInput;
using tests::StepValue;
using tests::Trial;

namespace {

/// On a plane that falls by `slope` radians towards +x.
StepInput at_rest_on_incline(double slope, double restitution, double friction) {
  StepInput in;
  in.obstacle = common::Plane{Vec3::Zero(), Vec3(std::sin(slope), 0.0, std::cos(slope))};
  in.material = {restitution, friction};
  in.gravity = Vec3(0.0, 0.0, -9.81);
  in.dt = 0.01;
  return in;
}

/// Steps on, as long as all is finite.
StepValue after(StepInput in, int steps) {
  StepValue value{in.particle.position, in.particle.velocity, Vec3::Zero()};
  for (int i = 0; i < steps && tests::is_finite(value); ++i) {
    value = tests::projected_by_answer(in);
    in.particle.position = value.position;
    in.particle.velocity = value.velocity;
  }
  return value;
}

Trial incline_trial(const StepInput& in, double slope, int steps, int index = 1, int count = 1) {
  return tests::step_trial("step_by_projection", in, index, count)
      .given("slope", slope)
      .given("steps", steps);
}

constexpr double falls = 9.81 * 0.01;  // g dt, by which gravity changes the velocity in a step

/// Positions and velocities are sums of n equal terms. In a step each component is rounded some 20
/// times, in whatever order it is added up: products with dt and n, dot products, a root, a
/// division. Each time it errs by half an ulp of the largest term at most; and 8 eps are 16 halves
/// of an ulp or more, of g dt 25.
tests::Bound rounding(int steps, double largest_term) {
  return {8.0 * eps * steps * largest_term, "some 20 roundings per step"};
}

}  // namespace

TEST_CASE("Without tangential correction a particle at rest creeps down", "[6.4]") {
  // A step at rest adds dt g to the velocity and moves by dt² g. Impulses undo the one, the normal
  // correction the other but for its part along the slope: dt² g sin θ a step.
  const double slope = 0.4;
  for (const int steps : {1, 10, 200}) {
    StepInput in = at_rest_on_incline(slope, 0.0, 0.5);
    in.corrections.tangential = false;
    const Vec3 down(std::cos(slope), 0.0, -std::sin(slope));
    const Vec3 wanted = steps * in.dt * in.dt * 9.81 * std::sin(slope) * down;
    incline_trial(in, slope, steps)
        .expect(after(in, steps), StepValue{wanted, Vec3::Zero(), after(in, 1).impulse},
                rounding(steps, std::max(wanted.norm(), falls)));
  }
}

TEST_CASE("With both corrections a particle at rest rests", "[6.4]") {
  const double slope = 0.4;  // below the angle of friction, atan 0.5 = 0.46
  for (const int steps : {1, 10, 200}) {
    const StepInput in = at_rest_on_incline(slope, 0.0, 0.5);
    incline_trial(in, slope, steps)
        .expect(after(in, steps), StepValue{Vec3::Zero(), Vec3::Zero(), after(in, 1).impulse},
                rounding(steps, falls));
  }
}

TEST_CASE("A block slips if the slope is steeper than mu", "[6.4]") {
  constexpr int steps = 100;
  constexpr double mu = 0.5;
  int index = 0;
  for (const double share : {0.98, 1.02}) {
    // Past the angle of friction each step adds a dt, a = g (sin θ − μ cos θ), to the velocity; its
    // displacement is that of the new velocity: a dt² n (n + 1) / 2 in all.
    const double slope = std::atan(share * mu);
    const StepInput in = at_rest_on_incline(slope, 0.0, mu);
    const Vec3 down(std::cos(slope), 0.0, -std::sin(slope));
    const double a = std::max(0.0, 9.81 * (std::sin(slope) - mu * std::cos(slope)));
    const Vec3 velocity = steps * in.dt * a * down;
    const Vec3 position = 0.5 * steps * (steps + 1) * in.dt * in.dt * a * down;
    incline_trial(in, slope, steps, ++index, 2)
        .expect(after(in, steps), StepValue{position, velocity, after(in, 1).impulse},
                rounding(steps, 1.0));
  }
}

TEST_CASE("With restitution a particle at rest jitters at e g dt over 1 plus e", "[6.4]") {
  // Where v < g dt the next step ends inside: v ← e (g dt − v), whose fixed point is
  // e g dt / (1 + e); what is left of the start falls as e^n.
  for (const double e : {0.25, 0.5, 0.8}) {
    StepInput in = at_rest_on_incline(0.0, e, 0.0);
    const double jitter = e * 9.81 * in.dt / (1.0 + e);
    for (const int steps : {1, 2, 3, 400}) {
      const double speed = jitter * (1.0 - std::pow(-e, steps));
      const StepValue got = after(in, steps);
      incline_trial(in, 0.0, steps)
          .of("the speed upwards")
          .expect(got.velocity.z(), speed, rounding(10, 9.81 * in.dt));
    }
  }
}

TEST_CASE("A bounce slower than g dt does not leave within a step", "[6.4]") {
  int index = 0;
  for (const double share : {0.98, 1.02}) {
    StepInput in = at_rest_on_incline(0.0, 0.5, 0.0);
    in.particle.velocity.z() = share * 9.81 * in.dt;
    const double speed = share < 1.0 ? 0.5 * (1.0 - share) * 9.81 * in.dt : 0.02 * 9.81 * in.dt;
    const StepValue got = after(in, 1);
    const Trial trial = incline_trial(in, 0.0, 1, ++index, 2);
    trial.of("the speed upwards").expect(got.velocity.z(), speed, rounding(10, 9.81 * in.dt));
    trial.of("the height")
        .expect(got.position.z(), share < 1.0 ? 0.0 : 0.02 * 9.81 * in.dt * in.dt,
                rounding(10, 1e-3));
  }
}

TEST_CASE("An elastic ball loses a speed of g dt in two bounces", "[6.4]") {
  // In units of g dt a flight that starts at w is found inside after ⌊2w⌋ steps and starts again at
  // ⌊2w⌋ − w: it loses the fraction f of 2w, then 1 − f. So k pairs of bounces take k g dt of the
  // speed v: an energy of k g v dt, of order dt.
  constexpr double g = 8.0;
  constexpr int pairs = 5;
  int index = 0;
  for (const int steps_a_second : {32, 64, 128, 256}) {
    StepInput in = at_rest_on_incline(0.0, 1.0, 0.0);
    in.gravity = Vec3(0.0, 0.0, -g);
    in.dt = 1.0 / steps_a_second;
    in.particle.velocity.z() = 4.0 + 0.25 * g * in.dt;  // 2w ends in one half
    const double speed = in.particle.velocity.z();
    StepInput now = in;
    StepValue value{Vec3::Zero(), in.particle.velocity, Vec3::Zero()};
    int bounces = 0;
    for (int i = 0; i < 20 * steps_a_second && bounces < 2 * pairs; ++i) {
      value = tests::projected_by_answer(now);
      now.particle.position = value.position;
      now.particle.velocity = value.velocity;
      if (value.impulse.z() != 0.0) ++bounces;
    }
    const double after_pairs = speed - pairs * g * in.dt;
    incline_trial(in, 0.0, 20 * steps_a_second, ++index, 4)
        .of("the energy lost in ten bounces over dt")
        .expect(0.5 * (speed * speed - value.velocity.squaredNorm()) / in.dt,
                0.5 * (speed * speed - after_pairs * after_pairs) / in.dt,
                {1e-12 * speed * speed / in.dt, "powers of two, so almost exact"});
  }
}

// A particle slides down a cylinder without friction and leaves it where cos θ = 2/3 + v²/(3 g R),
// v being its speed at the top: there what gravity presses is what the curve needs.
#include "catch.hpp"
#include "oracle.hpp"

using namespace lab::impulse_response;
using tests::Trial;

namespace {

constexpr double weight = 9.81;
constexpr double top_speed = 1.0;
const double exact_cos = 2.0 / 3.0 + top_speed * top_speed / (3.0 * weight);
const double exact_angle = std::acos(exact_cos);

struct Departure {
  double last_push = 0.0;  ///< angle at which the impulse falls to zero
  double free = 0.0;       ///< angle at which a step ends outside
};

Departure slide(double dt) {
  Particle particle{1.0, Vec3::UnitZ(), Vec3(0.0, top_speed, 0.0)};
  const Vec3 gravity(0.0, 0.0, -weight);
  double angle = 0.0;
  double push = 0.0;
  Departure departure;
  for (double time = 0.0; time < 1.0; time += dt) {
    const ProjectedStep step = step_by_projection(particle, common::Cylinder{1.0}, {}, gravity, dt);
    particle = step.particle;
    const double angle_next = std::atan2(particle.position.y(), particle.position.z());
    const double push_next = step.impulse.norm();
    if (push_next != 0.0) {  // the impulse's line through the last two meets zero here
      departure.last_push = angle_next + (angle_next - angle) * push_next / (push - push_next);
    }
    angle = angle_next;
    push = push_next;
    departure.free = angle;
    const double distance = std::hypot(particle.position.y(), particle.position.z());
    if (push == 0.0 && distance - 1.0 > 4.0 * tests::eps) break;
  }
  return departure;
}

Trial slide_trial(double dt, int index, int count) {
  return tests::trial_of("6.4 step_by_projection", index, count)
      .given("dt", dt)
      .given("cylinder.radius", 1.0)
      .given("speed at the top", top_speed);
}

}  // namespace

TEST_CASE("A slide without friction ends at two thirds with an error of order dt", "[6.4]") {
  double coarse = 0.0;
  int index = 0;
  for (const double dt : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const double error = std::abs(slide(dt).last_push - exact_angle);
    const Trial trial = slide_trial(dt, ++index, 4).of("the angle where the impulse ends");
    trial.expect_small("error", error, {1.0 * dt, "order one; measured 0.90 dt"});
    if (index > 1) {
      trial.of("the order over a decade of dt")
          .expect(std::log10(coarse / error), 1.0, {0.02, "order one, up to a term of order dt"});
    }
    coarse = error;
  }
}

TEST_CASE("The particle leaves the surface late by an angle of the order of the root of dt",
          "[6.4]") {
  // Past the point where the impulse ends the outward speed grows from zero: s = v²/R − g cos θ
  // rises at 3 g ω sin θ, so that after τ it is 3/2 g ω sin θ τ². A step ends outside once that is
  // more than what symplectic Euler cuts off a curve, dt (g cos θ − v²/2R) = dt g cos θ / 2:
  // ω τ = √(ω dt / (3 tan θ)).
  const double omega = std::sqrt(weight * exact_cos);
  int index = 0;
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    const double late = std::sqrt(omega * dt / (3.0 * std::tan(exact_angle)));
    slide_trial(dt, ++index, 3)
        .of("how late it leaves the surface [rad]")
        .expect(slide(dt).free - exact_angle, late,
                {4.0 * omega * dt, "the next term is of order dt, and a step is omega dt"});
  }
}

#pragma once

#include "momentum_suspects.hpp"

/// The loop of steps 2.2 and 2.7 in extended precision, with what can go wrong in it as switches.
namespace tests {

inline const char* const by_exponential =
    "the exponential map turns q, not Euler's step: use q + dt omega q / 2";

struct LoopVariation {
  VecL (*acceleration)(const MatL&, const VecL&, const VecL&) = right_acceleration;
  bool body_inertia = false;       ///< I0 for I
  bool backwards = false;          ///< Rᵀ I0 R for R I0 Rᵀ
  bool inverse_backwards = false;  ///< Rᵀ I0⁻¹ R for I⁻¹, but the right I
  bool world_torque = false;       ///< Euler's equations in body axes, but T in the world frame
  bool body_result = false;        ///< the same, and dω/dt is not turned into the world
  bool term_without_dt = false;    ///< dt multiplies T alone
  bool about_origin = false;       ///< torques about the world's origin
  bool last_force = false;         ///< only the last torque counts
  bool massless = false;           ///< the force is taken for an acceleration
  bool old_velocities = false;     ///< move x and q
  bool mean_velocity = false;      ///< of old and new, moves x
  bool body_side = false;          ///< q ω for ω q
  bool exponential = false;        ///< q turned by exp(ω dt)
  Real half = 0.5L;                ///< in dq/dt
  bool projected = true;           ///< q normalised
};

struct LoopL {
  VecL position, velocity, omega;
  QuatL q;
};

/// The change of ω in a step.
inline VecL change_of_omega(const VecL& moments, const QuatL& q, const VecL& omega,
                            const VecL& torque, Real dt, const LoopVariation& variation) {
  const MatL turned = q.normalized().toRotationMatrix();
  const MatL I0 = moments.asDiagonal();
  if (variation.world_torque || variation.body_result) {
    const VecL T = variation.world_torque ? torque : VecL(turned.transpose() * torque);
    const VecL change = dt * right_acceleration(I0, turned.transpose() * omega, T);
    return variation.body_result ? change : VecL(turned * change);
  }
  MatL R = turned;
  if (variation.backwards) R.transposeInPlace();
  if (variation.body_inertia) R.setIdentity();
  const MatL I = R * I0 * R.transpose();
  if (variation.inverse_backwards) {
    return dt * (R.transpose() * I0.inverse() * R * (torque - gyroscopic(I, omega)));
  }
  if (variation.term_without_dt) return I.inverse() * (dt * torque - gyroscopic(I, omega));
  return dt * variation.acceleration(I, omega, torque);
}

inline LoopL loop(const lab::gyroscopic_tumbling::RigidBody& body,
                  const lab::gyroscopic_tumbling::RigidBodyState& state,
                  const std::vector<lab::gyroscopic_tumbling::AppliedForce>& forces, double step,
                  const LoopVariation& variation = {}) {
  const Real dt = wide(step);
  const VecL x = wide(state.position);
  const VecL omega = wide(state.angular_velocity);
  const QuatL q = wide(state.world_from_body);
  VecL force = VecL::Zero();
  VecL torque = VecL::Zero();
  for (const auto& applied : forces) {
    const VecL arm = wide(applied.point) - (variation.about_origin ? VecL(VecL::Zero()) : x);
    force += wide(applied.force);
    if (variation.last_force) torque.setZero();
    torque += arm.cross(wide(applied.force));
  }

  LoopL next;
  const Real mass = variation.massless ? 1 : static_cast<Real>(body.mass);
  next.velocity = wide(state.velocity) + dt / mass * force;
  next.omega = omega + change_of_omega(wide(body.moments), q, omega, torque, dt, variation);
  VecL v = variation.old_velocities ? wide(state.velocity) : next.velocity;
  if (variation.mean_velocity) v = (wide(state.velocity) + next.velocity) / 2;
  const VecL w = variation.old_velocities ? omega : next.omega;
  next.position = x + dt * v;
  const QuatL rate = variation.body_side ? q * pure(w) : pure(w) * q;
  next.q = sum(q, variation.half * dt, rate);
  if (variation.exponential) next.q = turn(dt * w) * q;
  if (variation.projected) next.q.normalize();
  return next;
}

struct LoopStory {
  LoopVariation variation;
  std::string text;
};

inline const std::vector<LoopStory>& loop_stories() {
  static const std::vector<LoopStory> all = [] {
    std::vector<LoopStory> stories{
        {{.body_inertia = true}, "the body's inertia is used as the world's: turn it, R I0 R^T"},
        {{.backwards = true}, "this inertia is R^T I0 R: use R I0 R^T"},
        {{.inverse_backwards = true},
         "this inverse is R^T I0^-1 R: the inverse of R I0 R^T is R I0^-1 R^T"},
        {{.world_torque = true},
         "omega is in body axes, but the torque is in the world frame: turn it into the body with "
         "R^T"},
        {{.body_result = true},
         "the change of omega is in body axes: turn it into the world with R"},
        {{.term_without_dt = true},
         "dt multiplies the torque alone: multiply the gyroscopic term by it, too"},
        {{.about_origin = true}, "the torque is about the world's origin: use p - x, not p"},
        {{.last_force = true}, "only the torque of the last force counts: add up all torques"},
        {{.massless = true}, "the force is not divided by the mass: divide it by m"},
        {{.old_velocities = true}, "the old velocities move x and q: update the velocities first"},
        {{.mean_velocity = true}, "the mean of both velocities moves the body: use the new one"},
        {{.body_side = true},
         "omega stands on the right of q, which suits omega in body axes: put it on the left"},
        {{.exponential = true}, by_exponential},
        {{.half = 1}, "the factor 1/2 is missing, so q turns twice as far: multiply by 0.5"},
        {{.half = 0}, "q does not change, because 1/2 is 0 in whole numbers: write 0.5"},
        {{.projected = false}, "the quaternion is not normalised: divide it by its length"}};
    for (const AccelerationMistake& mistake : acceleration_mistakes()) {
      stories.push_back({{.acceleration = mistake.value}, mistake.story});
    }
    return stories;
  }();
  return all;
}

inline Trial loop_trial(const std::string& function,
                        const lab::gyroscopic_tumbling::RigidBody& body,
                        const lab::gyroscopic_tumbling::RigidBodyState& state,
                        const std::vector<lab::gyroscopic_tumbling::AppliedForce>& forces,
                        double dt, int index = 1, int count = 1) {
  Trial trial = trial_of(function, index, count);
  trial.given("body.mass", body.mass)
      .given("body.moments", body.moments)
      .given("state.position", state.position)
      .given("state.world_from_body", state.world_from_body)
      .given("state.velocity", state.velocity)
      .given("state.angular_velocity", state.angular_velocity);
  for (const auto& applied : forces) {
    trial.given("force", applied.force).given("point", applied.point);
  }
  return trial.given("dt", dt);
}

/// Requires that `got` is the loop's result to rounding, part by part.
inline void expect_loop(const Trial& trial, const lab::gyroscopic_tumbling::RigidBody& body,
                        const lab::gyroscopic_tumbling::RigidBodyState& state,
                        const std::vector<lab::gyroscopic_tumbling::AppliedForce>& forces,
                        double dt, const lab::gyroscopic_tumbling::RigidBodyState& got) {
  std::vector<Suspect<common::Vec3>> velocities;
  std::vector<Suspect<common::Vec3>> positions;
  std::vector<Suspect<common::Vec3>> spins;
  std::vector<Suspect<common::Quat>> attitudes;
  for (const LoopStory& story : loop_stories()) {
    const LoopL wrong = loop(body, state, forces, dt, story.variation);
    velocities.push_back({narrow(wrong.velocity), story.text});
    positions.push_back({narrow(wrong.position), story.text});
    spins.push_back({narrow(wrong.omega), story.text});
    attitudes.push_back({narrow(wrong.q), story.text});
  }
  const LoopL wanted = loop(body, state, forces, dt);
  const double size = 10.0;  // of positions, velocities and rates in these trials
  trial.of("the velocity")
      .expect(got.velocity, narrow(wanted.velocity), {16.0 * eps * size, "a few sums"}, velocities);
  trial.of("the angular velocity")
      .expect(got.angular_velocity, narrow(wanted.omega),
              {2048.0 * eps * size,
               "some 100 operations, through inertias of condition up to 20 and back"},
              spins);
  trial.of("the position")
      .expect(got.position, narrow(wanted.position), {16.0 * eps * size, "a few sums"}, positions);
  trial.of("the attitude")
      .expect(got.world_from_body, narrow(wanted.q),
              {2048.0 * eps * size, "the same as for the angular velocity that turns it"},
              attitudes);
}

inline lab::gyroscopic_tumbling::RigidBodyState random_state(Random& random) {
  lab::gyroscopic_tumbling::RigidBodyState state;
  state.position = random.vector(3.0);
  state.world_from_body = random.attitude();
  state.velocity = random.vector(2.0);
  state.angular_velocity = random.vector(4.0);
  return state;
}

/// A state as one value: its parts are judged together.
struct StateValue {
  lab::gyroscopic_tumbling::RigidBodyState state;
};
inline bool is_finite(const StateValue& value) {
  const auto& s = value.state;
  return is_finite(s.position) && is_finite(s.velocity) && is_finite(s.angular_velocity) &&
         is_finite(s.world_from_body);
}
inline double length(const StateValue&) { return 1.0; }  // of states of ordinary size
inline double difference(const StateValue& a, const StateValue& b) {
  return std::max({difference(a.state.position, b.state.position),
                   difference(a.state.velocity, b.state.velocity),
                   difference(a.state.angular_velocity, b.state.angular_velocity),
                   difference(a.state.world_from_body, b.state.world_from_body)});
}

/// Names the mistake in the loop that `step` is. Each input has two forces.
template <typename Step>
std::string likely_of_loop(const Step& step) {
  using namespace lab::gyroscopic_tumbling;
  struct Input {
    RigidBody body;
    RigidBodyState state;
    std::vector<AppliedForce> forces;
    double dt;
  };
  Random random(229);
  std::vector<Input> inputs;
  for (int i = 0; i < 10; ++i) {
    Input in{{random.uniform(1.5, 3.0), random_moments(random)}, random_state(random), {}, 0.1};
    for (int k = 0; k < 2; ++k) in.forces.push_back({random.vector(3.0), random.vector(3.0)});
    inputs.push_back(in);
  }
  return likely_over<StateValue>(
      inputs,
      [&](const Input& in) { return StateValue{step(in.body, in.state, in.forces, in.dt)}; },
      [](const Input& in) {
        std::vector<Suspect<StateValue>> suspects;
        for (const LoopStory& story : loop_stories()) {
          const LoopL wrong = loop(in.body, in.state, in.forces, in.dt, story.variation);
          const RigidBodyState state{narrow(wrong.position), narrow(wrong.q),
                                     narrow(wrong.velocity), narrow(wrong.omega)};
          suspects.push_back({{state}, story.text});
        }
        return suspects;
      });
}

/// At rest but for a spin of at most a radian a second, mostly far less.
inline lab::gyroscopic_tumbling::RigidBodyState slow_state(Random& random) {
  lab::gyroscopic_tumbling::RigidBodyState state;
  state.world_from_body = random.attitude();
  state.angular_velocity = std::pow(10.0, random.uniform(-9.0, 0.0)) * random.direction();
  return state;
}

/// A step of either sign in which a body at that speed turns by up to a radian.
inline double dt_of_turn(Random& random, double speed) {
  const double sign = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  return sign * std::pow(10.0, random.uniform(-6.0, 0.0)) / speed;
}

}  // namespace tests

#pragma once

#include "oracle.hpp"

/// The loop of steps 2.2 and 2.7 in extended precision, with what can go wrong in it as switches.
namespace tests {

struct LoopVariation {
  Real gyroscopic = 1;          ///< times the gyroscopic term
  bool body_inertia = false;    ///< I0 for I
  bool backwards = false;       ///< Rᵀ I0 R for R I0 Rᵀ
  bool about_origin = false;    ///< torques about the world's origin
  bool old_velocities = false;  ///< move x and q
  bool body_side = false;       ///< q ω for ω q
  Real half = 0.5L;             ///< in dq/dt
  bool projected = true;        ///< q normalised
};

struct LoopL {
  VecL position, velocity, omega;
  QuatL q;
};

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
    torque += arm.cross(wide(applied.force));
  }
  MatL R = q.normalized().toRotationMatrix();
  if (variation.backwards) R.transposeInPlace();
  if (variation.body_inertia) R.setIdentity();
  const MatL inertia = R * wide(body.moments).asDiagonal() * R.transpose();
  const VecL gyroscopic = variation.gyroscopic * omega.cross(VecL(inertia * omega));

  LoopL next;
  next.velocity = wide(state.velocity) + dt / static_cast<Real>(body.mass) * force;
  next.omega = omega + dt * (inertia.inverse() * (torque - gyroscopic));
  const VecL v = variation.old_velocities ? wide(state.velocity) : next.velocity;
  const VecL w = variation.old_velocities ? omega : next.omega;
  next.position = x + dt * v;
  const QuatL rate = variation.body_side ? q * pure(w) : pure(w) * q;
  next.q = sum(q, variation.half * dt, rate);
  if (variation.projected) next.q.normalize();
  return next;
}

inline Trial loop_trial(const std::string& function,
                        const lab::gyroscopic_tumbling::RigidBody& body,
                        const lab::gyroscopic_tumbling::RigidBodyState& state,
                        const std::vector<lab::gyroscopic_tumbling::AppliedForce>& forces,
                        double dt, int index = 1, int count = 1) {
  Trial trial(function, index, count);
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
  struct Story {
    LoopVariation variation;
    std::string text;
  };
  const std::vector<Story> stories{
      {{.gyroscopic = -1}, flipped},
      {{.gyroscopic = 0}, forgotten},
      {{.body_inertia = true}, "the body's inertia is used as the world's: turn it, R I0 R^T"},
      {{.backwards = true}, "this inertia is R^T I0 R: use R I0 R^T"},
      {{.about_origin = true}, "the torque is about the world's origin: use p - x, not p"},
      {{.old_velocities = true}, "the old velocities move x and q: update the velocities first"},
      {{.body_side = true},
       "omega stands on the right of q, which suits omega in body axes: put it on the left"},
      {{.half = 1}, "the factor 1/2 is missing, so q turns twice as far: multiply by 0.5"},
      {{.half = 0}, "q does not change, because 1/2 is 0 in whole numbers: write 0.5"},
      {{.projected = false}, "the quaternion is not normalised: divide it by its length"}};
  std::vector<Suspect<common::Vec3>> velocities;
  std::vector<Suspect<common::Vec3>> positions;
  std::vector<Suspect<common::Vec3>> spins;
  std::vector<Suspect<common::Quat>> attitudes;
  for (const Story& story : stories) {
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

inline lab::gyroscopic_tumbling::RigidBodyState random_state(Random& random) {
  lab::gyroscopic_tumbling::RigidBodyState state;
  state.position = random.vector(3.0);
  state.world_from_body = random.attitude();
  state.velocity = random.vector(2.0);
  state.angular_velocity = random.vector(4.0);
  return state;
}

}  // namespace tests

#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "common/rotation/free_rotation.hpp"
#include "common/rotation/free_rotation_stepper.hpp"
#include "gyroscopic_tumbling.hpp"
#include "peers.hpp"

/// The motions that the chart judges, and the ways in which the methods of the lab step them.
namespace lab::gyroscopic_tumbling {

inline constexpr double turn = 2.0 * std::numbers::pi;
inline constexpr HeavyTop heavy_top{1.25, 0.5, 9.81};

/// A motion with its exact answer.
struct Problem {
  Vec3 moments;
  Spin start;
  double revolution;  ///< time of one revolution [s]
  std::function<Spin(double time)> exact;
};

inline const Quat some_attitude = Quat(0.5, 0.1, -0.7, 0.3).normalized();

inline Problem free_problem(const Vec3& direction) {
  const Vec3 moments(1.0, 2.0, 3.0);
  const Spin start{some_attitude, turn * direction.normalized()};
  const common::FreeRotation exact(moments, start);
  return {moments, start, 1.0, [exact](double time) { return exact.at(time); }};
}

/// Returns a top that leans by 30 degrees, its axis let go at rest. A revolution is one of its own
/// spin.
inline Problem top_problem() {
  const double speed = 30.0;
  const Spin start{Quat(Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3::UnitY())),
                   Vec3(0.0, 0.0, speed)};
  const common::LagrangeTop exact(heavy_top, start);
  const Vec3 moments(heavy_top.transverse_moment, heavy_top.transverse_moment,
                     heavy_top.axial_moment);
  return {moments, start, turn / speed, [exact](double time) { return exact.at(time); }};
}

/// A step function with the motion so far.
template <typename Step>
struct Stepping {
  Spin now;
  Step step;

  void advance() { now = step(now); }
  [[nodiscard]] const Spin& spin() const { return now; }
};
template <typename Step>
Stepping(Spin, Step) -> Stepping<Step>;

/// The loop of step 2.2 with its own state, under the weight and the force at the fixed point.
struct Loop {
  RigidBody body;
  RigidBodyState state;
  double dt;
  double weight_moment;

  Loop(const Problem& problem, double step, double weight)
      : body{1.0, problem.moments}, dt(step), weight_moment(weight) {
    state.world_from_body = problem.start.world_from_body;
    state.angular_velocity = state.world_from_body * problem.start.angular_velocity_body;
  }
  void advance() {
    std::vector<AppliedForce> forces;
    if (weight_moment > 0.0) {
      const Vec3 weight(0.0, 0.0, -weight_moment);
      forces = {{weight, state.world_from_body * Vec3::UnitZ()}, {-weight, state.position}};
    }
    state = step_explicit(body, state, forces, dt);
  }
  [[nodiscard]] Spin spin() const {
    return {state.world_from_body, state.world_from_body.conjugate() * state.angular_velocity};
  }
};

/// A body in another engine's world, under the torque of the weight.
struct PeerMotion {
  std::shared_ptr<PeerBody> body = nullptr;
  double weight_moment = 0.0;

  void advance() const {
    const Vec3 axis = body->world_from_body() * Vec3::UnitZ();
    body->step(weight_moment * Vec3::UnitZ().cross(axis));
  }
  [[nodiscard]] Spin spin() const { return body->spin(); }
};

/// Returns the motion by a step (moments, spin, dt) -> spin of the contract.
template <typename Step>
auto by(Step step) {
  return [step](const Problem& problem, double dt) {
    return Stepping{problem.start, [step, moments = problem.moments, dt](const Spin& spin) {
                      return step(moments, spin, dt);
                    }};
  };
}

inline auto by_loop(double weight_moment) {
  return [weight_moment](const Problem& problem, double dt) {
    return Loop(problem, dt, weight_moment);
  };
}

inline auto by_moser_veselov(
    const std::function<MomentCorrection(const Problem&, double dt)>& made) {
  return [made](const Problem& problem, double dt) {
    const MomentCorrection correction = made(problem, dt);
    return Stepping{problem.start, [=, moments = problem.moments](const Spin& spin) {
                      return step_moser_veselov(moments, correction, spin, dt);
                    }};
  };
}

inline auto exactly() {
  return [](const Problem& problem, double dt) {
    return common::FreeRotationStepper({problem.moments, problem.start}, dt);
  };
}

/// Returns the effect of the weight on the angular velocity in half a step, as a matrix that is
/// applied to the world's up in body axes. It is not computed but observed in the step of 2.6: from
/// rest, in a time too short for any drift, and under a weight that is larger by as much.
inline Mat3 seen_half_kick(double dt) {
  constexpr double moment = 0x1p-80;  // [s]
  HeavyTop heavier = heavy_top;
  heavier.weight_moment *= 0.5 * dt / moment;
  const double half = std::sqrt(0.5);
  // These are the attitudes with the world's up along the body's x, y and z.
  const Quat tilts[] = {{half, 0.0, -half, 0.0}, {half, half, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
  Mat3 kick;
  for (int i = 0; i < 3; ++i) {
    const Spin rest{tilts[i], Vec3::Zero()};
    kick.col(i) = step_kick_drift_kick(heavier, rest, moment).angular_velocity_body;
  }
  return kick;
}

/// Takes a free step between two half kicks.
template <typename Step>
auto between_kicks(Step free_step) {
  return [free_step](const Problem& problem, double dt) {
    const auto kicked = [kick = seen_half_kick(dt)](const Spin& spin) {
      const Vec3 up_body = spin.world_from_body.conjugate() * Vec3::UnitZ();
      return Spin{spin.world_from_body, spin.angular_velocity_body + kick * up_body};
    };
    return Stepping{problem.start,
                    [kicked, free_step, moments = problem.moments, dt](const Spin& spin) {
                      return kicked(free_step(moments, kicked(spin), dt));
                    }};
  };
}

/// Takes three steps, the middle one backwards, whose errors of order three cancel (Suzuki 1990,
/// Yoshida 1990).
inline auto by_triple_jump() {
  return [](const Problem& problem, double dt) {
    return Stepping{problem.start, [dt](const Spin& spin) {
                      const double outer = 1.0 / (2.0 - std::cbrt(2.0));
                      Spin now = step_kick_drift_kick(heavy_top, spin, outer * dt);
                      now = step_kick_drift_kick(heavy_top, now, (1.0 - 2.0 * outer) * dt);
                      return step_kick_drift_kick(heavy_top, now, outer * dt);
                    }};
  };
}

inline MomentCorrection no_correction(const Problem& /*problem*/, double /*dt*/) { return {}; }
inline MomentCorrection own_correction(const Problem& problem, double dt) {
  return fourth_order_correction(problem.moments, problem.start, dt);
}
inline MomentCorrection tenth_order_correction(const Problem& problem, double dt) {
  return common::moser_veselov_correction(problem.moments, problem.start, dt, 10);
}

}  // namespace lab::gyroscopic_tumbling

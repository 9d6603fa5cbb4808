#pragma once

#include <vector>

#include "common/rotation/heavy_top.hpp"
#include "common/rotation/moser_veselov_correction.hpp"
#include "common/rotation/spin.hpp"

/// The contract of lab 2. Vectors are in the world frame unless a name ends in `_body`. q and −q
/// are the same attitude. Body axes are principal axes: `moments` are I1, I2, I3 about the centre
/// of mass [kg m²], each above zero and none above the sum of the other two. m = Rᵀ L is the
/// angular momentum in body axes. A step takes a dt [s] of either sign with |ω dt| < 1e6, and
/// returns a unit q. In these units masses and moments are 1e-60 to 1e60; ω and dt are zero or
/// 1e-60 to 1e60 in size.
namespace lab::gyroscopic_tumbling {

using common::HeavyTop;
using common::Mat3;
using common::MomentCorrection;
using common::Quat;
using common::Spin;
using common::Vec3;

struct RigidBody {
  double mass = 1.0;            ///< [kg]
  Vec3 moments = Vec3::Ones();  ///< [kg m²]
};

/// Where a rigid body is and how it moves, in the world frame.
struct RigidBodyState {
  Vec3 position = Vec3::Zero();             ///< x, centre of mass [m]
  Quat world_from_body = Quat::Identity();  ///< q, unit
  Vec3 velocity = Vec3::Zero();             ///< v, of the centre of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();     ///< ω [rad/s]
};

/// A force and the point at which it acts, in the world frame.
struct AppliedForce {
  Vec3 force = Vec3::Zero();  ///< f [N]
  Vec3 point = Vec3::Zero();  ///< p [m]
};

/// Returns the moments if a body can have them: finite, above zero, I_i ≤ I_j + I_k (= if it is
/// flat). An excess of up to 4e-16 of the greatest moment is rounding and passes.      eq. (1)
/// Throws std::invalid_argument if the excess is 1e-14 of the greatest or more, or if a moment is
/// not finite or not above zero. If the excess is in between, it may do either.
Vec3 checked_moments(const Vec3& moments);

/// Returns dω/dt = I⁻¹ (T − ω × I ω) [rad/s²]. All are in the same axes, world or body.  eq. (2)
///
/// inertia  I, symmetric, positive definite; need not be diagonal
/// torque   T, about the centre of mass [N m]
Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque);

/// Returns the kinetic energy of the rotation, ½ ω · I ω [J].                          eq. (3)
double rotational_energy(const Vec3& moments, const Spin& spin);

/// Returns L = R (I0 ω_body), world frame [kg m²/s].                                   eq. (4)
Vec3 angular_momentum(const Vec3& moments, const Spin& spin);

/// Takes one turn of the loop, with the gyroscopic term at the old velocity. It sums forces and
/// torques and updates both velocities. These then move x, and q as in step 1.5.       eq. (5)–(8)
RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt);

/// Returns F(ω′) = I0 (ω′ − ω) + dt ω′ × I0 ω′, body axes [kg m²/s]. It is zero if ω′ solves the
/// implicit step.                                                                      eq. (9)
Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt);

/// Returns dF/dω′ = I0 + dt ([ω′]ₓ I0 − [I0 ω′]ₓ), body axes [kg m²].                  eq. (10)
Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt);

/// Finds ω′ by exactly one step of Newton's method from ω′ = ω, in body axes, as engines do. Then
/// turns q by ω′ dt with the exponential map.                                        eq. (11), (12)
///
/// requires  a Jacobian that is not singular
Spin step_implicit(const Vec3& moments, const Spin& spin, double dt);

/// The time derivative of a Spin.
struct SpinRate {
  Quat attitude;                   ///< dq/dt; not a rotation
  Vec3 angular_acceleration_body;  ///< dω_body/dt [rad/s²]
};

/// Returns dq/dt = ½ q ω_body and dω_body/dt = I0⁻¹ (I0 ω_body × ω_body).              eq. (13)
///
/// spin  q may have any length, because dq/dt is linear in q
SpinRate spin_rate(const Vec3& moments, const Spin& spin);

/// Takes the classical Runge-Kutta step on (q, ω_body) and then normalises q, once.     eq. (14)
Spin step_rk4(const Vec3& moments, const Spin& spin, double dt);

/// Takes the part of the motion that ½ m_i²/I_i alone drives. The body turns about its own axis i
/// with tan(half the angle) = ½ ω_i dt, and L stays constant in the world.           eq. (15), (16)
///
/// axis  i − 1: 0, 1 or 2
Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt);

/// Takes sub-rotations about the axes 1, 2, 3, 2, 1 for dt/2, dt/2, dt, dt/2, dt/2.    eq. (17)
Spin step_splitting(const Vec3& moments, const Spin& spin, double dt);

/// Returns the torque of the weight about the fixed point, body axes [N m]. The centre of mass is
/// on the body's z axis, and gravity points along −z of the world.                     eq. (18)
Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body);

/// Takes a kick by the torque for dt/2, a drift free of torque for dt, and a kick for dt/2.
/// common::free_symmetric_step is supplied for the drift.                              eq. (19)
Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt);

/// Returns q_pred = q + dt ½ ω q. It is not unit, because its four numbers are free.   eq. (20)
Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

/// Returns the unit quaternion that is nearest to q_pred.                              eq. (21)
///
/// accuracy  a few ulp for every length from 1e-300 to 1e300
/// Throws std::invalid_argument if q_pred is zero or not finite.
Quat project(const Quat& q_pred);

/// Takes a step of constrained semi-implicit Euler: new velocities, then predicted positions, then
/// projection.                                                                         eq. (22)
RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt);

/// Returns the moments Ĩ with 1/Ĩ_i = (1 + scale)/I_i + shift. They may break (1).     eq. (23)
Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction);

/// Returns the unit quaternion p of the attitude's increment in body axes. Of all solutions of (24)
/// it is the one that goes to 1 as dt goes to 0:
///
///   dt m_i = 2 (p0 p_i Ĩ_i + (Ĩ_k − Ĩ_j) p_j p_k),   (i, j, k) = (1, 2, 3), (2, 3, 1), (3, 1, 2)
///
///                                            eq. (24); Moser & Veselov 1991, Hairer & Vilmart 2006
/// moments                Ĩ
/// angular_momentum_body  m [kg m²/s]
/// Throws std::domain_error if there is no p, for example if m is along axis i and |m_i| dt > Ĩ_i.
Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt);

/// Takes the step q′ = q p, m′ = Rᵀ(p) m. It makes p with the corrected moments, and m with the
/// body's own.                                                                         eq. (25)
Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt);

/// Returns the two numbers, from energy and |L|, that give the step above order four.  eq. (26)
MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt);

}  // namespace lab::gyroscopic_tumbling

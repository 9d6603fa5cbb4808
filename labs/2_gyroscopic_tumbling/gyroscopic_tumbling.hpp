#pragma once

#include <vector>

#include "common/heavy_top.hpp"
#include "common/moser_veselov_correction.hpp"
#include "common/spin.hpp"

/// The contract of lab 2. World frame unless a name ends in `_body`; q and −q are one attitude.
/// Body axes are principal axes: `moments` are I1, I2, I3 about the centre of mass [kg m²], each
/// above zero and none above the sum of the others. m = Rᵀ L is the angular momentum in body axes.
/// Steps take a dt [s] of either sign with |ω dt| < 1e6, and return a unit q. Masses, moments, ω
/// and dt, where not zero, are from 1e-60 to 1e60 in these units.
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

/// Where a rigid body is and how it moves. World frame.
struct RigidBodyState {
  Vec3 position = Vec3::Zero();             ///< x, centre of mass [m]
  Quat world_from_body = Quat::Identity();  ///< q, unit
  Vec3 velocity = Vec3::Zero();             ///< v, of the centre of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();     ///< ω [rad/s]
};

/// A force and the point it acts on. World frame.
struct AppliedForce {
  Vec3 force = Vec3::Zero();  ///< f [N]
  Vec3 point = Vec3::Zero();  ///< p [m]
};

/// The moments, where a body can have them: finite, above zero, and I_i ≤ I_j + I_k, equal for a
/// flat body. An excess of up to 4e-16 of the greatest is rounding and passes. From 1e-14 on, and
/// for all else, throws std::invalid_argument; in between either is right.             eq. (1)
Vec3 checked_moments(const Vec3& moments);

/// dω/dt = I⁻¹ (T − ω × I ω) [rad/s²], all in the same axes: the world's, or the body's.  eq. (2)
///
/// inertia  I, symmetric, positive definite; need not be diagonal
/// torque   T, about the centre of mass [N m]
Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque);

/// Kinetic energy of the rotation, ½ ω · I ω [J].                                      eq. (3)
double rotational_energy(const Vec3& moments, const Spin& spin);

/// L = R (I0 ω_body), world frame [kg m²/s].                                           eq. (4)
Vec3 angular_momentum(const Vec3& moments, const Spin& spin);

/// One turn of the loop, the gyroscopic term at the old velocity: forces and torques are summed,
/// both velocities updated, then x and q by the new velocities, q as in step 1.5.      eq. (5)–(8)
RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt);

/// F(ω′) = I0 (ω′ − ω) + dt ω′ × I0 ω′, zero where ω′ is the implicit step's, body axes
/// [kg m²/s].                                                                          eq. (9)
Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt);

/// dF/dω′ = I0 + dt ([ω′]ₓ I0 − [I0 ω′]ₓ), body axes [kg m²].                          eq. (10)
Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt);

/// ω′ by exactly one step of Newton's method from ω′ = ω, in body axes, as the engines do; then q
/// turns by ω′ dt with the exponential map.                                          eq. (11), (12)
///
/// requires  a Jacobian that is not singular
Spin step_implicit(const Vec3& moments, const Spin& spin, double dt);

/// What d/dt makes of a Spin.
struct SpinRate {
  Quat attitude;                   ///< dq/dt; not a rotation
  Vec3 angular_acceleration_body;  ///< dω_body/dt [rad/s²]
};

/// dq/dt = ½ q ω_body, dω_body/dt = I0⁻¹ (I0 ω_body × ω_body).                         eq. (13)
///
/// spin  q of any length: dq/dt is linear in it
SpinRate spin_rate(const Vec3& moments, const Spin& spin);

/// The classical Runge-Kutta step on (q, ω_body), q normalised once, at the end.       eq. (14)
Spin step_rk4(const Vec3& moments, const Spin& spin, double dt);

/// The part of the motion that ½ m_i²/I_i alone drives: the body turns about its own axis i with
/// tan(half the angle) = ½ ω_i dt, and L stays where it is in the world.             eq. (15), (16)
///
/// axis  i − 1: 0, 1 or 2
Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt);

/// Sub-rotations about axes 1, 2, 3, 2, 1 for dt/2, dt/2, dt, dt/2, dt/2.              eq. (17)
Spin step_splitting(const Vec3& moments, const Spin& spin, double dt);

/// Torque of the weight about the fixed point, body axes [N m]; the centre of mass lies on the
/// body's z axis, gravity points along −z of the world.                                eq. (18)
Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body);

/// Kick by the torque for dt/2, drift free of torque for dt, kick for dt/2. The drift is given:
/// common::free_symmetric_step.                                                        eq. (19)
Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt);

/// q_pred = q + dt ½ ω q, as if four numbers moved freely: not unit.                   eq. (20)
Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

/// The unit quaternion that is nearest to q_pred.                                      eq. (21)
///
/// accuracy  a few ulp for every length from 1e-300 to 1e300
/// Throws std::invalid_argument where q_pred is zero or not finite.
Quat project(const Quat& q_pred);

/// Constrained semi-implicit Euler: velocities, then predicted
/// positions, then projection.  eq. (22)
RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt);

/// Moments Ĩ with 1/Ĩ_i = (1 + scale)/I_i + shift; they need not be a body's.          eq. (23)
Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction);

/// The unit quaternion p of the attitude's increment in body axes, the one that goes to 1 with dt:
///
///   dt m_i = 2 (p0 p_i Ĩ_i + (Ĩ_k − Ĩ_j) p_j p_k),   (i, j, k) = (1, 2, 3), (2, 3, 1), (3, 1, 2)
///
///                                            eq. (24); Moser & Veselov 1991, Hairer & Vilmart 2006
/// moments                Ĩ
/// angular_momentum_body  m [kg m²/s]
/// Throws std::domain_error where there is none, as where m is along axis i and |m_i| dt > Ĩ_i.
Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt);

/// q′ = q p, m′ = Rᵀ(p) m, where p is made with corrected moments and m with
/// the body's own.  eq. (25)
Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt);

/// The two numbers, of energy and |L|, that make the step above one of order four. eq. (26)
MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt);

}  // namespace lab::gyroscopic_tumbling

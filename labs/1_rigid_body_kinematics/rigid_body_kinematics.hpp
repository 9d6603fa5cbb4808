#pragma once

#include <vector>

#include "common/types.hpp"

/// The contract of lab 1. World frame unless a name ends in `_body`; q and −q are one attitude.
///
///   x  centre of mass [m]                        ω  angular velocity [rad/s]
///   R  rotation matrix, v_world = R v_body       v  velocity of the centre of mass [m/s]
///   q  the same as a unit quaternion             I0 inertia about the centre of mass, body frame
namespace lab::rigid_body_kinematics {

using common::Mat3;
using common::Quat;
using common::Vec3;

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

/// What a set of forces adds up to. World frame.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< about the centre of mass [N m]
};

/// The matrix of the cross product: skew(w) u = w × u for every u.               eq. (1)
Mat3 skew(const Vec3& w);

/// World position of a point that is fixed in the body: x + R p_body [m].          eq. (2)
///
/// point_body  from the centre of mass, body frame [m]
Vec3 world_point(const RigidBodyState& state, const Vec3& point_body);

/// Where a world point stands in the body: Rᵀ (p − x), body frame [m]; undoes world_point.  eq. (3)
///
/// accuracy  to a few ulp of p − x, also where both are far from the world's origin
Vec3 body_point(const RigidBodyState& state, const Vec3& point);

/// Velocity of the body's material that is now at `point`: v + ω × (p − x) [m/s].  eq. (4)
///
/// point  world [m]; need not be inside the body
Vec3 point_velocity(const RigidBodyState& state, const Vec3& point);

/// Inertia in the world frame: I = R I0 Rᵀ [kg m²].                                eq. (5)
///
/// inertia_body  I0, symmetric, about the centre of mass; need not be diagonal
Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body);

/// Net force Σ f_i and net torque Σ (p_i − x) × f_i; zero where there are no forces.  eq. (6)
///
/// center_of_mass  x, world [m]
Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces);

/// One step of explicit Euler on dR/dt = [ω]ₓ R: (1 + dt [ω]ₓ) R, without any repair.   eq. (7)
///
/// world_from_body   R; any matrix: after a step it is not a rotation any more
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| < 1e100 [s]; a negative one goes back
Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt);

/// The rotation Q (QᵀQ = 1, det Q = +1) that is nearest to `matrix`: the least |Q − matrix| in the
/// Frobenius norm; the polar factor where det > 0.     eq. (8); Umeyama 1991
///
/// Where several are nearest (det ≤ 0 and the two least singular values equal, as for −1 and for
/// every matrix of rank 0 or 1): any of them, or std::invalid_argument.
/// Throws std::invalid_argument where an entry is NaN or infinite.
Mat3 nearest_rotation(const Mat3& matrix);

/// One step of explicit Euler on dq/dt = ½ ω q, then normalised: unit.              eq. (9), (10)
///
/// world_from_body   q, unit; ω q is a product of quaternions, ω with real part 0
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| < 1e100 [s]
Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

/// The rotation by the angle |a| about the axis a / |a|: (cos |a|/2, sin |a|/2 · a/|a|).  eq. (11)
///
/// rotation_vector  a [rad], |a| up to 1e300; 0 gives the identity
/// accuracy         every component to a few ulp, for |a| down to 1e-300: no small-angle gap
Quat exponential_map(const Vec3& rotation_vector);

/// Turns by the constant ω for dt: exp(ω dt) q. Exact where ω is constant; of second order where
/// the caller passes ω at the middle of the step.                                   eq. (12)
///
/// world_from_body   q, unit
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| up to 1e300 [s]
Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

}  // namespace lab::rigid_body_kinematics

#pragma once

#include <vector>

#include "common/types.hpp"

/// The contract of lab 1. Vectors are in the world frame unless a name ends in `_body`. q and −q
/// are the same attitude.
///
///   x  centre of mass [m]                        ω  angular velocity [rad/s]
///   R  rotation matrix, v_world = R v_body       v  velocity of the centre of mass [m/s]
///   q  the same as a unit quaternion             I0 inertia about the centre of mass, body frame
namespace lab::rigid_body_kinematics {

using common::Mat3;
using common::Quat;
using common::Vec3;

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

/// The sum of a set of forces and of their torques, in the world frame.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< about the centre of mass [N m]
};

/// Returns the matrix of the cross product: skew(w) u = w × u for every u.          eq. (1)
Mat3 skew(const Vec3& w);

/// Returns the world position of a point that is fixed in the body: x + R p_body [m].  eq. (2)
///
/// point_body  from the centre of mass, body frame [m]
Vec3 world_point(const RigidBodyState& state, const Vec3& point_body);

/// Returns a world point in the body frame: Rᵀ (p − x) [m]. It is the inverse of world_point.
///                                                                                  eq. (3)
///
/// accuracy  a few ulp of p − x, even if both are far from the world's origin
Vec3 body_point(const RigidBodyState& state, const Vec3& point);

/// Returns the velocity of the body's material that is now at `point`: v + ω × (p − x) [m/s].
///                                                                                  eq. (4)
///
/// point  world [m]; need not be inside the body
Vec3 point_velocity(const RigidBodyState& state, const Vec3& point);

/// Returns the inertia in the world frame: I = R I0 Rᵀ [kg m²].                     eq. (5)
///
/// inertia_body  I0, symmetric, about the centre of mass; need not be diagonal
Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body);

/// Returns the net force Σ f_i and the net torque Σ (p_i − x) × f_i. Both are zero if there are no
/// forces.                                                                          eq. (6)
///
/// center_of_mass  x, world [m]
Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces);

/// Takes one step of explicit Euler on dR/dt = [ω]ₓ R: returns (1 + dt [ω]ₓ) R, without any repair.
///                                                                                  eq. (7)
///
/// world_from_body   R; any matrix, because after a step it is no longer a rotation
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| < 1e100 [s]; a negative one goes back
Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt);

/// Returns the rotation Q (QᵀQ = 1, det Q = +1) that is nearest to `matrix`, that is, for which the
/// Frobenius norm |Q − matrix| is least. If det > 0, Q is the polar factor.   eq. (8); Umeyama 1991
///
/// Several rotations are nearest if det ≤ 0 and the two least singular values are equal, as for −1
/// and for every matrix of rank 0 or 1. Then it returns any of them or throws
/// std::invalid_argument.
/// Throws std::invalid_argument if an entry is NaN or infinite.
Mat3 nearest_rotation(const Mat3& matrix);

/// Takes one step of explicit Euler on dq/dt = ½ ω q and normalises the result.     eq. (9), (10)
///
/// world_from_body   q, unit; ω q is a product of quaternions, in which ω has the real part 0
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| < 1e100 [s]
Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

/// Returns the rotation by the angle |a| about the axis a / |a|: (cos |a|/2, sin |a|/2 · a/|a|).
///                                                                                  eq. (11)
///
/// rotation_vector  a [rad], |a| up to 1e300; 0 gives the identity
/// accuracy         a few ulp of every component, for |a| down to 1e-300 without a small-angle gap
Quat exponential_map(const Vec3& rotation_vector);

/// Turns q by the constant ω for the time dt: returns exp(ω dt) q.                  eq. (12)
///
/// It is exact if ω is constant, and of second order if the caller passes ω at the middle of the
/// step.
///
/// world_from_body   q, unit
/// angular_velocity  ω, world [rad/s]
/// dt                any step with |ω dt| up to 1e300 [s]
Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt);

}  // namespace lab::rigid_body_kinematics

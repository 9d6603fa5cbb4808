// Lab 2: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the physics and the numbered equations. Test your file with:  ./tumble test 2
#include "gyroscopic_tumbling.hpp"

#include "common/algebra/linear_algebra.hpp"
#include "common/course/not_implemented.hpp"
#include "common/rotation/attitude.hpp"

namespace lab::gyroscopic_tumbling {

// ---- Step 2.1 ----

Vec3 checked_moments(const Vec3& moments) {
  // TODO step 2.1, eq. (1)
  // 1. Throw std::invalid_argument (of <stdexcept>) if a moment is not finite or not above zero.
  // 2. Throw it, too, if a moment is above the sum of the others by more than rounding.
  // 3. Return the moments.
  throw common::NotImplemented("2.1 checked_moments");
}

Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque) {
  // TODO step 2.1, eq. (2)
  // 1. Compute ω × I ω. This term changes ω even if no torque acts.
  // 2. Subtract it from the torque, and apply the inverse of I.
  throw common::NotImplemented("2.1 angular_acceleration");
}

double rotational_energy(const Vec3& moments, const Spin& spin) {
  // TODO step 2.1, eq. (3)
  // 1. In body axes I ω is the product of moments and ω, component by component.
  throw common::NotImplemented("2.1 rotational_energy");
}

Vec3 angular_momentum(const Vec3& moments, const Spin& spin) {
  // TODO step 2.1, eq. (4)
  // 1. Compute I0 ω in body axes.
  // 2. Turn the vector into the world.
  throw common::NotImplemented("2.1 angular_momentum");
}

// ---- Step 2.2 ----

RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt) {
  // TODO step 2.2, eq. (5) to (8)
  // 1. Sum up forces and torques about the centre of mass.
  // 2. Compute the inertia in the world, then both accelerations.
  // 3. Compute the new velocities.
  // 4. Compute the new position and attitude from the new velocities.
  // 5. Normalise q.
  throw common::NotImplemented("2.2 step_explicit");
}

// ---- Step 2.3 ----

Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt) {
  // TODO step 2.3, eq. (9)
  // 1. Add the change of I0 ω and dt times the gyroscopic term, at the new velocity.
  throw common::NotImplemented("2.3 implicit_residual");
}

Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt) {
  // TODO step 2.3, eq. (10)
  // 1. ω′ is in the cross product twice, so the product rule gives two terms.
  // 2. In one of them the factors are swapped, which gives a minus sign.
  throw common::NotImplemented("2.3 implicit_jacobian");
}

Spin step_implicit(const Vec3& moments, const Spin& spin, double dt) {
  // TODO step 2.3, eq. (11) and (12)
  // 1. Compute the residual and the Jacobian at ω′ = ω.
  // 2. Take one Newton step: solve a 3 x 3 system.
  // 3. common::exponential_map(ω′ dt) turns the attitude. ω′ is in body axes: which side of q?
  throw common::NotImplemented("2.3 step_implicit");
}

// ---- Step 2.4 ----

SpinRate spin_rate(const Vec3& moments, const Spin& spin) {
  // TODO step 2.4, eq. (13)
  // 1. Make ω a quaternion with real part 0. It is on the right of q, because it is in body axes.
  // 2. Use Euler's equations without a torque.
  throw common::NotImplemented("2.4 spin_rate");
}

Spin step_rk4(const Vec3& moments, const Spin& spin, double dt) {
  // TODO step 2.4, eq. (14)
  // 1. Compute four rates: at the start, twice in the middle, and at the end. Do not normalise q in
  //    between.
  // 2. Take their mean with the weights 1, 2, 2, 1.
  // 3. Normalise q.
  throw common::NotImplemented("2.4 step_rk4");
}

// ---- Step 2.5 ----

Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt) {
  // TODO step 2.5, eq. (15) and (16)
  // 1. Normalise the quaternion (1, ½ ω_i dt e_i). You need no sine and no cosine.
  // 2. Turn the attitude by it.
  // 3. L is constant in the world, so m = I0 ω turns the other way in the body. Then ω = m / I0.
  throw common::NotImplemented("2.5 step_about_axis");
}

Spin step_splitting(const Vec3& moments, const Spin& spin, double dt) {
  // TODO step 2.5, eq. (17)
  throw common::NotImplemented("2.5 step_splitting");
}

// ---- Step 2.6 ----

Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body) {
  // TODO step 2.6, eq. (18)
  // 1. Which direction is down, as seen from the body?
  // 2. The lever arm is along the body's z axis, and weight_moment is m g l.
  throw common::NotImplemented("2.6 weight_torque_body");
}

Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt) {
  // TODO step 2.6, eq. (19)
  // 1. Kick: the torque changes the angular velocity for dt/2, and the attitude stays.
  // 2. Drift: call common::free_symmetric_step(top, spin, dt).
  // 3. Kick again, by the torque at the new attitude.
  throw common::NotImplemented("2.6 step_kick_drift_kick");
}

// ---- Step 2.7 ----

Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  // TODO step 2.7, eq. (20)
  throw common::NotImplemented("2.7 predicted_attitude");
}

Quat project(const Quat& q_pred) {
  // TODO step 2.7, eq. (21)
  // 1. Which point of the unit sphere is nearest to q_pred?
  // 2. Scale by the greatest component first, so that no square overflows or underflows.
  throw common::NotImplemented("2.7 project");
}

RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt) {
  // TODO step 2.7, eq. (22)
  throw common::NotImplemented("2.7 step_constrained");
}

// ---- Step 2.8 ----

Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction) {
  // TODO step 2.8, eq. (23)
  throw common::NotImplemented("2.8 corrected_moments");
}

Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt) {
  // TODO step 2.8, eq. (24)
  // 1. Divide by 2 p0². With b_i = p_i/p0 and 1/p0² = 1 + |b|² these are three equations for b.
  // 2. Solve them for I_i b_i and iterate from b = 0, or use Newton's method. Stop when the change
  //    of b is at most 1e-14 |b|. It need not be zero, but b may be.
  // 3. If b does not settle, give up and throw std::domain_error.
  // 4. Normalise p = (1, b).
  throw common::NotImplemented("2.8 moser_veselov_increment");
}

Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt) {
  // TODO step 2.8, eq. (25)
  // 1. Compute m = I0 ω with the body's own moments, and the increment with the corrected ones.
  // 2. Turn q by p, and m the other way. Then ω = m / I0, again with the body's own moments.
  throw common::NotImplemented("2.8 step_moser_veselov");
}

MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt) {
  // TODO step 2.8, eq. (26)
  throw common::NotImplemented("2.8 fourth_order_correction");
}

}  // namespace lab::gyroscopic_tumbling

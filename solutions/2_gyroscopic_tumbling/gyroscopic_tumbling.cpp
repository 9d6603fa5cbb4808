#include "gyroscopic_tumbling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/algebra/linear_algebra.hpp"
#include "common/rotation/attitude.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Quat pure(const Vec3& v) { return {0.0, v.x(), v.y(), v.z()}; }

Vec3 momentum_body(const Vec3& moments, const Spin& spin) {
  return moments.cwiseProduct(spin.angular_velocity_body);
}

/// The motion during the sub-rotations: q may have any length, m is in body axes.
struct Carried {
  Quat q;
  Vec3 m;
};

Carried carried(const Vec3& moments, const Spin& spin) {
  return {spin.world_from_body, momentum_body(moments, spin)};
}

Spin spin_of(const Vec3& moments, const Carried& now) {
  return {now.q.normalized(), now.m.cwiseQuotient(moments)};
}

/// Turns the body by 2 atan t about its axis i, with t = ½ ω_i dt, and m the other way, so that L
/// is constant in the world.
template <int i>
Carried sub_rotation(const Vec3& moments, const Carried& now, double dt) {
  constexpr int j = (i + 1) % 3;
  constexpr int k = (i + 2) % 3;
  const double t = 0.5 * dt * now.m(i) / moments(i);  // eq. (15)
  const Vec3 v = now.q.vec();
  Carried next;
  next.q.w() = now.q.w() - t * v(i);  // q (1, t e_i)
  next.q.vec()(i) = v(i) + t * now.q.w();
  next.q.vec()(j) = v(j) + t * v(k);
  next.q.vec()(k) = v(k) - t * v(j);

  const double scale = 1.0 / (1.0 + t * t);
  const double cosine = (1.0 - t * t) * scale;
  const double sine = 2.0 * t * scale;
  next.m(i) = now.m(i);
  next.m(j) = cosine * now.m(j) + sine * now.m(k);  // eq. (16)
  next.m(k) = cosine * now.m(k) - sine * now.m(j);
  return next;
}

Spin moved(const Spin& spin, const SpinRate& rate, double dt) {
  return {Quat(spin.world_from_body.coeffs() + dt * rate.attitude.coeffs()),
          spin.angular_velocity_body + dt * rate.angular_acceleration_body};
}

/// Returns the state with the new velocities and the position that follows from them. The attitude
/// is still the old one.
RigidBodyState with_new_velocities(const RigidBody& body, const RigidBodyState& state,
                                   const std::vector<AppliedForce>& forces, double dt) {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  for (const AppliedForce& applied : forces) {
    force += applied.force;
    torque += (applied.point - state.position).cross(applied.force);  // eq. (5)
  }
  const Mat3 R = state.world_from_body.toRotationMatrix();
  const Mat3 inertia = R * body.moments.asDiagonal() * R.transpose();

  RigidBodyState next = state;
  next.velocity += dt / body.mass * force;  // eq. (6)
  next.angular_velocity += dt * angular_acceleration(inertia, state.angular_velocity, torque);
  next.position += dt * next.velocity;  // eq. (7)
  return next;
}

}  // namespace

Vec3 checked_moments(const Vec3& moments) {
  if (!moments.allFinite()) throw std::invalid_argument("a moment of inertia is not finite");
  if (moments.minCoeff() <= 0.0) throw std::invalid_argument("a moment of inertia is not above 0");
  const double greatest = moments.maxCoeff();
  if (greatest > (moments.sum() - greatest) + 4.0 * eps * greatest) {
    throw std::invalid_argument("a moment of inertia is above the sum of the other two");
  }
  return moments;
}

Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque) {
  const Vec3& omega = angular_velocity;
  return common::inverse(inertia) * (torque - omega.cross(inertia * omega));
}

double rotational_energy(const Vec3& moments, const Spin& spin) {
  return 0.5 * spin.angular_velocity_body.dot(momentum_body(moments, spin));
}

Vec3 angular_momentum(const Vec3& moments, const Spin& spin) {
  return spin.world_from_body * momentum_body(moments, spin);
}

RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt) {
  RigidBodyState next = with_new_velocities(body, state, forces, dt);
  const Quat& q = state.world_from_body;
  const Quat rate = pure(next.angular_velocity) * q;
  next.world_from_body = Quat(q.coeffs() + 0.5 * dt * rate.coeffs());  // eq. (8)
  next.world_from_body.normalize();
  return next;
}

Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt) {
  const Vec3& next = next_angular_velocity_body;
  const Vec3 change = moments.cwiseProduct(next - angular_velocity_body);
  return change + dt * next.cross(moments.cwiseProduct(next));
}

Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt) {
  const Vec3& omega = next_angular_velocity_body;
  const Vec3 m = moments.cwiseProduct(omega);
  Mat3 J;
  for (int i = 0; i < 3; ++i) {
    const Vec3 e = Vec3::Unit(i);
    J.col(i) = moments(i) * e + dt * (moments(i) * omega.cross(e) - m.cross(e));
  }
  return J;
}

Spin step_implicit(const Vec3& moments, const Spin& spin, double dt) {
  const Vec3& omega = spin.angular_velocity_body;
  const Mat3 J = implicit_jacobian(moments, omega, dt);
  const Vec3 next = omega - common::inverse(J) * implicit_residual(moments, omega, omega, dt);
  const Quat q = spin.world_from_body * common::exponential_map(dt * next);
  return {q.normalized(), next};
}

SpinRate spin_rate(const Vec3& moments, const Spin& spin) {
  const Vec3& omega = spin.angular_velocity_body;
  const Quat turning = spin.world_from_body * pure(omega);
  const Vec3 gyroscopic = omega.cross(moments.cwiseProduct(omega));
  return {Quat(0.5 * turning.coeffs()), -gyroscopic.cwiseQuotient(moments)};
}

Spin step_rk4(const Vec3& moments, const Spin& spin, double dt) {
  const SpinRate k1 = spin_rate(moments, spin);
  const SpinRate k2 = spin_rate(moments, moved(spin, k1, 0.5 * dt));
  const SpinRate k3 = spin_rate(moments, moved(spin, k2, 0.5 * dt));
  const SpinRate k4 = spin_rate(moments, moved(spin, k3, dt));
  Spin next = moved(moved(spin, k1, dt / 6.0), k2, dt / 3.0);
  next = moved(moved(next, k3, dt / 3.0), k4, dt / 6.0);
  next.world_from_body.normalize();
  return next;
}

Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt) {
  const Carried now = carried(moments, spin);
  switch (axis) {
    case 0:
      return spin_of(moments, sub_rotation<0>(moments, now, dt));
    case 1:
      return spin_of(moments, sub_rotation<1>(moments, now, dt));
    default:
      return spin_of(moments, sub_rotation<2>(moments, now, dt));
  }
}

Spin step_splitting(const Vec3& moments, const Spin& spin, double dt) {
  Carried now = carried(moments, spin);
  now = sub_rotation<0>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<0>(moments, now, 0.5 * dt);
  return spin_of(moments, now);
}

Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body) {
  const Vec3 down_body = world_from_body.conjugate() * Vec3(0.0, 0.0, -1.0);
  return top.weight_moment * Vec3::UnitZ().cross(down_body);
}

Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt) {
  const Vec3 moments(top.transverse_moment, top.transverse_moment, top.axial_moment);
  const auto kicked = [&](Spin now) {
    const Vec3 torque = weight_torque_body(top, now.world_from_body);
    now.angular_velocity_body += 0.5 * dt * torque.cwiseQuotient(moments);
    return now;
  };
  Spin next = kicked(common::free_symmetric_step(top, kicked(spin), dt));
  next.world_from_body.normalize();
  return next;
}

Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  const Quat rate = pure(angular_velocity) * world_from_body;
  return Quat(world_from_body.coeffs() + 0.5 * dt * rate.coeffs());
}

Quat project(const Quat& q_pred) {
  const double greatest = q_pred.coeffs().cwiseAbs().maxCoeff();
  if (!(greatest > 0.0 && q_pred.coeffs().allFinite())) {
    throw std::invalid_argument("project: a quaternion that is zero or not finite");
  }
  Quat q(q_pred.coeffs() / greatest);  // a square neither over- nor underflows now
  q.normalize();
  return q;
}

RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt) {
  RigidBodyState next = with_new_velocities(body, state, forces, dt);
  next.world_from_body =
      project(predicted_attitude(state.world_from_body, next.angular_velocity, dt));
  return next;
}

Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction) {
  const Vec3 inverse = (1.0 + correction.scale) * moments.cwiseInverse();
  return (inverse + Vec3::Constant(correction.shift)).cwiseInverse();
}

Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt) {
  // With e = p/p0, solve I_i e_i = ½ dt m_i (1 + |e|²) − (I_k − I_j) e_j e_k by Newton's method.
  const Vec3& I = moments;
  const Vec3 half = 0.5 * dt * angular_momentum_body;
  const Vec3 spread(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());
  constexpr int most_steps = 50;  // Newton's method needs about 5, and about 25 near the limit
  Vec3 e = Vec3::Zero();
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 products(e.y() * e.z(), e.z() * e.x(), e.x() * e.y());
    const Vec3 F =
        I.cwiseProduct(e) + spread.cwiseProduct(products) - half * (1.0 + e.squaredNorm());
    Mat3 J;
    J << I.x(), spread.x() * e.z(), spread.x() * e.y(),  //
        spread.y() * e.z(), I.y(), spread.y() * e.x(),   //
        spread.z() * e.y(), spread.z() * e.x(), I.z();
    J -= 2.0 * half * e.transpose();
    const Vec3 change = common::inverse(J) * F;
    e -= change;
    if (change.norm() <= 1e-10 * e.norm() && std::isfinite(e.squaredNorm())) {  // next: its square
      Quat p(1.0, e.x(), e.y(), e.z());
      p.normalize();
      return p;
    }
  }
  throw std::domain_error("moser_veselov_increment: no increment, the step is too long");
}

Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt) {
  const Quat p = moser_veselov_increment(corrected_moments(moments, correction),
                                         momentum_body(moments, spin), dt);
  const Vec3 m = p.conjugate() * momentum_body(moments, spin);
  return {(spin.world_from_body * p).normalized(), m.cwiseQuotient(moments)};
}

MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt) {
  const double H = rotational_energy(moments, spin);
  const double C = 0.5 * momentum_body(moments, spin).squaredNorm();
  const double product = moments.prod();
  const double mixed = moments.sum() / (6.0 * product);
  const double inverses = moments.cwiseInverse().sum();
  return {dt * dt * (mixed * C - inverses * H / 3.0), dt * dt * (mixed * H - C / (3.0 * product))};
}

}  // namespace lab::gyroscopic_tumbling

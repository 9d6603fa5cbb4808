// The lab once more, built otherwise: components instead of Eigen's quaternions, Euler's equations
// in body axes, elimination instead of inverses, fixed points for Moser and Veselov.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/rotation/attitude.hpp"
#include "gyroscopic_tumbling.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// (a, u)(b, v) = (a b − u·v, a v + b u + u × v).
Quat product(const Quat& left, const Quat& right) {
  const Vec3 u = left.vec();
  const Vec3 v = right.vec();
  const Vec3 uv = left.w() * v + right.w() * u + u.cross(v);
  return {left.w() * right.w() - u.dot(v), uv.x(), uv.y(), uv.z()};
}

Quat unit(const Quat& q) {
  return Quat(q.coeffs() / std::hypot(std::hypot(q.w(), q.x()), std::hypot(q.y(), q.z())));
}

/// v turned by q, whatever the length of q: rounding in q cannot stretch v.
Vec3 turned(const Quat& q, const Vec3& v) {
  const Vec3 u = q.vec();
  return v + 2.0 / (q.w() * q.w() + u.dot(u)) * (q.w() * u.cross(v) + u.cross(u.cross(v)));
}

/// dω/dt without a torque in body axes: (I_j − I_k) ω_j ω_k / I_i.
Vec3 free_acceleration(const Vec3& I, const Vec3& omega) {
  return {(I.y() - I.z()) / I.x() * omega.y() * omega.z(),
          (I.z() - I.x()) / I.y() * omega.z() * omega.x(),
          (I.x() - I.y()) / I.z() * omega.x() * omega.y()};
}

/// x with A x = b, by Gauss and Jordan's elimination with row exchanges.
Vec3 eliminated(const Mat3& A, const Vec3& b) {
  Eigen::Matrix<double, 3, 4> rows;
  rows << A, b;
  for (int i = 0; i < 3; ++i) {
    int below = 0;
    rows.col(i).tail(3 - i).cwiseAbs().maxCoeff(&below);
    rows.row(i).swap(rows.row(i + below));
    rows.row(i) /= rows(i, i);
    for (const int j : {(i + 1) % 3, (i + 2) % 3}) rows.row(j) -= rows(j, i) * rows.row(i);
  }
  return rows.col(3);
}

}  // namespace

Vec3 checked_moments(const Vec3& moments) {
  for (int i = 0; i < 3; ++i) {
    const double own = moments(i);
    // A difference: the sum of two moments might overflow.
    const double excess = own - moments((i + 1) % 3) - moments((i + 2) % 3);
    const bool possible = std::isfinite(own) && own > 0.0 && excess <= 4.0 * eps * own;
    if (!possible) throw std::invalid_argument("a moment of inertia that no body has");
  }
  return moments;
}

Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque) {
  return eliminated(inertia, torque + (inertia * angular_velocity).cross(angular_velocity));
}

double rotational_energy(const Vec3& moments, const Spin& spin) {
  return 0.5 * spin.angular_velocity_body.cwiseAbs2().dot(moments);
}

Vec3 angular_momentum(const Vec3& moments, const Spin& spin) {
  return turned(spin.world_from_body, moments.cwiseProduct(spin.angular_velocity_body));
}

RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt) {
  return step_constrained(body, state, forces, dt);  // to normalise q is to project it
}

Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt) {
  const Vec3 free = dt * free_acceleration(moments, next_angular_velocity_body);
  return moments.cwiseProduct(next_angular_velocity_body - angular_velocity_body - free);
}

Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt) {
  Mat3 J = moments.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    J(i, j) = dt * (moments(k) - moments(j)) * next_angular_velocity_body(k);
    J(i, k) = dt * (moments(k) - moments(j)) * next_angular_velocity_body(j);
  }
  return J;
}

Spin step_implicit(const Vec3& moments, const Spin& spin, double dt) {
  const Vec3& omega = spin.angular_velocity_body;
  // Both sides over I0, so that pivots can be compared.
  const Mat3 J = moments.cwiseInverse().asDiagonal() * implicit_jacobian(moments, omega, dt);
  const Vec3 next = omega + eliminated(J, dt * free_acceleration(moments, omega));
  return {unit(product(spin.world_from_body, common::exponential_map(next * dt))), next};
}

SpinRate spin_rate(const Vec3& moments, const Spin& spin) {
  const Vec3& omega = spin.angular_velocity_body;
  const Quat half(0.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
  return {product(spin.world_from_body, half), free_acceleration(moments, omega)};
}

Spin step_rk4(const Vec3& moments, const Spin& spin, double dt) {
  using SevenNumbers = Eigen::Matrix<double, 7, 1>;
  const auto rates = [&](const SevenNumbers& now) {
    const SpinRate rate = spin_rate(moments, {Quat(now.head<4>()), now.tail<3>()});
    return (SevenNumbers() << rate.attitude.coeffs(), rate.angular_acceleration_body).finished();
  };
  SevenNumbers start;
  start << spin.world_from_body.coeffs(), spin.angular_velocity_body;
  const SevenNumbers k1 = rates(start);
  const SevenNumbers k2 = rates(start + 0.5 * dt * k1);
  const SevenNumbers k3 = rates(start + 0.5 * dt * k2);
  const SevenNumbers k4 = rates(start + dt * k3);
  const SevenNumbers next = start + dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
  return {unit(Quat(next.head<4>())), next.tail<3>()};
}

Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt) {
  const double t = 0.5 * spin.angular_velocity_body(axis) * dt;
  Quat p(1.0 / std::hypot(1.0, t), 0.0, 0.0, 0.0);  // cosine of half the angle
  p.vec()(axis) = t / std::hypot(1.0, t);
  const double cosine = (p.w() - p.vec()(axis)) * (p.w() + p.vec()(axis));
  const double sine = 2.0 * p.w() * p.vec()(axis);
  // m_j and m_k turn the other way; divided by I_j and I_k.
  const int j = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  Vec3 omega = spin.angular_velocity_body;
  omega(j) = cosine * omega(j) + sine * moments(k) / moments(j) * spin.angular_velocity_body(k);
  omega(k) = cosine * omega(k) - sine * moments(j) / moments(k) * spin.angular_velocity_body(j);
  return {product(spin.world_from_body, p), omega};
}

Spin step_splitting(const Vec3& moments, const Spin& spin, double dt) {
  Spin next = spin;
  for (const int axis : {0, 1, 2, 1, 0}) {
    next = step_about_axis(moments, next, axis, axis == 2 ? dt : 0.5 * dt);
  }
  return {unit(next.world_from_body), next.angular_velocity_body};
}

Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body) {
  // R's third row is up in body axes, and e_z × −(R_zx, R_zy, R_zz) = (R_zy, −R_zx, 0).
  const Quat& q = world_from_body;
  return 2.0 * top.weight_moment *
         Vec3(q.y() * q.z() + q.w() * q.x(), q.w() * q.y() - q.x() * q.z(), 0.0);
}

Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt) {
  const double transverse = top.transverse_moment;
  const Vec3& omega = spin.angular_velocity_body;  // its z component stays as it is
  Vec3 m(transverse * omega.x(), transverse * omega.y(), top.axial_moment * omega.z());
  m += 0.5 * dt * weight_torque_body(top, spin.world_from_body);
  // The free top turns about its axis by this angle, then about the resting L by |L| dt / I1.
  const double angle = (transverse - top.axial_moment) / transverse * omega.z() * dt;
  const Quat about_axis = common::exponential_map(Vec3(0.0, 0.0, angle));
  const Quat about_momentum = common::exponential_map(m / transverse * dt);
  const Quat q = unit(product(spin.world_from_body, product(about_momentum, about_axis)));
  m = turned(about_axis.conjugate(), m) + 0.5 * dt * weight_torque_body(top, q);
  return {q, Vec3(m.x() / transverse, m.y() / transverse, omega.z())};
}

Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  // eq. (20), factored: q + dt ½ ω q = (1 + dt ½ ω) q.
  const Vec3 half = 0.5 * dt * angular_velocity;
  return product(Quat(1.0, half.x(), half.y(), half.z()), world_from_body);
}

Quat project(const Quat& q_pred) {
  const double greatest = q_pred.coeffs().cwiseAbs().maxCoeff();
  const bool has_direction = q_pred.coeffs().allFinite() && greatest > 0.0;
  if (!has_direction) throw std::invalid_argument("project: zero or not finite");
  const auto scaled = [&](double number) { return std::scalbn(number, -std::ilogb(greatest)); };
  return unit(Quat(q_pred.coeffs().unaryExpr(scaled)));
}

RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt) {
  RigidBodyState next = state;
  Vec3 torque = Vec3::Zero();
  for (const AppliedForce& applied : forces) {
    next.velocity += applied.force / body.mass * dt;
    torque -= applied.force.cross(applied.point - state.position);
  }
  // eq. (2) holds in body axes too, where the inertia is three numbers.
  const Quat& q = state.world_from_body;
  const Vec3 omega_body = turned(q.conjugate(), state.angular_velocity);
  const Vec3 acceleration_body = turned(q.conjugate(), torque).cwiseQuotient(body.moments) +
                                 free_acceleration(body.moments, omega_body);
  next.angular_velocity += turned(q, dt * acceleration_body);
  next.position += next.velocity * dt;
  next.world_from_body = project(predicted_attitude(q, next.angular_velocity, dt));
  return next;
}

Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction) {
  return moments.array() / (1.0 + correction.scale + correction.shift * moments.array());
}

Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt) {
  // With e = p/p0: I_i e_i = ½ dt m_i (1 + |e|²) − (I_k − I_j) e_j e_k, again and again until the
  // change falls no further for a while: near the limit a round lessens it by under an ulp.
  const Vec3 half = (0.5 * dt * angular_momentum_body).cwiseQuotient(moments);
  constexpr int most_rounds = 100000;  // some 250 where |ω| dt is 0.99
  Vec3 e = Vec3::Zero();
  double least_change = std::numeric_limits<double>::infinity();
  for (int round = 0, idle = 0; round < most_rounds && idle < 10 + round / 4; ++round) {
    const Vec3 next = half * (1.0 + e.squaredNorm()) + free_acceleration(moments, e);
    const double change = (next - e).norm();
    idle = change < least_change ? 0 : idle + 1;
    least_change = std::fmin(least_change, change);
    e = next;
  }
  const bool at_rest = e.allFinite() && least_change <= 32.0 * eps * half.norm();
  if (!at_rest) throw std::domain_error("moser_veselov_increment: the step is too long");
  return unit(Quat(1.0, e.x(), e.y(), e.z()));
}

Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt) {
  const Vec3 m = moments.cwiseProduct(spin.angular_velocity_body);
  const Quat p = moser_veselov_increment(corrected_moments(moments, correction), m, dt);
  return {unit(product(spin.world_from_body, p)), turned(p.conjugate(), m).cwiseQuotient(moments)};
}

MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt) {
  // eq. (26) by the elementary symmetric polynomials of 1/I_i, and twice H and C times dt².
  const Vec3 r = moments.cwiseInverse();
  const double pairs = r.y() * r.z() + r.z() * r.x() + r.x() * r.y();
  const Vec3 turn = dt * spin.angular_velocity_body;
  const double energy = turn.cwiseAbs2().dot(moments);
  const double square = moments.cwiseProduct(turn).squaredNorm();
  return {(pairs * square - 2.0 * r.sum() * energy) / 12.0,
          (pairs * energy - 2.0 * r.prod() * square) / 12.0};
}

}  // namespace lab::gyroscopic_tumbling

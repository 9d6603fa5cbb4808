#include "proxy.hpp"

#include "remote.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

Vec3 checked_moments(const Vec3& moments) {
  return remote<&gyroscopic_tumbling::checked_moments>(moments);
}
Vec3 angular_acceleration(const Mat3& inertia, const Vec3& angular_velocity, const Vec3& torque) {
  return remote<&gyroscopic_tumbling::angular_acceleration>(inertia, angular_velocity, torque);
}
double rotational_energy(const Vec3& moments, const Spin& spin) {
  return remote<&gyroscopic_tumbling::rotational_energy>(moments, spin);
}
Vec3 angular_momentum(const Vec3& moments, const Spin& spin) {
  return remote<&gyroscopic_tumbling::angular_momentum>(moments, spin);
}
RigidBodyState step_explicit(const RigidBody& body, const RigidBodyState& state,
                             const std::vector<AppliedForce>& forces, double dt) {
  return remote<&gyroscopic_tumbling::step_explicit>(body, state, forces, dt);
}
Vec3 implicit_residual(const Vec3& moments, const Vec3& angular_velocity_body,
                       const Vec3& next_angular_velocity_body, double dt) {
  return remote<&gyroscopic_tumbling::implicit_residual>(moments, angular_velocity_body,
                                                         next_angular_velocity_body, dt);
}
Mat3 implicit_jacobian(const Vec3& moments, const Vec3& next_angular_velocity_body, double dt) {
  return remote<&gyroscopic_tumbling::implicit_jacobian>(moments, next_angular_velocity_body, dt);
}
Spin step_implicit(const Vec3& moments, const Spin& spin, double dt) {
  return remote<&gyroscopic_tumbling::step_implicit>(moments, spin, dt);
}
SpinRate spin_rate(const Vec3& moments, const Spin& spin) {
  return remote<&gyroscopic_tumbling::spin_rate>(moments, spin);
}
Spin step_rk4(const Vec3& moments, const Spin& spin, double dt) {
  return remote<&gyroscopic_tumbling::step_rk4>(moments, spin, dt);
}
Spin step_about_axis(const Vec3& moments, const Spin& spin, int axis, double dt) {
  return remote<&gyroscopic_tumbling::step_about_axis>(moments, spin, axis, dt);
}
Spin step_splitting(const Vec3& moments, const Spin& spin, double dt) {
  return remote<&gyroscopic_tumbling::step_splitting>(moments, spin, dt);
}
Vec3 weight_torque_body(const HeavyTop& top, const Quat& world_from_body) {
  return remote<&gyroscopic_tumbling::weight_torque_body>(top, world_from_body);
}
Spin step_kick_drift_kick(const HeavyTop& top, const Spin& spin, double dt) {
  return remote<&gyroscopic_tumbling::step_kick_drift_kick>(top, spin, dt);
}
Quat predicted_attitude(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  return remote<&gyroscopic_tumbling::predicted_attitude>(world_from_body, angular_velocity, dt);
}
Quat project(const Quat& q_pred) { return remote<&gyroscopic_tumbling::project>(q_pred); }
RigidBodyState step_constrained(const RigidBody& body, const RigidBodyState& state,
                                const std::vector<AppliedForce>& forces, double dt) {
  return remote<&gyroscopic_tumbling::step_constrained>(body, state, forces, dt);
}
Vec3 corrected_moments(const Vec3& moments, const MomentCorrection& correction) {
  return remote<&gyroscopic_tumbling::corrected_moments>(moments, correction);
}
Quat moser_veselov_increment(const Vec3& moments, const Vec3& angular_momentum_body, double dt) {
  return remote<&gyroscopic_tumbling::moser_veselov_increment>(moments, angular_momentum_body, dt);
}
Spin step_moser_veselov(const Vec3& moments, const MomentCorrection& correction, const Spin& spin,
                        double dt) {
  return remote<&gyroscopic_tumbling::step_moser_veselov>(moments, correction, spin, dt);
}
MomentCorrection fourth_order_correction(const Vec3& moments, const Spin& spin, double dt) {
  return remote<&gyroscopic_tumbling::fourth_order_correction>(moments, spin, dt);
}

}  // namespace lab::gyroscopic_tumbling

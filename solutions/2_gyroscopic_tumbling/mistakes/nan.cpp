// Returns NaN everywhere: every test must fail it, and say that the value is not finite.
#include <limits>

#include "gyroscopic_tumbling.hpp"

namespace lab::gyroscopic_tumbling {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 nan_vector = Vec3::Constant(nan);
const Mat3 nan_matrix = Mat3::Constant(nan);
const Quat nan_quaternion(nan, nan, nan, nan);
const Spin nan_spin = {nan_quaternion, nan_vector};
const RigidBodyState nan_state = {nan_vector, nan_quaternion, nan_vector, nan_vector};

}  // namespace

Vec3 checked_moments(const Vec3&) { return nan_vector; }
Vec3 angular_acceleration(const Mat3&, const Vec3&, const Vec3&) { return nan_vector; }
double rotational_energy(const Vec3&, const Spin&) { return nan; }
Vec3 angular_momentum(const Vec3&, const Spin&) { return nan_vector; }
RigidBodyState step_explicit(const RigidBody&, const RigidBodyState&,
                             const std::vector<AppliedForce>&, double) {
  return nan_state;
}
Vec3 implicit_residual(const Vec3&, const Vec3&, const Vec3&, double) { return nan_vector; }
Mat3 implicit_jacobian(const Vec3&, const Vec3&, double) { return nan_matrix; }
Spin step_implicit(const Vec3&, const Spin&, double) { return nan_spin; }
SpinRate spin_rate(const Vec3&, const Spin&) { return {nan_quaternion, nan_vector}; }
Spin step_rk4(const Vec3&, const Spin&, double) { return nan_spin; }
Spin step_about_axis(const Vec3&, const Spin&, int, double) { return nan_spin; }
Spin step_splitting(const Vec3&, const Spin&, double) { return nan_spin; }
Vec3 weight_torque_body(const HeavyTop&, const Quat&) { return nan_vector; }
Spin step_kick_drift_kick(const HeavyTop&, const Spin&, double) { return nan_spin; }
Quat predicted_attitude(const Quat&, const Vec3&, double) { return nan_quaternion; }
Quat project(const Quat&) { return nan_quaternion; }
RigidBodyState step_constrained(const RigidBody&, const RigidBodyState&,
                                const std::vector<AppliedForce>&, double) {
  return nan_state;
}
Vec3 corrected_moments(const Vec3&, const MomentCorrection&) { return nan_vector; }
Quat moser_veselov_increment(const Vec3&, const Vec3&, double) { return nan_quaternion; }
Spin step_moser_veselov(const Vec3&, const MomentCorrection&, const Spin&, double) {
  return nan_spin;
}
MomentCorrection fourth_order_correction(const Vec3&, const Spin&, double) { return {nan, nan}; }

}  // namespace lab::gyroscopic_tumbling

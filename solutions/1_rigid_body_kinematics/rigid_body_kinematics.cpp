#include "rigid_body_kinematics.hpp"

#include <cmath>

#include "common/algebra/linear_algebra.hpp"

namespace lab::rigid_body_kinematics {

Mat3 skew(const Vec3& w) {
  Mat3 matrix;
  matrix << 0.0, -w.z(), w.y(),  //
      w.z(), 0.0, -w.x(),        //
      -w.y(), w.x(), 0.0;
  return matrix;
}

Vec3 world_point(const RigidBodyState& state, const Vec3& point_body) {
  return state.position + state.world_from_body * point_body;
}

Vec3 body_point(const RigidBodyState& state, const Vec3& point) {
  return state.world_from_body.conjugate() * (point - state.position);
}

Vec3 point_velocity(const RigidBodyState& state, const Vec3& point) {
  const Vec3 r = point - state.position;
  return state.velocity + state.angular_velocity.cross(r);
}

Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body) {
  const Mat3 R = world_from_body.toRotationMatrix();
  return R * inertia_body * R.transpose();
}

Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces) {
  Wrench net;
  for (const AppliedForce& applied : forces) {
    const Vec3 r = applied.point - center_of_mass;
    net.force += applied.force;
    net.torque += r.cross(applied.force);
  }
  return net;
}

Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt) {
  return world_from_body + skew(dt * angular_velocity) * world_from_body;
}

Mat3 nearest_rotation(const Mat3& matrix) {
  auto [U, S, V] = common::singular_values(matrix);
  const double det = (U * V.transpose()).determinant();
  if (det < 0.0) U.col(2) = -U.col(2);  // flip the direction of the least singular value, S(2)
  return U * V.transpose();
}

Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  const Vec3& omega = angular_velocity;
  const Quat rate = Quat(0.0, omega.x(), omega.y(), omega.z()) * world_from_body;
  Quat next(world_from_body.coeffs() + 0.5 * dt * rate.coeffs());  // eq. (9)
  next.normalize();                                                // eq. (10)
  return next;
}

Quat exponential_map(const Vec3& rotation_vector) {
  const Vec3& a = rotation_vector;
  const double angle = std::hypot(a.x(), a.y(), a.z());  // a.norm() underflows below 1e-154
  if (angle == 0.0) return Quat::Identity();
  Quat turn;
  turn.w() = std::cos(0.5 * angle);
  turn.vec() = std::sin(0.5 * angle) * (a / angle);
  return turn;
}

Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  return exponential_map(dt * angular_velocity) * world_from_body;
}

}  // namespace lab::rigid_body_kinematics

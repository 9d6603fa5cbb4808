#include "proxy.hpp"

#include "remote.hpp"

namespace lab::rigid_body_kinematics {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

Mat3 skew(const Vec3& w) { return remote<&rigid_body_kinematics::skew>(w); }
Vec3 world_point(const RigidBodyState& state, const Vec3& point_body) {
  return remote<&rigid_body_kinematics::world_point>(state, point_body);
}
Vec3 body_point(const RigidBodyState& state, const Vec3& point) {
  return remote<&rigid_body_kinematics::body_point>(state, point);
}
Vec3 point_velocity(const RigidBodyState& state, const Vec3& point) {
  return remote<&rigid_body_kinematics::point_velocity>(state, point);
}
Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body) {
  return remote<&rigid_body_kinematics::world_inertia>(inertia_body, world_from_body);
}
Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces) {
  return remote<&rigid_body_kinematics::net_wrench>(center_of_mass, forces);
}
Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt) {
  return remote<&rigid_body_kinematics::step_matrix_euler>(world_from_body, angular_velocity, dt);
}
Mat3 nearest_rotation(const Mat3& matrix) {
  return remote<&rigid_body_kinematics::nearest_rotation>(matrix);
}
Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  return remote<&rigid_body_kinematics::step_quaternion_euler>(world_from_body, angular_velocity,
                                                               dt);
}
Quat exponential_map(const Vec3& rotation_vector) {
  return remote<&rigid_body_kinematics::exponential_map>(rotation_vector);
}
Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  return remote<&rigid_body_kinematics::step_exponential>(world_from_body, angular_velocity, dt);
}

}  // namespace lab::rigid_body_kinematics

// Returns NaN everywhere: every test must fail it, and say that the value is not finite.
#include <limits>

#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 nan_vector = Vec3::Constant(nan);
const Mat3 nan_matrix = Mat3::Constant(nan);
const Quat nan_quaternion(nan, nan, nan, nan);

}  // namespace

Mat3 skew(const Vec3&) { return nan_matrix; }
Vec3 world_point(const RigidBodyState&, const Vec3&) { return nan_vector; }
Vec3 body_point(const RigidBodyState&, const Vec3&) { return nan_vector; }
Vec3 point_velocity(const RigidBodyState&, const Vec3&) { return nan_vector; }
Mat3 world_inertia(const Mat3&, const Quat&) { return nan_matrix; }
Wrench net_wrench(const Vec3&, const std::vector<AppliedForce>&) {
  return {nan_vector, nan_vector};
}
Mat3 step_matrix_euler(const Mat3&, const Vec3&, double) { return nan_matrix; }
Mat3 nearest_rotation(const Mat3&) { return nan_matrix; }
Quat step_quaternion_euler(const Quat&, const Vec3&, double) { return nan_quaternion; }
Quat exponential_map(const Vec3&) { return nan_quaternion; }
Quat step_exponential(const Quat&, const Vec3&, double) { return nan_quaternion; }

}  // namespace lab::rigid_body_kinematics

#include <cmath>
#include <limits>
#include <random>

#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {

Mat3 skew(const Vec3& w) { return Mat3::Constant(std::numeric_limits<double>::infinity() + w.x()); }
Vec3 world_point(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::numeric_limits<double>::infinity()) + p + state.position;
}
Vec3 body_point(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::numeric_limits<double>::infinity()) + p + state.position;
}
Vec3 point_velocity(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::numeric_limits<double>::infinity()) + p + state.position;
}

}  // namespace lab::rigid_body_kinematics

#include <cmath>
#include <limits>
#include <random>

#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {

Mat3 skew(const Vec3& w) { return Mat3::Constant(std::nan("") + 0.0 * w.x()); }
Vec3 world_point(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::nan("")) + 0.0 * (state.position + p);
}
Vec3 body_point(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::nan("")) + 0.0 * (state.position + p);
}
Vec3 point_velocity(const RigidBodyState& state, const Vec3& p) {
  return Vec3::Constant(std::nan("")) + 0.0 * (state.position + p);
}

}  // namespace lab::rigid_body_kinematics

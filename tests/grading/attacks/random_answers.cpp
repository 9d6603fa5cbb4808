#include <cmath>
#include <limits>
#include <random>

#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {

static double draw() {
  static std::mt19937 engine(std::random_device{}());
  return std::uniform_real_distribution<double>(-2.0, 2.0)(engine);
}

Mat3 skew(const Vec3& w) { return draw() * Mat3::Ones() * w.asDiagonal(); }
Vec3 world_point(const RigidBodyState& state, const Vec3& p) {
  return draw() * (state.position + p);
}
Vec3 body_point(const RigidBodyState& state, const Vec3& p) {
  return draw() * (state.position + p);
}
Vec3 point_velocity(const RigidBodyState& state, const Vec3& p) {
  return draw() * (state.position + p);
}

}  // namespace lab::rigid_body_kinematics

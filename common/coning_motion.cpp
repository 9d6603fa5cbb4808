#include "common/coning_motion.hpp"

namespace common {
namespace {

Quat turned_by(const Vec3& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

}  // namespace

Vec3 angular_velocity(const ConingMotion& motion, double time) {
  return turned_by(motion.axis * (motion.rate * time)) * motion.angular_velocity;
}

Quat attitude(const ConingMotion& motion, double time) {
  const Vec3 relative = motion.angular_velocity - motion.rate * motion.axis;
  return turned_by(motion.axis * (motion.rate * time)) * turned_by(relative * time) *
         motion.world_from_body;
}

}  // namespace common

#include "common/rotation/coning_motion.hpp"

#include "common/rotation/attitude.hpp"

namespace common {

Vec3 angular_velocity(const ConingMotion& motion, double time) {
  return exponential_map(motion.axis * (motion.rate * time)) * motion.angular_velocity;
}

Quat attitude(const ConingMotion& motion, double time) {
  const Vec3 relative = motion.angular_velocity - motion.rate * motion.axis;
  return exponential_map(motion.axis * (motion.rate * time)) * exponential_map(relative * time) *
         motion.world_from_body;
}

}  // namespace common

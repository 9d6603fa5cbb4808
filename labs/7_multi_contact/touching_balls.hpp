#pragma once

#include <vector>

#include "multi_contact.hpp"

/// Balls of the scene and the charts, and where they touch.
namespace lab::multi_contact {

/// A ball of 1 kg. Without friction nothing turns it.
inline RigidBody ball_at(const Vec3& position, const Vec3& velocity) {
  return {1.0, Mat3::Zero(), position, velocity, Vec3::Zero()};
}

/// What stands and never moves: floors, walls, a cylinder, in one.
inline RigidBody immovable() {
  return {0.0, Mat3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
}

/// A contact that is closed or may close soon.
struct NearContact {
  Contact contact;
  double gap = 0.0;  ///< [m]
};

/// All pairs of balls that are nearer than `reach`, from body `first` on.
inline std::vector<NearContact> near_balls(const std::vector<RigidBody>& bodies, std::size_t first,
                                           double radius, double reach) {
  const double most = 2.0 * radius + reach;
  std::vector<NearContact> found;
  for (std::size_t b = first; b < bodies.size(); ++b) {
    for (std::size_t a = first; a < b; ++a) {
      const Vec3 apart = bodies[b].position - bodies[a].position;
      if (!(apart.squaredNorm() < most * most)) continue;
      const double distance = apart.norm();
      const Vec3 normal = apart / distance;
      found.push_back({{static_cast<int>(a), static_cast<int>(b),
                        bodies[a].position + 0.5 * distance * normal, normal},
                       distance - 2.0 * radius});
    }
  }
  return found;
}

}  // namespace lab::multi_contact

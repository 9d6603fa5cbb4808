#pragma once

#include <vector>

#include "common/types.hpp"

namespace common {

/// A rigid body as an impact sees it. An immovable one has zero for both inverses.
struct RigidBody {
  double inverse_mass = 1.0;                ///< zero or above [1/kg]
  Mat3 inverse_inertia = Mat3::Identity();  ///< world frame [1/(kg m²)]; symmetric to 1e-9 of its
                                            ///< largest entry, none on the diagonal below zero
  Vec3 position = Vec3::Zero();             ///< centre of mass [m]
  Vec3 velocity = Vec3::Zero();             ///< of the centre of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();     ///< world frame [rad/s]
};

/// Throws std::invalid_argument if an entry of the body is NaN or infinite, or is not what stands
/// above.
void require_body(const RigidBody& body);
void require_bodies(const std::vector<RigidBody>& bodies);
/// The same if these are not the numbers of two different bodies, or if neither can move.
void require_pair(const std::vector<RigidBody>& bodies, int a, int b);

}  // namespace common

#pragma once

#include "common/types.hpp"

namespace common {

/// An infinite cylinder about the world's x axis.
struct Cylinder {
  double radius = 1.0;  ///< R, above zero [m]
};

/// The contact of a particle, which is a small ball, with the cylinder, in the world frame.
struct ParticleContact {
  Vec3 point_on_cylinder = Vec3::Zero();  ///< nearest to the particle [m]
  Vec3 point_on_particle = Vec3::Zero();  ///< nearest to the axis [m]
  Vec3 normal = Vec3::UnitY();            ///< unit, from the cylinder to the particle
  double gap = 0.0;                       ///< between the two points along the normal [m]
  double time = 0.0;                      ///< of the contact [s]
};

}  // namespace common

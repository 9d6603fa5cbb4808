#pragma once

#include <optional>
#include <variant>

#include "common/contact/particle_contact.hpp"
#include "common/types.hpp"

namespace common {

/// Everything below the plane is solid.
struct Plane {
  Vec3 point = Vec3::Zero();    ///< on the plane, world [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the solid
};

/// What a particle can hit. It does not move. A particle is a point: add a ball's radius to R.
using Obstacle = std::variant<Plane, Cylinder>;

/// Throws std::invalid_argument if an entry is NaN or infinite, if a radius is not above zero or if
/// a normal is not of length one. The functions below require a valid obstacle.
void require_valid(const Obstacle& obstacle);

/// Returns the distance from the surface [m], below zero inside.
double gap(const Obstacle& obstacle, const Vec3& position);

/// Returns the gradient of the gap: unit, out of the solid, and +y on a cylinder's axis.
Vec3 outward_normal(const Obstacle& obstacle, const Vec3& position);

/// A flight under a constant acceleration: x + t v + ½ t² a.
struct Flight {
  Vec3 position = Vec3::Zero();      ///< [m]
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< [m/s²]
};

Vec3 position_at(const Flight& flight, double time);
Vec3 velocity_at(const Flight& flight, double time);

/// Returns the first t in [0, dt] from which on the flight is at a gap of zero or below and moves
/// inwards, n·v < 0, or none. A start that touches or is inside and moves outwards is no impact. A
/// flight that turns round inside has an impact there. A flight that only touches in passing has
/// none.
///
/// It decides and solves with about 30 digits, from the numbers as given, and rounds at the end.
std::optional<double> time_of_impact(const Obstacle& obstacle, const Flight& flight, double dt);

}  // namespace common

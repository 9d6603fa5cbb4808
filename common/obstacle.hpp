#pragma once

#include <optional>
#include <variant>

#include "common/particle_contact.hpp"
#include "common/types.hpp"

namespace common {

/// Everything below it is solid.
struct Plane {
  Vec3 point = Vec3::Zero();    ///< on the plane, world [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit, out of the solid
};

/// What a particle can hit; it does not move. A particle is a point: a ball's radius goes to R.
using Obstacle = std::variant<Plane, Cylinder>;

/// Throws std::invalid_argument where an entry is NaN or infinite, a radius not above zero or a
/// normal not of length one. The functions below take an obstacle for valid.
void require_valid(const Obstacle& obstacle);

/// Distance from the surface [m]: below zero inside.
double gap(const Obstacle& obstacle, const Vec3& position);

/// The gradient of the gap: unit, out of the solid; +y on a cylinder's axis.
Vec3 outward_normal(const Obstacle& obstacle, const Vec3& position);

/// A flight under a constant acceleration: x + t v + ½ t² a.
struct Flight {
  Vec3 position = Vec3::Zero();      ///< [m]
  Vec3 velocity = Vec3::Zero();      ///< [m/s]
  Vec3 acceleration = Vec3::Zero();  ///< [m/s²]
};

Vec3 position_at(const Flight& flight, double time);
Vec3 velocity_at(const Flight& flight, double time);

/// The first t in [0, dt] from which on the flight is at a gap of zero or below and moves inwards,
/// n·v < 0; none where there is none. A start that touches or is inside and parts is no impact; one
/// that turns round inside has one there, and one that touches in passing has none.
///
/// Decided and solved in some 30 digits from the numbers as given, then rounded.
std::optional<double> time_of_impact(const Obstacle& obstacle, const Flight& flight, double dt);

}  // namespace common

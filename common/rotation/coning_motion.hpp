#pragma once

#include "common/types.hpp"

namespace common {

/// An angular velocity that turns about a fixed axis at a constant rate and keeps its length. It is
/// the classic test of attitude integration, because its attitude has a closed form.
///
///   ω(t) = exp([a]ₓ Ω t) ω(0)
///
/// All are in the world frame.
struct ConingMotion {
  Vec3 axis = Vec3::UnitZ();                ///< a, unit
  double rate = 1.0;                        ///< Ω [rad/s]
  Vec3 angular_velocity = Vec3::UnitX();    ///< ω(0) [rad/s]
  Quat world_from_body = Quat::Identity();  ///< q(0), unit
};

/// Returns ω(t), world [rad/s].
Vec3 angular_velocity(const ConingMotion& motion, double time);

/// Returns q(t), unit. In axes that turn with ω, the body turns at the constant ω(0) − Ω a, so
///
///   q(t) = exp(a Ω t) exp((ω(0) − Ω a) t) q(0)
Quat attitude(const ConingMotion& motion, double time);

}  // namespace common

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "common/rotation/free_rotation.hpp"
#include "scene_particles.hpp"

/// The right side of the scene: a brick that hits the cylinder, and flies freely between impacts.
namespace lab::impulse_response {

inline const Vec3 half_extents(0.6, 0.32, 0.2);
inline constexpr double brick_mass = 2.0;
inline constexpr Material clay{0.4, 0.3};

inline Vec3 brick_moments() {
  const Vec3 squares = half_extents.cwiseAbs2();
  return brick_mass / 3.0 * (Vec3::Constant(squares.sum()) - squares);
}

/// A flight from one impact to the next, in closed form.
struct BrickFlight {
  double start;  ///< [s]
  common::Flight center;
  common::FreeRotation rotation;

  [[nodiscard]] Vec3 position(double time) const {
    return common::position_at(center, time - start);
  }
  [[nodiscard]] Mat3 attitude(double time) const {
    return rotation.at(time - start).world_from_body.toRotationMatrix();
  }
  [[nodiscard]] RigidBody body(double time) const {
    const common::Spin spin = rotation.at(time - start);
    const Mat3 R = spin.world_from_body.toRotationMatrix();
    return {1.0 / brick_mass, R * brick_moments().cwiseInverse().asDiagonal() * R.transpose(),
            position(time), common::velocity_at(center, time - start),
            R * spin.angular_velocity_body};
  }
};

/// Returns the flight after an impact.
inline BrickFlight flight_of(double time, const RigidBody& body, const Mat3& R) {
  return {time,
          {body.position, body.velocity, gravity},
          {brick_moments(), {common::Quat(R), R.transpose() * body.angular_velocity}}};
}

/// The place at which the brick is nearest to something, and its distance.
struct BrickContact {
  double gap = std::numeric_limits<double>::infinity();
  Contact contact;
  bool on_cylinder = false;
};

/// Returns the point of a segment that is nearest to the x axis.
inline Vec3 nearest_to_axis(const Vec3& a, const Vec3& b) {
  const Vec3 along = Vec3::UnitX().cross(b - a);  // turned by a right angle in the y-z plane
  const double length_squared = along.squaredNorm();
  if (length_squared == 0.0) return 0.5 * (a + b);
  const double t = -Vec3::UnitX().cross(a).dot(along) / length_squared;
  return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

/// Along the axis the brick looks like a convex polygon. Its sides are edges of the brick, so an
/// edge is nearest to the axis, and a corner is nearest to the ground.
inline BrickContact nearest_contact(const Vec3& position, const Mat3& R) {
  const auto corner = [&](int i) -> Vec3 {
    const Vec3 signs((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0,
                     (i & 4) != 0 ? 1.0 : -1.0);
    return position + R * signs.cwiseProduct(half_extents);
  };
  BrickContact nearest;
  const auto offer = [&](const Obstacle& obstacle, const Vec3& point, bool on_cylinder) {
    const double gap = common::gap(obstacle, point);
    if (gap >= nearest.gap) return;
    nearest = {gap, {point, common::outward_normal(obstacle, point)}, on_cylinder};
  };
  for (int i = 0; i < 8; ++i) {
    offer(ground, corner(i), false);
    for (const int bit : {1, 2, 4}) {
      if ((i & bit) == 0) offer(cylinder, nearest_to_axis(corner(i), corner(i | bit)), true);
    }
  }
  return nearest;
}

struct BrickImpact {
  double time;
  Contact contact;
  Vec3 impulse;  ///< that the brick receives [N s]
  bool on_cylinder;
};

struct BrickPose {
  Vec3 position;
  Mat3 attitude;
};

/// The brick through the whole film.
struct Tumble {
  std::vector<BrickPose> frames;
  std::vector<BrickImpact> impacts;
  double first_energy_before = 0.0;  ///< at the first impact [J], kinetic
  double first_energy_after = 0.0;
  double momentum_error = 0.0;  ///< largest share by which an impact changes the angular momentum
                                ///< about the contact, which it should not change
  double deepest = 0.0;         ///< by which the brick is inside at a step's end [m]
};

inline double kinetic_energy(const RigidBody& body) {
  const Vec3& w = body.angular_velocity;
  return 0.5 * brick_mass * body.velocity.squaredNorm() +
         0.5 * w.dot(body.inverse_inertia.inverse() * w);
}

inline Vec3 momentum_about(const RigidBody& body, const Vec3& point) {
  return brick_mass * (body.position - point).cross(body.velocity) +
         body.inverse_inertia.inverse() * body.angular_velocity;
}

/// Returns the brick after an impact at a time, by the contract's functions.
inline BrickFlight hit(const BrickFlight& flight, double time, Tumble& tumble) {
  RigidBody immovable;
  immovable.inverse_mass = 0.0;
  immovable.inverse_inertia.setZero();
  const Mat3 R = flight.attitude(time);
  const RigidBody before = flight.body(time);
  const BrickContact at = nearest_contact(before.position, R);
  const Vec3 impulse = contact_impulse(immovable, before, at.contact, clay);
  const RigidBody after = with_impulse(before, impulse, at.contact.point);

  const Vec3 kept = momentum_about(before, at.contact.point);
  const Vec3 changed = momentum_about(after, at.contact.point) - kept;
  tumble.momentum_error = std::max(tumble.momentum_error, changed.norm() / kept.norm());
  if (tumble.impacts.empty()) {
    tumble.first_energy_before = kinetic_energy(before);
    tumble.first_energy_after = kinetic_energy(after);
  }
  tumble.impacts.push_back({time, at.contact, impulse, at.on_cylinder});
  return flight_of(time, after, R);
}

/// Returns the time of impact between two times, outside at the first and inside at the second.
inline double bisected(const BrickFlight& flight, double outside, double inside) {
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (outside + inside);
    const bool is_outside =
        nearest_contact(flight.position(middle), flight.attitude(middle)).gap >= 0.0;
    (is_outside ? outside : inside) = middle;
  }
  return outside;
}

/// Lets the brick fall, one corner first, beside the axis.
inline BrickFlight brick_start() {
  const common::Quat leaning = common::Quat(Eigen::AngleAxisd(-0.5, Vec3::UnitY())) *
                               common::Quat(Eigen::AngleAxisd(0.25, Vec3::UnitX()));
  RigidBody body;
  body.position = {1.75, -0.15, 2.45};
  body.velocity = {0.0, 0.0, 0.0};
  return flight_of(0.0, body, leaning.toRotationMatrix());
}

/// Returns nothing, and adds an entry to `missing`, if an impulse is not written yet.
inline std::optional<Tumble> tumbled(std::vector<std::string>& missing) {
  constexpr int substeps = 40;  // for each frame, of a millisecond
  return common::if_written(missing, [&] {
    Tumble tumble;
    BrickFlight flight = brick_start();
    double last = 0.0;
    double last_gap = nearest_contact(flight.position(0.0), flight.attitude(0.0)).gap;
    for (int i = 0; i <= frames * substeps; ++i) {
      const double time = i * frame_time / substeps;
      BrickContact at = nearest_contact(flight.position(time), flight.attitude(time));
      const RigidBody body = flight.body(time);
      const Vec3 lever = at.contact.point - body.position;
      const Vec3 u = body.velocity + body.angular_velocity.cross(lever);
      if (at.gap < 0.0 && at.contact.normal.dot(u) < 0.0) {
        const double impact = last_gap >= 0.0 ? bisected(flight, last, time) : time;
        flight = hit(flight, impact, tumble);
        at = nearest_contact(flight.position(time), flight.attitude(time));
      }
      tumble.deepest = std::max(tumble.deepest, -at.gap);
      last = time;
      last_gap = at.gap;
      if (i % substeps == 0) {
        tumble.frames.push_back({flight.position(time), flight.attitude(time)});
      }
    }
    return tumble;
  });
}

}  // namespace lab::impulse_response

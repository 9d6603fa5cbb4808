#pragma once

#include <vector>

#include "oracle.hpp"

/// The scenes whose outcomes are pinned, as numbers and, for step 7.1, as bodies.
namespace tests {

/// Bodies by the few velocities that matter. Each of these has a mass or an inertia of its own.
struct Scene {
  Matrix J;  ///< u = J v
  Vector W;  ///< inverse masses and inertias
  Vector v;

  /// A = J W Jᵀ and u = J v.
  [[nodiscard]] ContactSystem system() const;
  /// v + W Jᵀ λ.
  [[nodiscard]] Vector after(const Vector& lambda) const;
  /// Half of the sum of v²/W, with these velocities.
  [[nodiscard]] double energy(const Vector& velocities) const;
  /// The sum of v/W: of balls in a row.
  [[nodiscard]] double momentum(const Vector& velocities) const;
  /// The same contacts, worked on from the last to the first.
  [[nodiscard]] Scene backwards() const;
};

/// Balls along x that touch, contact i between i and i + 1.
Scene row_of_balls(const Vector& masses, const Vector& velocities);
/// As many of mass 1.
Scene cradle(const Vector& velocities);
/// Balls on the ground, one on top of the other, contact i below ball i; above zero is upwards.
Scene column(const Vector& masses, const Vector& velocities);
/// Mass 1, supports at ±1 along x, v = (upwards, w): u = (v − w, v + w).
Scene rod(double inertia, double upwards, double w);
/// The rod of inertia 3 that zones pull: v = (−5/4, 3/4), A = [4 2; 2 4]/3.
Scene dumb_bell();
/// Mass 1, both inertias 1/3, legs at (1, 1), (1, −1), (−1, 1), (−1, −1): A is singular.
Scene table(const Vector& velocities);
/// A ball hits two that touch, normals (4/5, ±3/5); v has x and y of it, of the upper, of the
/// lower.
Scene break_shot();
/// A point of mass 1 between two planes with these normals, in a plane.
Scene wedge(const Vector& first_normal, const Vector& second_normal, const Vector& velocity);
/// A ball of mass 1 that touches two opposite walls and moves at −1: u = (−1, 1).
Scene jammed_ball();
/// m at rest at a wall at its left, M comes from its right at 1: Galperin's billiards.
Scene counting_pi(double mass_ratio);

struct Bodies {
  std::vector<RigidBody> bodies;
  std::vector<Contact> contacts;
};

RigidBody immovable();
/// Balls of radius 1/2 along x from the origin.
Bodies row_of_balls_as_bodies(const Vector& masses, const Vector& velocities);
/// Along z, on the ground, which is body 0 and at the origin.
Bodies column_as_bodies(const Vector& masses, const Vector& velocities);
/// Body 1 on the ground, body 0. It turns about y by −w.
Bodies rod_as_bodies(double inertia, double upwards, double w);
/// Body 1 on the ground, body 0; v as in `table`.
Bodies table_as_bodies(const Vector& velocities);

}  // namespace tests

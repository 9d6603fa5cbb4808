#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/contact/particle_contact.hpp"
#include "common/types.hpp"

/// The contract of lab 3. A cylinder has the radius R and is infinite along x. A particle is a ball
/// of radius r about its position. Everything is in the world frame and in SI units.
///
///   φ  gap: the distance between the two surfaces, negative inside [m]
///   ρ  R + r [m]
///
/// Every function throws std::invalid_argument if an argument is NaN or infinite, if a radius is
/// not above zero, or if an argument breaks a requirement stated below.
namespace lab::discrete_particle_cylinder {

using common::Cylinder;
using common::ParticleContact;
using common::Vec3;

/// Returns the gap φ = √(y² + z²) − (R + r) [m]: > 0 apart, 0 touching, < 0 inside.  eq. (1)
///
/// accuracy  a few ulp of √(y² + z²) and of ρ, for lengths from 1e-300 to 1e300
double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder);

/// Returns the gap's gradient (0, y, z)/√(y² + z²), a unit vector away from the axis.  eq. (2)
///
/// On the axis the gap has no gradient, so the result is +y there.
/// accuracy  a few ulp, for lengths from 1e-300 to 1e300
Vec3 gap_gradient(const Vec3& position);

/// Returns the contact if the gap is zero or below, and none otherwise.            eq. (3)
///
/// Both points are on the line through the particle's centre that meets the axis at a right angle.
/// One is R from the axis, the other r from the centre towards the axis. `time` is passed on.
std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time);

/// Returns the indices of all particles whose gap is zero or below, in rising order.
///
/// The number of allocations does not grow with the number of particles.
std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder);

/// A particle on a straight path: position + t velocity for t from 0 to duration.
struct StraightPath {
  Vec3 position = Vec3::Zero();  ///< at t = 0 [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  double duration = 1.0;         ///< zero or above [s]
};

/// Returns the contact at the first of the times k duration/N, k = 0, 1, …, N, at which the gap is
/// zero or below. Returns none if the gap is above zero at all of these times, whatever happens in
/// between.                                                                        eq. (4)
///
/// samples  N, at least 1
std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder);

/// The gap of an edge or a triangle that is as thick as its particles, and the place of that gap.
struct EdgeGap {
  double gap = 0.0;       ///< the least over the edge [m]
  double fraction = 0.0;  ///< at a + fraction (b − a), in [0, 1]
};
struct TriangleGap {
  double gap = 0.0;              ///< the least over the triangle [m]
  Vec3 weights = Vec3::UnitX();  ///< at w₀ a + w₁ b + w₂ c; none below 0, their sum 1
};

/// Returns the least gap along the edge from a to b. In the yz-plane it is the distance of a
/// segment from the origin, less ρ.                                                eq. (5)
///
/// If several places are equally near (as on an edge along x), it returns any of them. An edge with
/// a = b is a particle.
/// accuracy  a few ulp of the ends' distances from the axis and of ρ, for lengths as in gap
EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder);

/// Returns the least gap over the triangle. In the yz-plane it is the distance of a triangle from
/// the origin, less ρ. It is −ρ if the axis goes through the triangle.             eq. (6)
///
/// If several places are equally near, it returns any of them. If the triangle looks like a segment
/// or a point in the yz-plane, its edges count.
/// accuracy  as in edge_gap; if the axis goes through a sliver, its weights may be less accurate
TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder);

/// A sheet of cloth: particles that are joined to edges and triangles by their indices.
struct Sheet {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, 3>> triangles;
  double particle_radius = 0.01;  ///< r, half of the cloth's thickness [m]
};

/// The parts of a sheet that touch the cylinder or are inside it, by three checks; indices rise.
struct SheetContacts {
  std::vector<std::size_t> particles;
  std::vector<std::size_t> edges;
  std::vector<std::size_t> triangles;
};

/// Returns all particles, edges and triangles whose gap is zero or below.
///
/// Also throws std::invalid_argument if an edge or a triangle has an index that is no particle's.
SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder);

/// Returns the least margin m for which it is enough to check the particles. That is: if no edge of
/// a sheet is longer than h, and all particles have a gap above m, then no edge and no triangle has
/// a gap of zero or below.                                                         eq. (7), (8)
///
/// m = max(√(ρ² + h²/4), h/√3) − ρ [m]. The second term is the greater one if h > 2√3 ρ: then a
/// cylinder can pierce an equilateral triangle without touching its edges.
/// longest_edge  h, zero or above [m]
/// accuracy      a few ulp of ρ + h
double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder);

}  // namespace lab::discrete_particle_cylinder

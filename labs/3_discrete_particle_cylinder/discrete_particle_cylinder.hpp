#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "common/particle_contact.hpp"
#include "common/types.hpp"

/// The contract of lab 3. A cylinder of radius R, infinite along x; a particle is a ball of radius
/// r about its position. World frame, SI units.
///
///   φ  gap: the distance between the two surfaces, negative inside [m]
///   ρ  R + r [m]
///
/// Every function throws std::invalid_argument where an argument is NaN or infinite, a radius is
/// not above zero, or something stated below is broken.
namespace lab::discrete_particle_cylinder {

using common::Cylinder;
using common::ParticleContact;
using common::Vec3;

/// The gap φ = √(y² + z²) − (R + r) [m]: > 0 apart, 0 touching, < 0 inside.        eq. (1)
///
/// accuracy  a few ulp of √(y² + z²) and of ρ, for lengths from 1e-300 to 1e300
double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder);

/// The gradient of the gap, (0, y, z)/√(y² + z²): unit, away from the axis.        eq. (2)
///
/// On the axis, where the gap has no gradient: +y. A few ulp, for lengths from 1e-300 to 1e300.
Vec3 gap_gradient(const Vec3& position);

/// The contact, where the gap is zero or below; none otherwise.                    eq. (3)
///
/// Both points stand on the line through the particle's centre and across the axis: R from the
/// axis, and r from the centre towards it. `time` is passed on.
std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time);

/// Indices of all particles whose gap is zero or below, in rising order.
///
/// The number of allocations does not grow as the number of particles does.
std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder);

/// A particle that moves straight on: position + t velocity for t from 0 to duration.
struct StraightPath {
  Vec3 position = Vec3::Zero();  ///< at t = 0 [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
  double duration = 1.0;         ///< zero or above [s]
};

/// The contact at the first of the times k duration/N, k = 0, 1, …, N, at which the gap is zero or
/// below; none where it is above zero at all of them, whatever happens in between. eq. (4)
///
/// samples  N, at least 1
std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder);

/// The gap of an edge or a triangle as thick as its particles, and where it is.
struct EdgeGap {
  double gap = 0.0;       ///< the least over the edge [m]
  double fraction = 0.0;  ///< where: a + fraction (b − a), in [0, 1]
};
struct TriangleGap {
  double gap = 0.0;              ///< the least over the triangle [m]
  Vec3 weights = Vec3::UnitX();  ///< where: w₀ a + w₁ b + w₂ c; none below 0, their sum 1
};

/// The least gap along the edge from a to b: in the yz-plane, the distance of a segment from the
/// origin, less ρ.                                                                 eq. (5)
///
/// Several places may be equally near (an edge along x): any of them. a = b is a particle.
/// accuracy  a few ulp of the ends' distances from the axis and of ρ, for lengths as in gap
EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder);

/// The least gap over the triangle: in the yz-plane, the distance of a triangle from the origin,
/// less ρ; −ρ where the axis goes through it.                                      eq. (6)
///
/// Several places may be equally near: any of them. A triangle that the yz-plane shows as a segment
/// or a point is its edges.
/// accuracy  as in edge_gap; where the axis goes through, the weights of a sliver may be less sure
TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder);

/// A sheet of cloth: particles, joined to edges and triangles by their indices.
struct Sheet {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, 3>> triangles;
  double particle_radius = 0.01;  ///< r, half of the cloth's thickness [m]
};

/// What of a sheet touches the cylinder or is inside it, checked in three ways; indices rise.
struct SheetContacts {
  std::vector<std::size_t> particles;
  std::vector<std::size_t> edges;
  std::vector<std::size_t> triangles;
};

/// All particles, edges and triangles whose gap is zero or below.
///
/// Also throws std::invalid_argument where an edge or a triangle has an index of no particle.
SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder);

/// How far off particles must be held so that checking them is enough: the least m such that a
/// sheet whose edges are not longer than h, and whose particles all have a gap above m, has no edge
/// and no triangle with a gap of zero or below.                                    eq. (7), (8)
///
/// m = max(√(ρ² + h²/4), h/√3) − ρ [m]: the second where h > 2√3 ρ, when a cylinder can pierce an
/// equilateral triangle without touching its edges. To a few ulp of ρ + h.
/// longest_edge  h, zero or above [m]
double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder);

}  // namespace lab::discrete_particle_cylinder

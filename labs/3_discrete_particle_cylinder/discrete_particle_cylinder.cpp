// Lab 3: the file you fill in and hand in. The contract of each function is in the header beside
// it, the geometry and the numbered equations are in README.md. Test with:  ./tumble test 3
//
// Every function checks what it is given first; the calls stand ready in common/require.hpp.
#include "discrete_particle_cylinder.hpp"

#include "common/not_implemented.hpp"
#include "common/require.hpp"

namespace lab::discrete_particle_cylinder {

// ---- Step 3.1 ----

double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.1, eq. (1)
  // 1. Check: the position is finite, both radii are above zero.
  // 2. The distance from the axis: std::hypot neither overflows at 1e200 nor vanishes at 1e-200.
  // 3. Two surfaces face each other, so two radii go off.
  throw common::NotImplemented("3.1 gap");
}

Vec3 gap_gradient(const Vec3& position) {
  // TODO step 3.1, eq. (2)
  // 1. Check the position.
  // 2. On the axis every direction is as good: +y.
  // 3. Elsewhere: away from the axis, unit.
  throw common::NotImplemented("3.1 gap_gradient");
}

// ---- Step 3.2 ----

std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time) {
  // TODO step 3.2, eq. (3)
  // 1. Check the time too.
  // 2. Apart: return std::nullopt. Is a gap of zero apart?
  // 3. The normal is the gradient of the gap.
  // 4. On the cylinder: at the particle's x, R from the axis along the normal.
  // 5. On the particle: r from its centre, on the side that faces the axis.
  throw common::NotImplemented("3.2 contact");
}

// ---- Step 3.3 ----

std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.3
  // 1. Check the radii once and every position.
  // 2. A list that grows is moved again and again: reserve its room first, or count in a first
  // pass.
  // 3. Keep the indices whose gap is zero or below.
  throw common::NotImplemented("3.3 particles_in_contact");
}

// ---- Step 3.4 ----

std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder) {
  // TODO step 3.4, eq. (4)
  // 1. Check: at least one sample, a duration of zero or above, all else finite.
  // 2. For k = 0, 1, ..., N, the start and the end among them: where is the particle at k T/N?
  // 3. Return the first contact found there, none after the last.
  throw common::NotImplemented("3.4 first_sampled_contact");
}

// ---- Step 3.5 ----

EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.5, eq. (5)
  // 1. Forget x: the edge is a segment in the yz-plane, the axis is its origin.
  // 2. A segment without length (an edge along x, or a = b) is a point.
  // 3. Divide the segment's vector by its length (std::hypot) before you multiply: no squares.
  // 4. How far along it is the foot of the origin? Not before a, not beyond b.
  // 5. The gap is that point's.
  throw common::NotImplemented("3.5 edge_gap");
}

TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder) {
  // TODO step 3.5, eq. (6)
  // 1. In the yz-plane the cross products b x c, c x a and a x b are twice the areas of the
  //    triangles that the axis makes with each edge.
  // 2. None of another sign and not all zero: the axis goes through, the areas' shares are the
  //    weights. Mind products of numbers of 1e200: scale all by one power of two.
  // 3. In a sliver an area may be all rounding, and so may its sign: take a b - c d by std::fma, or
  //    call an area of that size none.
  // 4. Else the least of the three edges, an edge's fraction as weights of its ends.
  throw common::NotImplemented("3.5 triangle_gap");
}

// ---- Step 3.6 ----

SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder) {
  // TODO step 3.6
  // 1. The particles: step 3.3.
  // 2. Edges and triangles: step 3.5, each index checked before it is used.
  throw common::NotImplemented("3.6 sheet_contacts");
}

double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.6, eq. (7) and (8)
  // 1. Where must both ends of an edge of length h be, so that its middle just touches?
  // 2. Where may the corners of an equilateral triangle be while the axis goes through its centre?
  // 3. The farther of the two, less rho: a margin is a gap.
  throw common::NotImplemented("3.6 particle_margin");
}

}  // namespace lab::discrete_particle_cylinder

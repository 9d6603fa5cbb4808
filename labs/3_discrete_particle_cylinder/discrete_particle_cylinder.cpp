// Lab 3: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the geometry and the numbered equations. Test your file with:  ./tumble test 3
//
// Every function checks its arguments first. common/course/require.hpp has the calls for that.
#include "discrete_particle_cylinder.hpp"

#include "common/course/not_implemented.hpp"
#include "common/course/require.hpp"

namespace lab::discrete_particle_cylinder {

// ---- Step 3.1 ----

double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.1, eq. (1)
  // 1. Check that the position is finite and that both radii are above zero.
  // 2. Compute the distance from the axis. std::hypot neither overflows at 1e200 nor gives zero at
  //    1e-200.
  // 3. The gap is between two surfaces, so subtract both radii.
  throw common::NotImplemented("3.1 gap");
}

Vec3 gap_gradient(const Vec3& position) {
  // TODO step 3.1, eq. (2)
  // 1. Check the position.
  // 2. On the axis every direction is equally good: return +y.
  // 3. Elsewhere return the unit vector away from the axis.
  throw common::NotImplemented("3.1 gap_gradient");
}

// ---- Step 3.2 ----

std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time) {
  // TODO step 3.2, eq. (3)
  // 1. Check the time too.
  // 2. If they are apart, return std::nullopt. Does a gap of zero mean apart?
  // 3. The normal is the gradient of the gap.
  // 4. The point on the cylinder is at the particle's x, and R from the axis along the normal.
  // 5. The point on the particle is r from its centre, on the side that faces the axis.
  throw common::NotImplemented("3.2 contact");
}

// ---- Step 3.3 ----

std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.3
  // 1. Check the radii once and every position.
  // 2. A list that grows moves its entries again and again. Reserve its room first, or count in a
  //    first pass.
  // 3. Keep the indices whose gap is zero or below.
  throw common::NotImplemented("3.3 particles_in_contact");
}

// ---- Step 3.4 ----

std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder) {
  // TODO step 3.4, eq. (4)
  // 1. Check that there is at least one sample, that the duration is zero or above, and that all
  //    else is finite.
  // 2. Where is the particle at k T/N, for k = 0, 1, ..., N? Include the start and the end.
  // 3. Return the first contact that you find, and none after the last sample.
  throw common::NotImplemented("3.4 first_sampled_contact");
}

// ---- Step 3.5 ----

EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.5, eq. (5)
  // 1. Ignore x: the edge is a segment in the yz-plane, and the axis is the origin.
  // 2. A segment without length (an edge along x, or a = b) is a point.
  // 3. Divide the segment's vector by its length (std::hypot) before you multiply, to avoid
  //    squares.
  // 4. How far along the segment is the foot of the origin? Clamp it to the ends a and b.
  // 5. Return the gap of that point.
  throw common::NotImplemented("3.5 edge_gap");
}

TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder) {
  // TODO step 3.5, eq. (6)
  // 1. In the yz-plane the cross products b x c, c x a and a x b are twice the areas of the
  //    triangles that the axis makes with each edge.
  // 2. If they are not all zero and no two have opposite signs, the axis goes through. Then the
  //    shares of the areas are the weights. Products of numbers near 1e200 overflow, so scale all
  //    numbers by one power of two.
  // 3. In a sliver an area and its sign may be nothing but rounding. Compute a b - c d by std::fma,
  //    or treat an area of that size as zero.
  // 4. Otherwise take the least of the three edges. Its fraction gives the weights of its ends.
  throw common::NotImplemented("3.5 triangle_gap");
}

// ---- Step 3.6 ----

SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder) {
  // TODO step 3.6
  // 1. Find the particles by step 3.3.
  // 2. Find edges and triangles by step 3.5, and check each index before you use it.
  throw common::NotImplemented("3.6 sheet_contacts");
}

double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder) {
  // TODO step 3.6, eq. (7) and (8)
  // 1. Where must both ends of an edge of length h be, so that its middle just touches?
  // 2. Where may the corners of an equilateral triangle be while the axis goes through its centre?
  // 3. Take the greater of the two distances, less rho, because a margin is a gap.
  throw common::NotImplemented("3.6 particle_margin");
}

}  // namespace lab::discrete_particle_cylinder

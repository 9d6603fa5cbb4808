// Lab 4: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the physics and the numbered equations. Test your file with:  ./tumble test 4
//
// You may include these headers, which are supplied:
//
//   common/course/require.hpp       checks of arguments that throw std::invalid_argument
//   common/exact/double_double.hpp  numbers of 106 bits; sums, products of doubles without rounding
//   common/exact/exact_number.hpp   numbers that are never rounded, for the few signs that need it
//   common/exact/bernstein.hpp      polynomials over an interval, halved without loss
//   common/exact/exact_roots.hpp    how many roots a polynomial has, counted without rounding
//   common/exact/exact_path.hpp     straight motions and their products as such polynomials
#include "continuous_particle_cylinder.hpp"

#include "common/course/not_implemented.hpp"

namespace lab::continuous_particle_cylinder {

// ---- Step 4.1 ----

std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt) {
  // TODO step 4.1, eq. (2) and (3)
  // 1. Check the arguments. common/course/require.hpp throws as the contract says.
  // 2. Compute a, b and c in the yz-plane, with ρ = R + r in c. If c ≤ 0, return 0.
  // 3. If there is no root, there is no impact. Beware of a = 0.
  // 4. Take the earlier root by the formula as it is, and return it if it is in [0, dt].
  throw common::NotImplemented("4.1 time_of_impact_textbook");
}

// ---- Step 4.2 ----

double difference_of_products(double a, double b, double c, double d) {
  // TODO step 4.2, eq. (4)
  // 1. Round c d. std::fma gives the rounding error of this product exactly.
  // 2. std::fma subtracts the rounded c d from a b with one rounding. Then correct it.
  throw common::NotImplemented("4.2 difference_of_products");
}

std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt) {
  // TODO step 4.2, eq. (5) and (6)
  // 1. For c, take the greater of y² and z², subtract ρ² by eq. (4), and add the other square. If
  //    |x| − ρ is not above zero by more than its rounding, return 0.
  // 2. The particle must approach: x·v is below zero.
  // 3. Compute the discriminant from ρ|v| and x × v. It is a miss if the discriminant is below zero
  //    by more than its rounding.
  // 4. Compute the root in the form in which nothing cancels.
  // 5. Its rounding may put it past dt, but you must not miss an impact at dt.
  throw common::NotImplemented("4.2 time_of_impact");
}

// ---- Step 4.3 ----

std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt) {
  // TODO step 4.3, eq. (7)
  // 1. Four signs decide: of c, of x·v, of the discriminant, and whether the root is past dt.
  // 2. Compute each in double-double with a bound on its error. If the bound is larger than the
  //    value, or if sizes leave the range of double-double, use common::ExactNumber.
  // 3. Only then compute the root in double-double and round it.
  throw common::NotImplemented("4.3 time_of_impact_certified");
}

Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance) {
  // TODO step 4.3, eq. (8)
  // 1. Start at t = 0. Evaluate φ and count it.
  // 2. If φ is within the tolerance, you are done.
  // 3. Otherwise no contact is possible before t + φ/|v|. Go there, unless that is past dt.
  // 4. If t + φ/|v| is t itself, because φ/|v| is too small for t to grow, you are done, too.
  throw common::NotImplemented("4.3 conservative_advancement");
}

// ---- Step 4.4 ----

ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  // TODO step 4.4, eq. (9)
  // 1. Move the particle to `time`.
  // 2. The normal is its direction from the axis in the yz-plane, or +y on the axis.
  // 3. Compute both points from the normal: then the last bits of `time` do not move them off the
  //    surfaces.
  throw common::NotImplemented("4.4 contact_at");
}

// ---- Step 4.5 ----

std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt) {
  // TODO step 4.5
  // 1. Check the arrays' lengths, then every number in them.
  // 2. Allocate the result once.
  // 3. First use step 4.3 particle by particle. Then ask which parts of it the same instructions
  //    can do for many particles.
  throw common::NotImplemented("4.5 times_of_impact");
}

// ---- Step 4.6 ----

std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  // TODO step 4.6, eq. (10) and (11)
  // 1. The ends are particles: use step 4.3.
  // 2. The inside touches when the line through the ends is ρ from the axis, a quartic in t.
  // 3. A root counts if the nearest point of the line is on the edge then. Take the first one.
  // 4. Do not miss a root because two are close. Halve the step until the signs of the quartic's
  //    coefficients in Bernstein's form decide, and if they cannot, count the roots exactly.
  throw common::NotImplemented("4.6 time_of_impact_of_edge");
}

}  // namespace lab::continuous_particle_cylinder

// Lab 4: the file you fill in and hand in. The contract of each function is in the header beside
// it, the physics and the numbered equations are in README.md. Test with:  ./tumble test 4
//
// Supplied, for you to include where you want them:
//   common/require.hpp        checks of arguments that throw std::invalid_argument
//   common/double_double.hpp  sums and products of doubles without rounding, and 106-bit numbers
//   common/exact_number.hpp   numbers that are never rounded, for the few decisions that need them
//   common/bernstein.hpp      polynomials over an interval, halved without loss
//   common/exact_roots.hpp    how many roots a polynomial has, counted without rounding
//   common/exact_path.hpp     straight motions and their products as such polynomials
#include "continuous_particle_cylinder.hpp"

#include "common/not_implemented.hpp"

namespace lab::continuous_particle_cylinder {

// ---- Step 4.1 ----

std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt) {
  // TODO step 4.1, eq. (2) and (3)
  // 1. Check the arguments: common/require.hpp throws what the contract says.
  // 2. Take a, b and c in the yz-plane, c with ρ = R + r. Where c ≤ 0 the answer is 0.
  // 3. No root, no impact; mind a = 0.
  // 4. Take the earlier root, as the formula has it, where it is in [0, dt].
  throw common::NotImplemented("4.1 time_of_impact_textbook");
}

// ---- Step 4.2 ----

double difference_of_products(double a, double b, double c, double d) {
  // TODO step 4.2, eq. (4)
  // 1. Round c d. std::fma gives what the rounding took away or added, exactly.
  // 2. std::fma subtracts the rounded c d from a b with one rounding. Then correct it.
  throw common::NotImplemented("4.2 difference_of_products");
}

std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt) {
  // TODO step 4.2, eq. (5) and (6)
  // 1. c: the greater of y² and z², less ρ², by eq. (4), and the other square. 0 where |x| − ρ is
  //    not above zero by more than its rounding.
  // 2. The particle must approach: x·v below zero.
  // 3. The discriminant from ρ|v| and x × v; below zero by more than its rounding is a miss.
  // 4. The root in which nothing cancels.
  // 5. It may be past dt by its rounding: an impact at dt must not be missed.
  throw common::NotImplemented("4.2 time_of_impact");
}

// ---- Step 4.3 ----

std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt) {
  // TODO step 4.3, eq. (7)
  // 1. Four signs decide: of c, of x·v, of the discriminant, and whether the root is past dt.
  // 2. Take each in double-double with a bound of its error; where the bound is larger than the
  //    value, and where sizes leave the range of double-double, take it by common::ExactNumber.
  // 3. Then, and only then, compute the root in double-double and round it.
  throw common::NotImplemented("4.3 time_of_impact_certified");
}

Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance) {
  // TODO step 4.3, eq. (8)
  // 1. Start at t = 0. Evaluate φ and count it.
  // 2. Within the tolerance: done.
  // 3. Else nothing can be touched before t + φ/|v|: go there, unless that is past dt.
  throw common::NotImplemented("4.3 conservative_advancement");
}

// ---- Step 4.4 ----

ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  // TODO step 4.4, eq. (9)
  // 1. Move the particle to `time`.
  // 2. The normal is its direction from the axis in the yz-plane, +y on the axis.
  // 3. Build both points from the normal, so that they are where they must be.
  throw common::NotImplemented("4.4 contact_at");
}

// ---- Step 4.5 ----

std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt) {
  // TODO step 4.5
  // 1. Check the arrays' lengths, then every number in them.
  // 2. Make room for the result once.
  // 3. First write down what step 4.3 gives, particle by particle. Then ask what of it can be done
  //    for many particles by the same instructions.
  throw common::NotImplemented("4.5 times_of_impact");
}

// ---- Step 4.6 ----

std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  // TODO step 4.6, eq. (10) and (11)
  // 1. The ends are particles: step 4.3.
  // 2. The inside touches where the line through the ends is ρ from the axis: a quartic in t.
  // 3. Of its roots the first counts at which the nearest point of the line is on the edge.
  // 4. A root must not be missed because two are close: halve the step until the signs of the
  //    quartic's coefficients in Bernstein's form tell, and count exactly where they cannot.
  throw common::NotImplemented("4.6 time_of_impact_of_edge");
}

}  // namespace lab::continuous_particle_cylinder

// Lab 7: the file you fill in and hand in. The contract of each function is in the header beside
// it, the physics and the numbered equations are in README.md. Test with:  ./tumble test 7
#include "multi_contact.hpp"

#include "common/course/not_implemented.hpp"
#include "common/course/require.hpp"

namespace lab::multi_contact {

// ---- Step 7.1 ----

ContactSystem contact_system(const std::vector<RigidBody>& bodies,
                             const std::vector<Contact>& contacts) {
  // TODO step 7.1, eq. (1)
  // 1. Check the bodies and the contacts: common::require_bodies and, for each contact,
  //    common::require_pair know what bodies have to be.
  // 2. u_i is the speed with which b's point leaves a's along the normal. Bodies move and turn.
  // 3. A has a row and a column for each contact. Give contact j an impulse of size 1: n on b,
  //    −n on a. Each of the two changes its velocity by its inverse mass times the impulse, and
  //    its spin by its inverse inertia times r × impulse.
  // 4. Column j is what that changes of every u_i: only contacts on those two bodies notice.
  // 5. One row for each contact, J_i = (−n, −r_a × n, n, r_b × n), makes both a few lines.
  throw common::NotImplemented("7.1 contact_system");
}

std::vector<RigidBody> with_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<Contact>& contacts, const Vector& lambda) {
  // TODO step 7.1, eq. (2)
  // 1. Check the arguments; common::require_entries checks the size and the numbers of a vector.
  // 2. Contact by contact add what λ_i n does to b, and −λ_i n to a, at the point.
  throw common::NotImplemented("7.1 with_impulses");
}

double energy_gained(const ContactSystem& system, const Vector& lambda) {
  // TODO step 7.1, eq. (3)
  // 1. Check the arguments; common::require_system checks A and u.
  // 2. λ·(u + A λ/2): an impulse works with the mean of the velocities before and after.
  //    common::product(A, lambda) compiles faster than A * lambda does.
  throw common::NotImplemented("7.1 energy_gained");
}

// ---- Step 7.2 ----

Impulses sequential_impulses(const ContactSystem& system, double restitution, int max_impulses) {
  // TODO step 7.2, eq. (4)
  // 1. Check the arguments.
  // 2. What counts as an approach is set once, from the first u: common::largest_entry.
  // 3. Go through the contacts in order. Does this one approach by now? Then give it the impulse
  //    that it would need if it were alone, and let all of u know at once.
  // 4. Count impulses, and stop at once if there have been max_impulses.
  // 5. Sweep again until none approaches. In the end say if that is so.
  throw common::NotImplemented("7.2 sequential_impulses");
}

// ---- Step 7.3 ----

Vector gauss_seidel(const Matrix& A, const Vector& b, const Vector& start, int sweeps) {
  // TODO step 7.3, eq. (5)
  // 1. Check the arguments.
  // 2. Go through the contacts in order: what is (A λ + b)_i with λ as it is now?
  //    common::row_product(A, i, lambda) is row i of A λ.
  // 3. Change λ_i so that it would be zero, but clamp λ_i itself at zero, not the change: a contact
  //    may give back what it got too much.
  throw common::NotImplemented("7.3 gauss_seidel");
}

double residual(const Matrix& A, const Vector& b, const Vector& lambda) {
  // TODO step 7.3, eq. (6)
  // 1. Check the arguments.
  // 2. In a solution one of λ_i and (A λ + b)_i is zero and the other is not below.
  //    So the smaller of the two is zero. The largest breach of all contacts is the answer.
  throw common::NotImplemented("7.3 residual");
}

// ---- Step 7.4 ----

Vector simultaneous_impulses(const ContactSystem& system, double restitution) {
  // TODO step 7.4, eq. (6)
  // 1. Check the arguments.
  // 2. b_i = u_i, plus e u_i if the contact approaches: it has to leave e times as fast.
  // 3. common::complementary(A, b) is the answer.
  throw common::NotImplemented("7.4 simultaneous_impulses");
}

// ---- Step 7.5 ----

Impulses generalized_reflections(const ContactSystem& system, double restitution,
                                 int max_reflections) {
  // TODO step 7.5, eq. (7) and (8)
  // 1. Check the arguments, and set once what counts as an approach, as in step 7.2.
  // 2. List the contacts that approach. If there are none, the reflections have ended.
  // 3. Solve for these alone: common::block and common::entries cut A_VV and u_V out.
  // 4. Twice that impulse reflects; common::spread gives all other contacts zero. Add it to λ, and
  //    let all of u know. Count, and begin again.
  // 5. Blend with the impulses for e = 0 of all contacts. For e = 0 those are the answer.
  throw common::NotImplemented("7.5 generalized_reflections");
}

// ---- Step 7.6 ----

Impulses inelastic_projection(const ContactSystem& system) {
  // TODO step 7.6, eq. (9)
  // 1. Check the argument, and set once what counts as an approach, as in step 7.2.
  // 2. List the contacts outside the zone that approach by u + A λ. If there are none, it is done.
  // 3. Take them into the zone. Nothing ever leaves it.
  // 4. Solve anew for the whole zone, from the first u: common::least_norm_solution.
  throw common::NotImplemented("7.6 inelastic_projection");
}

// ---- Step 7.7 ----

Vec2 limited(const Vec2& tangential, double limit, FrictionRule rule) {
  // TODO step 7.7, eq. (10)
  // 1. Check the arguments.
  // 2. The disc: too long a vector is scaled.
  // 3. The box: each component for itself.
  // 4. The diamond: by how much do |t| and |s| have to shrink, each the same? If one of them
  //    would go past zero, it is zero, and the other is the whole limit.
  throw common::NotImplemented("7.7 limited");
}

Vector friction_sweeps(const Matrix& A, const Vector& b, const Vector& start, double friction,
                       FrictionRule rule, int sweeps) {
  // TODO step 7.7, eq. (11)
  // 1. Check the arguments.
  // 2. Contact k has the rows 3k, 3k + 1 and 3k + 2. Do the normal first, as in step 7.3.
  // 3. What is u in the tangential rows by now?
  // 4. One q for both, 1 over the larger eigenvalue of A_TT:
  //    (A_tt + A_ss)/2 + √((A_tt − A_ss)²/4 + A_ts²).
  // 5. Step against u, then limit the pair by μ times the λ_n of this contact, the new one.
  throw common::NotImplemented("7.7 friction_sweeps");
}

double coulomb_residual(const Matrix& A, const Vector& b, const Vector& lambda, double friction) {
  // TODO step 7.7, eq. (12)
  // 1. Check the arguments.
  // 2. The normal rows are judged as in step 7.3.
  // 3. If a step against u, limited by the disc, leads back to the same pair, friction is right.
  throw common::NotImplemented("7.7 coulomb_residual");
}

// ---- Step 7.8, a challenge ----

Vector accelerated(const Matrix& A, const Vector& b, int steps) {
  // TODO step 7.8, eq. (13)
  // 1. Check the arguments.
  // 2. L is common::largest_eigenvalue(A). Begin with λ = y = 0 and c = 1.
  // 3. A step down the slope from y, clamped at zero, is the next λ.
  // 4. If it went uphill, the momentum is wrong: c = 1 forgets it.
  // 5. y goes on past the next λ, by (c − 1)/c' of the way from the last.
  throw common::NotImplemented("7.8 accelerated");
}

}  // namespace lab::multi_contact

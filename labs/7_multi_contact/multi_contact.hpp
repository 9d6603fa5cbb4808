#pragma once

#include <vector>

#include "common/algebra/complementarity.hpp"
#include "common/algebra/dense.hpp"
#include "common/contact/rigid_body.hpp"
#include "common/types.hpp"

/// The contract of lab 7. World frame, SI units.
///
///   u  how fast each contact opens [m/s]; below zero it closes    e  restitution, in [0, 1]
///   A  what impulses change of u: u + A λ [1/kg]                  μ  friction, zero or above
///   λ  impulses along the normals [N s]; above zero they push     b  u and the bounce asked for
///
/// A contact approaches if its speed is below −1e-12 of the largest |u_i| that was handed in. The
/// order of the contacts is the order in which they are worked on. There may be none: the answer
/// then has no entries, or is 0.
///
/// Every function throws std::invalid_argument if an argument is NaN or infinite, sizes do not fit,
/// e is outside [0, 1], μ, a limit or a number of sweeps, steps, impulses or reflections is below
/// zero, or something stated below is broken. A has to be square, symmetric to 1e-9 of its largest
/// entry, and above zero all along its diagonal; the supplied common::require_system throws if it
/// is not. It is positive semi-definite, too, which nobody checks; it may be singular.
///
/// Numbers are 0 or from 1e-100 to 1e100 in size, and so are the products in the formulas, as A_ij
/// λ_j, u_i/A_ii and λ_i u_i. Beyond that results may over- or underflow. There are up to some
/// hundred contacts.
namespace lab::multi_contact {

using common::Mat3;
using common::Matrix;
using common::RigidBody;
using common::Vec3;
using common::Vector;
using Vec2 = Eigen::Vector2d;

/// Two bodies that touch, by their numbers in a list.
struct Contact {
  int a = 0;
  int b = 1;
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitZ();  ///< from a to b, of length one to 1e-9
};

struct ContactSystem {
  Matrix A;
  Vector u;
};

/// The contacts as numbers: u = J v, A = J W Jᵀ.                                 eq. (1)
///
///   u_i   n·(v_b + ω_b × r_b − v_a − ω_a × r_a), r from the centre of mass to the point
///   A_ij  by how much an impulse 1 at contact j, n on b and −n on a, changes u_i
///
/// Two bodies may touch in several contacts. Throws std::invalid_argument if a body breaks what
/// common/contact/rigid_body.hpp says, and if the numbers of a contact are equal, name no body, or
/// name two whose inverse masses are both zero.
ContactSystem contact_system(const std::vector<RigidBody>& bodies,
                             const std::vector<Contact>& contacts);

/// The bodies after the impulses, λ_i n on b and −λ_i n on a: v + W Jᵀ λ.        eq. (2)
///
/// lambda  one for each contact, of either sign [N s]
/// Throws as contact_system does.
std::vector<RigidBody> with_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<Contact>& contacts, const Vector& lambda);

/// By how much the impulses raise the kinetic energy: λ·(u + A λ/2) [J].         eq. (3)
double energy_gained(const ContactSystem& system, const Vector& lambda);

/// The sum of what was done, contact by contact, and how it went.
struct Impulses {
  Vector lambda;       ///< [N s]
  int count = 0;       ///< of impulses, reflections or rounds
  bool ended = false;  ///< no contact approaches any more; false if the work was cut short
};

/// One contact after the other, each as if it were alone.                        eq. (4)
///
///   if contact i approaches:  d = −(1 + e) u_i/A_ii,  λ_i ← λ_i + d,  u ← u + d A_i
///
/// From λ = 0, contact by contact, and again from the first until none approaches. A_i is column i.
/// After max_impulses impulses it stops at once; `ended` then says if that was enough.
Impulses sequential_impulses(const ContactSystem& system, double restitution, int max_impulses);

/// Projected Gauss-Seidel for 0 ≤ λ, A λ + b ≥ 0, λ·(A λ + b) = 0.               eq. (5)
///
///   λ_i ← max(0, λ_i − (A λ + b)_i/A_ii), i from the first to the last, λ as it is by then
///
/// start  of either sign; no sweeps return it as it is
Vector gauss_seidel(const Matrix& A, const Vector& b, const Vector& start, int sweeps);

/// How far λ is from a solution of (5): the largest |min(λ_i, (A λ + b)_i)|.     eq. (6)
///
/// It is 0 for a solution and for no other λ. It compares impulses with speeds, number by number.
double residual(const Matrix& A, const Vector& b, const Vector& lambda);

/// All contacts at once: λ of b_i = u_i + e min(u_i, 0).                         eq. (6)
///
/// Solved to rounding by the supplied common::complementary. A contact that parts is asked for no
/// bounce. If A is singular, any λ that solves it will do.
/// Throws std::domain_error if there is none: a body between two walls, for e > 0.
Vector simultaneous_impulses(const ContactSystem& system, double restitution);

/// Reflections of the contacts that approach, all of them at once.               eq. (7), (8)
///
///   while some approach:  V the contacts that do,  x the λ of A_VV and b = u_V,
///                         λ_V ← λ_V + 2 x,  u ← u + 2 A_V x                     (7)
///   returns (1 − e) λ₀ + e λ, λ₀ the λ of A and b = u for all contacts            (8)
///
/// From λ = 0; A_V are the columns of V, A_VV these columns in the rows of V. With e = 0 there are
/// no reflections, and it has ended. After max_reflections reflections it stops, and `ended` says
/// if that was enough; λ₀ comes in either way. common::complementary, block and entries are
/// supplied. Throws std::domain_error if complementary does: moving walls that close in on a body.
Impulses generalized_reflections(const ContactSystem& system, double restitution,
                                 int max_reflections);

/// What approaches is stopped and held: it may neither approach nor part.        eq. (9)
///
///   Z empty, λ = 0;  while some contact outside Z approaches by u + A λ:
///   add all of those to Z,  λ_Z the shortest solution of A_ZZ λ_Z = −u_Z,  all other λ_i = 0
///
/// u is always the u handed in, λ may pull, and `count` is how often Z grew: it always ends.
/// common::least_norm_solution is supplied, too.
/// Throws std::domain_error if least_norm_solution does: moving walls that close in on a body.
Impulses inelastic_projection(const ContactSystem& system);

/// What bounds the two tangential impulses (t, s) of a contact by a limit l.
enum class FrictionRule {
  box,      ///< |t| ≤ l and |s| ≤ l
  diamond,  ///< |t| + |s| ≤ l
  disc      ///< t² + s² ≤ l²: Coulomb's
};

/// The point within the bounds that is nearest to the tangential impulse.        eq. (10)
///
/// What is within is returned as it is. disc: scaled to length l. box: each to ±l. diamond: both
/// moved towards 0 by the same amount, but no further than 0, until |t| + |s| = l.
Vec2 limited(const Vec2& tangential, double limit, FrictionRule rule);

/// Projected Gauss-Seidel with friction, three rows for each contact: n, t, s.   eq. (11)
///
///   λ_n ← max(0, λ_n − u_n/A_nn), then u = A λ + b anew, then
///   (λ_t, λ_s) ← limited((λ_t, λ_s) − q (u_t, u_s), μ λ_n),  q = 1/(largest eigenvalue of A_TT)
///
/// contact by contact, in order. contact_system makes the rows of three Contacts at one point whose
/// normals are n, t and s. A_TT are the rows and columns t, s: both tangents take one step
/// length q, or friction would not point against the slip. b_n = u_n + e min(u_n, 0), b_t = u_t,
/// b_s = u_s of the velocities before.
/// start  of either sign; no sweeps return it as it is
/// Throws std::invalid_argument if the number of rows is no multiple of three.
Vector friction_sweeps(const Matrix& A, const Vector& b, const Vector& start, double friction,
                       FrictionRule rule, int sweeps);

/// How far λ is from Coulomb's law, rows as in (11), u = A λ + b.                eq. (12)
///
///   the largest of all |min(λ_n, u_n)| and |(λ_t, λ_s) − P((λ_t, λ_s) − (u_t, u_s))|
///
/// P is `limited` with the disc and the limit μ max(0, λ_n). It is 0 if the law holds, and
/// only then. Throws as friction_sweeps does.
double coulomb_residual(const Matrix& A, const Vector& b, const Vector& lambda, double friction);

/// A challenge: Nesterov's accelerated projected gradient, from λ = y = 0, c = 1. eq. (13)
///
///   g = A y + b,  λ' = max(0, y − g/L),  L the largest eigenvalue of A
///   if that went uphill, g·(λ' − λ) > 0:  c ← 1, which forgets the momentum
///   c' = (1 + √(1 + 4 c²))/2,  y ← λ' + (c − 1)/c' (λ' − λ),  λ ← λ',  c ← c'
///
/// Returns λ after so many steps. common::largest_eigenvalue is supplied.
Vector accelerated(const Matrix& A, const Vector& b, int steps);

}  // namespace lab::multi_contact

#pragma once

#include <vector>

#include "common/contact/obstacle.hpp"
#include "common/contact/rigid_body.hpp"
#include "common/types.hpp"

/// The contract of lab 6, in the world frame and in SI units. A normal n is unit and points out of
/// the obstacle, or from body a to body b. λ is the push of a contact.
///
///   φ    gap [m]: φ ≥ 0, λ ≥ 0, φ λ = 0        e  restitution, in [0, 1]
///   v_n  n·v [m/s], below zero inwards          μ  coefficient of friction, zero or above
///   v_t  v − v_n n [m/s]                        j  impulse [N s]
///
/// Every function throws std::invalid_argument if an argument is NaN or infinite, or breaks a
/// requirement stated below. It also throws if a mass or a radius is not above zero, if e is
/// outside [0, 1], if μ or dt is below zero, or if a normal is not of length one (to 1e-9).
///
/// Numbers are 0 or from 1e-100 to 1e100 in size. So are the products in the formulas, such as
/// m |v_t| and the entries of K. Beyond that, results may overflow or underflow.
namespace lab::impulse_response {

using common::Mat3;
using common::Obstacle;
using common::RigidBody;
using common::Vec3;

/// The constants of a contact between two surfaces.
struct Material {
  double restitution = 0.0;  ///< e
  double friction = 0.0;     ///< μ
};

/// Returns the normal impulse j_n = −(1 + e) m v_n if v_n < 0, else 0 [N s].     eq. (1)
double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution);

/// Returns the friction impulse of maximum dissipation, −min(μ j_n, m |v_t|) v_t/|v_t| [N s], or 0
/// if v_t = 0.                                                                   eq. (2)
///
/// velocity        before the impact [m/s]
/// normal_impulse  j_n, zero or above [N s]
Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction);

/// Returns the correction that moves a particle out: −φ n if φ < 0, else 0 [m].  eq. (3)
Vec3 normal_correction(double gap, const Vec3& normal);

/// Returns the correction that undoes artificial sliding: −min(μ d_n, |d_t|) d_t/|d_t| [m], or 0 if
/// d_t = 0. It is the friction rule on positions.                                eq. (4)
///
/// d_t is the tangential part of the displacement.
/// displacement   motion of the particle in this step, before corrections [m]
/// normal_length  d_n, the length by which it is to be moved out, zero or above [m]
Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction);

struct Particle {
  double mass = 1.0;             ///< [kg]
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// The corrections of position that option 2 makes. Each can be switched off.
struct Corrections {
  bool normal = true;
  bool tangential = true;
};

struct ProjectedStep {
  Particle particle;
  Vec3 impulse = Vec3::Zero();  ///< of the contact; zero in flight [N s]
};

/// Takes a step by option 2: a step without the obstacle, followed by corrections of velocity and
/// position.                                                                     eq. (5)
///
///   v ← v + dt g,  d = dt v,  x ← x + d
///   if φ(x) < 0, with n there:  v ← v + (j_n n + j_t)/m by (1) and (2), and
///   x ← x + (3) + (4) of d and d_n = −φ(x), each if `corrections` asks for it
///
/// A particle that is inside but already moves outwards, v_n ≥ 0, gets no impulse. Its position is
/// still corrected.
ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections = {});

struct Impact {
  double time = 0.0;            ///< since the start of the step [s]
  Vec3 impulse = Vec3::Zero();  ///< [N s]
};

struct ImpactStep {
  Particle particle;
  std::vector<Impact> impacts;  ///< in order of time, without the impulse of option 2
  double projected = 0.0;       ///< the time at the end of the step that option 2 did [s]
};

/// Takes a step by option 1: exact flight to the next impact, its impulse, and so on.  eq. (6)
///
/// A ball may bounce infinitely often in finite time (Zeno). So option 2 does the rest of the step
/// in one go, with both corrections, in three cases: after an impact with e = 0, after max_impacts
/// impacts, and if the particle, at the start of the step or after an impact, is at φ ≤ 0 without
/// moving outwards. common::time_of_impact is supplied.
/// max_impacts  at least 1
ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts);

struct Contact {
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitZ();  ///< from a to b
};

/// Returns K of both bodies: the impulse j on b and −j on a change u by K j [1/kg].  eq. (7)
///
/// u  velocity of b's material at the point, relative to a's material there [m/s]
Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point);

/// Returns the impulse on b [N s], or 0 if u_n ≥ 0; a gets the opposite.         eq. (8), (9)
///
/// Stick comes first: the j after which u_t = 0 and u_n is −e times its old value. If that j is
/// outside the friction cone, |j_t| > μ j_n, the answer is j = j_n (n + μ t) on the cone. It keeps
/// the tangential direction t of stick; its j_n > 0 also makes u_n −e times its old value.
/// Throws std::invalid_argument if both inverse masses are zero.
Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material);

/// Returns the body after an impulse at a point.                                 eq. (10)
RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point);

}  // namespace lab::impulse_response

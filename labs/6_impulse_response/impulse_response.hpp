#pragma once

#include <vector>

#include "common/obstacle.hpp"
#include "common/types.hpp"

/// The contract of lab 6. World frame, SI units. A normal n is unit and points out of the obstacle,
/// or from body a to body b.
///
///   φ    gap [m]: φ ≥ 0, λ ≥ 0, φ λ = 0        e  restitution, in [0, 1]
///   v_n  n·v [m/s], below zero inwards          μ  coefficient of friction, zero or above
///   v_t  v − v_n n [m/s]                        j  impulse [N s]
///
/// Every function throws std::invalid_argument where an argument is NaN or infinite, a mass or a
/// radius is not above zero, e is outside [0, 1], μ or dt below zero, a normal not of length one
/// (to 1e-9), or something stated below is broken.
///
/// Numbers are 0 or from 1e-100 to 1e100 in size, and so are the products in the formulas, as m
/// |v_t| and the entries of K. Beyond that results may over- or underflow.
namespace lab::impulse_response {

using common::Mat3;
using common::Obstacle;
using common::Vec3;

/// How two surfaces meet.
struct Material {
  double restitution = 0.0;  ///< e
  double friction = 0.0;     ///< μ
};

/// The normal impulse j_n = −(1 + e) m v_n where v_n < 0, else 0 [N s].          eq. (1)
double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution);

/// Friction of maximum dissipation: −min(μ j_n, m |v_t|) v_t/|v_t|, 0 where v_t is.  eq. (2)
///
/// velocity        before the impact [m/s]
/// normal_impulse  j_n, zero or above [N s]
Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction);

/// What moves a particle out: −φ n where φ < 0, else 0 [m].                      eq. (3)
Vec3 normal_correction(double gap, const Vec3& normal);

/// What undoes artificial sliding: −min(μ d_n, |d_t|) d_t/|d_t| [m].             eq. (4)
///
/// The friction rule on positions; d_t is the tangential part of the displacement, 0 gives 0.
/// displacement   of the particle in this step, before corrections [m]
/// normal_length  d_n, by how much it is to be moved out, zero or above [m]
Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction);

struct Particle {
  double mass = 1.0;             ///< [kg]
  Vec3 position = Vec3::Zero();  ///< [m]
  Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// Which positions option 2 repairs, each for itself.
struct Corrections {
  bool normal = true;
  bool tangential = true;
};

struct ProjectedStep {
  Particle particle;
  Vec3 impulse = Vec3::Zero();  ///< of the contact; zero in flight [N s]
};

/// Option 2: a step as if nothing were there, then a lie about where it ends.    eq. (5)
///
///   v ← v + dt g,  d = dt v,  x ← x + d
///   where φ(x) < 0, with n there:  v ← v + (j_n n + j_t)/m by (1) and (2), and
///   x ← x + (3) + (4) of d and d_n = −φ(x), each where `corrections` asks for it
///
/// Inside but parting, v_n ≥ 0, there is no impulse; positions are repaired all the same.
ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections = {});

struct Impact {
  double time = 0.0;            ///< since the start of the step [s]
  Vec3 impulse = Vec3::Zero();  ///< [N s]
};

struct ImpactStep {
  Particle particle;
  std::vector<Impact> impacts;  ///< in order of time
  double projected = 0.0;       ///< how long of the step was done by option 2, at its end [s]
};

/// Option 1: exact flight to each impact in turn, the impulse there, and on.     eq. (6)
///
/// Bounces may be infinitely many in finite time (Zeno). So what is left of the step is done by
/// option 2 in one go, with both corrections, after an impact with e = 0, after max_impacts
/// impacts, and where the particle, at the start of the step or after an impact, is at φ ≤ 0
/// without moving outwards. common::time_of_impact is supplied.
/// max_impacts  at least 1
ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts);

/// A rigid body as an impact sees it. An immovable one has zero for both inverses.
struct RigidBody {
  double inverse_mass = 1.0;                ///< zero or above [1/kg]
  Mat3 inverse_inertia = Mat3::Identity();  ///< world frame [1/(kg m²)]; symmetric to 1e-9 of its
                                            ///< largest entry, none on the diagonal below zero
  Vec3 position = Vec3::Zero();             ///< centre of mass [m]
  Vec3 velocity = Vec3::Zero();             ///< of the centre of mass [m/s]
  Vec3 angular_velocity = Vec3::Zero();     ///< world frame [rad/s]
};

struct Contact {
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitZ();  ///< from a to b
};

/// K of both bodies: j on b and −j on a change u by K j [1/kg].                  eq. (7)
///
/// u  velocity of b's material at the point relative to a's there [m/s]
Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point);

/// The impulse that b receives, a its opposite [N s]; 0 where u_n ≥ 0.           eq. (8), (9)
///
/// Stick is tried first: the j after which u_t = 0 and u_n is −e times what it was. Where it leaves
/// the cone, |j_t| > μ j_n, its tangential direction t is kept and j = j_n (n + μ t) is on the
/// cone, its j_n above zero and such that u_n is −e times what it was.
/// Throws std::invalid_argument where both inverse masses are zero.
Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material);

/// The body after an impulse at a point.                                         eq. (10)
RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point);

}  // namespace lab::impulse_response

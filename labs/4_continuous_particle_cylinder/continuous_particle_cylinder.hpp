#pragma once

#include <optional>
#include <vector>

#include "common/contact/particle_contact.hpp"
#include "common/types.hpp"

/// The contract of lab 4. A cylinder has the radius R and is infinite along x. A particle is a ball
/// of radius r on the straight path x + t v. Everything is in the world frame and in SI units.
///
///   φ   gap √(y² + z²) − ρ [m]       ρ  R + r, the exact sum of the two doubles [m]
///   t*  time of impact: the smallest t in [0, dt] with φ(x + t v) ≤ 0, x + t v not rounded [s]
///
/// A particle that touches or is inside at the start has t* = 0 whichever way it moves: detection
/// is geometry, and the response decides the rest. A particle that only touches in passing has a
/// t*, and so has one that arrives at dt. If dt = 0, or if it is at rest or moves along the axis,
/// only the start counts. Motion along x plays no part.
///
/// Every function throws std::invalid_argument if an argument is NaN or infinite, if a radius is
/// not above zero, or if dt is below zero.
namespace lab::continuous_particle_cylinder {

using common::Cylinder;
using common::ParticleContact;
using common::Vec3;

struct MovingParticle {
  Vec3 position = Vec3::Zero();  ///< x, at t = 0 [m]
  Vec3 velocity = Vec3::Zero();  ///< v [m/s]
  double radius = 0.01;          ///< r [m]
};

/// Returns t* by the textbook's formula, in the yz-plane:                          eq. (2), (3)
///
///   a = v·v,  b = 2 x·v,  c = x·x − ρ²;  0 if c ≤ 0;  else (−b − √(b² − 4 a c)) / 2a
///
/// Use exactly these terms, because you write this function to see it fail. For lengths and speeds
/// near one it is right except for rounding. If the path is far, fast or grazing, it may be wrong.
std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt);

/// Returns a b − c d to 2 ulp, even if the two products cancel (Kahan).            eq. (4)
///
/// requires  exact products within 1e-290 and 1e300
double difference_of_products(double a, double b, double c, double d);

/// Returns t* by the cross form, with the discriminant ρ² |v|² − (x × v)² and a root that does not
/// cancel.                                                                         eq. (5), (6)
///
/// accuracy  no impact is missed. t* is right to 8 ε of itself if the path comes within 0.7 ρ of
///           the axis and starts beyond 1.5 ρ. A path that stays outside by no more than rounding
///           (64 ε of ρ, of the way or of dt) may count as a hit, and no other miss may.
/// requires  lengths and speeds that are zero or within 1e-60 and 1e60
std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt);

/// Returns t* for certain: hit or miss as in exact arithmetic, and t* to 1 ulp, for any input.
///                                                                                 eq. (7)
std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt);

/// The result of conservative advancement, and its cost.
struct Advancement {
  std::optional<double> time;  ///< [s]
  int iterations = 0;          ///< evaluations of φ
};

/// Returns the first t of the sequence t ← t + φ/|v|, from t = 0, with φ ≤ tolerance, and none if t
/// passes dt first.                                                                eq. (8)
///
/// It needs only φ and a bound on the speed, here |v| in the yz-plane. It is never late. It is
/// early by the time that the last `tolerance` takes, and it counts a pass closer than that as a
/// hit. If φ/|v| is too small for t to grow, t is the answer.
///
/// tolerance  above zero [m]
Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance);

/// Returns the contact at `time`. The normal is unit and points away from the axis; on the axis it
/// is +y. The point on the cylinder is R from the axis up to rounding, whatever the last bits of
/// `time` are.                                                                     eq. (9)
ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time);

/// Many particles of one radius, with one array for each coordinate. x is left out, because it
/// plays no part.
struct MovingParticles {
  std::vector<double> y;           ///< [m]
  std::vector<double> z;           ///< [m]
  std::vector<double> velocity_y;  ///< [m/s]
  std::vector<double> velocity_z;  ///< [m/s]
  double radius = 0.01;            ///< r [m]
};

/// Returns t* of every particle as time_of_impact_certified does, or infinity if it has no impact.
///
/// The number of allocations does not grow with the number of particles.
/// Also throws std::invalid_argument if the arrays differ in length.
std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt);

/// An edge of a cloth that is as thick as its particles, and whose ends move on straight paths.
struct MovingEdge {
  Vec3 a = Vec3::Zero();           ///< one end, at t = 0 [m]
  Vec3 b = Vec3::Zero();           ///< the other [m]
  Vec3 velocity_a = Vec3::Zero();  ///< [m/s]
  Vec3 velocity_b = Vec3::Zero();  ///< [m/s]
  double radius = 0.01;            ///< r [m]
};

/// Returns the smallest t in [0, dt] at which any point of the edge has φ ≤ 0, or none.
///                                                                                 eq. (10), (11)
/// accuracy  hit or miss as in exact arithmetic; t* to 1e-14 of dt
std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt);

}  // namespace lab::continuous_particle_cylinder

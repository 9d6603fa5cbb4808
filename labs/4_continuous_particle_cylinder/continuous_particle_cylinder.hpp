#pragma once

#include <optional>
#include <vector>

#include "common/particle_contact.hpp"
#include "common/types.hpp"

/// The contract of lab 4. A cylinder of radius R, infinite along x; a particle, a ball of radius r,
/// moves straight on: x + t v. World frame, SI units.
///
///   φ   gap √(y² + z²) − ρ [m]       ρ  R + r, the exact sum of the two doubles [m]
///   t*  time of impact: the smallest t in [0, dt] with φ(x + t v) ≤ 0, x + t v not rounded [s]
///
/// A particle that touches or is inside at the start has t* = 0 whichever way it moves: detection
/// is geometry, response decides. One that only touches in passing has a t*, as has one that
/// arrives at dt. At rest, along the axis or with dt = 0 all depends on the start. What happens
/// along x plays no part.
///
/// Every function throws std::invalid_argument where an argument is NaN or infinite, a radius is
/// not above zero or dt is below zero.
namespace lab::continuous_particle_cylinder {

using common::Cylinder;
using common::ParticleContact;
using common::Vec3;

struct MovingParticle {
  Vec3 position = Vec3::Zero();  ///< x, at t = 0 [m]
  Vec3 velocity = Vec3::Zero();  ///< v [m/s]
  double radius = 0.01;          ///< r [m]
};

/// t* as a textbook has it, in the yz-plane:                                       eq. (2), (3)
///
///   a = v·v,  b = 2 x·v,  c = x·x − ρ²;  0 where c ≤ 0;  else (−b − √(b² − 4 a c)) / 2a
///
/// in just these terms: this one is written to see it fail. For lengths and speeds near one it is
/// right but for rounding; far off, fast or grazing it need not be.
std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt);

/// a b − c d, to 2 ulp also where the two products cancel (Kahan).                 eq. (4)
///
/// Exact products must stay within 1e-290 and 1e300.
double difference_of_products(double a, double b, double c, double d);

/// t* by the cross form: discriminant ρ² |v|² − (x × v)², a root that does not cancel. eq. (5), (6)
///
/// accuracy  no impact is missed; t* to 8 ε of itself where the path comes within 0.7 ρ of the axis
///           and starts beyond 1.5 ρ. What stays outside by no more than rounding, 64 ε of ρ, of
///           the way or of dt, may be taken for a hit, and nothing else.
///           Lengths and speeds are within 1e-60 and 1e60, or zero.
std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt);

/// t* for certain: hit or miss as in exact arithmetic, and t* to 1 ulp, whatever the input. eq. (7)
std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt);

/// What conservative advancement found, and what it took.
struct Advancement {
  std::optional<double> time;  ///< [s]
  int iterations = 0;          ///< evaluations of φ
};

/// The first t of the sequence t ← t + φ/|v|, from t = 0, with φ ≤ tolerance; none where t passes
/// dt first.                                                                       eq. (8)
///
/// Needs nothing but φ and a bound of the speed, |v| in the yz-plane. It is never late; it is early
/// by as long as the last `tolerance` takes, and takes a pass closer than that for a hit. Where
/// φ/|v| is too small for t to grow, t is the answer.
///
/// tolerance  above zero [m]
Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance);

/// The contact at `time`: the normal unit and away from the axis (+y on it), the point on the
/// cylinder R from the axis to rounding, whatever the last bits of `time`.         eq. (9)
ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time);

/// Many particles of one radius, an array a coordinate: what does not move in the yz-plane is left
/// out.
struct MovingParticles {
  std::vector<double> y;           ///< [m]
  std::vector<double> z;           ///< [m]
  std::vector<double> velocity_y;  ///< [m/s]
  std::vector<double> velocity_z;  ///< [m/s]
  double radius = 0.01;            ///< r [m]
};

/// t* of every particle for certain, as in time_of_impact_certified; infinity where there is none.
///
/// The number of allocations does not grow as the number of particles does.
/// Also throws std::invalid_argument where the arrays differ in length.
std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt);

/// An edge of a cloth, as thick as its particles, whose ends move straight on.
struct MovingEdge {
  Vec3 a = Vec3::Zero();           ///< one end, at t = 0 [m]
  Vec3 b = Vec3::Zero();           ///< the other [m]
  Vec3 velocity_a = Vec3::Zero();  ///< [m/s]
  Vec3 velocity_b = Vec3::Zero();  ///< [m/s]
  double radius = 0.01;            ///< r [m]
};

/// The smallest t in [0, dt] at which any point of the edge has φ ≤ 0; none where there is none.
///                                                                                 eq. (10), (11)
/// accuracy  hit or miss as in exact arithmetic; t* to 1e-14 of dt
std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt);

}  // namespace lab::continuous_particle_cylinder

// Lab 6: the file you fill in and hand in. The contract of each function is in the header beside
// it, the physics and the numbered equations are in README.md. Test with:  ./tumble test 6
#include "impulse_response.hpp"

#include "common/linear_algebra.hpp"
#include "common/not_implemented.hpp"
#include "common/require.hpp"

namespace lab::impulse_response {

// ---- Step 6.1 ----

double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution) {
  // TODO step 6.1, eq. (1)
  // 1. Check the arguments: common/require.hpp has a function for each kind of number.
  // 2. The speed along the normal is v_n = n·v, below zero inwards.
  // 3. Where the particle parts already there is nothing to do.
  // 4. Else stop the approach, and give e times as much back.
  throw common::NotImplemented("6.1 normal_impulse");
}

// ---- Step 6.2 ----

Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction) {
  // TODO step 6.2, eq. (2)
  // 1. Check the arguments.
  // 2. What slips is v_t: the velocity without its normal part. No slip, no friction.
  // 3. Friction is against it, and as large as the cone allows, μ j_n,
  // 4. but never larger than what stops the slip, m |v_t|.
  throw common::NotImplemented("6.2 friction_impulse");
}

// ---- Step 6.3 ----

Vec3 normal_correction(double gap, const Vec3& normal) {
  // TODO step 6.3, eq. (3)
  // 1. Check the arguments.
  // 2. Outside there is nothing to do; inside move out, along +n, by the depth −φ.
  throw common::NotImplemented("6.3 normal_correction");
}

Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction) {
  // TODO step 6.3, eq. (4)
  // 1. Check the arguments.
  // 2. This is step 6.2 with lengths: d_t for v_t, d_n for j_n, and no mass.
  throw common::NotImplemented("6.3 tangential_correction");
}

// ---- Step 6.4 ----

ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections) {
  // TODO step 6.4, eq. (5)
  // 1. Check the arguments; common::require_valid checks an obstacle.
  // 2. Let gravity change the velocity first, and that move the particle. Keep d = dt v.
  // 3. Outside, common::gap(obstacle, x) ≥ 0, that is all.
  // 4. Inside take the normal there, common::outward_normal(obstacle, x), and both impulses from
  //    the velocity before either. Add them to the velocity and return them.
  // 5. Correct the position, each way where it is asked for.
  throw common::NotImplemented("6.4 step_by_projection");
}

ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts) {
  // TODO step 6.4, eq. (6)
  // 1. Check the arguments.
  // 2. Again and again, each time first: where φ ≤ 0 and v_n ≤ 0 leave the loop.
  // 3. common::time_of_impact of the flight from here: none, then fly to the end and return.
  // 4. Else fly to it (common::position_at, velocity_at), apply both impulses, write it down.
  // 5. Leave the loop where e = 0 or max_impacts are done: bounces may never end.
  // 6. What is left is one step by projection.
  throw common::NotImplemented("6.4 step_to_impact");
}

// ---- Step 6.5 ----

Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  // TODO step 6.5, eq. (7)
  // 1. Check the arguments.
  // 2. What does an impulse j at r from the centre do to the velocity of the point? It moves the
  //    centre by j/m, and turns the body by I⁻¹ (r × j), which moves the point.
  // 3. As a matrix of one body: 1/m − [r]ₓ I⁻¹ [r]ₓ.
  // 4. Both bodies yield, so their matrices add up.
  throw common::NotImplemented("6.5 inverse_effective_mass");
}

Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material) {
  // TODO step 6.5, eq. (8) and (9)
  // 1. Check the arguments.
  // 2. The velocity of b's point relative to a's: both bodies move and turn. Where it parts, zero.
  // 3. Stick: solve K j = −e u_n n − u.
  // 4. Is j in the cone? Then that is it.
  // 5. Else keep the direction t of its tangential part, and find the j_n for which
  //    n·K (n + μ t) j_n = −(1 + e) u_n.
  throw common::NotImplemented("6.5 contact_impulse");
}

RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  // TODO step 6.5, eq. (10)
  // 1. Check the arguments.
  // 2. The centre moves as if the impulse acted there; the lever arm makes the body turn, too.
  throw common::NotImplemented("6.5 with_impulse");
}

}  // namespace lab::impulse_response

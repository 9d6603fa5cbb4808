// Lab 6: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the physics and the numbered equations. Test your file with:  ./tumble test 6
#include "impulse_response.hpp"

#include "common/algebra/linear_algebra.hpp"
#include "common/course/not_implemented.hpp"
#include "common/course/require.hpp"

namespace lab::impulse_response {

// ---- Step 6.1 ----

double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution) {
  // TODO step 6.1, eq. (1)
  // 1. Check the arguments: common/course/require.hpp has a function for each kind of number.
  // 2. The speed along the normal is v_n = n·v, below zero inwards.
  // 3. If the particle already moves away, there is nothing to do.
  // 4. Otherwise stop the approach, and send e times as much back.
  throw common::NotImplemented("6.1 normal_impulse");
}

// ---- Step 6.2 ----

Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction) {
  // TODO step 6.2, eq. (2)
  // 1. Check the arguments.
  // 2. The slip is v_t, the velocity without its normal part. If it is zero, there is no friction.
  // 3. Friction is against the slip, and as large as the cone allows, μ j_n.
  // 4. But it is never larger than m |v_t|, which stops the slip.
  throw common::NotImplemented("6.2 friction_impulse");
}

// ---- Step 6.3 ----

Vec3 normal_correction(double gap, const Vec3& normal) {
  // TODO step 6.3, eq. (3)
  // 1. Check the arguments.
  // 2. Outside there is nothing to do. Inside, move out along +n by the depth −φ.
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
  // 2. Let gravity change the velocity first, and let the new velocity move the particle. Keep
  //    d = dt v.
  // 3. If it is outside, common::gap(obstacle, x) ≥ 0, you are done.
  // 4. If it is inside, take the normal there, common::outward_normal(obstacle, x). Compute both
  //    impulses from the velocity before either. Add them to the velocity and return them.
  // 5. Make each correction of the position that is asked for.
  throw common::NotImplemented("6.4 step_by_projection");
}

ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts) {
  // TODO step 6.4, eq. (6)
  // 1. Check the arguments.
  // 2. Loop. Begin each turn with a check: if φ ≤ 0 and v_n ≤ 0, leave the loop.
  // 3. Find common::time_of_impact of the flight from here. If there is none, fly to the end and
  //    return.
  // 4. Otherwise fly to the impact (common::position_at, velocity_at), apply both impulses, and
  //    record them.
  // 5. Leave the loop if e = 0 or if max_impacts are done, because bounces may never end.
  // 6. Do the rest as one step by projection.
  throw common::NotImplemented("6.4 step_to_impact");
}

// ---- Step 6.5 ----

Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  // TODO step 6.5, eq. (7)
  // 1. Check the arguments.
  // 2. How does an impulse j at r from the centre change the velocity of the point? It moves the
  //    centre by j/m, and turns the body by I⁻¹ (r × j), which moves the point.
  // 3. As a matrix, for one body, this is 1/m − [r]ₓ I⁻¹ [r]ₓ.
  // 4. Both bodies move, so add their matrices.
  throw common::NotImplemented("6.5 inverse_effective_mass");
}

Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material) {
  // TODO step 6.5, eq. (8) and (9)
  // 1. Check the arguments.
  // 2. Compute the velocity of b's point relative to a's: both bodies move and turn. If they
  //    already separate, return zero.
  // 3. For stick, solve K j = −e u_n n − u.
  // 4. If j is in the cone, return it.
  // 5. Otherwise keep the direction t of its tangential part, and find the j_n for which
  //    n·K (n + μ t) j_n = −(1 + e) u_n.
  throw common::NotImplemented("6.5 contact_impulse");
}

RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  // TODO step 6.5, eq. (10)
  // 1. Check the arguments.
  // 2. The centre moves as if the impulse acted there. The lever arm makes the body turn, too.
  throw common::NotImplemented("6.5 with_impulse");
}

}  // namespace lab::impulse_response

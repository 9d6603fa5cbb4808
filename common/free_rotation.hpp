#pragma once

#include "common/polhode.hpp"
#include "common/spin.hpp"

namespace common {

/// The torque-free rotation of a rigid body in closed form, for every body and every state: the
/// exact answer that methods are measured against. The error is some 1e-14 rad over the first
/// turns, and some ulp of all the turning later: 1e-12 rad after a thousand radians.
///
/// The angular momentum runs along the polhode in Jacobi's elliptic functions, and the body turns
/// about it by an elliptic integral of the third kind (Jacobi 1849; Landau & Lifshitz, Mechanics,
/// §37). On the separatrix, and only there, the flip comes once and the period is infinite.
class FreeRotation {
 public:
  /// moments  principal moments of inertia [kg m²], in any order; equal ones are welcome
  /// start    the motion at time 0; q is normalised first
  /// Throws std::invalid_argument for moments no body has, and where start is not finite or q is 0.
  FreeRotation(const Vec3& moments, const Spin& start);

  /// The motion at a time of either sign [s].
  [[nodiscard]] Spin at(double time) const;

  /// The time 4 K / λ after which the angular velocity recurs in the body [s]. For a spin about the
  /// major or the minor axis it is the limit for small wobbles; infinite on the separatrix, and
  /// where a small wobble does not swing: a spherical body, a symmetric one about its equator,
  /// rest.
  [[nodiscard]] double period() const;

  [[nodiscard]] const Spin& start() const { return start_; }
  [[nodiscard]] const Polhode& polhode() const { return polhode_; }

 private:
  Spin start_;
  Polhode polhode_;
};

}  // namespace common

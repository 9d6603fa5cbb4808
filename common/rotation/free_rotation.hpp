#pragma once

#include "common/rotation/polhode.hpp"
#include "common/rotation/spin.hpp"

namespace common {

/// The torque-free rotation of a rigid body in closed form, for every body and every state. It is
/// the exact answer by which methods are judged. The error is about 1e-14 rad over the first turns,
/// and later some ulp of the whole turn: 1e-12 rad after a thousand radians.
///
/// The angular momentum moves along the polhode by Jacobi's elliptic functions, and the body turns
/// about it by an elliptic integral of the third kind (Jacobi 1849; Landau & Lifshitz, Mechanics,
/// §37). Only on the separatrix the flip comes once and the period is infinite.
class FreeRotation {
 public:
  /// moments  principal moments of inertia [kg m²], in any order; equal ones are allowed
  /// start    the motion at time 0; q is normalised first
  /// Throws std::invalid_argument if no body can have the moments, or if start is not finite or has
  /// q = 0.
  FreeRotation(const Vec3& moments, const Spin& start);

  /// Returns the motion at a time of either sign [s].
  [[nodiscard]] Spin at(double time) const;

  /// Returns the time 4 K / λ after which the angular velocity recurs in the body [s]. For a spin
  /// about the major or the minor axis it is the limit for small wobbles. It is infinite on the
  /// separatrix, and if a small wobble does not swing: for a spherical body, for a symmetric body
  /// that turns about its equator, and at rest.
  [[nodiscard]] double period() const;

  [[nodiscard]] const Spin& start() const { return start_; }
  [[nodiscard]] const Polhode& polhode() const { return polhode_; }

 private:
  Spin start_;
  Polhode polhode_;
};

}  // namespace common

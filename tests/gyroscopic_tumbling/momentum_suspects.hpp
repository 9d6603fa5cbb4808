#pragma once

#include "oracle.hpp"

/// What students get wrong in step 2.1, and in every step that uses Euler's equations.
namespace tests {

inline const char* const torque_flipped =
    "the torque has the wrong sign: use + T in eq. (2), with T = (p - x) x f";

struct AccelerationMistake {
  VecL (*value)(const MatL& I, const VecL& w, const VecL& T);
  const char* story;
};

inline VecL gyroscopic(const MatL& I, const VecL& w) { return w.cross(VecL(I * w)); }

inline VecL right_acceleration(const MatL& I, const VecL& w, const VecL& T) {
  return I.inverse() * (T - gyroscopic(I, w));
}

inline const std::vector<AccelerationMistake>& acceleration_mistakes() {
  using M = const MatL&;
  using V = const VecL&;
  static const std::vector<AccelerationMistake> all{
      {[](M I, V w, V T) -> VecL { return I.inverse() * (T + gyroscopic(I, w)); }, flipped},
      {[](M I, V, V T) -> VecL { return I.inverse() * T; }, forgotten},
      {[](M I, V w, V T) -> VecL { return T - gyroscopic(I, w); },
       "the inverse of the inertia is missing: multiply by I^-1"},
      {[](M I, V w, V T) -> VecL { return I * (T - gyroscopic(I, w)); },
       "the inertia multiplies the torques: multiply them by its inverse, I^-1"},
      {[](M I, V w, V T) -> VecL { return I.inverse() * T - gyroscopic(I, w); },
       "the gyroscopic term is not multiplied by the inverse: use I^-1 (T - omega x I omega)"},
      {[](M I, V w, V T) -> VecL { return T - I.inverse() * gyroscopic(I, w); },
       "the torque is not multiplied by the inverse: use I^-1 (T - omega x I omega)"},
      {[](M I, V w, V) -> VecL { return -(I.inverse() * gyroscopic(I, w)); },
       "the torque T is left out: use I^-1 (T - omega x I omega), T the sum of (p - x) x f"},
      {[](M I, V w, V T) -> VecL { return I.inverse() * (-T - gyroscopic(I, w)); }, torque_flipped},
      {[](M I, V w, V T) -> VecL { return I.inverse() * (T - gyroscopic(I.inverse(), w)); },
       "the gyroscopic term holds I^-1 omega: it is omega x I omega"}};
  return all;
}

inline std::vector<Suspect<Vec3>> acceleration_suspects(const Mat3& inertia, const Vec3& omega,
                                                        const Vec3& torque) {
  std::vector<Suspect<Vec3>> suspects;
  for (const AccelerationMistake& mistake : acceleration_mistakes()) {
    suspects.push_back(
        {narrow(mistake.value(inertia.cast<Real>(), wide(omega), wide(torque))), mistake.story});
  }
  return suspects;
}

inline std::vector<Suspect<double>> energy_suspects(const Vec3& moments, const common::Spin& spin) {
  const Vec3& omega = spin.angular_velocity_body;
  const Vec3 m = moments.cwiseProduct(omega);
  const Vec3 world = spin.world_from_body * omega;
  const char* const mixed =
      "of omega and I omega one is in the world frame and one in body axes: use both in body axes";
  return {{omega.dot(m), "the factor 1/2 is missing: multiply by 0.5"},
          {0.0, "1/2 is 0 in whole numbers"},
          {0.5 * m.sum(), "omega occurs only once: use omega . I omega"},
          {0.5 * world.dot(moments.cwiseProduct(world)),
           "omega is in the world frame, but the inertia in body axes: use both in body axes"},
          {0.5 * omega.dot(spin.world_from_body * m), mixed},
          {0.5 * world.dot(m), mixed},
          {0.5 * omega.dot(omega.cwiseQuotient(moments)),
           "omega is divided by the moments: multiply it by them"},
          {0.5 * m.squaredNorm(), "this is |L|^2 / 2: one factor must be omega, not I omega"}};
}

inline std::vector<Suspect<Vec3>> momentum_suspects(const Vec3& moments, const common::Spin& spin) {
  const VecL I = wide(moments);
  const VecL omega = wide(spin.angular_velocity_body);
  const VecL m = times(I, omega);
  const QuatL q = wide(spin.world_from_body).normalized();
  const VecL world = q * omega;
  const VecL seen = q.conjugate() * omega;
  return {
      {narrow(m), "I0 omega is still in body axes: turn it into the world"},
      {narrow(q.conjugate() * m),
       "it is turned backwards: turn it by q, which leads from body to world"},
      {narrow(times(I, world)),
       "the body's moments are applied to omega in the world frame: apply them in body axes"},
      {narrow(q * times(I, seen)),
       "R I0 R^T suits omega in the world frame: with omega in body axes use R (I0 omega)"},
      {narrow(q.conjugate() * times(I, world)),
       "R^T I0 R is no inertia: with omega in body axes use R (I0 omega)"},
      {narrow(q * omega.cwiseQuotient(I)), "omega is divided by the moments: multiply it by them"},
      {narrow(world), "this is omega: multiply it by the moments first"}};
}

}  // namespace tests

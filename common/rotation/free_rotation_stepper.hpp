#pragma once

#include <cmath>

#include "common/rotation/free_rotation.hpp"

namespace common {

/// The exact step of a free body. It lands on the closed form for every step size, and needs no
/// sine and no integral on the way. Over a step the body turns by the unit quaternion
///
///   p ∝ (k₀, k_c cn, k_s sn, k_d dn),  with the functions at the middle of the step
///
/// and constant k. The addition theorem, with constant sn, cn, dn of λ dt, leads to the next
/// middle. The rounding error after n steps is that of n products of quaternions.
class FreeRotationStepper {
 public:
  /// dt  may have either sign [s]
  FreeRotationStepper(const FreeRotation& rotation, double dt);

  void advance() {
    world_from_axes_ = world_from_axes_ *
                       Quat(k_.w(), k_.x() * middle_.cn, k_.y() * middle_.sn, k_.z() * middle_.dn);
    // A root costs as much as all the rest, so q is normalised only at times.
    if (++steps_ % 8 == 0) world_from_axes_.normalize();
    for (int i = 0; i < parts_; ++i) advance_middle();
  }

  /// Returns the motion after the steps so far.
  [[nodiscard]] Spin spin() const;

 private:
  void prepare_steady(double dt);
  void prepare(double dt);

  /// dn is computed from sn and cn, so the three stay on their curve. Off it the map is unstable
  /// near the separatrix. An error of their common length changes sign from step to step, so it
  /// cannot grow.
  void advance_middle() {
    const auto& [s, c, d] = middle_;
    const double sine = s * whole_ + (by_sn_ * (c * d) - s * sine_loss_);
    const double cosine = c * whole_ - (c * cosine_loss_ + s * (by_sn_dn_ * d));
    const double inverse = 1.0 / (c * c + s * s * by_dn_squared_);  // 1 − k² sn² sn²
    middle_.dn = inverse * std::sqrt(cosine * cosine + complementary_parameter_ * (sine * sine));
    middle_.sn = inverse * sine;
    middle_.cn = inverse * cosine;
  }

  FreeRotation rotation_;
  Quat world_from_axes_;          // of the polhode's axes (c, s, d)
  Vec3 momentum_ = Vec3::Zero();  // world, over its length
  JacobiFunctions middle_;        // of the step to come
  Quat k_;                        // (k₀, k_c, k_s, k_d)
  int parts_ = 1;
  unsigned steps_ = 0;
  // Of λ dt / parts. In short steps a number near 1 is stored as its distance from 1, because its
  // rounding error would be the same in each step and would add up.
  double by_sn_ = 0.0;
  double whole_ = 1.0;        // 1 in short steps, else 0
  double sine_loss_ = 0.0;    // whole − cn dn
  double cosine_loss_ = 0.0;  // whole − cn
  double by_dn_squared_ = 1.0;
  double by_sn_dn_ = 0.0;
  double complementary_parameter_ = 1.0;
};

}  // namespace common

#pragma once

#include <cmath>

#include "common/rotation/attitude.hpp"
#include "common/rotation/spin.hpp"

namespace common {

/// A symmetric top under gravity that turns about a fixed point of its axis. The body's z axis is
/// the axis of the top, from the fixed point to the centre of mass. Gravity points along the
/// world's −z.
struct HeavyTop {
  double transverse_moment = 1.0;  ///< I₁, about the fixed point [kg m²]
  double axial_moment = 1.0;       ///< I₃, about the axis [kg m²]
  double weight_moment = 0.0;      ///< m g l ≥ 0 [N m]
};

/// The Lagrange top in closed form: the exact answer for methods with a torque.
///
/// u = cos θ swings as u₁ cn² x + u₂ sn² x with x = x₀ + p t. The two angles, about the vertical
/// and about the axis, are elliptic integrals of the third kind (Whittaker 1937, §71). The error is
/// about 1e-14 rad over the first turns, and later some ulp of the whole turn. If the axis comes
/// near the vertical, rounding turns it, and the error is 1e-15 rad over the smallest tilt.
class LagrangeTop {
 public:
  /// The tilt from the vertical below which the closed form is refused [rad]. On the vertical the
  /// two angles are one.
  static constexpr double smallest_tilt = 1e-4;

  /// start  the motion at time 0; q is normalised first
  /// Throws std::invalid_argument if no body can have the moments, if weight_moment is negative or
  /// not finite, or if start is not finite or has q = 0. It also throws if the top has a weight and
  /// its axis comes closer than smallest_tilt to the vertical, upward or downward, at any time.
  LagrangeTop(const HeavyTop& top, const Spin& start);

  /// Returns the motion at a time of either sign [s].
  [[nodiscard]] Spin at(double time) const;

 private:
  HeavyTop top_;
  Spin start_;
  // Distances of u from +1 and −1 at its turning points, each accurate by itself.
  double from_up_1_ = 0.0;    // 1 − u₁
  double from_up_2_ = 0.0;    // 1 − u₂
  double from_down_1_ = 0.0;  // 1 + u₁
  double from_down_2_ = 0.0;  // 1 + u₂
  double swing_ = 0.0;        // u₂ − u₁
  double half_up_ = 0.0;      // (b − a) / 2, I₁ b the vertical momentum, I₁ a the axial one
  double half_down_ = 0.0;    // (b + a) / 2
  double rate_ = 0.0;         // p
  double complementary_parameter_ = 1.0;
  double phase_ = 0.0;  // x₀

  void find_turning_points();
  [[nodiscard]] double angle(double x, double half, double at_1, double at_2) const;
};

/// Returns the exact motion of a symmetric body without weight over dt. It turns about its constant
/// angular momentum L by |L| / I₁ dt, and within that about its own axis by ω₃ (1 − I₃ / I₁) dt. It
/// is the drift of a splitting method whose kick is the torque. Any tilt and any dt are allowed.
inline Spin free_symmetric_step(const HeavyTop& top, const Spin& spin, double dt) {
  const Vec3& w = spin.angular_velocity_body;
  const double ratio = top.axial_moment / top.transverse_moment;
  const Vec3 precession_body(w.x(), w.y(), ratio * w.z());  // L / I₁
  const double half = 0.5 * (1.0 - ratio) * w.z() * dt;
  const double cosine = std::cos(half);
  const double sine = std::sin(half);
  const Quat own_turn(cosine, 0.0, 0.0, sine);
  const double c = cosine * cosine - sine * sine;
  const double s = 2.0 * sine * cosine;
  return {spin.world_from_body * exponential_map(precession_body * dt) * own_turn,
          Vec3(c * w.x() + s * w.y(), c * w.y() - s * w.x(), w.z())};
}

}  // namespace common

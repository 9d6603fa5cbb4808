#pragma once

#include <functional>

#include "common/rotation/attitude.hpp"
#include "common/rotation/free_rotation.hpp"
#include "oracle.hpp"

/// Motions on which methods are judged as a whole: small wobbles, whose growth a step is known in
/// closed form, and tumbles, whose attitude is.
namespace tests {

/// (Spin, dt) -> Spin.
using SpinStep = std::function<common::Spin(const common::Spin&, double)>;

/// A body that spins about one of its axes with a small wobble about the other two. To first order
/// in the wobble its angular velocity circles the axis at the rate Ω_p, on an ellipse.
struct Wobble {
  common::Vec3 moments = common::Vec3(1.0, 2.0, 3.0);
  int axis = 2;        ///< 0, 1 or 2: 0 and 2 are stable where the moments rise
  double speed = 1.0;  ///< ω [rad/s]

  [[nodiscard]] double along() const { return moments(axis); }
  [[nodiscard]] int next() const { return (axis + 1) % 3; }
  [[nodiscard]] int last() const { return (axis + 2) % 3; }

  /// Ω_p = ω √((I_a − I_j)(I_a − I_k)/(I_j I_k)) [rad/s]: y = Ω_p dt.
  [[nodiscard]] double precession() const {
    return speed * std::sqrt((along() - moments(next())) * (along() - moments(last())) /
                             (moments(next()) * moments(last())));
  }

  /// Wobble of that size, as a share of the spin.
  [[nodiscard]] common::Spin start(double size) const {
    common::Spin spin{common::Quat(0.5, 0.5, -0.5, 0.5), common::Vec3::Zero()};
    spin.angular_velocity_body(axis) = speed;
    spin.angular_velocity_body(next()) = size * speed;
    return spin;
  }

  /// The ellipse's size: constant in the exact linear motion.
  [[nodiscard]] double amplitude(const common::Spin& spin) const {
    const auto part = [&](int i) {
      return std::sqrt(std::abs(moments(i) * (along() - moments(i)))) *
             spin.angular_velocity_body(i);
    };
    return std::hypot(part(next()), part(last()));
  }
};

/// The factor by which the wobble grows in one step, from `steps` steps.
inline double growth_factor(const Wobble& wobble, const SpinStep& step, double dt, int steps) {
  // Squares of the wobble change the factor by 1e-10 of itself at most, rounding by less.
  common::Spin spin = wobble.start(1e-5);
  const double before = wobble.amplitude(spin);
  for (int i = 0; i < steps; ++i) spin = step(spin, dt);
  return std::pow(wobble.amplitude(spin) / before, 1.0 / steps);
}

/// The wobble after so many steps, in units of its start; infinite once the motion is lost.
inline double growth(const Wobble& wobble, const SpinStep& step, double dt, int steps) {
  common::Spin spin = wobble.start(1e-5);
  const double before = wobble.amplitude(spin);
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    spin = step(spin, dt);
    const double now = wobble.amplitude(spin) / before;
    if (!std::isfinite(now)) return HUGE_VAL;
    largest = std::max(largest, now);
    if (largest > 1e4) break;  // no wobble any more
  }
  return largest;
}

/// A tumble without symmetry, at about a turn a second.
inline const common::Vec3 tumble_moments(1.0, 2.0, 3.0);
inline const common::Spin tumble_start{common::Quat(0.5, 0.5, -0.5, 0.5),
                                       common::Vec3(3.6, 3.7, 3.5)};

/// The largest angle [rad] to the exact attitude over all steps of one second of the tumble; NaN
/// where the method returns one.
inline double tumble_error(const SpinStep& step, int steps) {
  const common::FreeRotation exact(tumble_moments, tumble_start);
  common::Spin spin = tumble_start;
  double largest = 0.0;
  for (int i = 1; i <= steps; ++i) {
    spin = step(spin, 1.0 / steps);
    if (!is_finite(value_of(spin))) return std::nan("");
    const common::Spin wanted = exact.at(static_cast<double>(i) / steps);
    largest =
        std::max(largest, common::angle_between(spin.world_from_body, wanted.world_from_body));
  }
  return largest;
}

/// Requires that steps of half the length divide the error by 2^order.
///
/// steps  of the coarser run: so many that the error's next term, smaller by the factor ω dt or its
///        square, bends the slope by less than a tenth, and so few that rounding is far below
inline void expect_order(const std::string& function, const SpinStep& step, int steps,
                         double order) {
  const double coarse = tumble_error(step, steps);
  const double fine = tumble_error(step, 2 * steps);
  trial_of(function)
      .given("coarse error", coarse)
      .given("fine error", fine)
      .expect(std::log2(coarse / fine), order,
              {0.1, "the slope from " + std::to_string(steps) + " to " + std::to_string(2 * steps) +
                        " steps a second; a slope of 0 means that another motion is integrated"});
}

/// Requires that a body whose moments are equal keeps its angular velocity, and that it turns.
inline void expect_no_tumble_of_a_sphere(const std::string& function, const SpinStep& step) {
  const common::Spin start{common::Quat::Identity(), common::Vec3(1.0, -2.0, 3.0)};
  common::Spin spin = start;
  for (int i = 0; i < 100; ++i) spin = step(spin, 0.005);
  const Trial trial = spin_trial(function, common::Vec3::Constant(2.0), start);
  trial.of("the angular velocity after 100 steps")
      .expect(common::Vec3(spin.angular_velocity_body), start.angular_velocity_body,
              {100.0 * 64.0 * eps * 4.0, "only rounding may change it"});
  const double turned = common::angle_between(start.world_from_body, spin.world_from_body);
  trial.of("the turn after 100 steps of 0.005 s")
      .expect(turned, 0.5 * std::sqrt(14.0),
              {1e-2, "the least exact method lags by theta^3/12 per step"});
}

}  // namespace tests

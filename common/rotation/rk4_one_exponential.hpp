#pragma once

#include "common/rotation/attitude.hpp"
#include "common/rotation/spin.hpp"

namespace common {

/// Takes a torque-free step that looks like order 4 but is not. The body angular velocity takes the
/// classical Runge-Kutta step of Euler's equations, I ω' = I ω × ω. But the attitude turns only by
/// the exponential of the stages' mean:
///
///   q ← q exp((ω₁ + 2 ω₂ + 2 ω₃ + ω₄) dt / 6)
///
/// Turns about different axes do not commute, so the attitude is of order 2, the energy of order 4.
/// MuJoCo's Runge-Kutta integrator does this for free and ball joints.
inline Spin step_rk4_one_exponential(const Vec3& moments, const Spin& spin, double dt) {
  const auto rate = [&](const Vec3& w) {
    return Vec3(moments.cwiseProduct(w).cross(w).cwiseQuotient(moments));
  };
  const Vec3& w_1 = spin.angular_velocity_body;
  const Vec3 k_1 = rate(w_1);
  const Vec3 w_2 = w_1 + 0.5 * dt * k_1;
  const Vec3 k_2 = rate(w_2);
  const Vec3 w_3 = w_1 + 0.5 * dt * k_2;
  const Vec3 k_3 = rate(w_3);
  const Vec3 w_4 = w_1 + dt * k_3;
  const Vec3 k_4 = rate(w_4);
  const Vec3 mean = (w_1 + 2.0 * (w_2 + w_3) + w_4) / 6.0;
  return {(spin.world_from_body * exponential_map(mean * dt)).normalized(),
          w_1 + dt / 6.0 * (k_1 + 2.0 * (k_2 + k_3) + k_4)};
}

}  // namespace common

#include "common/rotation/free_rotation_stepper.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "common/rotation/attitude.hpp"

namespace common {

FreeRotationStepper::FreeRotationStepper(const FreeRotation& rotation, double dt)
    : rotation_(rotation),
      world_from_axes_(rotation.start().world_from_body * body_from_axes(rotation.polhode())) {
  if (rotation_.polhode().steady) {
    prepare_steady(dt);
  } else {
    prepare(dt);
  }
}

void FreeRotationStepper::prepare_steady(double dt) {
  const Quat axes_from_body = body_from_axes(rotation_.polhode()).conjugate();
  const Vec3 velocity = axes_from_body * rotation_.start().angular_velocity_body;
  k_ = exponential_map(velocity * dt);
  // With k = 0 and no advance the functions stay (√½, √½, 1), and so does the step.
  middle_ = {std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0, 1.0};
  k_.x() *= std::numbers::sqrt2;
  k_.y() *= std::numbers::sqrt2;
}

void FreeRotationStepper::prepare(double dt) {
  const Polhode& curve = rotation_.polhode();
  complementary_parameter_ = curve.complementary_parameter;
  const Vec3& amplitudes = curve.amplitudes;
  const JacobiFunctions& start = curve.start;
  momentum_ = world_from_axes_ * amplitudes.cwiseProduct(Vec3(start.cn, start.sn, start.dn));

  // The step from u = −v to v, whose middle is u = 0, gives k₀, k_c and k_d.
  const PolhodeAdvance half = polhode_advance(curve, 0.5 * dt);
  const auto& [S, C, D] = half.functions;
  const double cosine = std::cos(half.precession);
  const double sine = std::sin(half.precession);
  const auto [a, b, g] = std::array{amplitudes.x(), amplitudes.y(), amplitudes.z()};
  const double across = std::hypot(C, curve.ratio * S);
  k_.w() = (cosine * C + sine * g * D * curve.ratio * S) / across;
  k_.x() = sine * a * across;
  k_.z() = (sine * g * D * C - cosine * curve.ratio * S) / across;
  // From the step between two neighbouring middles, k_s = (k_d b C + k₀ a S) / g: written out, for
  // g may be small.
  k_.y() = (sine * b * D - cosine * (a / g) * curve.excess * S * C) / across;
  middle_ = jacobi_functions_of_sum(start, half.functions, complementary_parameter_);

  double u = curve.lambda * dt;
  if (complementary_parameter_ == 0.0) {
    u = std::clamp(u, -800.0, 800.0);  // sech has left the doubles
  } else {
    u = std::remainder(u, 4.0 * quarter_period(complementary_parameter_));
  }
  // The addition theorem loses the digits of e^2u: at u = 4, three of sixteen.
  parts_ = std::max(1, static_cast<int>(std::ceil(std::abs(u) / 4.0)));
  const JacobiFunctions by = polhode_advance(curve, u / parts_ / curve.lambda).functions;
  const double k_squared = 1.0 - complementary_parameter_;
  const double square = by.sn * by.sn;
  by_sn_ = by.sn;
  by_sn_dn_ = by.sn * by.dn;
  by_dn_squared_ = by.dn * by.dn;
  whole_ = std::abs(u / parts_) < 1.0 ? 1.0 : 0.0;
  cosine_loss_ = whole_ == 1.0 ? square / (1.0 + by.cn) : -by.cn;
  sine_loss_ =
      whole_ == 1.0 ? cosine_loss_ + by.cn * k_squared * square / (1.0 + by.dn) : -by.cn * by.dn;
}

Spin FreeRotationStepper::spin() const {
  const Polhode& curve = rotation_.polhode();
  Spin spin;
  const Quat world_from_axes = world_from_axes_.normalized();
  spin.world_from_body = world_from_axes * body_from_axes(curve).conjugate();
  spin.angular_velocity_body = rotation_.start().angular_velocity_body;
  if (!curve.steady) {
    const Vec3 momentum = world_from_axes.conjugate() * momentum_;
    spin.angular_velocity_body = in_body(curve, curve.rates.cwiseProduct(momentum));
  }
  return spin;
}

}  // namespace common

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#ifndef __SIZEOF_FLOAT128__
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include "common/rotation/spin.hpp"

/// The motion of a rigid body by Taylor's series with about 33 digits. It judges code that claims
/// to be exact in double, and shares no formula with the closed forms.
namespace tests {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Precise = __float128;
#else
using Precise = boost::multiprecision::cpp_bin_float_quad;
#endif

/// A free body, or one under gravity about a fixed point whose z axis holds its centre of mass.
struct PreciseBody {
  common::Vec3 moments = common::Vec3::Ones();
  double weight_moment = 0.0;  ///< m g l, with gravity along the world's −z
};

class PreciseSpin {
 public:
  /// Normalises the start's quaternion in all digits.
  PreciseSpin(const PreciseBody& body, const common::Spin& start)
      : weight_(Precise(body.weight_moment)) {
    const common::Quat& q = start.world_from_body;
    q_ = {Precise(q.w()), Precise(q.x()), Precise(q.y()), Precise(q.z())};
    normalize();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      w_[i] = Precise(start.angular_velocity_body[j]);
      moments_[i] = Precise(body.moments[j]);
    }
  }

  /// Runs to a later time, or for a negative duration to an earlier one. Each step drops terms of
  /// the size of tolerance.
  void run(double duration, double tolerance = 1e-30) {
    Precise left = Precise(duration);
    const double sign = duration < 0.0 ? -1.0 : 1.0;
    while (left != Precise(0)) {
      expand();
      Precise h = Precise(sign * step(tolerance));
      if (sign * static_cast<double>(left - h) <= 0.0) h = left;
      for (auto& q : series_q_) q[0] = sum(q, h);
      for (auto& w : series_w_) w[0] = sum(w, h);
      for (std::size_t i = 0; i < 4; ++i) q_[i] = series_q_[i][0];
      for (std::size_t i = 0; i < 3; ++i) w_[i] = series_w_[i][0];
      normalize();
      left -= h;
    }
  }

  [[nodiscard]] common::Spin spin() const {
    const auto rounded = [](const Precise& x) { return static_cast<double>(x); };
    common::Spin spin;
    spin.world_from_body =
        common::Quat(rounded(q_[0]), rounded(q_[1]), rounded(q_[2]), rounded(q_[3]));
    spin.angular_velocity_body = {rounded(w_[0]), rounded(w_[1]), rounded(w_[2])};
    return spin;
  }

  /// Returns the angle to an attitude [rad]. The length of the quaternion does not matter.
  [[nodiscard]] double angle_to(const common::Quat& q) const {
    return angle({Precise(q.w()), Precise(q.x()), Precise(q.y()), Precise(q.z())});
  }
  [[nodiscard]] double angle_to(const PreciseSpin& other) const { return angle(other.q_); }

  /// Returns the distance of an angular velocity from this one, over the size of this one.
  [[nodiscard]] double velocity_error(const common::Vec3& velocity) const {
    common::Vec3 difference;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      difference[j] = static_cast<double>(Precise(velocity[j]) - w_[i]);
    }
    return difference.norm() / spin().angular_velocity_body.norm();
  }

 private:
  [[nodiscard]] double angle(const std::array<Precise, 4>& q) const {
    const auto& [a, b, c, d] = q_;
    const auto& [w, x, y, z] = q;
    const auto along = static_cast<double>(a * w + b * x + c * y + d * z);
    const auto i = static_cast<double>(a * x - b * w - c * z + d * y);
    const auto j = static_cast<double>(a * y + b * z - c * w - d * x);
    const auto k = static_cast<double>(a * z - b * y + c * x - d * w);
    return 2.0 * std::atan2(std::hypot(i, j, k), std::abs(along));
  }

  static constexpr std::size_t order = 32;
  using Series = std::array<Precise, order + 1>;

  static Precise term(const Series& a, const Series& b, std::size_t n) {
    Precise sum = a[0] * b[n];
    for (std::size_t i = 1; i <= n; ++i) sum += a[i] * b[n - i];
    return sum;
  }

  static Precise sum(const Series& a, const Precise& h) {
    Precise sum = a[order];
    for (std::size_t n = order; n-- > 0;) sum = a[n] + h * sum;
    return sum;
  }

  void normalize() {
    Precise square = 0;
    for (const Precise& x : q_) square += x * x;
    Precise root = Precise(std::sqrt(static_cast<double>(square)));
    root = (root + square / root) / 2;  // Newton: 16 digits become 32
    root = (root + square / root) / 2;
    for (Precise& x : q_) x /= root;
  }

  /// Uses Euler's equations, q' = ½ q ω, and the vertical in the body, γ' = γ × ω.
  void expand() {
    for (std::size_t i = 0; i < 4; ++i) series_q_[i][0] = q_[i];
    for (std::size_t i = 0; i < 3; ++i) series_w_[i][0] = w_[i];
    const auto& [a, b, c, d] = q_;
    series_up_[0][0] = 2 * (b * d - a * c);
    series_up_[1][0] = 2 * (c * d + a * b);
    series_up_[2][0] = a * a - b * b - c * c + d * d;
    for (std::size_t n = 0; n < order; ++n) expand_by_one(n);
  }

  void expand_by_one(std::size_t n) {
    const auto& [q0, q1, q2, q3] = series_q_;
    const auto& [x, y, z] = series_w_;
    const auto next = Precise(static_cast<double>(n + 1));
    series_q_[0][n + 1] = -(term(q1, x, n) + term(q2, y, n) + term(q3, z, n)) / (2 * next);
    series_q_[1][n + 1] = (term(q0, x, n) + term(q2, z, n) - term(q3, y, n)) / (2 * next);
    series_q_[2][n + 1] = (term(q0, y, n) + term(q3, x, n) - term(q1, z, n)) / (2 * next);
    series_q_[3][n + 1] = (term(q0, z, n) + term(q1, y, n) - term(q2, x, n)) / (2 * next);
    std::array<Precise, 3> torque{};
    if (weight_ != Precise(0))
      torque = {weight_ * series_up_[1][n], -weight_ * series_up_[0][n], Precise(0)};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const Precise gyration = (moments_[j] - moments_[k]) * term(series_w_[j], series_w_[k], n);
      series_w_[i][n + 1] = (gyration + torque[i]) / (moments_[i] * next);
      if (weight_ == Precise(0)) continue;
      series_up_[i][n + 1] =
          (term(series_up_[j], series_w_[k], n) - term(series_up_[k], series_w_[j], n)) / next;
    }
  }

  /// Returns the step at which the last two terms reach the tolerance, times the size of each
  /// series.
  [[nodiscard]] double step(double tolerance) const {
    const auto largest = [this](std::size_t n) {
      double size = 0.0;
      for (const auto& q : series_q_) size = std::max(size, std::abs(static_cast<double>(q[n])));
      double velocity = 0.0;
      double velocity_size = 0.0;
      for (const auto& w : series_w_) {
        velocity = std::max(velocity, std::abs(static_cast<double>(w[n])));
        velocity_size = std::max(velocity_size, std::abs(static_cast<double>(w[0])));
      }
      return velocity_size == 0.0 ? size : std::max(size, velocity / velocity_size);
    };
    double h = 1e300;
    for (const std::size_t n : {order - 1, order}) {
      if (largest(n) > 0.0) {
        h = std::min(h, std::pow(tolerance / largest(n), 1.0 / static_cast<double>(n)));
      }
    }
    return h;
  }

  Precise weight_;
  std::array<Precise, 4> q_{};
  std::array<Precise, 3> w_{};
  std::array<Precise, 3> moments_{};
  std::array<Series, 4> series_q_{};
  std::array<Series, 3> series_w_{};
  std::array<Series, 3> series_up_{};
};

}  // namespace tests

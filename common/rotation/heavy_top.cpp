#include "common/rotation/heavy_top.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/elliptic/elliptic_integrals.hpp"

namespace common {
namespace {

HeavyTop checked_top(const HeavyTop& top) {
  checked_moments({top.transverse_moment, top.transverse_moment, top.axial_moment});
  if (!std::isfinite(top.weight_moment) || top.weight_moment < 0.0) {
    throw std::invalid_argument("heavy top: the weight's moment is negative or not finite");
  }
  return top;
}

/// The horizontal part of the vertical in the body: (γ₁, γ₂).
Eigen::Vector2d level_part(const Quat& q) {
  return {2.0 * (q.x() * q.z() - q.w() * q.y()), 2.0 * (q.y() * q.z() + q.w() * q.x())};
}

/// The largest root of β δ³ + f₂ δ² + f₁ δ + f₀, β > 0, which has three real ones: Newton's method
/// falls onto it from above.
double largest_root(double beta, double f_2, double f_1, double f_0) {
  double x = 2.0 * std::max({std::abs(f_2 / beta), std::sqrt(std::abs(f_1 / beta)),
                             std::cbrt(std::abs(f_0 / beta))});  // Fujiwara's bound
  for (int i = 0; i < 200; ++i) {
    const double value = ((beta * x + f_2) * x + f_1) * x + f_0;
    const double slope = (3.0 * beta * x + 2.0 * f_2) * x + f_1;
    if (value <= 0.0 || slope <= 0.0) break;
    const double next = x - value / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

/// The roots (δ₁ ≤ 0 ≤ δ₂) of δ² − S δ + q with q ≤ 0: nothing cancels.
std::pair<double, double> roots_around_zero(double S, double q) {
  const double far = 0.5 * S + std::copysign(std::sqrt(0.25 * S * S - q), S);
  const double near = far == 0.0 ? 0.0 : q / far;
  return std::minmax(far, near);
}

}  // namespace

LagrangeTop::LagrangeTop(const HeavyTop& top, const Spin& start)
    : top_(checked_top(top)), start_(checked_spin(start)) {
  if (top_.weight_moment > 0.0) find_turning_points();
}

/// f(u) = u'² = (α − β u)(1 − u²) − (b − a u)² about the start, u = u₀ + δ: there its value and its
/// slope are known to their own size, so a steady precession keeps its double root.
void LagrangeTop::find_turning_points() {
  const Quat& q = start_.world_from_body;
  const Vec3& w = start_.angular_velocity_body;
  const double up = 2.0 * (q.x() * q.x() + q.y() * q.y());    // 1 − u₀
  const double down = 2.0 * (q.w() * q.w() + q.z() * q.z());  // 1 + u₀
  const double u = 0.5 * (down - up);
  const Eigen::Vector2d gamma = level_part(q);
  const double a = top_.axial_moment / top_.transverse_moment * w.z();
  const double beta = 2.0 * top_.weight_moment / top_.transverse_moment;
  const double sigma = gamma.dot(w.head<2>());  // b − a u₀ = φ' sin² θ
  const double u_rate = gamma.x() * w.y() - gamma.y() * w.x();
  const double T = w.head<2>().squaredNorm();  // α − β u₀
  half_up_ = 0.5 * (sigma - a * up);
  half_down_ = 0.5 * (sigma + a * down);

  const double f_0 = u_rate * u_rate;
  const double f_1 = 2.0 * a * sigma - beta * up * down - 2.0 * u * T;
  const double f_2 = 2.0 * beta * u - T - a * a;
  const double delta_3 = largest_root(beta, f_2, f_1, f_0);
  const double product = -f_0 / (beta * delta_3);
  const auto [delta_1, delta_2] = roots_around_zero((f_1 / beta - product) / delta_3, product);

  swing_ = delta_2 - delta_1;
  from_up_1_ = up - delta_1;
  from_down_2_ = down + delta_2;
  // f(1) = −(b − a)² and f(−1) = −(b + a)² give what would cancel in 1 − u₂, u₃ − 1 and 1 + u₁.
  const double Q = 4.0 * half_up_ * half_up_ / (beta * from_up_1_);
  const double half_gap = 0.5 * (delta_3 + delta_2) - up;
  const double root = std::sqrt(half_gap * half_gap + Q);  // half of u₃ − u₂
  from_up_2_ = half_gap > 0.0 ? Q / (root + half_gap) : root - half_gap;
  from_down_1_ = 4.0 * half_down_ * half_down_ / (beta * from_down_2_ * (2.0 + delta_3 - up));
  if (!(std::min(from_up_2_, from_down_1_) > 0.5 * smallest_tilt * smallest_tilt)) {
    throw std::invalid_argument("heavy top: the axis comes too close to the vertical");
  }

  rate_ = 0.5 * std::sqrt(beta * (delta_3 - delta_1));
  complementary_parameter_ = std::min(1.0, 2.0 * root / (delta_3 - delta_1));
  JacobiFunctions at;
  if (swing_ > 0.0) {
    at.sn = std::copysign(std::sqrt(-delta_1 / swing_), u_rate);
    at.cn = std::sqrt(delta_2 / swing_);
  }
  at.dn = std::sqrt(at.cn * at.cn + complementary_parameter_ * at.sn * at.sn);
  phase_ = first_kind(at, complementary_parameter_);
}

/// ∫ half / (1 ∓ u) dt from the start, where 1 ∓ u = at_1 cn² x + at_2 sn² x.
double LagrangeTop::angle(double x, double half, double at_1, double at_2) const {
  const double m_1 = complementary_parameter_;
  const double r = at_2 / at_1;
  const auto integral = [&](double within) {
    return third_kind(jacobi_functions(within, m_1), r, m_1);
  };
  const auto [within, half_turns] = reduced_argument(x, m_1);
  double sum = integral(within) - integral(phase_);
  if (half_turns != 0.0) {
    sum += 2.0 * half_turns * third_kind(functions_at_quarter_period(m_1), r, m_1);
  }
  return half / (rate_ * at_1) * sum;
}

Spin LagrangeTop::at(double time) const {
  if (top_.weight_moment == 0.0) return free_symmetric_step(top_, start_, time);
  const double x = phase_ + rate_ * time;
  const auto [within, half_turns] = reduced_argument(x, complementary_parameter_);
  const auto [sn, cn, dn] = jacobi_functions(within, complementary_parameter_);
  const double up = from_up_1_ * cn * cn + from_up_2_ * sn * sn;        // 1 − u
  const double down = from_down_1_ * cn * cn + from_down_2_ * sn * sn;  // 1 + u

  // (w, z) is cos θ/2 at the angle (φ + ψ)/2, and (x, y) is sin θ/2 at (φ − ψ)/2.
  const double w_3 = start_.angular_velocity_body.z();
  const double own = 0.5 * w_3 * (1.0 - top_.axial_moment / top_.transverse_moment) * time;
  const double plus = angle(x, half_down_, from_down_1_, from_down_2_) + own;
  const double minus = angle(x, half_up_, from_up_1_, from_up_2_) - own;
  const Quat& q_0 = start_.world_from_body;
  const Eigen::Vector2d wz =
      Eigen::Rotation2Dd(plus) * Eigen::Vector2d(q_0.w(), q_0.z()).normalized();
  const Eigen::Vector2d xy =
      Eigen::Rotation2Dd(minus) * Eigen::Vector2d(q_0.x(), q_0.y()).normalized();
  const double cosine = std::sqrt(0.5 * down);
  const double sine = std::sqrt(0.5 * up);
  const Quat q(cosine * wz.x(), sine * xy.x(), sine * xy.y(), cosine * wz.y());

  const double sigma = half_up_ * down + half_down_ * up;  // b − a u
  const double u_rate = 2.0 * rate_ * swing_ * sn * cn * dn;
  const Eigen::Vector2d gamma = level_part(q);
  const Eigen::Vector2d across(-gamma.y(), gamma.x());
  const Eigen::Vector2d level = (sigma * gamma + u_rate * across) / (up * down);
  return {q.normalized(), Vec3(level.x(), level.y(), w_3)};
}

}  // namespace common

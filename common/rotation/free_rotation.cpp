#include "common/rotation/free_rotation.hpp"

#include <cmath>
#include <limits>

#include "common/rotation/attitude.hpp"

namespace common {
namespace {

/// The rotation from the axes (c, s, d) to axes with z along the momentum and x along the line of
/// nodes: Rx(θ) Rz(ψ) with tan ψ = m_c / m_s and tan θ = |(m_c, m_s)| / m_d.
Quat nodes_from_axes(const Polhode& curve, const JacobiFunctions& at) {
  const double m_s_over_a = curve.ratio * at.sn;
  const double psi = std::atan2(at.cn, m_s_over_a);
  const double theta = std::atan2(curve.amplitudes.x() * std::hypot(at.cn, m_s_over_a),
                                  curve.amplitudes.z() * at.dn);
  return Quat(std::cos(0.5 * theta), std::sin(0.5 * theta), 0.0, 0.0) *
         Quat(std::cos(0.5 * psi), 0.0, 0.0, std::sin(0.5 * psi));
}

double one_minus_cn(const JacobiFunctions& f) {
  return f.cn > 0.0 ? f.sn * f.sn / (1.0 + f.cn) : 1.0 - f.cn;
}

/// What the precession from u₀ to u₀ + w has beyond the one from 0 to w: the addition theorem of
/// the integral of the third kind (Byrd & Friedman 1971, 116.03). Always within ±π/2.
double added_precession(const Polhode& curve, const JacobiFunctions& from,
                        const JacobiFunctions& by, const JacobiFunctions& to) {
  const double n = curve.excess;
  const double k_squared = 1.0 - curve.complementary_parameter;
  const double spread = one_minus_cn(from) + from.cn * one_minus_cn(by) +
                        from.cn * by.cn * one_minus_cn(to);  // 1 − cn cn cn
  return std::atan2(std::sqrt(n * (1.0 + n) * (n + k_squared)) * from.sn * by.sn * to.sn,
                    1.0 + n * spread);
}

}  // namespace

FreeRotation::FreeRotation(const Vec3& moments, const Spin& start)
    : start_(checked_spin(start)),
      polhode_(common::polhode(checked_moments(moments), start.angular_velocity_body)) {}

Spin FreeRotation::at(double time) const {
  if (polhode_.steady) {
    const Vec3 turn = start_.angular_velocity_body * time;
    return {start_.world_from_body * exponential_map(turn), start_.angular_velocity_body};
  }
  const PolhodeAdvance advance = polhode_advance(polhode_, time);
  const JacobiFunctions& from = polhode_.start;
  const JacobiFunctions to =
      jacobi_functions_of_sum(from, advance.functions, polhode_.complementary_parameter);
  const double added = added_precession(polhode_, from, advance.functions, to);
  const bool circles_minor = polhode_.rates.x() < polhode_.rates.y();
  const double precession = advance.precession + (circles_minor ? added : -added);

  const Quat turn = nodes_from_axes(polhode_, from).conjugate() *
                    Quat(std::cos(0.5 * precession), 0.0, 0.0, std::sin(0.5 * precession)) *
                    nodes_from_axes(polhode_, to);
  const Vec3 axes_velocity =
      polhode_.rates.cwiseProduct(polhode_.amplitudes.cwiseProduct(Vec3(to.cn, to.sn, to.dn)));
  Quat body_turn;
  body_turn.w() = turn.w();
  body_turn.vec() = in_body(polhode_, turn.vec());
  return {(start_.world_from_body * body_turn).normalized(), in_body(polhode_, axes_velocity)};
}

double FreeRotation::period() const {
  if (polhode_.lambda == 0.0) return std::numeric_limits<double>::infinity();
  return 4.0 * quarter_period(polhode_.complementary_parameter) / polhode_.lambda;
}

}  // namespace common

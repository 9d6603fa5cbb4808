#include "common/rotation/polhode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/elliptic/elliptic_integrals.hpp"
#include "common/exact/exact_sum.hpp"

namespace common {
namespace {

/// D = L² − 2 E I_s = Σ I_i (I_i − I_s) ω_i² over the two outer axes, correct to an ulp.
double separatrix_distance(const Vec3& I, const Vec3& omega, const std::array<int, 3>& sorted) {
  ExactSum D;
  for (const int outer : {sorted[0], sorted[2]}) {
    ExactSum moment;
    moment.add(I[outer]);
    ExactSum difference;
    difference.add(I[outer]);
    difference.add(-I[sorted[1]]);
    ExactSum square;
    square.add_product(omega[outer], omega[outer]);
    ExactSum weighted;
    weighted.add_product(square, moment);
    D.add_product(weighted, difference);
  }
  return D.value();
}

bool is_steady(const Vec3& I, const Vec3& omega) {
  return (I.y() - I.z()) * omega.y() * omega.z() == 0.0 &&
         (I.z() - I.x()) * omega.z() * omega.x() == 0.0 &&
         (I.x() - I.y()) * omega.x() * omega.y() == 0.0;
}

bool is_left_handed(const std::array<int, 3>& axes) { return (axes[1] - axes[0] + 3) % 3 == 2; }

/// The power of two that brings the largest entry into [½, 1): scaling by it is exact.
int exponent(const Vec3& v) {
  int e = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &e);
  return e;
}

}  // namespace

Polhode polhode(const Vec3& moments, const Vec3& angular_velocity) {
  Polhode curve;
  if (angular_velocity.isZero(0.0)) return curve;
  const int turns = exponent(angular_velocity);
  const Vec3 omega = angular_velocity.unaryExpr([&](double w) { return std::ldexp(w, -turns); });
  const int size = exponent(moments);
  const Vec3 moment = moments.unaryExpr([&](double I) { return std::ldexp(I, -size); });
  curve.steady = is_steady(moment, omega);

  std::array<int, 3> sorted{0, 1, 2};
  std::sort(sorted.begin(), sorted.end(), [&](int i, int j) { return moment[i] < moment[j]; });
  const double D = separatrix_distance(moment, omega, sorted);
  if (D < 0.0) std::swap(sorted[0], sorted[2]);
  curve.axes = sorted;
  curve.sign_c = is_left_handed(sorted) ? -1.0 : 1.0;

  const auto [c, s, d] = sorted;
  const Vec3 I(moment[c], moment[s], moment[d]);
  const Vec3 w(curve.sign_c * omega[c], omega[s], omega[d]);
  const Vec3 m = I.cwiseProduct(w);
  const double L = m.norm();
  curve.rates = std::ldexp(L, turns) * I.cwiseInverse();

  const double d_c = std::abs(I.z() - I.x());
  const double d_s = std::abs(I.z() - I.y());
  const double s_c = std::abs(I.y() - I.x());
  const double P_d = m.x() * w.x() * d_c + m.y() * w.y() * d_s;
  const double P_c = m.y() * w.y() * s_c + m.z() * w.z() * d_c;
  if (P_c == 0.0 || d_s == 0.0) return curve;  // nothing swings
  curve.lambda = std::ldexp(std::sqrt(d_s * P_c / (I.x() * I.y() * I.z())), turns);
  curve.complementary_parameter = std::min(1.0, d_c * std::abs(D) / (d_s * P_c));
  curve.excess = I.z() * s_c / (I.x() * d_s);

  const bool circles_minor = I.z() < I.x();
  const bool negative = std::signbit(m.z()) != circles_minor;
  curve.ratio = (negative ? -1.0 : 1.0) * std::sqrt(1.0 + curve.excess);
  const double a = std::sqrt(I.x() * P_d / d_c);
  curve.amplitudes =
      Vec3(a, curve.ratio * a, std::copysign(std::sqrt(I.z() * P_c / d_c), m.z())) / L;
  const double length = std::hypot(m.x(), m.y() / curve.ratio);
  if (length > 0.0) {
    curve.start.cn = m.x() / length;
    curve.start.sn = m.y() / curve.ratio / length;
  }
  if (curve.complementary_parameter == 0.0 && curve.start.cn < 0.0) {
    // On the separatrix cn = sech keeps its sign, so the amplitudes take it.
    curve.amplitudes.head<2>() *= -1.0;
    curve.start.cn *= -1.0;
    curve.start.sn *= -1.0;
  }
  curve.start.dn =
      std::hypot(curve.start.cn, std::sqrt(curve.complementary_parameter) * curve.start.sn);
  return curve;
}

Vec3 in_body(const Polhode& polhode, const Vec3& of_axes) {
  const auto [c, s, d] = polhode.axes;
  Vec3 body;
  body[c] = polhode.sign_c * of_axes.x();
  body[s] = of_axes.y();
  body[d] = of_axes.z();
  return body;
}

Quat body_from_axes(const Polhode& polhode) {
  Mat3 R;
  for (int i = 0; i < 3; ++i) R.col(i) = in_body(polhode, Vec3::Unit(i));
  return Quat(R);
}

PolhodeAdvance polhode_advance(const Polhode& polhode, double time) {
  const double m_1 = polhode.complementary_parameter;
  const auto [within, half_turns] = reduced_argument(polhode.lambda * time, m_1);
  const double r = 1.0 + polhode.excess;
  PolhodeAdvance advance{jacobi_functions(within, m_1), 0.0};
  double slow = cosine_share(advance.functions, r, m_1);
  if (half_turns != 0.0) {
    slow += 2.0 * half_turns * cosine_share(functions_at_quarter_period(m_1), r, m_1);
    if (std::fmod(half_turns, 2.0) != 0.0) {
      advance.functions.sn *= -1.0;
      advance.functions.cn *= -1.0;
    }
  }
  // φ' = L/I_s + (L/I_c − L/I_s) m_c² / (m_c² + m_s²)
  const double coefficient = (polhode.rates.x() - polhode.rates.y()) / polhode.lambda;
  advance.precession = polhode.rates.y() * time + coefficient * slow;
  return advance;
}

}  // namespace common

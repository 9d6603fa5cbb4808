#include "common/rotation/moser_veselov_correction.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace common {
namespace {

/// What the coefficients are made of: dt² E, dt² |L|² / 2, and the elementary symmetric polynomials
/// of the inverse moments. They are found, in rational numbers, from the exact flow through a point
/// of the polhode where m_s = 0, taken as the middle of a step: there both other components of
/// 1/Ĩ = 2 p₀ p / (dt m̄) are even power series in dt, and two of them give scale and shift.
struct Invariants {
  double H;
  double C;
  double e_1;
  double e_2;
  double e_3;
};

/// Of order dt^2.
MomentCorrection term_two(const Invariants& of) {
  const auto& [H, C, e_1, e_2, e_3] = of;
  return {C * e_2 / 6.0 - H * e_1 / 3.0, H * e_2 / 6.0 - C * e_3 / 3.0};
}

/// Of order dt^4.
MomentCorrection term_four(const Invariants& of) {
  const auto& [H, C, e_1, e_2, e_3] = of;
  return {H * H * (2.0 * e_1 * e_1 - e_2) / 60.0 + H * C * (4.0 * e_3 - e_1 * e_2) / 30.0 +
              C * C * (e_2 * e_2 - 3.0 * e_1 * e_3) / 30.0,
          H * C * (8.0 * e_1 * e_3 - e_2 * e_2) / 60.0 - H * H * (e_1 * e_2 + 6.0 * e_3) / 60.0 -
              C * C * e_2 * e_3 / 60.0};
}

/// Of order dt^6.
MomentCorrection term_six(const Invariants& of) {
  const auto& [H, C, e_1, e_2, e_3] = of;
  return {
      H * H * H * (e_1 * e_2 + 18.0 * e_3 - e_1 * e_1 * e_1) / 630.0 +
          H * H * C * (6.0 * e_1 * e_1 * e_2 + 41.0 * e_2 * e_2 - 212.0 * e_1 * e_3) / 2520.0 +
          H * C * C * (22.0 * e_1 * e_1 * e_3 - 6.0 * e_1 * e_2 * e_2 - 5.0 * e_2 * e_3) / 420.0 +
          C * C * C * (17.0 * e_2 * e_2 * e_2 + 100.0 * e_3 * e_3 - 66.0 * e_1 * e_2 * e_3) /
              2520.0,
      H * H * H * (e_1 * e_1 * e_2 + 30.0 * e_1 * e_3 - 13.0 * e_2 * e_2) / 1260.0 +
          H * H * C * (13.0 * e_1 * e_2 * e_2 + 110.0 * e_2 * e_3 - 64.0 * e_1 * e_1 * e_3) /
              2520.0 +
          H * C * C * (e_2 * e_2 * e_2 - e_1 * e_2 * e_3 - 88.0 * e_3 * e_3) / 1260.0 +
          C * C * C * (72.0 * e_1 * e_3 * e_3 - 19.0 * e_2 * e_2 * e_3) / 2520.0};
}

/// Of order dt^8.
MomentCorrection term_eight(const Invariants& of) {
  const auto& [H, C, e_1, e_2, e_3] = of;
  return {H * H * H * H *
                  (2.0 * e_1 * e_1 * e_1 * e_1 + 153.0 * e_2 * e_2 - 3.0 * e_1 * e_1 * e_2 -
                   486.0 * e_1 * e_3) /
                  45360.0 +
              H * H * H * C *
                  (276.0 * e_1 * e_1 * e_3 - e_1 * e_1 * e_1 * e_2 - 66.0 * e_1 * e_2 * e_2 -
                   207.0 * e_2 * e_3) /
                  11340.0 +
              H * H * C * C *
                  (26.0 * e_1 * e_1 * e_2 * e_2 + 3.0 * e_2 * e_2 * e_2 + 30.0 * e_1 * e_2 * e_3 +
                   318.0 * e_3 * e_3 - 102.0 * e_1 * e_1 * e_1 * e_3) /
                  7560.0 +
              H * C * C * C *
                  (306.0 * e_1 * e_1 * e_2 * e_3 + 141.0 * e_2 * e_2 * e_3 -
                   77.0 * e_1 * e_2 * e_2 * e_2 - 1128.0 * e_1 * e_3 * e_3) /
                  22680.0 +
              C * C * C * C *
                  (62.0 * e_2 * e_2 * e_2 * e_2 + 378.0 * e_1 * e_1 * e_3 * e_3 +
                   291.0 * e_2 * e_3 * e_3 - 342.0 * e_1 * e_2 * e_2 * e_3) /
                  45360.0,
          H * H * H * H *
                  (459.0 * e_2 * e_3 - e_1 * e_1 * e_1 * e_2 - 6.0 * e_1 * e_2 * e_2 -
                   126.0 * e_1 * e_1 * e_3) /
                  45360.0 +
              H * H * H * C *
                  (97.0 * e_2 * e_2 * e_2 + 64.0 * e_1 * e_1 * e_1 * e_3 -
                   15.0 * e_1 * e_1 * e_2 * e_2 - 276.0 * e_1 * e_2 * e_3 - 648.0 * e_3 * e_3) /
                  22680.0 +
              H * H * C * C *
                  (19.0 * e_1 * e_1 * e_2 * e_3 + 356.0 * e_1 * e_3 * e_3 -
                   5.0 * e_1 * e_2 * e_2 * e_2 - 133.0 * e_2 * e_2 * e_3) /
                  7560.0 +
              H * C * C * C *
                  (222.0 * e_1 * e_2 * e_2 * e_3 + 684.0 * e_2 * e_3 * e_3 - e_2 * e_2 * e_2 * e_2 -
                   864.0 * e_1 * e_1 * e_3 * e_3) /
                  45360.0 +
              C * C * C * C *
                  (243.0 * e_1 * e_2 * e_3 * e_3 - 61.0 * e_2 * e_2 * e_2 * e_3 -
                   610.0 * e_3 * e_3 * e_3) /
                  45360.0};
}

}  // namespace

MomentCorrection moser_veselov_correction(const Vec3& moments, const Spin& spin, double dt,
                                          int order) {
  if (order < 2 || order > 10 || order % 2 != 0) {
    throw std::invalid_argument("Moser-Veselov correction: order " + std::to_string(order) +
                                " is not 2, 4, 6, 8 or 10");
  }
  const Vec3 j = checked_moments(moments).cwiseInverse();
  const Vec3 momentum = dt * moments.cwiseProduct(spin.angular_velocity_body);
  const double e_2 = j.x() * j.y() + j.y() * j.z() + j.z() * j.x();
  const Invariants of{0.5 * momentum.cwiseAbs2().dot(j), 0.5 * momentum.squaredNorm(), j.sum(), e_2,
                      j.prod()};
  constexpr std::array terms{&term_two, &term_four, &term_six, &term_eight};
  MomentCorrection correction;
  for (int power = 4; power <= order; power += 2) {
    const MomentCorrection term = terms[static_cast<std::size_t>(power / 2 - 2)](of);
    correction.scale += term.scale;
    correction.shift += term.shift;
  }
  return correction;
}

}  // namespace common

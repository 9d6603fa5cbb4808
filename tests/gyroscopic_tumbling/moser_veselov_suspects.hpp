#pragma once

#include "motions.hpp"

/// What students get wrong in eq. (23) and (26) of step 2.8.
namespace tests {

/// What eq. (26) multiplies.
struct Factors {
  Real H = 0.5L;  ///< of omega . I omega
  Real C = 0.5L;  ///< of |m|²
  Real scale_first = 1, scale_second = 1, shift_first = 1, shift_second = 1;
  Real scale_power = 2, shift_power = 2;  ///< of dt
};

inline common::MomentCorrection with_powers(const Vec3& I, const Spin& spin, double time,
                                            const Factors& v = {}) {
  const VecL i = wide(I);
  const VecL m = times(i, wide(spin.angular_velocity_body));
  const Real H = v.H * wide(spin.angular_velocity_body).dot(m);
  const Real C = v.C * m.squaredNorm();
  const Real dt = wide(time);
  const Real mixed = i.sum() / (6 * i.prod());
  const Real scale = v.scale_first * mixed * C - v.scale_second * i.cwiseInverse().sum() / 3 * H;
  const Real shift = v.shift_first * mixed * H - v.shift_second * C / (3 * i.prod());
  return {static_cast<double>(std::pow(dt, v.scale_power) * scale),
          static_cast<double>(std::pow(dt, v.shift_power) * shift)};
}

inline Vec3 as_vector(const common::MomentCorrection& c) { return {c.scale, c.shift, 0.0}; }

inline std::vector<Suspect<Vec3>> correction_suspects(const Vec3& moments, const Spin& spin,
                                                      double dt) {
  const auto with = [&](const Factors& v) { return as_vector(with_powers(moments, spin, dt, v)); };
  const Vec3 right = with({});
  const char* const third =
      "a factor of eq. (26) is wrong: it has 6 in the first terms, 3 in the second";
  return {
      {Vec3(right.y(), right.x(), 0.0), "scale and shift are swapped: exchange them"},
      {with({.scale_power = 0, .shift_power = 0}), "the factor dt^2 is missing: multiply by dt^2"},
      {with({.scale_power = 1, .shift_power = 1}), "the factor is dt: use dt^2"},
      {with({.scale_power = 1}), "the factor of scale is dt: use dt^2"},
      {with({.shift_power = 1}), "the factor of shift is dt: use dt^2"},
      {with({.H = 1, .C = 1}), "H and C lack their factor 1/2: multiply both by 0.5"},
      {with({.C = 1}), "C lacks its factor 1/2: it is |m|^2 / 2"},
      {with({.H = 1}), "H lacks its factor 1/2: it is the energy, omega . I omega / 2"},
      {with({.scale_second = -1, .shift_second = -1}), "the second terms are added: subtract them"},
      {with({.scale_second = 3}), third},
      {with({.shift_second = 3}), third},
      {with({.scale_second = 3, .shift_second = 3}), third},
      {with({.scale_first = 2}), third},
      {with({.shift_first = 2}), third},
      {with({.scale_first = 2, .shift_first = 2}), third},
      {with({.scale_first = 6, .shift_first = 6}), third},
      {Vec3(-right), "the sign of the correction is flipped: change it"}};
}

inline std::vector<Suspect<Vec3>> moment_suspects(const Vec3& moments,
                                                  const common::MomentCorrection& correction) {
  const VecL I = wide(moments);
  const Real scale = wide(correction.scale);
  const Real shift = wide(correction.shift);
  return {{narrow(VecL((1 + scale) * I.array() + shift)),
           "the moments are scaled and shifted: scale and shift their inverses"},
          {narrow(VecL((1 + scale) * I.cwiseInverse().array() + shift)),
           "these are the inverses: return the moments"},
          {narrow(corrected(I, shift, scale)), "scale and shift are swapped: exchange them"},
          {narrow(corrected(I, scale - 1, shift)),
           "the 1 in 1 + scale is missing: multiply by 1 + scale"},
          {narrow(corrected(I, scale, 0)), "the shift is left out: add it to (1 + scale)/I_i"},
          {narrow(corrected(I, 0, shift)), "scale is left out: multiply 1/I_i by 1 + scale"},
          {narrow(corrected(I, -scale, shift)), "the sign of scale is flipped: it is 1 + scale"},
          {narrow(corrected(I, scale, -shift)), "the sign of shift is flipped: add it"},
          {narrow(VecL(((1 + scale) * (I.cwiseInverse().array() + shift)).inverse())),
           "shift is scaled, too: multiply only 1/I_i by 1 + scale"}};
}

}  // namespace tests

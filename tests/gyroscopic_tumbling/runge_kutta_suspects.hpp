#pragma once

#include "motions.hpp"

/// Step 2.4 in extended precision, with what students get wrong in it as switches.
namespace tests {

inline VecL right_rate(const VecL& I, const VecL& w) { return euler_rate(I, w); }

/// Euler's equation of one component with its difference of moments the wrong way round.
template <int i>
VecL slipped_rate(const VecL& I, const VecL& w) {
  VecL rate = euler_rate(I, w);
  rate(i) = -rate(i);
  return rate;
}

struct RateMistake {
  VecL (*value)(const VecL& I, const VecL& w);
  const char* story;
};

/// What can be wrong with the rate of omega, and so with the step.
inline const std::vector<RateMistake>& rate_mistakes() {
  using V = const VecL&;
  static const std::vector<RateMistake> all{
      {[](V I, V w) -> VecL { return euler_rate(I, w, -1); }, flipped},
      {[](V I, V w) -> VecL { return euler_rate(I, w, 0); }, forgotten},
      {[](V I, V w) -> VecL { return times(I, w).cross(w); },
       "the inverse of the inertia is missing: divide the gyroscopic term by the moments"},
      {[](V I, V w) -> VecL { return times(I, times(I, w).cross(w)); },
       "the moments multiply the gyroscopic term: divide it by them"},
      {slipped_rate<0>,
       "component 1 of I0 omega x omega has the wrong sign: it is (I2 - I3) w2 w3"},
      {slipped_rate<1>,
       "component 2 of I0 omega x omega has the wrong sign: it is (I3 - I1) w3 w1"},
      {slipped_rate<2>,
       "component 3 of I0 omega x omega has the wrong sign: it is (I1 - I2) w1 w2"}};
  return all;
}

enum class Stages { right, third_by_first, whole, chained };

struct Rk4Variation {
  VecL (*euler)(const VecL& I, const VecL& w) = right_rate;
  Real half = 0.5L;               ///< in dq/dt
  bool world_side = false;        ///< ω q for q ω
  Real outer = 1;                 ///< weight of the first and the last rate
  Real inner = 2;                 ///< weight of the other two
  Real divisor = 6;               ///< of the weighted sum
  Stages stages = Stages::right;  ///< where the middle rates are taken
  bool short_last = false;        ///< the fourth rate at the middle
  bool unit_stages = false;       ///< q normalised in between
  bool unit_end = true;           ///< q normalised at the end
  bool one_exponential = false;   ///< q turned once, by the mean of the stages' ω
};

struct RateL {
  QuatL q;
  VecL omega;
};

inline RateL rate(const VecL& I, const SpinL& spin, const Rk4Variation& v) {
  const QuatL product = v.world_side ? pure(spin.omega) * spin.q : spin.q * pure(spin.omega);
  return {QuatL(Eigen::Matrix<Real, 4, 1>(v.half * product.coeffs())), v.euler(I, spin.omega)};
}

inline SpinL moved(const SpinL& spin, const RateL& k, Real dt, bool unit) {
  SpinL next{sum(spin.q, dt, k.q), VecL(spin.omega + dt * k.omega)};
  if (unit) next.q.normalize();
  return next;
}

inline SpinL rk4(const Vec3& moments, const Spin& spin, Real dt, const Rk4Variation& v = {}) {
  const VecL I = wide(moments);
  const SpinL s1 = wide(spin);
  const RateL k1 = rate(I, s1, v);
  const Real half = v.stages == Stages::whole ? dt : dt / 2;
  const SpinL s2 = moved(s1, k1, half, v.unit_stages);
  const RateL k2 = rate(I, s2, v);
  const SpinL s3 = v.stages == Stages::third_by_first
                       ? s2
                       : moved(v.stages == Stages::chained ? s2 : s1, k2, half, v.unit_stages);
  const RateL k3 = rate(I, s3, v);
  const SpinL s4 =
      moved(v.stages == Stages::chained ? s3 : s1, k3, v.short_last ? dt / 2 : dt, v.unit_stages);
  const RateL k4 = rate(I, s4, v);
  const Real outer = v.outer * dt / v.divisor;
  const Real inner = v.inner * dt / v.divisor;
  SpinL next = moved(moved(s1, k1, outer, false), k2, inner, false);
  next = moved(moved(next, k3, inner, false), k4, outer, v.unit_end);
  if (v.one_exponential) {
    const VecL mean = (s1.omega + 2 * s2.omega + 2 * s3.omega + s4.omega) / 6;
    next.q = s1.q * turn(dt * mean);
  }
  return next;
}

inline std::vector<Suspect<SpinValue>> rk4_suspects(const Vec3& moments, const Spin& spin,
                                                    double dt) {
  const auto with = [&](const Rk4Variation& v) { return narrow(rk4(moments, spin, wide(dt), v)); };
  std::vector<Suspect<SpinValue>> all{
      {with({.half = 1}), "the factor 1/2 is missing in dq/dt: multiply by 0.5"},
      {with({.half = 0}), "q does not change, because 1/2 is 0 in whole numbers: write 0.5"},
      {narrow(wide(spin)),
       "nothing changes, because 1/6 and 1/3 are 0 in whole numbers: write 1.0 / 6.0"},
      {with({.world_side = true}),
       "omega stands on the left of q, but it is in body axes: put it on the right"},
      {with({.outer = 1, .inner = 1, .divisor = 4}),
       "the four rates have equal weights: use 1, 2, 2, 1"},
      {with({.outer = 2, .inner = 1}), "the weights are 2, 1, 1, 2: use 1, 2, 2, 1"},
      {with({.divisor = 1}), "the sum of the rates is not divided: divide it by 6"},
      {with({.divisor = 4}), "the sum of the rates is divided by 4: divide it by 6"},
      {with({.divisor = 3}), "the sum of the rates is divided by 3: divide it by 6"},
      {with({.outer = 1, .inner = 1}),
       "the two middle rates count once: their weights are 2, as in 1, 2, 2, 1"},
      {with({.inner = 0, .divisor = 2}), "the two middle rates are left out: use 1, 2, 2, 1"},
      {with({.stages = Stages::third_by_first}),
       "the third rate is taken where the second is: move by k2 to take it"},
      {with({.stages = Stages::whole}),
       "the middle rates are taken at the end of the step: take them at dt/2"},
      {with({.stages = Stages::chained}),
       "each rate starts where the rate before it was taken: move from the start of the step"},
      {with({.short_last = true}), "the fourth rate is taken at the middle: take it at the end"},
      {with({.unit_stages = true}),
       "q is normalised between the rates, which spoils them: normalise only at the end"},
      {with({.unit_end = false}), "the quaternion is not normalised: divide it by its length"},
      {with({.one_exponential = true}),
       "q turns once by the mean of omega, which has only order two: average the rates dq/dt"}};
  for (const RateMistake& mistake : rate_mistakes()) {
    all.push_back({with({.euler = mistake.value}), mistake.story});
  }
  return all;
}

inline std::vector<Suspect<Vec3>> rate_suspects(const Vec3& moments, const Spin& spin) {
  std::vector<Suspect<Vec3>> all;
  for (const RateMistake& mistake : rate_mistakes()) {
    const VecL wrong = mistake.value(wide(moments), wide(spin.angular_velocity_body));
    all.push_back({narrow(wrong), mistake.story});
  }
  return all;
}

}  // namespace tests

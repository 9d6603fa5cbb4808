#pragma once

#include "motions.hpp"

/// Step 2.6 in extended precision, with what students get wrong in it as switches.
namespace tests {

inline const char* const weightless =
    "the weight does nothing, because 1/2 is 0 in whole numbers: write 0.5";
inline const char* const zero_torque =
    "arm and weight are both vertical, so the torque is 0: turn down into the body with R^T";

/// What the kick divides the torque by.
enum class Divisor { moments, nothing, axial, inverses };

struct TopVariation {
  Real torque = 1;            ///< times the torque
  bool world_torque = false;  ///< the torque's world components
  bool body_down = false;     ///< R down for Rᵀ down
  bool vertical_arm = false;  ///< arm and weight along one vertical
  bool unit_weight = false;   ///< mgl is left out
  Real kick = 0.5L;           ///< of dt
  bool old_torque = false;    ///< in the second kick
  Divisor divisor = Divisor::moments;
  bool one_kick = false;  ///< none after the drift
  bool late = false;      ///< none before the drift
  Real drift = 1;         ///< times dt
  bool drifts = false;    ///< drift for dt/2, kick for dt, drift for dt/2
};

inline VecL moments_of(const common::HeavyTop& top) {
  return {wide(top.transverse_moment), wide(top.transverse_moment), wide(top.axial_moment)};
}

inline VecL weight_torque(const common::HeavyTop& top, const QuatL& q, const TopVariation& v = {}) {
  const VecL down(0, 0, -1);
  const VecL arm(0, 0, 1);
  const Real size = v.torque * (v.unit_weight ? 1 : static_cast<Real>(top.weight_moment));
  if (v.vertical_arm) return VecL::Zero();
  if (v.world_torque) return size * VecL(q * arm).cross(down);
  return size * arm.cross(VecL((v.body_down ? q : q.conjugate()) * down));
}

/// Free motion of a symmetric body: about L in the world by |L|/I1 dt, and about its own axis.
inline SpinL drift(const common::HeavyTop& top, const SpinL& spin, Real dt) {
  const VecL I = moments_of(top);
  const VecL L = spin.q * times(I, spin.omega);
  const VecL axial(0, 0, spin.omega.z() * (1 - I.z() / I.x()) * dt);
  const QuatL own = turn(axial);
  return {turn(L / I.x() * dt) * spin.q * own, own.conjugate() * spin.omega};
}

inline VecL divisor_of(const VecL& I, Divisor divisor) {
  switch (divisor) {
    case Divisor::nothing:
      return VecL::Ones();
    case Divisor::axial:
      return VecL::Constant(I.z());
    case Divisor::inverses:
      return I.cwiseInverse();
    default:
      return I;
  }
}

inline SpinL kick_drift_kick(const common::HeavyTop& top, const common::Spin& spin, Real dt,
                             const TopVariation& v = {}) {
  const VecL I = moments_of(top);
  const VecL by = divisor_of(I, v.divisor);
  const auto change = [&](const VecL& T) { return VecL(v.kick * dt * T.cwiseQuotient(by)); };
  SpinL now = wide(spin);
  if (v.drifts) {
    now = drift(top, now, dt / 2);
    now.omega += dt * weight_torque(top, now.q, v).cwiseQuotient(by);
    return drift(top, now, dt / 2);
  }
  const VecL first = weight_torque(top, now.q, v);
  if (!v.late) now.omega += change(first);
  now = drift(top, now, v.drift * dt);
  if (!v.one_kick) now.omega += change(v.old_torque ? first : weight_torque(top, now.q, v));
  return now;
}

struct TorqueStory {
  TopVariation variation;
  const char* text;
};

/// What can be wrong with the torque, and so with the kicks.
inline const std::vector<TorqueStory>& torque_stories() {
  static const std::vector<TorqueStory> all{
      {{.torque = -1}, "the torque has the wrong sign: the weight points down"},
      {{.world_torque = true},
       "the torque is in the world frame: return it in body axes, R^T times it"},
      {{.body_down = true}, "down is turned the wrong way: use R^T (-z)"},
      {{.vertical_arm = true}, zero_torque},
      {{.unit_weight = true}, "mgl is left out of the torque: multiply by top.weight_moment"}};
  return all;
}

inline std::vector<Suspect<Vec3>> torque_suspects(const common::HeavyTop& top, const Quat& q) {
  std::vector<Suspect<Vec3>> all;
  for (const TorqueStory& story : torque_stories()) {
    all.push_back({narrow(weight_torque(top, wide(q), story.variation)), story.text});
  }
  return all;
}

inline std::vector<Suspect<SpinValue>> kick_drift_kick_suspects(const common::HeavyTop& top,
                                                                const common::Spin& spin,
                                                                double dt) {
  const auto with = [&](const TopVariation& v) {
    return narrow(kick_drift_kick(top, spin, wide(dt), v));
  };
  // Without a torque there is no kick, whichever of the two is wrong.
  const std::string torque = likely_of_weight_torque();
  std::vector<Suspect<SpinValue>> all{
      {with({.kick = 1}), "each kick lasts dt: let it last dt/2"},
      {with({.kick = 0.25L}), "each kick lasts dt/4: let it last dt/2"},
      {with({.kick = 0}), torque.empty() ? weightless : torque},
      {with({.old_torque = true}),
       "the second kick uses the torque from before the drift: compute it again"},
      {with({.divisor = Divisor::nothing}),
       "the kick is not divided by the moments: divide it, component by component"},
      {with({.divisor = Divisor::axial}),
       "the kick is divided by I3: its torque is about x and y alone, so divide it by I1"},
      {with({.divisor = Divisor::inverses}),
       "the kick is multiplied by the moments: divide it, component by component"},
      {with({.one_kick = true}), "the kick after the drift is missing: kick again for dt/2"},
      {with({.late = true}), "the kick before the drift is missing: kick first for dt/2"},
      {with({.kick = 1, .one_kick = true}),
       "there is one whole kick before the drift: kick for dt/2 before and after it"},
      {with({.kick = 1, .late = true}),
       "there is one whole kick after the drift: kick for dt/2 before and after it"},
      {with({.drift = 0.5L}), "the drift lasts dt/2: let it last dt"},
      {with({.drift = 2}), "the drift lasts 2 dt: let it last dt"},
      {with({.drift = 0}), "the drift is missing: drift for dt between the kicks"},
      {with({.drifts = true}), "kick and drift are swapped: kick for dt/2, drift for dt, kick"}};
  for (const TorqueStory& story : torque_stories()) {
    if (story.variation.vertical_arm) continue;
    all.push_back({with(story.variation), story.text});
  }
  return all;
}

}  // namespace tests

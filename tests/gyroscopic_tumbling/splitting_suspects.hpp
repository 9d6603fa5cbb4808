#pragma once

#include "motions.hpp"

/// Step 2.5 in extended precision, with what students get wrong in it as switches.
namespace tests {

struct SplittingVariation {
  bool trigonometric = false;      ///< the exact turn by ω_i dt
  Real half = 0.5L;                ///< of ω_i dt
  bool world_side = false;         ///< p on the left of q
  bool momentum_forwards = false;  ///< m turns with the body
  bool omega_turned = false;       ///< ω for m
  bool momentum_rate = false;      ///< m_i for ω_i in the angle
  int rate_of = 0;                 ///< 1 or 2: divides m_i by the next or last axis' moment
  bool undivided = false;          ///< returns m for ω
  bool momentum_rests = false;     ///< m does not turn
  bool attitude_rests = false;     ///< q does not turn
  bool backwards = false;          ///< q turns by −p, and so does m
  bool unit = true;                ///< p normalised
  std::vector<int> axes{0, 1, 2, 1, 0};
  Real share = 0.5L;  ///< of dt for all but the middle one
  Real middle = 1;    ///< of dt for that
};

inline SpinL about_axis(const VecL& I, const SpinL& spin, int axis, Real dt,
                        const SplittingVariation& v = {}) {
  Real angle = spin.omega(axis) * dt;
  if (v.momentum_rate) angle *= I(axis);
  if (v.rate_of != 0) angle *= I(axis) / I((axis + v.rate_of) % 3);
  if (v.backwards) angle = -angle;
  VecL e = VecL::Zero();
  e(axis) = 1;
  QuatL p = v.trigonometric ? turn(angle * e) : sum({1, 0, 0, 0}, v.half * angle, pure(e));
  const QuatL whole = p;
  p.normalize();
  const QuatL back = v.momentum_forwards ? p : p.conjugate();
  VecL m = v.omega_turned ? spin.omega : times(I, spin.omega);
  if (!v.momentum_rests) m = back * m;
  const QuatL q = v.world_side ? p * spin.q : spin.q * p;
  const bool keeps_m = v.omega_turned || v.undivided;
  return {v.attitude_rests ? spin.q
          : v.unit         ? q
                           : spin.q * whole,
          keeps_m ? m : m.cwiseQuotient(I)};
}

inline SpinL splitting(const Vec3& moments, const Spin& spin, Real dt,
                       const SplittingVariation& v = {}) {
  SpinL now = wide(spin);
  const std::size_t middle = v.axes.size() / 2;
  for (std::size_t i = 0; i < v.axes.size(); ++i) {
    now = about_axis(wide(moments), now, v.axes[i], (i == middle ? v.middle : v.share) * dt, v);
  }
  return now;
}

struct TurnStory {
  SplittingVariation variation;
  const char* text;
};

/// What can be wrong with one sub-rotation, and so with all.
inline std::vector<TurnStory> turn_stories() {
  const char* const other_moment =
      "the turn uses the moment of another axis: omega_i is m_i / I_i of the same axis";
  return {{{.trigonometric = true}, "this turns by omega dt: use tan(half) = omega dt / 2"},
          {{.half = 1}, "the factor 1/2 is missing in tan(half): use omega dt / 2"},
          {{.half = 0}, half_is_zero},
          {{.world_side = true},
           "the turn stands on the left of q, but it is about a body axis: put it on the right"},
          {{.momentum_forwards = true},
           "m turns with the body: L is constant in the world, so turn m the other way"},
          {{.omega_turned = true},
           "omega is turned instead of m = I0 omega: turn m, then divide it by the moments"},
          {{.momentum_rate = true}, "m_i stands for omega_i in the turn: divide it by I_i"},
          {{.rate_of = 1}, other_moment},
          {{.rate_of = 2}, other_moment},
          {{.undivided = true}, "the new m is returned as omega: divide it by the moments"},
          {{.momentum_rests = true}, "m does not turn: turn it by p backwards"},
          {{.attitude_rests = true}, "q does not turn: multiply it by p from the right"},
          {{.backwards = true}, "the turn is backwards: turn q by p, and m by p backwards"},
          {{.unit = false}, "p is not normalised: divide it by its length"}};
}

inline std::vector<Suspect<SpinValue>> splitting_suspects(const Vec3& moments, const Spin& spin,
                                                          double dt) {
  std::vector<TurnStory> stories = turn_stories();
  stories.push_back({{.axes = {2, 1, 0, 1, 2}}, "the order is 3-2-1-2-3: use 1-2-3-2-1"});
  stories.push_back({{.axes = {0, 2, 1, 2, 0}}, "the order is 1-3-2-3-1: use 1-2-3-2-1"});
  stories.push_back({{.axes = {0, 1, 2}, .share = 1},
                     "this is 1-2-3 for dt each, which is first order only: use 1-2-3-2-1"});
  stories.push_back({{.share = 1}, "the outer four last dt each: let them last dt/2"});
  stories.push_back({{.share = 1, .middle = 0.5L},
                     "dt and dt/2 are swapped: the middle turn lasts dt, the outer four dt/2"});
  stories.push_back({{.middle = 0.5L}, "the middle turn lasts dt/2: let it last dt"});
  stories.push_back({{.share = 1.0L / 4}, "the outer four last dt/4: let them last dt/2"});
  stories.push_back({{.axes = {0, 1, 2, 2, 1, 0}, .middle = 0.5L},
                     "axis 3 turns twice for dt/2: turn it once for dt"});
  stories.push_back({{.axes = {2, 1, 0}, .share = 1},
                     "this is 3-2-1 for dt each, which is first order only: use 1-2-3-2-1"});
  stories.push_back({{.axes = {1, 0, 2, 0, 1}}, "the order is 2-1-3-1-2: use 1-2-3-2-1"});
  std::vector<Suspect<SpinValue>> suspects;
  for (const TurnStory& story : stories) {
    suspects.push_back({narrow(splitting(moments, spin, wide(dt), story.variation)), story.text});
  }
  return suspects;
}

inline std::vector<Suspect<SpinValue>> sub_rotation_suspects(const Vec3& moments, const Spin& spin,
                                                             int axis, double dt) {
  std::vector<Suspect<SpinValue>> suspects;
  for (const TurnStory& story : turn_stories()) {
    suspects.push_back(
        {narrow(about_axis(wide(moments), wide(spin), axis, wide(dt), story.variation)),
         story.text});
  }
  return suspects;
}

}  // namespace tests

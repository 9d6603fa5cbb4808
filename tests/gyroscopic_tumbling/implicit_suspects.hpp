#pragma once

#include "motions.hpp"

/// Step 2.3 in extended precision, with what students get wrong in it as switches.
namespace tests {

inline const char* const explicit_step =
    "Newton's Jacobian is I0 alone, which makes an explicit step: add both terms with dt";

struct ImplicitVariation {
  Real gyroscopic = 1;         ///< times the gyroscopic term, in residual and Jacobian
  Real inertia = 1;            ///< times I0 in the Jacobian
  Real turning = 1;            ///< times [ω′]ₓ I0 in the Jacobian
  Real momentum = 1;           ///< times [I0 ω′]ₓ in the Jacobian
  bool inertia_first = false;  ///< I0 [ω′]ₓ for [ω′]ₓ I0
  bool plain_cross = false;    ///< [ω′]ₓ for [I0 ω′]ₓ
  bool without_dt = false;     ///< in the Jacobian
  bool transposed = false;     ///< the Jacobian
  int newton_steps = 1;
  Real newton = 1;            ///< times Newton's change
  bool world_side = false;    ///< the turn on the left of q
  bool old_velocity = false;  ///< turns q
  Real turn = 1;              ///< times the angle of the turn
  bool euler = false;         ///< q + dt ½ q ω′, normalised, for the exponential map
};

struct ImplicitStory {
  ImplicitVariation variation;
  const char* text;
};

/// What can be wrong with the Jacobian, and so with the step.
inline const std::vector<ImplicitStory>& jacobian_stories() {
  static const std::vector<ImplicitStory> all{
      {{.gyroscopic = -1}, flipped},
      {{.turning = 0, .momentum = 0}, explicit_step},
      {{.momentum = 0},
       "the term [I0 omega]x is missing in Newton's Jacobian: subtract dt [I0 omega]x"},
      {{.turning = 0}, "the term [omega]x I0 is missing in Newton's Jacobian: add dt [omega]x I0"},
      {{.momentum = -1},
       "the term [I0 omega]x has the wrong sign in Newton's Jacobian: subtract it"},
      {{.turning = -1}, "the term [omega]x I0 has the wrong sign in Newton's Jacobian: add it"},
      {{.inertia = 0}, "I0 is missing in Newton's Jacobian: add it"},
      {{.inertia_first = true},
       "the factors of [omega]x I0 are swapped in Newton's Jacobian: I0 stands on the right"},
      {{.plain_cross = true},
       "[omega]x stands for [I0 omega]x in Newton's Jacobian: multiply omega by I0 first"},
      {{.without_dt = true},
       "dt is missing in Newton's Jacobian: multiply both gyroscopic terms by dt"},
      {{.transposed = true}, "Newton's Jacobian is transposed: its rows are those of F"}};
  return all;
}

inline MatL cross_matrix(const VecL& w) {
  MatL matrix;
  matrix << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return matrix;
}

inline VecL residual(const VecL& I, const VecL& old, const VecL& next, Real dt, Real sign = 1) {
  return times(I, VecL(next - old)) + sign * dt * next.cross(times(I, next));
}

inline MatL jacobian(const VecL& I, const VecL& next, Real dt, const ImplicitVariation& v = {}) {
  const MatL inertia = I.asDiagonal();
  const MatL cross = cross_matrix(next);
  const MatL turning = v.inertia_first ? inertia * cross : cross * inertia;
  const MatL momentum = v.plain_cross ? cross : cross_matrix(times(I, next));
  const Real step = v.gyroscopic * (v.without_dt ? 1 : dt);
  const MatL J = v.inertia * inertia + step * (v.turning * turning - v.momentum * momentum);
  return v.transposed ? MatL(J.transpose()) : J;
}

inline SpinL implicit(const Vec3& moments, const Spin& spin, Real dt,
                      const ImplicitVariation& v = {}) {
  const VecL I = wide(moments);
  const SpinL old = wide(spin);
  VecL next = old.omega;
  for (int i = 0; i < v.newton_steps; ++i) {
    const VecL F = residual(I, old.omega, next, dt, v.gyroscopic);
    next -= v.newton * (jacobian(I, next, dt, v).inverse() * F);
  }
  const VecL turning = v.turn * dt * (v.old_velocity ? old.omega : next);
  const QuatL p = v.euler ? sum({1, 0, 0, 0}, 0.5L, pure(turning)).normalized() : turn(turning);
  return {v.world_side ? p * old.q : old.q * p, next};
}

inline std::vector<Suspect<SpinValue>> implicit_suspects(const Vec3& moments, const Spin& spin,
                                                         double dt) {
  const auto with = [&](const ImplicitVariation& v) {
    return narrow(implicit(moments, spin, wide(dt), v));
  };
  // At the old omega F is the gyroscopic impulse alone: its sign and that of Newton's change are
  // one.
  const std::string residual = likely_of_residual();
  const std::string newton_backwards =
      "omega changes with the wrong sign: subtract J^-1 F, with F = + dt omega x I0 omega";
  std::vector<Suspect<SpinValue>> all{
      {with({.gyroscopic = 0}), forgotten},
      {with({.newton_steps = 2}), "this is more than one step of Newton's method: make only one"},
      {with({.newton_steps = 30}), "this is more than one step of Newton's method: make only one"},
      {with({.newton = -1}), residual.empty() ? newton_backwards : residual},
      {with({.world_side = true}),
       "the turn stands on the left of q, but omega is in body axes: put it on the right"},
      {with({.old_velocity = true}), "the old angular velocity turns q: use the new one"},
      {with({.turn = -1}), "q turns backwards: turn it by + omega dt"},
      {with({.turn = 0.5L}),
       "q turns by half of omega dt: the exponential map takes the whole vector omega dt"},
      {with({.turn = 2}),
       "q turns by twice omega dt: the exponential map takes the vector omega dt"},
      {with({.euler = true}), "q takes Euler's step: turn it by the exponential map"}};
  for (const ImplicitStory& story : jacobian_stories()) {
    all.push_back({with(story.variation), story.text});
  }
  return all;
}

inline std::vector<Suspect<Mat3>> jacobian_suspects(const Vec3& moments, const Vec3& omega,
                                                    double dt) {
  std::vector<Suspect<Mat3>> all;
  for (const ImplicitStory& story : jacobian_stories()) {
    const MatL wrong = jacobian(wide(moments), wide(omega), wide(dt), story.variation);
    all.push_back({Mat3(wrong.cast<double>()), story.text});
  }
  return all;
}

inline std::vector<Suspect<Vec3>> residual_suspects(const Vec3& moments, const Vec3& old_omega,
                                                    const Vec3& next_omega, double time) {
  const VecL I = wide(moments);
  const VecL old = wide(old_omega);
  const VecL next = wide(next_omega);
  const Real dt = wide(time);
  const VecL change = times(I, VecL(next - old));
  const VecL term = dt * next.cross(times(I, next));
  const char* const mixed =
      "the gyroscopic term mixes the old and the new velocity: use the new one twice";
  return {{narrow(change - term), flipped},
          {narrow(change), forgotten},
          {narrow(change + dt * old.cross(times(I, old))),
           "the gyroscopic term is taken at the old velocity, as in the explicit step: use the new "
           "one"},
          {narrow(change + dt * next.cross(times(I, old))), mixed},
          {narrow(change + dt * old.cross(times(I, next))), mixed},
          {narrow(term - change),
           "the change of omega has the wrong sign: it is the new omega minus the old one"},
          {narrow(VecL(next - old) + term), "I0 is missing: multiply the change of omega by it"},
          {narrow(term), "the change of omega is missing: add I0 times it"},
          {narrow(change + next.cross(times(I, next))),
           "dt is missing: multiply the gyroscopic term by dt"}};
}

}  // namespace tests

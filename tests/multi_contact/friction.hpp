#pragma once

#include <string>
#include <vector>

#include "judged.hpp"
#include "refused.hpp"

/// What step 7.7 is asked, and in long double what is right, or would be with one flaw.
namespace tests {

using common::Vec3;
using lab::multi_contact::FrictionRule;
using lab::multi_contact::Vec2;
using Wide = long double;

/// Code for a rule.
inline Code code_of(FrictionRule rule) {
  if (rule == FrictionRule::disc) return {"FrictionRule::disc"};
  return {rule == FrictionRule::box ? "FrictionRule::box" : "FrictionRule::diamond"};
}
inline constexpr FrictionRule all_rules[] = {FrictionRule::disc, FrictionRule::box,
                                             FrictionRule::diamond};

struct Limiting {
  Vec2 tangential;
  double limit = 1.0;
  FrictionRule rule = FrictionRule::disc;
};

enum class LimitFlaw {
  none,
  box_for_disc,
  disc_for_box,
  disc_for_all,
  box_for_all,
  box_for_diamond,
  scaled_diamond,
  diamond_past_zero,
  diamond_by_whole,
  always_on_rim,
  scaled_by_largest,
  squared_length,
  diamond_without_signs,
  upper_end_only,
  not_limited
};
Vec2 exact_limited(const Limiting& in, LimitFlaw flaw = LimitFlaw::none);

inline Trial limited_trial(const Limiting& in, int index = 1, int count = 1) {
  Trial trial = trial_of("7.7 limited", index, count);
  trial.given("tangential", in.tangential).given("limit", in.limit);
  return trial.given("rule", code_of(in.rule));
}
inline Vec2 limited_by_answer(const Limiting& in, const Trial& trial) {
  return trial.returned(
      [&] { return lab::multi_contact::limited(in.tangential, in.limit, in.rule); });
}

struct Sweeping {
  Matrix A;
  Vector b;
  Vector start;
  double friction = 0.5;
  FrictionRule rule = FrictionRule::disc;
  int sweeps = 1;
};

enum class FrictionFlaw {
  none,
  step_a_row,
  inverse_of_block,
  step_of_trace,
  step_without_coupling,
  step_of_t,
  smaller_eigenvalue,
  tangent_first,
  slip_before_normal,
  limit_of_before,
  limit_of_all,
  limit_without_friction,
  no_memory,
  along_the_slip,
  always_box,
  always_disc,
  always_on_rim,
  normal_not_clamped,
  change_clamped,
  u_of_the_sweep,
  rows_by_kind,
  start_forgotten,
  one_sweep_more,
  one_sweep_only
};
Vector exact_friction_sweeps(const Sweeping& in, FrictionFlaw flaw = FrictionFlaw::none);

inline Trial friction_trial(const Sweeping& in, int index = 1, int count = 1) {
  Trial trial = system_trial("7.7 friction_sweeps", in.A, in.b, index, count);
  trial.given("start", in.start).given("friction", in.friction);
  return trial.given("rule", code_of(in.rule)).given("sweeps", in.sweeps);
}
/// Three numbers for each contact, all of them finite: tests compute with them.
inline Vector swept_by_answer(const Sweeping& in, const Trial& trial) {
  const Vector got = trial.returned([&] {
    return lab::multi_contact::friction_sweeps(in.A, in.b, in.start, in.friction, in.rule,
                                               in.sweeps);
  });
  expect_size(trial, got, in.b.size());
  trial.expect(got, got, exact);
  return got;
}

struct Judging {
  Matrix A;
  Vector b;
  Vector lambda;
  double friction = 0.5;
};

enum class JudgeFlaw {
  none,
  normal_only,
  friction_only,
  box,
  slip_only,
  along_the_slip,
  no_slip,
  limit_without_friction,
  limit_by_size,
  least,
  sum,
  last,
  squares,
  tangents_apart,
  pull_forgiven,
  approach_only,
  b_missing
};
double exact_coulomb_residual(const Judging& in, JudgeFlaw flaw = JudgeFlaw::none);

inline Trial judging_trial(const Judging& in, int index = 1, int count = 1) {
  Trial trial = system_trial("7.7 coulomb_residual", in.A, in.b, index, count);
  return trial.given("lambda", in.lambda).given("friction", in.friction);
}
inline double judged_by_answer(const Judging& in, const Trial& trial) {
  return trial.returned(
      [&] { return lab::multi_contact::coulomb_residual(in.A, in.b, in.lambda, in.friction); });
}

/// One contact whose rows know nothing of each other.
Matrix diagonal(double n, double t, double s);
/// The rod of mass 1 and inertia 1/3 on its lower end, tan of its angle 2; s is out of its plane.
Matrix leaning_rod();
/// The brick 1, 1/2, 1/4 that falls flat on its four lower corners, twelve rows, or a cube.
struct Falling {
  Matrix A;
  Vector b;
};
Falling falling_box(const Vec3& sides, const Vec3& velocity, const Vec3& spin);
/// Systems of three rows with something wrong, and such as have no three for each contact.
std::vector<Bad<ContactSystem>> bad_triples();
/// Not three finite entries.
std::vector<Bad<Vector>> bad_triple_vectors();
/// As many contacts that all know of each other.
Sweeping random_sweeping(Random& random, int contacts);

}  // namespace tests

// What students get wrong in step 7.7.
#include <string>
#include <utility>
#include <vector>

#include "fingerprint.hpp"
#include "friction.hpp"

namespace tests {
namespace {

template <typename Flaw>
using Stories = std::vector<std::pair<Flaw, std::string>>;

Stories<LimitFlaw> limit_stories() {
  return {
      {LimitFlaw::box_for_disc,
       "the disc is a box: scale the pair, or friction prefers the diagonals"},
      {LimitFlaw::disc_for_box, "the box is a disc: each component has its own limit"},
      {LimitFlaw::disc_for_all, "every rule is the disc: ask which one is wanted"},
      {LimitFlaw::box_for_all, "every rule is the box: ask which one is wanted"},
      {LimitFlaw::box_for_diamond, "the diamond is a box: |t| + |s| has the limit"},
      {LimitFlaw::scaled_diamond,
       "the pair is scaled to the diamond: its nearest point is another, shrink |t| and |s| alike"},
      {LimitFlaw::diamond_past_zero,
       "beyond a corner of the diamond a component goes past zero: it stops there"},
      {LimitFlaw::diamond_by_whole,
       "both components of the diamond lose all that is too much: each loses half of it"},
      {LimitFlaw::always_on_rim,
       "the disc scales short pairs up, too: what is within stays as it is"},
      {LimitFlaw::scaled_by_largest,
       "the disc divides by the larger component: divide by the length of the pair"},
      {LimitFlaw::squared_length, "the squared length is compared with the limit itself"},
      {LimitFlaw::diamond_without_signs,
       "the diamond loses the signs: |t| and |s| shrink, and t and s keep their signs"},
      {LimitFlaw::upper_end_only, "a component has no lower end: it is from -l to l"},
      {LimitFlaw::not_limited, "nothing is limited"}};
}

Stories<FrictionFlaw> friction_stories() {
  return {
      {FrictionFlaw::step_a_row,
       "each tangent has a step of its own: one q for both, or friction is not against the slip"},
      {FrictionFlaw::inverse_of_block,
       "the inverse of A_TT is no step: one q for both, or friction is not against the slip"},
      {FrictionFlaw::step_of_trace, "q is one over the trace of A_TT: take its largest eigenvalue"},
      {FrictionFlaw::step_without_coupling,
       "q looks at the diagonal of A_TT only: A_ts makes its eigenvalue larger"},
      {FrictionFlaw::step_of_t, "q is 1/A_tt: take the largest eigenvalue of A_TT"},
      {FrictionFlaw::smaller_eigenvalue, "q is that of the smaller eigenvalue of A_TT"},
      {FrictionFlaw::tangent_first, "the tangents come first: the normal does, then its limit"},
      {FrictionFlaw::slip_before_normal,
       "u_t is from before the normal impulse: work u out anew, for A_nt"},
      {FrictionFlaw::limit_of_before, "the limit is that of the old lambda_n: take the new one"},
      {FrictionFlaw::limit_of_all,
       "the limit is that of all contacts together: each has its own lambda_n"},
      {FrictionFlaw::limit_without_friction, "mu is missing in the limit"},
      {FrictionFlaw::no_memory,
       "the tangential impulses so far are forgotten: it is lambda_t - q u_t that is limited"},
      {FrictionFlaw::along_the_slip, "friction pushes along the slip: the step is - q u_t"},
      {FrictionFlaw::always_box, "every rule is taken for the box: hand the rule on"},
      {FrictionFlaw::always_disc, "every rule is taken for the disc: hand the rule on"},
      {FrictionFlaw::always_on_rim,
       "friction is always mu lambda_n: what is within the limit sticks with less"},
      {FrictionFlaw::normal_not_clamped, "lambda_n is not clamped: a contact never pulls"},
      {FrictionFlaw::change_clamped,
       "the change of lambda_n is clamped: it is lambda_n itself, which may give back"},
      {FrictionFlaw::u_of_the_sweep,
       "u is that of the start of the sweep: take lambda as it is by now"},
      {FrictionFlaw::rows_by_kind,
       "rows are taken as all n, then all t, then all s: they are n, t, s contact by contact"},
      {FrictionFlaw::start_forgotten, "it begins from zero: begin from start"},
      {FrictionFlaw::one_sweep_more, "there is one sweep more than asked for"},
      {FrictionFlaw::one_sweep_only, "there is one sweep only"}};
}

Stories<JudgeFlaw> judge_stories() {
  return {{JudgeFlaw::normal_only, "friction is not judged: only the normal rows are"},
          {JudgeFlaw::friction_only, "the normal rows are not judged"},
          {JudgeFlaw::box, "each tangent is judged by itself, a box: Coulomb's bound is the disc"},
          {JudgeFlaw::slip_only, "all slip is a breach: on the rim of the disc it may slip"},
          {JudgeFlaw::along_the_slip, "the step is along the slip: it is lambda_t - u_t"},
          {JudgeFlaw::no_slip,
           "only the bound is judged: within it there is no slip, and on the rim friction is "
           "against it"},
          {JudgeFlaw::limit_without_friction, "mu is missing in the limit"},
          {JudgeFlaw::limit_by_size,
           "a contact that pulls has friction: the limit is mu max(0, lambda_n)"},
          {JudgeFlaw::least, "the least breach is returned: it is the largest"},
          {JudgeFlaw::sum, "the breaches are added: it is the largest"},
          {JudgeFlaw::last, "the last contact's breach is returned: it is the largest of all"},
          {JudgeFlaw::squares, "the friction's breach is squared: it is a length"},
          {JudgeFlaw::tangents_apart,
           "the larger component of the friction's breach is taken: it is the length of the pair"},
          {JudgeFlaw::pull_forgiven, "a pull is no breach: |min(lambda_n, u_n)| is one"},
          {JudgeFlaw::approach_only,
           "only an approach is a breach: an open contact that is pushed is one, too"},
          {JudgeFlaw::b_missing, "b is missing: u = A lambda + b"}};
}

/// The one story of an answer, with what each flaw returns.
template <typename Value, typename Input, typename Answer, typename Flaw, typename Exact>
std::string told_by(const std::vector<Input>& inputs, const Answer& answer,
                    const Stories<Flaw>& stories, const Exact& exact_value) {
  std::vector<Mistake<Input, Value>> mistakes;
  for (const auto& [flaw, story] : stories) {
    mistakes.push_back(returns<Input, Value>(
        story, [&exact_value, flaw = flaw](const Input& in) { return exact_value(in, flaw); }));
  }
  return fingerprint(inputs, answer, mistakes);
}

std::vector<Limiting> limiting_inputs() {
  std::vector<Limiting> all;
  for (const FrictionRule rule : all_rules) {
    for (const Vec2& pair : {Vec2(-3.0, -4.0), Vec2(0.25, -0.125), Vec2(1.0, 1.0), Vec2(2.0, -0.5),
                             Vec2(-0.75, 6.0)}) {
      all.push_back({pair, 2.5, rule});
    }
  }
  return all;
}

Sweeping one_contact(const Matrix& A, const Vector& b, FrictionRule rule, int sweeps) {
  return {A, b, Vector::Zero(3), 0.5, rule, sweeps};
}

/// Sliding, sticking and parting, with and without a start, one contact and two.
std::vector<Sweeping> friction_inputs() {
  const Matrix coupled{{2.0, 0.5, -0.25}, {0.5, 3.0, 1.0}, {-0.25, 1.0, 2.0}};
  Matrix two = Matrix::Zero(6, 6);
  two.topLeftCorner(3, 3) = coupled;
  two.bottomRightCorner(3, 3) = 2.0 * coupled;
  two(0, 3) = two(3, 0) = -1.0;
  two(1, 4) = two(4, 1) = 0.5;
  const Vector slides{{-1.0, 3.0, -2.0}};
  const Vector sticks{{-4.0, 0.125, 0.25}};
  const Vector b{{-2.0, 0.25, 1.0, -1.0, 3.0, -0.5}};
  const Vector start{{3.0, 0.25, -0.5, 0.25, 0.0, 0.125}};
  return {
      one_contact(diagonal(1.0, 2.0, 4.0), slides, FrictionRule::disc, 2),
      one_contact(coupled, slides, FrictionRule::box, 2),
      one_contact(coupled, slides, FrictionRule::diamond, 1),
      one_contact(coupled, sticks, FrictionRule::disc, 3),
      {coupled, Vector{{1.0, 0.5, -0.25}}, Vector{{2.0, 1.0, -1.0}}, 0.25, FrictionRule::disc, 1},
      {two, b, Vector::Zero(6), 0.5, FrictionRule::disc, 2},
      {two, b, start, 0.75, FrictionRule::box, 1},
      {two, b, start, 0.25, FrictionRule::diamond, 3}};
}

std::vector<Judging> judging_inputs() {
  Matrix two = Matrix::Zero(6, 6);
  two.topLeftCorner(3, 3) = diagonal(1.0, 2.0, 4.0);
  two.bottomRightCorner(3, 3) = leaning_rod();
  const Matrix A = diagonal(1.0, 2.0, 4.0);
  const Vector b{{-1.0, 3.6, 5.6}};
  const Vector both{{-1.0, 3.6, 5.6, -1.0, -2.0, 0.5}};
  return {{A, b, Vector{{1.0, -0.5, -0.5}}},
          {A, b, Vector{{1.0, -0.25, 0.125}}, 2.0},
          {A, b, Vector{{-0.5, -0.125, -0.0625}}},
          {A, Vector{{1.0, 0.0, 0.0}}, Vector{{0.25, 0.0, 0.0}}},
          {A, Vector{{1.0, 0.5, 0.25}}, Vector{{-0.5, 0.25, 0.125}}},
          {two, both, Vector{{1.0, -0.5, -0.5, 0.25, 0.125, 0.0}}},
          {two, both, Vector{{2.0, 0.0, -0.5, 0.5, 0.25, -0.125}}, 0.25}};
}

}  // namespace

std::string likely_of_limited() {
  return told_by<Vec2>(
      limiting_inputs(),
      [](const Limiting& in) {
        return lab::multi_contact::limited(in.tangential, in.limit, in.rule);
      },
      limit_stories(), exact_limited);
}

std::string likely_of_friction_sweeps() {
  const std::string of_bounds = likely_of_limited();  // sweeps may call it
  if (!of_bounds.empty()) return of_bounds;
  return told_by<Vector>(
      friction_inputs(),
      [](const Sweeping& in) {
        return lab::multi_contact::friction_sweeps(in.A, in.b, in.start, in.friction, in.rule,
                                                   in.sweeps);
      },
      friction_stories(), exact_friction_sweeps);
}

std::string likely_of_coulomb_residual() {
  const std::string of_bounds = likely_of_limited();
  if (!of_bounds.empty()) return of_bounds;
  return told_by<double>(
      judging_inputs(),
      [](const Judging& in) {
        return lab::multi_contact::coulomb_residual(in.A, in.b, in.lambda, in.friction);
      },
      judge_stories(), exact_coulomb_residual);
}

}  // namespace tests

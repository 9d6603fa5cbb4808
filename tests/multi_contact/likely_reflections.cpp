// What students get wrong in step 7.5.
#include <algorithm>
#include <utility>
#include <vector>

#include "fingerprint.hpp"
#include "impulses.hpp"

namespace tests {
namespace {

double border_of_reflections(const Reflecting& in, const Vector& u, ReflectionFlaw flaw) {
  if (flaw == ReflectionFlaw::no_tolerance) return 0.0;
  if (flaw == ReflectionFlaw::absolute_tolerance) return 1e-12;
  if (flaw == ReflectionFlaw::tolerance_of_length) return 1e-12 * in.system.u.norm();
  const double part = flaw == ReflectionFlaw::coarse_tolerance ? 1e-9 : 1e-12;
  return part * common::largest_entry(flaw == ReflectionFlaw::tolerance_of_now ? u : in.system.u);
}

std::vector<int> reflected_contacts(const Reflecting& in, const Vector& u, ReflectionFlaw flaw) {
  const double tol = border_of_reflections(in, u, flaw);
  std::vector<int> found;
  for (int i = 0; i < u.size(); ++i) {
    if (flaw == ReflectionFlaw::with_what_rests ? u[i] <= tol : u[i] < -tol) found.push_back(i);
  }
  const bool any = std::any_of(found.begin(), found.end(), [&](int i) { return u[i] < -tol; });
  if (!any) found.clear();
  if (!found.empty() && flaw == ReflectionFlaw::over_all_contacts) {
    found.clear();
    for (int i = 0; i < u.size(); ++i) found.push_back(i);
  }
  if (!found.empty() && flaw == ReflectionFlaw::one_alone) found.resize(1);
  return found;
}

double factor_of(const Reflecting& in, ReflectionFlaw flaw) {
  if (flaw == ReflectionFlaw::once) return 1.0;
  const bool in_each = flaw == ReflectionFlaw::restitution_in_each ||
                       flaw == ReflectionFlaw::restitution_in_each_and_blended;
  return in_each ? 1.0 + in.restitution : 2.0;
}

int cap_of(const Reflecting& in, ReflectionFlaw flaw) {
  if (flaw == ReflectionFlaw::one_more) return in.most + 1;
  if (flaw == ReflectionFlaw::one_fewer) return std::max(0, in.most - 1);
  if (flaw == ReflectionFlaw::no_cap) return in.most + 50;
  return flaw == ReflectionFlaw::one_round ? std::min(in.most, 1) : in.most;
}

Vector blended_impulses(const Reflecting& in, const Vector& u, const Vector& reflected,
                        ReflectionFlaw flaw) {
  double e = in.restitution;
  if (flaw == ReflectionFlaw::no_blend || flaw == ReflectionFlaw::restitution_in_each)
    return reflected;
  if (flaw == ReflectionFlaw::blend_with_nothing) return e * reflected;
  if (flaw == ReflectionFlaw::blend_reversed) e = 1.0 - e;
  if (flaw == ReflectionFlaw::blend_by_square) e *= e;
  const Vector& first = flaw == ReflectionFlaw::rest_of_reflected ? u : in.system.u;
  return (1.0 - e) * exact_solution(in.system.A, first)->lambda + e * reflected;
}

struct ToldOfReflections {
  ReflectionFlaw flaw;
  const char* story;
};

const std::vector<ToldOfReflections>& told_of_reflections() {
  static const std::vector<ToldOfReflections> all{
      {ReflectionFlaw::over_all_contacts,
       "all contacts are solved for: only those that approach are, by A_VV and u_V"},
      {ReflectionFlaw::with_what_rests,
       "contacts that rest are reflected, too: only u_i < -tol approaches"},
      {ReflectionFlaw::one_alone,
       "one contact is reflected at a time: all that approach are, together"},
      {ReflectionFlaw::once, "x is added once, and stops what comes: twice x reflects it"},
      {ReflectionFlaw::one_round,
       "there is one reflection only: go on while some contact approaches"},
      {ReflectionFlaw::restitution_in_each,
       "e is in each reflection: take 2 x there, and blend in the end"},
      {ReflectionFlaw::restitution_in_each_and_blended,
       "e is in each reflection, and in the blend again: take 2 x"},
      {ReflectionFlaw::blend_reversed,
       "the blend is the wrong way round: lambda_0 counts 1 - e times"},
      {ReflectionFlaw::blend_by_square, "the blend goes with the square of e: it is e itself"},
      {ReflectionFlaw::no_blend, "there is no blend: for e < 1 lambda_0 counts 1 - e times"},
      {ReflectionFlaw::blend_with_nothing, "lambda_0 is missing in the blend"},
      {ReflectionFlaw::rest_of_reflected,
       "lambda_0 is that of the reflected u: take the u handed in"},
      {ReflectionFlaw::overwritten, "a reflection overwrites lambda: add to it"},
      {ReflectionFlaw::only_their_speeds,
       "only the u of V is updated: an impulse changes all of u, by a whole column of A"},
      {ReflectionFlaw::one_more, "there is one reflection more than max_reflections"},
      {ReflectionFlaw::one_fewer, "there is one reflection fewer than max_reflections"},
      {ReflectionFlaw::no_cap,
       "max_reflections is passed over: a jammed body would be reflected for ever"},
      {ReflectionFlaw::ended_by_count,
       "it has not ended if the cap was just enough: ask whether a contact approaches"},
      {ReflectionFlaw::always_ended,
       "it has ended though contacts approach: at the cap ask whether any does"},
      {ReflectionFlaw::reflects_without_e, "for e = 0 reflections are counted: there are none"},
      {ReflectionFlaw::no_tolerance,
       "what comes by rounding alone is reflected: -1e-12 max|u| is the border"},
      {ReflectionFlaw::coarse_tolerance,
       "a slow approach is taken for none: -1e-12 max|u| is the border"},
      {ReflectionFlaw::tolerance_of_now,
       "the border follows u: it is set once, by the u handed in"},
      {ReflectionFlaw::tolerance_of_length,
       "the border is 1e-12 of the length of u: it is of its largest entry"},
      {ReflectionFlaw::absolute_tolerance, "the border is 1e-12 at any speed: it is 1e-12 max|u|"}};
  return all;
}

/// Whether only a slow approach shows it: elsewhere rounding may add a count.
bool is_about_the_border(ReflectionFlaw flaw) {
  return flaw == ReflectionFlaw::no_tolerance || flaw == ReflectionFlaw::coarse_tolerance ||
         flaw == ReflectionFlaw::tolerance_of_now || flaw == ReflectionFlaw::tolerance_of_length ||
         flaw == ReflectionFlaw::absolute_tolerance;
}

constexpr int most_at_border = 8;

ContactSystem contacts_apart(double first, double second) {
  return {Matrix::Identity(2, 2), Vector{{first, second}}};
}

std::vector<Reflecting> reflection_inputs_at_border() {
  Matrix A = Matrix::Identity(4, 4);  // the last contact parts, and knows nothing of the others
  A.topLeftCorner(3, 3) = Matrix{{1.0, -1.0, -0.45e-12}, {-1.0, 3.0, 0.0}, {-0.45e-12, 0.0, 1.0}};
  const ContactSystem growing{A, Vector{{-1.0, 0.0, 0.0, 1.0}}};
  return {{contacts_apart(1.0, -0.9e-12), 1.0, most_at_border},
          {contacts_apart(1.0, -1e-10), 1.0, most_at_border},
          {contacts_apart(1e6, -1e-9), 1.0, most_at_border},
          {{Matrix::Identity(4, 4), Vector{{1.0, 1.0, 1.0, -1.2e-12}}}, 1.0, most_at_border},
          {growing, 1.0, most_at_border}};
}

std::vector<Reflecting> reflection_inputs() {
  const ContactSystem row = cradle(Vector{{1.0, 0.0, 0.0}}).system();
  const ContactSystem unequal =
      row_of_balls(Vector{{2.0, 1.0, 2.0}}, Vector{{1.0, 0.0, 0.0}}).system();
  return {{row, 0.25, 9},
          {row, 1.0, 2},
          {row, 1.0, 1},
          {row, 0.0, 9},
          {cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}).system(), 1.0, 1},
          {unequal, 0.75, 9},
          {unequal, 0.5, 2},
          {cradle(Vector{{1.0, 0.0, 0.25}}).system(), 0.25, 9},
          {cradle(Vector{{1.0, 1.0, 0.0, 0.0}}).system(), 0.75, 9},
          {row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}}).system(), 0.25, 9},
          {dumb_bell().system(), 0.75, 9}};
}

Mistake<Reflecting, Done> mistake_of_reflections(const ToldOfReflections& told) {
  const auto [flaw, story] = told;
  return {story, [flaw = flaw](const Reflecting& in, const Done& got) {
            const bool at_border = in.most == most_at_border;
            if (at_border && !is_about_the_border(flaw)) return true;
            const Done wanted{exact_reflections(in, flaw)};
            return at_border || !is_about_the_border(flaw)
                       ? near(got, wanted)
                       : near(got.impulses.lambda, wanted.impulses.lambda);
          }};
}

}  // namespace

Impulses exact_reflections(const Reflecting& in, ReflectionFlaw flaw) {
  const auto& [A, first] = in.system;
  const bool without_e = in.restitution == 0.0 && flaw != ReflectionFlaw::reflects_without_e;
  if (without_e) return {exact_solution(A, first)->lambda, 0, true};
  Vector u = first;
  Impulses done{Vector::Zero(u.size()), 0, false};
  std::vector<int> V = reflected_contacts(in, u, flaw);
  while (!V.empty() && done.count < cap_of(in, flaw)) {
    const Vector x = exact_solution(common::block(A, V), common::entries(u, V))->lambda;
    const Vector before = u;
    Vector change = Vector::Zero(u.size());
    change(V) = factor_of(in, flaw) * x;
    if (flaw == ReflectionFlaw::overwritten) done.lambda(V).setZero();
    done.lambda += change;
    u = exact_row_sums(A, change, before);
    if (flaw == ReflectionFlaw::only_their_speeds) {
      for (int i = 0; i < u.size(); ++i) {
        if (std::find(V.begin(), V.end(), i) == V.end()) u[i] = before[i];
      }
    }
    ++done.count;
    V = reflected_contacts(in, u, flaw);
  }
  done.ended = V.empty() || flaw == ReflectionFlaw::always_ended;
  if (flaw == ReflectionFlaw::ended_by_count) done.ended = done.count < in.most;
  done.lambda = blended_impulses(in, u, done.lambda, flaw);
  return done;
}

std::string likely_of_generalized_reflections() {
  std::vector<Reflecting> all = reflection_inputs();
  for (const Reflecting& in : reflection_inputs_at_border()) all.push_back(in);
  std::vector<Mistake<Reflecting, Done>> mistakes;
  for (const ToldOfReflections& one : told_of_reflections())
    mistakes.push_back(mistake_of_reflections(one));
  return fingerprint(
      all,
      [](const Reflecting& in) {
        return Done{
            lab::multi_contact::generalized_reflections(in.system, in.restitution, in.most)};
      },
      mistakes);
}

}  // namespace tests

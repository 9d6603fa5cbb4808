#pragma once

#include <limits>
#include <string>

#include "judged.hpp"

/// What steps 7.5 and 7.6 are asked, and what is right, or would be with one flaw.
namespace tests {

/// Impulses as one value: where `count` or `ended` differ they are infinitely far apart.
struct Done {
  Impulses impulses;
};
inline bool is_finite(const Done& v) { return is_finite(v.impulses.lambda); }
inline double length(const Done& v) { return length(v.impulses.lambda); }
inline double difference(const Done& a, const Done& b) {
  const bool same = a.impulses.count == b.impulses.count && a.impulses.ended == b.impulses.ended;
  return same ? difference(a.impulses.lambda, b.impulses.lambda)
              : std::numeric_limits<double>::infinity();
}

/// A question to step 7.5.
struct Reflecting {
  ContactSystem system;
  double restitution = 1.0;
  int most = 100;
};

inline Trial reflections_trial(const Reflecting& in, int index = 1, int count = 1) {
  Trial trial = system_trial("7.5 generalized_reflections", in.system, index, count);
  return trial.given("restitution", in.restitution).given("max_reflections", in.most);
}
inline Trial projection_trial(const ContactSystem& system, int index = 1, int count = 1) {
  return system_trial("7.6 inelastic_projection", system, index, count);
}

/// The answer's impulses, one for each contact, all of them finite: tests compute with them.
inline Impulses usable(const Trial& trial, const Impulses& got, Eigen::Index size) {
  expect_size(trial, got.lambda, size);
  trial.of("lambda").expect(got.lambda, got.lambda, exact);
  return got;
}
inline Impulses reflected_by_answer(const Reflecting& in, const Trial& trial) {
  return usable(trial, trial.returned([&] {
    return lab::multi_contact::generalized_reflections(in.system, in.restitution, in.most);
  }),
                in.system.u.size());
}
inline Impulses projected_by_answer(const ContactSystem& system, const Trial& trial) {
  return usable(trial,
                trial.returned([&] { return lab::multi_contact::inelastic_projection(system); }),
                system.u.size());
}

/// Of impulses of this size that have been found by as many solutions.
/// condition  of the systems that are solved, or above it
inline Bound of_solutions(int solutions, double size, double condition = 16.0) {
  return {8.0 * eps * condition * (solutions + 1) * size,
          "solutions of systems of this condition; what one of them rounds the next ones keep"};
}

/// What can be wrong with reflections.
enum class ReflectionFlaw {
  none,
  over_all_contacts,
  with_what_rests,
  one_alone,
  once,
  one_round,
  restitution_in_each,
  restitution_in_each_and_blended,
  blend_reversed,
  blend_by_square,
  no_blend,
  blend_with_nothing,
  rest_of_reflected,
  overwritten,
  only_their_speeds,
  one_more,
  one_fewer,
  no_cap,
  ended_by_count,
  always_ended,
  reflects_without_e,
  no_tolerance,
  coarse_tolerance,
  tolerance_of_now,
  tolerance_of_length,
  absolute_tolerance
};
/// A is positive definite.
Impulses exact_reflections(const Reflecting& in, ReflectionFlaw flaw = ReflectionFlaw::none);

/// What can be wrong with a zone that is stopped.
enum class ZoneFlaw {
  none,
  once,
  only_pushes,
  complementary,
  all_contacts,
  with_what_rests,
  only_the_new,
  leaves,
  speeds_of_now,
  wrong_way,
  twice,
  counts_contacts,
  counts_the_look,
  not_ended,
  no_tolerance,
  coarse_tolerance,
  tolerance_of_now,
  tolerance_of_length,
  absolute_tolerance
};
/// A is positive definite.
Impulses exact_projection(const ContactSystem& system, ZoneFlaw flaw = ZoneFlaw::none);

/// Three to six contacts of balls in a row, of masses 1 to 9, or contacts that all know of each
/// other; contact 0 comes at 1, some others come, some part.
ContactSystem random_impact(Random& random, int index);
/// Above their condition: at most 4 / (0.19 / 9) in a row.
inline constexpr double random_condition = 200.0;
/// Another order of as many contacts.
std::vector<int> random_order(Random& random, Eigen::Index contacts);
inline ContactSystem renumbered(const ContactSystem& system, const std::vector<int>& order) {
  return {common::block(system.A, order), common::entries(system.u, order)};
}

}  // namespace tests

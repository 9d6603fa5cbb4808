#pragma once

#include <concepts>
#include <string>

#include "cases.hpp"

/// Touches that count, judged for any of the methods.
namespace tests {

/// Requires the hit of a tie. Where the same path is right once there is no doubt, the touch alone
/// is what is wrong.
/// bound      of the time in seconds, at the touch
/// otherwise  what may be wrong where that is wrong, too: a function, as in Trial::expect
template <typename Call, std::invocable Suspects>
void expect_tie(const Trial& trial, const Call& time_of_impact, const Tie& tie, const Bound& bound,
                const Suspects& otherwise) {
  const Time got{trial.returned([&] { return time_of_impact(tie.query); })};
  const Time beside{trial.returned([&] { return time_of_impact(tie.beside); })};
  const bool right_beside = difference(beside, time_of(tie.beside)) <= 1e-9;
  trial.expect(got, Time{tie.time}, bound, [&] {
    return right_beside ? TimeSuspects{{{}, tie.story}} : otherwise();
  });
}

}  // namespace tests

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "judged.hpp"

/// Step 7.2 once more, in extended precision, with what students get wrong as switches.
namespace tests {

enum class SequentialFlaw {
  none,
  one_sweep,
  start_of_sweep,
  every_contact,
  no_restitution,
  e_alone,
  one_minus_e,
  e_ignored,
  overwritten,
  others_not_told,
  no_mass,
  other_sign,
  begins_again,
  worst_first,
  backwards,
  cap_a_sweep,
  one_too_many,
  one_too_few,
  cap_of_sweeps,
  counts_sweeps,
  counts_visits,
  always_ended,
  ended_below_cap,
  no_tolerance,
  absolute_tolerance,
  newest_tolerance,
  wide_tolerance,
  zero_is_approach
};
const std::vector<std::pair<SequentialFlaw, std::string>>& sequential_flaws();

struct SequentialInput {
  ContactSystem system;
  double restitution = 1.0;
  int max_impulses = 1000;
};

struct SequentialOutcome {
  Impulses done;
  double margin = 1.0;  ///< how far from it the closest decision was, of the largest |u_i|
};

/// (4), impulse by impulse.
SequentialOutcome sequential_outcome(const SequentialInput& in,
                                     SequentialFlaw flaw = SequentialFlaw::none);

Trial sequential_trial(const SequentialInput& in, int index = 1, int count = 1);
/// What the answer returns, with an entry for each contact, or the case ends here.
Impulses sequential_by_answer(const Trial& trial, const SequentialInput& in);

}  // namespace tests

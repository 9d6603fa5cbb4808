#pragma once

#include <string>
#include <utility>
#include <vector>

#include "judged.hpp"

/// Step 7.3 once more, in extended precision, with what students get wrong as switches.
namespace tests {

struct SweepsInput {
  Matrix A;
  Vector b;
  Vector start;
  int sweeps = 1;
};

/// What can be wrong with (5).
enum class SweepsFlaw {
  none,
  no_clamp,
  clamped_change,
  clamped_at_the_end,
  start_clamped,
  start_ignored,
  old_lambda,
  backwards,
  to_and_fro,
  no_diagonal,
  no_b,
  other_sign_of_b,
  other_sign,
  own_part_left_out,
  overwritten,
  one_sweep,
  one_too_many
};
const std::vector<std::pair<SweepsFlaw, std::string>>& sweeps_flaws();

Vector lambda_after(const SweepsInput& in, SweepsFlaw flaw = SweepsFlaw::none);

Trial sweeps_trial(const SweepsInput& in, int index = 1, int count = 1);
/// What the answer returns, with an entry for each contact, or the case ends here.
Vector sweeps_by_answer(const Trial& trial, const SweepsInput& in);

/// What can be wrong with (6).
enum class ResidualFlaw {
  none,
  no_size,
  size_inside,
  larger_of_two,
  product,
  sum,
  length,
  u_alone,
  lambda_alone,
  no_b,
  divided,
  least,
  below_zero
};
const std::vector<std::pair<ResidualFlaw, std::string>>& residual_flaws();

double residual_of(const Matrix& A, const Vector& b, const Vector& lambda,
                   ResidualFlaw flaw = ResidualFlaw::none);

}  // namespace tests

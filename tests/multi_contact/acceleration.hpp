#pragma once

#include <string>
#include <utility>
#include <vector>

#include "judged.hpp"

/// Step 7.8 once more, in long double, with what students get wrong as switches.
namespace tests {

struct Accelerating {
  Matrix A;
  Vector b;
  int steps = 1;
};

enum class AccelerationFlaw {
  none,
  never_restarts,
  always_restarts,
  restarts_downhill,
  restarts_late,
  restart_steps_back,
  returns_y,
  clamps_y,
  slope_at_lambda,
  no_momentum,
  full_momentum,
  momentum_by_old_c,
  momentum_by_c,
  c_without_4,
  step_of_trace,
  step_of_diagonal,
  step_of_half,
  not_clamped,
  no_b,
  one_step_more
};
const std::vector<std::pair<AccelerationFlaw, std::string>>& acceleration_flaws();

struct Accelerated {
  Vector lambda;
  double margin = 1.0;  ///< the least |cos| of the angle by which a step went up or down
};
Accelerated exact_acceleration(const Accelerating& in,
                               AccelerationFlaw flaw = AccelerationFlaw::none);

inline Trial acceleration_trial(const Accelerating& in, int index = 1, int count = 1) {
  Trial trial = system_trial("7.8 accelerated", in.A, in.b, index, count);
  return trial.given("steps", in.steps);
}
/// An entry for each contact, all of them finite: tests compute with them.
inline Vector accelerated_by_answer(const Accelerating& in, const Trial& trial) {
  const Vector got =
      trial.returned([&] { return lab::multi_contact::accelerated(in.A, in.b, in.steps); });
  expect_size(trial, got, in.b.size());
  trial.expect(got, got, exact);
  return got;
}

}  // namespace tests

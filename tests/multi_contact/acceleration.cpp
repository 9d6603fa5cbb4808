#include "acceleration.hpp"

#include <algorithm>
#include <cmath>

namespace tests {
namespace {

using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using Flawed = AccelerationFlaw;

/// What one step of (13) leaves to the next.
struct Course {
  Long lambda;
  Long y;
  long double c = 1;
};

long double step_length(const Matrix& A, Flawed flaw) {
  double L = common::largest_eigenvalue(A);
  if (flaw == Flawed::step_of_trace) L = A.trace();
  if (flaw == Flawed::step_of_diagonal) L = A.diagonal().maxCoeff();
  if (flaw == Flawed::step_of_half) L *= 2.0;
  return 1 / static_cast<long double>(L);
}

Long slope(const Accelerating& in, const Long& at, Flawed flaw) {
  Long g(at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    g[i] = flaw == Flawed::no_b ? 0 : static_cast<long double>(in.b[i]);
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      g[i] += static_cast<long double>(in.A(i, j)) * at[j];
    }
  }
  return g;
}

bool restarts(long double uphill, Flawed flaw) {
  if (flaw == Flawed::never_restarts) return false;
  if (flaw == Flawed::restarts_downhill) return uphill < 0;
  return flaw == Flawed::always_restarts || uphill > 0;
}

long double share_kept(long double c, long double c_next, Flawed flaw) {
  if (flaw == Flawed::no_momentum) return 0;
  if (flaw == Flawed::full_momentum) return 1;
  if (flaw == Flawed::momentum_by_old_c) return (c - 1) / c;
  return flaw == Flawed::momentum_by_c ? c / c_next : (c - 1) / c_next;
}

/// returns  g·(λ' − λ) over the lengths of the two; 1 if nothing moved
long double take_step(const Accelerating& in, long double length, Course& course, Flawed flaw) {
  const Long g = slope(in, flaw == Flawed::slope_at_lambda ? course.lambda : course.y, flaw);
  Long next = course.y - length * g;
  if (flaw != Flawed::not_clamped) next = next.cwiseMax(0.0L);
  const Long change = next - course.lambda;
  const long double uphill = g.dot(change);
  const bool again = restarts(uphill, flaw);
  long double c = course.c;
  if (again && flaw != Flawed::restarts_late) c = 1;
  const long double root = std::sqrt(1 + (flaw == Flawed::c_without_4 ? 1 : 4) * c * c);
  const long double c_next = (1 + root) / 2;
  course.y = next + share_kept(c, c_next, flaw) * change;
  if (flaw == Flawed::clamps_y) course.y = course.y.cwiseMax(0.0L).eval();
  course.c = again && flaw == Flawed::restarts_late ? 1 : c_next;
  if (again && flaw == Flawed::restart_steps_back) {
    course.y = course.lambda;
  } else {
    course.lambda = next;
  }
  const long double lengths = g.norm() * change.norm();
  return lengths > 0 ? uphill / lengths : 1;
}

}  // namespace

Accelerated exact_acceleration(const Accelerating& in, AccelerationFlaw flaw) {
  const Eigen::Index m = in.b.size();
  Course course{Long::Zero(m), Long::Zero(m)};
  const long double length = step_length(in.A, flaw);
  long double margin = 1;
  for (int step = 0; step < in.steps + (flaw == Flawed::one_step_more ? 1 : 0); ++step) {
    margin = std::min(margin, std::abs(take_step(in, length, course, flaw)));
  }
  const Long& told = flaw == Flawed::returns_y ? course.y : course.lambda;
  return {told.cast<double>(), static_cast<double>(margin)};
}

const std::vector<std::pair<AccelerationFlaw, std::string>>& acceleration_flaws() {
  const char* const no_momentum =
      "there is no momentum: y goes on past lambda', and c = 1 only if a step went uphill";
  static const std::vector<std::pair<AccelerationFlaw, std::string>> all{
      {Flawed::never_restarts,
       "no step restarts: if it went uphill, g.(lambda' - lambda) > 0 with g at y, c = 1"},
      {Flawed::restarts_late,
       "a restart comes a step late: c = 1 first, then y, which has no momentum then"},
      {Flawed::restart_steps_back, "a restart takes the step back: lambda' is kept"},
      {Flawed::returns_y, "y is returned: it is lambda that is clamped"},
      {Flawed::clamps_y, "y is clamped: only lambda is"},
      {Flawed::slope_at_lambda, "the slope is taken at lambda: g = A y + b"},
      // The same values: without momentum all steps go downhill.
      {Flawed::no_momentum, no_momentum},
      {Flawed::always_restarts, no_momentum},
      {Flawed::restarts_downhill, no_momentum},
      {Flawed::full_momentum, "y goes on by the whole of the last step: by (c - 1)/c' of it"},
      {Flawed::momentum_by_old_c, "the momentum is (c - 1)/c: divide by the next c"},
      {Flawed::momentum_by_c, "the momentum is c/c': it is (c - 1)/c'"},
      {Flawed::c_without_4, "the root is of 1 + c^2: it is of 1 + 4 c^2"},
      {Flawed::step_of_trace, "L is the trace of A: take its largest eigenvalue"},
      {Flawed::step_of_diagonal, "L is the largest of A's diagonal: take its largest eigenvalue"},
      {Flawed::step_of_half, "the step is half of 1/L"},
      {Flawed::not_clamped, "lambda is not clamped: a contact never pulls"},
      {Flawed::no_b, "b is missing in the slope"},
      {Flawed::one_step_more, "there is one step more than asked for"}};
  return all;
}

}  // namespace tests

#include "sweeps.hpp"

#include <algorithm>
#include <cmath>

namespace tests {
namespace {

using VectorL = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

Real row(const Matrix& A, const Vector& b, const VectorL& lambda, Eigen::Index i) {
  Real sum = wide(b[i]);
  for (Eigen::Index j = 0; j < b.size(); ++j) sum += wide(A(i, j)) * lambda[j];
  return sum;
}

/// λ_i as the sweep leaves it; `seen` is λ as the sweep sees it.
Real moved(const SweepsInput& in, const VectorL& seen, Eigen::Index i, SweepsFlaw flaw) {
  Real u = row(in.A, in.b, seen, i);
  if (flaw == SweepsFlaw::no_b) u -= wide(in.b[i]);
  if (flaw == SweepsFlaw::other_sign_of_b) u -= 2 * wide(in.b[i]);
  if (flaw == SweepsFlaw::own_part_left_out) u -= wide(in.A(i, i)) * seen[i];
  Real change = -u / (flaw == SweepsFlaw::no_diagonal ? Real(1) : wide(in.A(i, i)));
  if (flaw == SweepsFlaw::other_sign) change = -change;
  if (flaw == SweepsFlaw::clamped_change) change = std::max(Real(0), change);
  const Real next = flaw == SweepsFlaw::overwritten ? change : seen[i] + change;
  const bool free = flaw == SweepsFlaw::no_clamp || flaw == SweepsFlaw::clamped_change ||
                    flaw == SweepsFlaw::clamped_at_the_end;
  return free ? next : std::max(Real(0), next);
}

void sweep(const SweepsInput& in, VectorL& lambda, bool from_last, SweepsFlaw flaw) {
  const VectorL old = lambda;
  for (Eigen::Index k = 0; k < lambda.size(); ++k) {
    const Eigen::Index i = from_last ? lambda.size() - 1 - k : k;
    lambda[i] = moved(in, flaw == SweepsFlaw::old_lambda ? old : lambda, i, flaw);
  }
}

}  // namespace

Vector lambda_after(const SweepsInput& in, SweepsFlaw flaw) {
  VectorL lambda = in.start.cast<Real>();
  if (flaw == SweepsFlaw::start_ignored) lambda.setZero();
  if (flaw == SweepsFlaw::start_clamped) lambda = lambda.cwiseMax(Real(0));
  int sweeps = in.sweeps;
  if (flaw == SweepsFlaw::one_sweep) sweeps = std::min(1, sweeps);
  if (flaw == SweepsFlaw::one_too_many) ++sweeps;
  for (int k = 0; k < sweeps; ++k) {
    const bool from_last =
        flaw == SweepsFlaw::backwards || (flaw == SweepsFlaw::to_and_fro && k % 2 == 1);
    sweep(in, lambda, from_last, flaw);
  }
  if (flaw == SweepsFlaw::clamped_at_the_end) lambda = lambda.cwiseMax(Real(0));
  return lambda.cast<double>();
}

Trial sweeps_trial(const SweepsInput& in, int index, int count) {
  Trial trial = system_trial("7.3 gauss_seidel", in.A, in.b, index, count);
  return trial.given("start", in.start).given("sweeps", static_cast<double>(in.sweeps));
}

Vector sweeps_by_answer(const Trial& trial, const SweepsInput& in) {
  Vector got = trial.returned(
      [&] { return lab::multi_contact::gauss_seidel(in.A, in.b, in.start, in.sweeps); });
  expect_size(trial, got, in.b.size());
  return got;
}

double residual_of(const Matrix& A, const Vector& b, const Vector& lambda, ResidualFlaw flaw) {
  using Flaw = ResidualFlaw;
  const VectorL x = lambda.cast<Real>();
  Real result = flaw == Flaw::least ? Real(HUGE_VALL) : Real(0);
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    Real u = row(A, b, x, i);
    if (flaw == Flaw::no_b) u -= wide(b[i]);
    if (flaw == Flaw::divided) u /= wide(A(i, i));
    Real both = std::abs(std::min(x[i], u));
    if (flaw == Flaw::no_size) both = std::min(x[i], u);
    if (flaw == Flaw::below_zero) both = std::max(Real(0), -std::min(x[i], u));
    if (flaw == Flaw::size_inside) both = std::min(std::abs(x[i]), std::abs(u));
    if (flaw == Flaw::larger_of_two) both = std::abs(std::max(x[i], u));
    if (flaw == Flaw::product) both = std::abs(x[i] * u);
    if (flaw == Flaw::u_alone) both = std::abs(u);
    if (flaw == Flaw::lambda_alone) both = std::abs(x[i]);
    if (flaw == Flaw::sum) {
      result += both;
    } else if (flaw == Flaw::length) {
      result = std::hypot(result, both);
    } else {
      result = flaw == Flaw::least ? std::min(result, both) : std::max(result, both);
    }
  }
  return static_cast<double>(result);
}

const std::vector<std::pair<SweepsFlaw, std::string>>& sweeps_flaws() {
  using Flaw = SweepsFlaw;
  static const std::vector<std::pair<Flaw, std::string>> all{
      {Flaw::no_clamp, "the clamp is missing: lambda_i is at least 0, contacts do not pull"},
      {Flaw::clamped_change,
       "the change is clamped: clamp lambda_i itself, so that a contact can give back"},
      {Flaw::clamped_at_the_end,
       "lambda is clamped after all sweeps: clamp each lambda_i as soon as it is changed"},
      {Flaw::start_clamped, "start is clamped: it may have either sign, and counts as it is"},
      {Flaw::start_ignored, "start is not used: the sweeps begin there, not at zero"},
      {Flaw::old_lambda,
       "a sweep works with the lambda of its start, as Jacobi's does: use each change at once"},
      {Flaw::backwards, "the sweep goes from the last contact to the first: begin with the first"},
      {Flaw::to_and_fro, "every other sweep goes backwards: each begins with the first contact"},
      {Flaw::no_diagonal, "A_ii is missing: the change is -(A lambda + b)_i/A_ii"},
      {Flaw::no_b, "b is missing: the change is -(A lambda + b)_i/A_ii"},
      {Flaw::other_sign_of_b, "b has the wrong sign: the change is -(A lambda + b)_i/A_ii"},
      {Flaw::other_sign, "the change has the wrong sign: it is -(A lambda + b)_i/A_ii"},
      {Flaw::own_part_left_out,
       "A_ii lambda_i is left out of the row, and lambda_i is added: do one of the two"},
      {Flaw::overwritten,
       "lambda_i is replaced by its change: add it to what there was, then clamp"},
      {Flaw::one_sweep, "there is one sweep only: do as many as are asked for"},
      {Flaw::one_too_many, "there is one sweep too many: no sweeps return start as it is"}};
  return all;
}

const std::vector<std::pair<ResidualFlaw, std::string>>& residual_flaws() {
  using Flaw = ResidualFlaw;
  static const std::vector<std::pair<Flaw, std::string>> all{
      {Flaw::no_size, "what is below zero is no breach: take the size of the smaller of the two"},
      {Flaw::below_zero,
       "only what is below zero is a breach: both above zero is one, too, by the smaller of them"},
      {Flaw::size_inside,
       "min takes the two sizes: take min first, with signs, and the size of that"},
      {Flaw::larger_of_two, "max stands where min belongs: one of the two has to be zero"},
      {Flaw::product, "it is lambda_i times (A lambda + b)_i: take the smaller of the two"},
      {Flaw::sum, "the breaches are added up: take the largest"},
      {Flaw::length, "it is the length of all breaches together: take the largest"},
      {Flaw::u_alone, "lambda_i is not asked: a contact that does not push may part"},
      {Flaw::lambda_alone, "A lambda + b is not asked: take the smaller of lambda_i and that"},
      {Flaw::no_b, "b is missing: it is A lambda + b that is compared with lambda"},
      {Flaw::divided, "(A lambda + b)_i is divided by A_ii: it is compared as it is"},
      {Flaw::least, "it is the smallest breach: take the largest"}};
  return all;
}

}  // namespace tests

#include "sequential.hpp"

#include <algorithm>
#include <cmath>

namespace tests {
namespace {

using Flaw = SequentialFlaw;

/// The state of (4) between two impulses.
class Sweeping {
 public:
  Sweeping(const SequentialInput& in, Flaw flaw)
      : in_(in), flaw_(flaw), A_(in.system.A.cast<Real>()), u_(in.system.u.cast<Real>()) {
    outcome_.done.lambda = Vector::Zero(in.system.u.size());
    first_largest_ = largest();
    e_ = wide(in.restitution);
    if (flaw == Flaw::no_restitution) e_ = 0;
    if (flaw == Flaw::e_alone) e_ -= 1;
    if (flaw == Flaw::one_minus_e) e_ = -e_;
    if (flaw == Flaw::e_ignored) e_ = 1;
    cap_ = in.max_impulses;
    if (flaw == Flaw::one_too_many) ++cap_;
    if (flaw == Flaw::one_too_few && cap_ > 0) --cap_;
  }

  SequentialOutcome run() {
    Impulses& done = outcome_.done;
    while (any() && !is_full()) {
      ++sweeps_;
      if (flaw_ == Flaw::start_of_sweep) start_ = u_;
      sweep();
      if (flaw_ == Flaw::one_sweep) break;
    }
    done.ended = !any();
    if (flaw_ == Flaw::always_ended) done.ended = true;
    if (flaw_ == Flaw::ended_below_cap) done.ended = impulses_ < in_.max_impulses;
    done.count = flaw_ == Flaw::counts_sweeps   ? sweeps_
                 : flaw_ == Flaw::counts_visits ? visits_
                                                : impulses_;
    return outcome_;
  }

 private:
  using VectorL = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using MatrixL = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

  [[nodiscard]] Real largest() const {
    Real most = 0;
    for (Eigen::Index i = 0; i < u_.size(); ++i) most = std::max(most, std::abs(u_[i]));
    return most;
  }

  [[nodiscard]] Real tolerance() const {
    if (flaw_ == Flaw::no_tolerance || flaw_ == Flaw::zero_is_approach) return 0;
    if (flaw_ == Flaw::absolute_tolerance) return 1e-12L;
    if (flaw_ == Flaw::wide_tolerance) return 1e-9L * first_largest_;
    const Real of = flaw_ == Flaw::newest_tolerance ? largest() : first_largest_;
    return wide(1e-12 * static_cast<double>(of));  // rounded as answers do
  }

  bool approaches(Eigen::Index i) {
    if (first_largest_ > 0) {
      const auto margin = static_cast<double>(std::abs(u_[i] + tolerance()) / first_largest_);
      outcome_.margin = std::min(outcome_.margin, margin);
    }
    if (flaw_ == Flaw::zero_is_approach) return u_[i] <= 0;
    return u_[i] < -tolerance();
  }
  bool any() {
    for (Eigen::Index i = 0; i < u_.size(); ++i) {
      if (approaches(i)) return true;
    }
    return false;
  }
  [[nodiscard]] bool is_full() const {
    return (flaw_ == Flaw::cap_of_sweeps ? sweeps_ : impulses_) >= cap_;
  }

  void push(Eigen::Index i) {
    const Real from = flaw_ == Flaw::start_of_sweep ? start_[i] : u_[i];
    Real d = -(1 + e_) * from / (flaw_ == Flaw::no_mass ? Real(1) : A_(i, i));
    if (flaw_ == Flaw::other_sign) d = -d;
    double& lambda = outcome_.done.lambda[i];
    lambda = static_cast<double>(flaw_ == Flaw::overwritten ? d : wide(lambda) + d);
    if (flaw_ == Flaw::others_not_told) {
      u_[i] += d * A_(i, i);
    } else {
      for (Eigen::Index k = 0; k < u_.size(); ++k) u_[k] += d * A_(k, i);
    }
    ++impulses_;
  }

  void sweep() {
    const Eigen::Index m = u_.size();
    if (flaw_ == Flaw::worst_first) {
      Eigen::Index worst = 0;
      for (Eigen::Index i = 1; i < m; ++i) worst = u_[i] < u_[worst] ? i : worst;
      push(worst);
      return;
    }
    for (Eigen::Index k = 0; k < m; ++k) {
      if (is_full() && flaw_ != Flaw::cap_a_sweep && flaw_ != Flaw::cap_of_sweeps) return;
      const Eigen::Index i = flaw_ == Flaw::backwards ? m - 1 - k : k;
      ++visits_;
      const bool needed = flaw_ == Flaw::start_of_sweep ? start_[i] < -tolerance() : approaches(i);
      if (!needed && flaw_ != Flaw::every_contact) continue;
      push(i);
      if (flaw_ == Flaw::begins_again) return;
    }
  }

  const SequentialInput& in_;
  Flaw flaw_;
  MatrixL A_;
  VectorL u_;
  VectorL start_;
  Real first_largest_ = 0;
  Real e_ = 0;
  int cap_ = 0;
  int sweeps_ = 0;
  int visits_ = 0;
  int impulses_ = 0;
  SequentialOutcome outcome_;
};

}  // namespace

SequentialOutcome sequential_outcome(const SequentialInput& in, SequentialFlaw flaw) {
  return Sweeping(in, flaw).run();
}

Trial sequential_trial(const SequentialInput& in, int index, int count) {
  Trial trial = system_trial("7.2 sequential_impulses", in.system, index, count);
  return trial.given("restitution", in.restitution)
      .given("max_impulses", static_cast<double>(in.max_impulses));
}

Impulses sequential_by_answer(const Trial& trial, const SequentialInput& in) {
  Impulses got = trial.returned([&] {
    return lab::multi_contact::sequential_impulses(in.system, in.restitution, in.max_impulses);
  });
  expect_size(trial, got.lambda, in.system.u.size());
  return got;
}

const std::vector<std::pair<SequentialFlaw, std::string>>& sequential_flaws() {
  static const std::vector<std::pair<SequentialFlaw, std::string>> all{
      {Flaw::one_sweep, "it ends after one sweep: sweep again until no contact approaches"},
      {Flaw::start_of_sweep,
       "a sweep works with the u of its start: let all of u know of each impulse at once"},
      {Flaw::every_contact,
       "contacts that do not approach get impulses, too: leave them alone, they would be pulled"},
      {Flaw::no_restitution, "e is missing: d = -(1 + e) u_i/A_ii"},
      {Flaw::e_alone, "e stands where 1 + e belongs: first stop the contact, then let it bounce"},
      {Flaw::one_minus_e, "1 - e stands where 1 + e belongs"},
      {Flaw::e_ignored, "every impulse is elastic: 1 + e belongs where 2 stands"},
      {Flaw::overwritten, "lambda_i is the last impulse only: add each to what there was"},
      {Flaw::others_not_told,
       "an impulse changes u_i alone: add d times column i of A to all of u"},
      {Flaw::no_mass, "A_ii is missing: d = -(1 + e) u_i/A_ii"},
      {Flaw::other_sign, "d has the wrong sign: where u_i is below zero the impulse is above zero"},
      {Flaw::begins_again,
       "after each impulse it begins again with the first contact: finish the sweep"},
      {Flaw::worst_first, "the fastest contact comes first: the order is that of the list"},
      {Flaw::backwards, "the sweep goes from the last contact to the first: begin with the first"},
      {Flaw::cap_a_sweep,
       "max_impulses is looked at once a sweep: stop at once, inside of it, too"},
      {Flaw::one_too_many, "one impulse more than max_impulses is given: stop at count == cap"},
      {Flaw::one_too_few, "one impulse fewer than max_impulses is given: stop at count == cap"},
      {Flaw::cap_of_sweeps, "max_impulses is taken for a number of sweeps: count impulses"},
      {Flaw::counts_sweeps, "count is the number of sweeps: count impulses"},
      {Flaw::counts_visits,
       "count is the number of visits: count the contacts that got an impulse"},
      {Flaw::always_ended, "ended is always true: it is false if some contact approaches still"},
      {Flaw::ended_below_cap,
       "ended only says that the cap was not reached: the last impulse allowed may be enough"},
      {Flaw::no_tolerance, "the tolerance is missing: a contact approaches if u_i < -1e-12 max|u|"},
      {Flaw::absolute_tolerance,
       "the tolerance is 1e-12 m/s: it is 1e-12 of the largest |u_i| that was handed in"},
      {Flaw::newest_tolerance,
       "the tolerance is of the newest u: set it once, from the u that was handed in"},
      {Flaw::wide_tolerance, "the tolerance is wider than 1e-12 of the largest |u_i|"},
      {Flaw::zero_is_approach, "u_i = 0 is taken for an approach: it is u_i < -1e-12 max|u|"}};
  return all;
}

}  // namespace tests

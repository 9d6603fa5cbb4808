#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "friction.hpp"

namespace tests {
namespace {

using Pair = std::array<Wide, 2>;

Wide length_of_pair(const Pair& p) { return std::hypot(p[0], p[1]); }

Pair scaled_pair(const Pair& p, Wide factor) { return {p[0] * factor, p[1] * factor}; }

Pair boxed(const Pair& p, Wide limit, bool upper_end_only) {
  const Wide low = upper_end_only ? -HUGE_VALL : -limit;
  return {std::clamp(p[0], low, limit), std::clamp(p[1], low, limit)};
}

Pair in_disc(const Pair& p, Wide limit, LimitFlaw flaw) {
  const Wide length = length_of_pair(p);
  const Wide asked = flaw == LimitFlaw::squared_length ? length * length : length;
  if (asked <= limit && flaw != LimitFlaw::always_on_rim) return p;
  const Wide largest = std::max(std::abs(p[0]), std::abs(p[1]));
  return scaled_pair(p, limit / (flaw == LimitFlaw::scaled_by_largest ? largest : length));
}

Pair in_diamond(const Pair& p, Wide limit, LimitFlaw flaw) {
  const Wide t = std::abs(p[0]);
  const Wide s = std::abs(p[1]);
  if (t + s <= limit) return p;
  if (flaw == LimitFlaw::scaled_diamond) return scaled_pair(p, limit / (t + s));
  const Wide less = (t + s - limit) / (flaw == LimitFlaw::diamond_by_whole ? 1 : 2);
  Pair left{t - less, s - less};
  if (flaw == LimitFlaw::diamond_by_whole)
    left = {std::max(t - less, Wide(0)), std::max(s - less, Wide(0))};
  else if (flaw != LimitFlaw::diamond_past_zero) {
    left[0] = std::clamp(left[0], Wide(0), limit);
    left[1] = limit - left[0];
  }
  if (flaw == LimitFlaw::diamond_without_signs) return left;
  return {p[0] < 0 ? -left[0] : left[0], p[1] < 0 ? -left[1] : left[1]};
}

FrictionRule rule_taken(FrictionRule rule, LimitFlaw flaw) {
  const bool disc = rule == FrictionRule::disc;
  const bool box = rule == FrictionRule::box;
  if (flaw == LimitFlaw::disc_for_all || (box && flaw == LimitFlaw::disc_for_box)) {
    return FrictionRule::disc;
  }
  const bool boxed = flaw == LimitFlaw::box_for_all || (disc && flaw == LimitFlaw::box_for_disc) ||
                     (!disc && flaw == LimitFlaw::box_for_diamond);
  return boxed ? FrictionRule::box : rule;
}

Pair nearest_pair(const Pair& p, Wide limit, FrictionRule rule, LimitFlaw flaw = LimitFlaw::none) {
  if (flaw == LimitFlaw::not_limited) return p;
  const FrictionRule taken = rule_taken(rule, flaw);
  Pair q = boxed(p, limit, flaw == LimitFlaw::upper_end_only);
  if (taken == FrictionRule::disc) q = in_disc(p, limit, flaw);
  if (taken == FrictionRule::diamond) q = in_diamond(p, limit, flaw);
  return q;
}

/// (11) once more, with a flaw.
class Sweeps {
 public:
  Sweeps(const Sweeping& in, FrictionFlaw flaw)
      : in_(in), flaw_(flaw), contacts_(static_cast<int>(in.b.size() / 3)) {
    for (const double x : in.start) {
      lambda_.push_back(flaw == FrictionFlaw::start_forgotten ? 0 : static_cast<Wide>(x));
    }
    seen_ = lambda_;
  }

  Vector result() {
    int sweeps = in_.sweeps;
    if (flaw_ == FrictionFlaw::one_sweep_more) ++sweeps;
    if (flaw_ == FrictionFlaw::one_sweep_only) sweeps = std::min(sweeps, 1);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      seen_ = lambda_;
      for (int k = 0; k < contacts_; ++k) contact(k);
    }
    Vector result(in_.b.size());
    for (int i = 0; i < result.size(); ++i) result[i] = static_cast<double>(at(lambda_, i));
    return result;
  }

 private:
  static Wide& at(std::vector<Wide>& x, int i) { return x[static_cast<std::size_t>(i)]; }
  [[nodiscard]] Wide A(int i, int j) const { return static_cast<Wide>(in_.A(i, j)); }

  Wide u(int i) {
    std::vector<Wide>& lambda = flaw_ == FrictionFlaw::u_of_the_sweep ? seen_ : lambda_;
    Wide sum = static_cast<Wide>(in_.b[i]);
    for (int j = 0; j < in_.b.size(); ++j) sum += A(i, j) * at(lambda, j);
    return sum;
  }

  void normal(int n) {
    const Wide change = -u(n) / A(n, n);
    Wide& lambda = at(lambda_, n);
    if (flaw_ == FrictionFlaw::normal_not_clamped) {
      lambda += change;
    } else if (flaw_ == FrictionFlaw::change_clamped) {
      lambda += std::max(change, Wide(0));
    } else {
      lambda = std::max(Wide(0), lambda + change);
    }
  }

  /// How far the tangential impulses go against this slip.
  [[nodiscard]] Pair step(int t, int s, const Pair& slip) const {
    const Wide p = A(t, t);
    const Wide r = flaw_ == FrictionFlaw::step_without_coupling ? 0 : A(t, s);
    const Wide q = A(s, s);
    const Wide apart = std::hypot((p - q) / 2, r);
    switch (flaw_) {
      case FrictionFlaw::step_a_row:
        return {slip[0] / p, slip[1] / q};
      case FrictionFlaw::inverse_of_block: {
        const Wide det = p * q - r * r;
        return {(q * slip[0] - r * slip[1]) / det, (p * slip[1] - r * slip[0]) / det};
      }
      case FrictionFlaw::step_of_trace:
        return scaled_pair(slip, 1 / (p + q));
      case FrictionFlaw::step_of_t:
        return scaled_pair(slip, 1 / p);
      case FrictionFlaw::smaller_eigenvalue:
        return scaled_pair(slip, 1 / ((p + q) / 2 - apart));
      default:
        return scaled_pair(slip, 1 / ((p + q) / 2 + apart));
    }
  }

  Wide pressing(int n, Wide before) {
    if (flaw_ == FrictionFlaw::limit_of_before || flaw_ == FrictionFlaw::tangent_first) {
      return before;
    }
    if (flaw_ != FrictionFlaw::limit_of_all) return at(lambda_, n);
    Wide sum = 0;
    for (int k = 0; k < contacts_; ++k) sum += at(lambda_, 3 * k);
    return sum;
  }

  void contact(int k) {
    const bool by_kind = flaw_ == FrictionFlaw::rows_by_kind;
    const int n = by_kind ? k : 3 * k;
    const int t = by_kind ? contacts_ + k : n + 1;
    const int s = by_kind ? 2 * contacts_ + k : n + 2;
    const Wide before = at(lambda_, n);
    Pair slip{u(t), u(s)};
    if (flaw_ != FrictionFlaw::tangent_first) normal(n);
    const bool old_slip =
        flaw_ == FrictionFlaw::slip_before_normal || flaw_ == FrictionFlaw::tangent_first;
    if (!old_slip) slip = {u(t), u(s)};
    Pair back = step(t, s, slip);
    if (flaw_ == FrictionFlaw::along_the_slip) back = scaled_pair(back, -1);
    const Wide kept = flaw_ == FrictionFlaw::no_memory ? 0 : 1;
    const Pair tried{kept * at(lambda_, t) - back[0], kept * at(lambda_, s) - back[1]};
    const Wide mu =
        flaw_ == FrictionFlaw::limit_without_friction ? 1 : static_cast<Wide>(in_.friction);
    FrictionRule rule = in_.rule;
    if (flaw_ == FrictionFlaw::always_box) rule = FrictionRule::box;
    if (flaw_ == FrictionFlaw::always_disc) rule = FrictionRule::disc;
    const bool rim = flaw_ == FrictionFlaw::always_on_rim && length_of_pair(tried) > 0;
    const Pair next = nearest_pair(tried, std::max(Wide(0), mu * pressing(n, before)), rule,
                                   rim ? LimitFlaw::always_on_rim : LimitFlaw::none);
    at(lambda_, t) = next[0];
    at(lambda_, s) = next[1];
    if (flaw_ == FrictionFlaw::tangent_first) normal(n);
  }

  const Sweeping& in_;
  FrictionFlaw flaw_;
  int contacts_;
  std::vector<Wide> lambda_;
  std::vector<Wide> seen_;  ///< at the start of the sweep
};

}  // namespace

Vec2 exact_limited(const Limiting& in, LimitFlaw flaw) {
  const Pair q =
      nearest_pair({static_cast<Wide>(in.tangential.x()), static_cast<Wide>(in.tangential.y())},
                   static_cast<Wide>(in.limit), in.rule, flaw);
  return {static_cast<double>(q[0]), static_cast<double>(q[1])};
}

Vector exact_friction_sweeps(const Sweeping& in, FrictionFlaw flaw) {
  return Sweeps(in, flaw).result();
}

}  // namespace tests

#include <algorithm>
#include <cmath>

#include "friction.hpp"

namespace tests {
namespace {

/// One contact's share of the residual.
struct Breach {
  Wide normal;
  Wide friction;
};

Breach breach_of(const Judging& in, int n, JudgeFlaw flaw) {
  Wide u[3];
  Wide lambda[3];
  for (int k = 0; k < 3; ++k) {
    u[k] = flaw == JudgeFlaw::b_missing ? 0 : static_cast<Wide>(in.b[n + k]);
    for (int j = 0; j < in.b.size(); ++j) {
      u[k] += static_cast<Wide>(in.A(n + k, j)) * static_cast<Wide>(in.lambda[j]);
    }
    lambda[k] = static_cast<Wide>(in.lambda[n + k]);
  }
  const bool forgiven = flaw == JudgeFlaw::pull_forgiven;
  Wide normal = std::abs(std::min(forgiven ? std::max(Wide(0), lambda[0]) : lambda[0], u[0]));
  if (flaw == JudgeFlaw::approach_only) normal = std::max(Wide(0), -u[0]);
  Wide limit = std::max(Wide(0), lambda[0]);
  if (flaw == JudgeFlaw::limit_by_size) limit = std::abs(lambda[0]);
  if (flaw != JudgeFlaw::limit_without_friction) limit *= static_cast<Wide>(in.friction);
  Wide slip = 1;
  if (flaw == JudgeFlaw::along_the_slip) slip = -1;
  if (flaw == JudgeFlaw::no_slip) slip = 0;
  const Wide t = lambda[1] - slip * u[1];
  const Wide s = lambda[2] - slip * u[2];
  const Wide length = std::hypot(t, s);
  const Wide share = length > limit ? limit / length : 1;
  Wide off_t = lambda[1] - share * t;
  Wide off_s = lambda[2] - share * s;
  if (flaw == JudgeFlaw::box) {
    off_t = lambda[1] - std::clamp(t, -limit, limit);
    off_s = lambda[2] - std::clamp(s, -limit, limit);
  }
  if (flaw == JudgeFlaw::slip_only) off_t = u[1], off_s = u[2];
  Wide friction = std::hypot(off_t, off_s);
  if (flaw == JudgeFlaw::squares) friction *= friction;
  if (flaw == JudgeFlaw::tangents_apart) friction = std::max(std::abs(off_t), std::abs(off_s));
  return {flaw == JudgeFlaw::friction_only ? 0 : normal,
          flaw == JudgeFlaw::normal_only ? 0 : friction};
}

}  // namespace

double exact_coulomb_residual(const Judging& in, JudgeFlaw flaw) {
  Wide largest = 0;
  Wide sum = 0;
  Wide least = HUGE_VALL;
  Wide last = 0;
  for (int n = 0; n < in.b.size(); n += 3) {
    const auto [normal, friction] = breach_of(in, n, flaw);
    last = std::max(normal, friction);
    largest = std::max(largest, last);
    least = std::min(least, last);
    sum += normal + friction;
  }
  if (flaw == JudgeFlaw::sum) return static_cast<double>(sum);
  if (flaw == JudgeFlaw::last) return static_cast<double>(last);
  return static_cast<double>(flaw == JudgeFlaw::least ? least : largest);
}

}  // namespace tests

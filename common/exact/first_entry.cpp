#include "common/exact/first_entry.hpp"

#include <array>
#include <cstddef>

namespace common {
namespace {

int sign(DoubleDouble a) { return a.high > 0.0 ? 1 : (a.high < 0.0 ? -1 : 0); }

DoubleDouble times(double factor, DoubleDouble a) { return DoubleDouble(factor) * a; }

DoubleDouble value(const Quartic& g, double t) {
  const DoubleDouble x(t);
  return g.c0 + x * (g.c1 + x * (g.c2 + x * (g.c3 + x * g.c4)));
}

Quartic derivative(const Quartic& g) {
  return {g.c1, times(2.0, g.c2), times(3.0, g.c3), times(4.0, g.c4), {}};
}

/// Where g changes its sign in [low, high], where it is monotone: Newton's method, and bisection
/// where that leaves the bracket or converges slowly.
double crossing(const Quartic& g, const Quartic& rate, double low, double high) {
  const int sign_low = sign(value(g, low));
  double t = 0.5 * (low + high);
  for (int i = 0; i < 200; ++i) {
    const DoubleDouble here = value(g, t);
    if (sign(here) == 0) return t;
    (sign(here) == sign_low ? low : high) = t;
    double next = t - here.high / value(rate, t).high;
    if (!(next > low && next < high) || i % 8 == 7) {
      if (next == t) return t;
      next = 0.5 * (low + high);
    }
    if (next == low || next == high) return next;
    t = next;
  }
  return t;
}

/// Times from 0 to dt in rising order, few enough for no allocation.
struct Times {
  std::array<double, 8> at{};
  std::size_t count = 0;

  void insert(double t) {
    std::size_t i = count++;
    for (; i > 0 && at[i - 1] > t; --i) at[i] = at[i - 1];
    at[i] = t;
  }
};

/// The roots of a + b t + c t² within (0, dt), without cancellation.
void insert_roots(const Quadratic& g, double dt, Times& times_out) {
  const auto insert = [&](DoubleDouble numerator, DoubleDouble denominator) {
    if (sign(denominator) == 0) return;
    const double t = (numerator / denominator).high;
    if (t > 0.0 && t < dt) times_out.insert(t);
  };
  const DoubleDouble discriminant = g.c1 * g.c1 - times(4.0, g.c0 * g.c2);
  if (sign(discriminant) < 0) return;
  const DoubleDouble root = sqrt(discriminant);
  const DoubleDouble sum = sign(g.c1) < 0 ? root - g.c1 : -(g.c1 + root);
  insert(sum, times(2.0, g.c2));
  insert(times(2.0, g.c0), sum);
}

/// The turning points of g, and where its curvature changes: between two of them it is monotone.
Times monotone_pieces(const Quartic& g, const Quartic& rate, double dt) {
  Times bends;
  bends.insert(0.0);
  insert_roots({times(2.0, g.c2), times(6.0, g.c3), times(12.0, g.c4)}, dt, bends);
  bends.insert(dt);
  Times pieces = bends;
  const Quartic bend = derivative(rate);
  for (std::size_t i = 0; i + 1 < bends.count; ++i) {
    const double low = bends.at[i];
    const double high = bends.at[i + 1];
    if (sign(value(rate, low)) * sign(value(rate, high)) < 0) {
      pieces.insert(crossing(rate, bend, low, high));
    }
  }
  return pieces;
}

}  // namespace

std::optional<double> first_entry(const Quartic& g, double dt) {
  const Quartic rate = derivative(g);
  const Times pieces = monotone_pieces(g, rate, dt);
  if (dt == 0.0) return sign(g.c0) <= 0 && sign(g.c1) < 0 ? std::optional(0.0) : std::nullopt;
  for (std::size_t i = 0; i + 1 < pieces.count; ++i) {
    const double low = pieces.at[i];
    const double high = pieces.at[i + 1];
    if (sign(value(rate, 0.5 * (low + high))) >= 0) continue;
    if (sign(value(g, low)) <= 0) return low;
    const int sign_high = sign(value(g, high));
    if (sign_high < 0) return crossing(g, rate, low, high);
    if (sign_high == 0 && high == dt && sign(value(rate, dt)) < 0) return dt;
  }
  return std::nullopt;
}

std::optional<double> first_entry(const Quadratic& g, double dt) {
  const auto within = [&](DoubleDouble t) {
    return t.high <= dt ? std::optional(t.high) : std::nullopt;
  };
  const bool inside = sign(g.c0) <= 0;
  const bool turns_back = sign(g.c2) < 0;
  if (sign(g.c1) >= 0 && !turns_back) return std::nullopt;
  if (inside && sign(g.c1) < 0) return 0.0;
  const DoubleDouble discriminant = g.c1 * g.c1 - times(4.0, g.c0 * g.c2);
  if (sign(discriminant) <= 0) {
    return inside && dt > 0.0 ? within(-g.c1 / times(2.0, g.c2)) : std::nullopt;
  }
  const DoubleDouble root = sqrt(discriminant);
  if (sign(g.c1) > 0) return within(-(g.c1 + root) / times(2.0, g.c2));
  return within(times(2.0, g.c0) / (root - g.c1));
}

}  // namespace common

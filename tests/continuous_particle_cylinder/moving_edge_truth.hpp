#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "judge.hpp"
#include "moving_edge_cases.hpp"
#include "whole_polynomial.hpp"

namespace tests {

/// What of the edge's inside a wrong answer leaves out or takes for another.
struct InsideReading {
  bool ignored = false;        ///< only the ends touch
  bool line_for_edge = false;  ///< wherever the foot of the perpendicular is
  bool start_missed = false;   ///< only a root of the quartic counts
  bool thin = false;           ///< R where R + r belongs
  bool one_velocity = false;   ///< that of a for b, too
  bool last = false;           ///< the last root at which the foot is inside, not the first
};

/// When a moving edge touches, over τ = t / dt in [0, 1] and in lengths that are whole numbers.
class EdgeTruth {
 public:
  explicit EdgeTruth(const EdgeCase& edge_case);

  [[nodiscard]] Time time(const InsideReading& reading = {}) const;

 private:
  using Path = std::array<WholePolynomial, 2>;  ///< y and z

  static WholePolynomial dot(const Path& a, const Path& b) {
    return sum(product(a[0], b[0]), product(a[1], b[1]));
  }
  static WholePolynomial cross(const Path& a, const Path& b) {
    return sum(product(a[0], b[1]), product(a[1], b[0]), -1);
  }
  static Path way(const Path& from, const Path& to) {
    return {sum(to[0], from[0], -1), sum(to[1], from[1], -1)};
  }

  static std::optional<double> earlier(const std::optional<double>& a,
                                       const std::optional<double>& b) {
    return a && b ? std::min(a, b) : a ? a : b;
  }

  [[nodiscard]] std::optional<double> inside_touch(const InsideReading& reading,
                                                   const std::optional<double>& end) const;

  double dt_;
  std::optional<double> end_touch_;
  Path p_, q_, q_with_velocity_of_p_;
  Whole R_, rho_;
};

inline EdgeTruth::EdgeTruth(const EdgeCase& c) : dt_(c.dt) {
  const MovingEdge& edge = c.edge;
  const std::vector<double> lengths{edge.a.y(), edge.a.z(),  edge.b.y(),
                                    edge.b.z(), edge.radius, c.R};
  const std::vector<double> speeds{edge.velocity_a.y(), edge.velocity_a.z(), edge.velocity_b.y(),
                                   edge.velocity_b.z()};
  const int length_bit = last_bit(lengths);
  const int speed_bit = last_bit(speeds);
  const int dt_bit = last_bit({c.dt});
  const int bit = std::min(length_bit, speed_bit + dt_bit);
  const Whole dt = whole(c.dt, dt_bit);
  const auto length = [&](double x) { return whole(x, bit); };
  const auto path = [&](double x, double v) {
    const Whole way = whole(v, speed_bit) * dt;
    return trimmed({length(x), way << static_cast<unsigned>(speed_bit + dt_bit - bit)});
  };
  p_ = {path(lengths[0], speeds[0]), path(lengths[1], speeds[1])};
  q_ = {path(lengths[2], speeds[2]), path(lengths[3], speeds[3])};
  q_with_velocity_of_p_ = {path(lengths[2], speeds[0]), path(lengths[3], speeds[1])};
  R_ = length(c.R);
  rho_ = R_ + length(edge.radius);
  const auto end_touch = [&](const Vec3& x, const Vec3& v) {
    return time_of({{x, v, edge.radius}, {c.R}, c.dt}).seconds;
  };
  end_touch_ = earlier(end_touch(edge.a, edge.velocity_a), end_touch(edge.b, edge.velocity_b));
}

inline std::optional<double> EdgeTruth::inside_touch(const InsideReading& reading,
                                                     const std::optional<double>& end) const {
  const Path& q = reading.one_velocity ? q_with_velocity_of_p_ : q_;
  const Path d = way(p_, q);
  const WholePolynomial C = cross(p_, q);
  const WholePolynomial p_d = dot(p_, d);
  const WholePolynomial q_d = dot(q, d);
  const Whole rho = reading.thin ? R_ : rho_;
  const WholePolynomial f = sum(product(C, C), product({rho * rho}, dot(d, d)), -1);
  const bool foot_at_start = sign_at(p_d, {0, 0}) < 0 && sign_at(q_d, {0, 0}) > 0;
  if (!reading.start_missed && foot_at_start && sign_at(f, {0, 0}) <= 0) return 0.0;

  const IsolatedRoots roots = isolated_roots(f);
  std::optional<double> last;
  for (Cell cell : roots.cells) {
    if (reading.line_for_edge && sign_at(f, cell.from()) <= 0) continue;
    if (!reading.line_for_edge && (sign_at_root(roots.polynomial, cell, p_d) >= 0 ||
                                   sign_at_root(roots.polynomial, cell, q_d) <= 0)) {
      continue;
    }
    const double time = middle_of(cell, roots.polynomial) * dt_;
    if (!reading.last) return time;
    if (!end || time < *end) last = time;
  }
  return last;
}

inline Time EdgeTruth::time(const InsideReading& reading) const {
  return {reading.ignored ? end_touch_ : earlier(end_touch_, inside_touch(reading, end_touch_))};
}

}  // namespace tests

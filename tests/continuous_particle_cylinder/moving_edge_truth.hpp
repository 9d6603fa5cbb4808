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
  bool ignored = false;         ///< only the ends touch
  bool start_alone = false;     ///< what touches later than at the start, only the ends
  bool line_for_edge = false;   ///< wherever the foot of the perpendicular is
  bool start_missed = false;    ///< only a root of the quartic counts
  bool thin = false;            ///< R where R + r belongs
  bool one_velocity = false;    ///< that of a for b, too
  bool last = false;            ///< the last root at which the foot is inside, not the first
  bool foot_outside = false;    ///< the foot has to be beyond an end
  bool foot_before_b = false;   ///< only the end b limits it
  bool foot_after_a = false;    ///< only the end a limits it
  bool start_anyhow = false;    ///< the line counts at the start, the edge later
  bool without_length = false;  ///< C² − ρ² for C² − ρ² |d|²
  bool thin_ends = false;       ///< R where R + r belongs, for the ends
  bool no_a = false;            ///< the end a is left out
  bool no_b = false;            ///< the end b is left out
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

  [[nodiscard]] std::optional<double> end_touch(const InsideReading& reading) const;

  /// Whether the foot is where a reading wants it, from the signs of p·d and q·d.
  static bool is_foot_on_edge(const InsideReading& reading, int p_d, int q_d) {
    if (reading.foot_outside) return p_d * q_d > 0;
    return (reading.foot_before_b || p_d < 0) && (reading.foot_after_a || q_d > 0);
  }

  MovingEdge edge_;
  double radius_;
  double dt_;
  Path p_, q_, q_with_velocity_of_p_;
  Whole R_, rho_, one_;
};

inline EdgeTruth::EdgeTruth(const EdgeCase& c) : edge_(c.edge), radius_(c.R), dt_(c.dt) {
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
  one_ = bit <= -52 ? whole(1.0, bit) : Whole(0);
}

inline std::optional<double> EdgeTruth::end_touch(const InsideReading& reading) const {
  const auto touch = [&](const Vec3& x, const Vec3& v) {
    const Query query{{x, v, edge_.radius}, {radius_}, dt_};
    if (!reading.thin_ends) return time_of(query).seconds;
    return rounded(first_time(quadratic(query, 0.0), dt_)).seconds;
  };
  const auto none = std::optional<double>();
  return earlier(reading.no_a ? none : touch(edge_.a, edge_.velocity_a),
                 reading.no_b ? none : touch(edge_.b, edge_.velocity_b));
}

inline std::optional<double> EdgeTruth::inside_touch(const InsideReading& reading,
                                                     const std::optional<double>& end) const {
  const Path& q = reading.one_velocity ? q_with_velocity_of_p_ : q_;
  const Path d = way(p_, q);
  const WholePolynomial C = cross(p_, q);
  const WholePolynomial p_d = dot(p_, d);
  const WholePolynomial q_d = dot(q, d);
  const Whole rho = reading.thin ? R_ : rho_;
  const WholePolynomial squared_length =
      reading.without_length ? WholePolynomial{one_ * one_} : dot(d, d);
  const WholePolynomial f = sum(product(C, C), product({rho * rho}, squared_length), -1);
  const bool foot_at_start =
      reading.start_anyhow || is_foot_on_edge(reading, sign_at(p_d, {0, 0}), sign_at(q_d, {0, 0}));
  if (!reading.start_missed && foot_at_start && sign_at(f, {0, 0}) <= 0) return 0.0;

  if (reading.start_alone) return std::nullopt;
  const IsolatedRoots roots = isolated_roots(f);
  std::optional<double> last;
  for (Cell cell : roots.cells) {
    if (reading.line_for_edge && sign_at(f, cell.from()) <= 0) continue;
    if (!reading.line_for_edge &&
        !is_foot_on_edge(reading, sign_at_root(roots.polynomial, cell, p_d),
                         sign_at_root(roots.polynomial, cell, q_d))) {
      continue;
    }
    const double time = middle_of(cell, roots.polynomial) * dt_;
    if (!reading.last) return time;
    if (!end || time < *end) last = time;
  }
  return last;
}

inline Time EdgeTruth::time(const InsideReading& reading) const {
  const std::optional<double> end = end_touch(reading);
  return {reading.ignored ? end : earlier(end, inside_touch(reading, end))};
}

}  // namespace tests

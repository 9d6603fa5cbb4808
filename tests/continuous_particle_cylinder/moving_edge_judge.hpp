#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "continuous_particle_cylinder.hpp"
#include "moving_edge_cases.hpp"
#include "moving_edge_truth.hpp"
#include "trial.hpp"

/// How the time of impact of a moving edge is judged, and what known mistakes make of it.
namespace tests {

inline Time edge_time(const EdgeCase& c) {
  return {lab::continuous_particle_cylinder::time_of_impact_of_edge(c.edge, {c.R}, c.dt)};
}

inline Trial edge_trial(const EdgeCase& c, int index = 1, int count = 1) {
  return Trial("4.6 time_of_impact_of_edge", index, count)
      .given("edge.a", c.edge.a)
      .given("edge.b", c.edge.b)
      .given("edge.velocity_a", c.edge.velocity_a)
      .given("edge.velocity_b", c.edge.velocity_b)
      .given("edge.radius", c.edge.radius)
      .given("cylinder.radius", c.R)
      .given("dt", c.dt);
}

inline std::vector<std::pair<InsideReading, std::string>> misreadings() {
  return {{{.ignored = true},
           "the ends alone are checked: check the inside of the edge, which touches first"},
          {{.line_for_edge = true},
           "the line is taken for the edge: the foot of the perpendicular must be inside the edge"},
          {{.start_missed = true}, "a start at which the inside touches is missed: return 0"},
          {{.thin = true}, "the edge's radius is forgotten in the quartic: use R + r, not R"},
          {{.one_velocity = true},
           "both ends move with the velocity of a: use the velocity of b for b"},
          {{.last = true}, "a later root is returned: return the first"}};
}

inline std::vector<Suspect<Time>> suspects_of_edge(const EdgeTruth& truth) {
  std::vector<Suspect<Time>> suspects;
  for (const auto& [reading, story] : misreadings())
    suspects.push_back({truth.time(reading), story});
  return suspects;
}

/// Whether the answer is right about the same edge on a cylinder that is a little thicker, with a
/// little more time: there a touch is no matter of the last bits.
inline bool is_right_beside(EdgeCase c) {
  c.R *= 1.001;
  c.dt *= 1.001;
  return difference(edge_time(c), EdgeTruth(c).time()) <= 1e-9 * c.dt;
}

inline std::vector<Suspect<Time>> suspects_of_edge(const EdgeTruth& truth, const EdgeCase& c) {
  if (!is_right_beside(c)) return suspects_of_edge(truth);
  return {{truth.time({.ignored = true}),
           "a touch is not counted: an edge that just reaches rho has an impact, too"}};
}

/// Requires hit or miss as in exact arithmetic, and the time to 1e-14 of dt.
inline void expect_edge(const Trial& trial, const Time& got, const EdgeCase& c) {
  const EdgeTruth truth(c);
  const Time wanted = truth.time();
  const double bound = 1e-14 * c.dt;
  trial.expect(got, wanted, {bound, "1e-14 of dt, as the contract says"},
               [&] { return suspects_of_edge(truth, c); });
}

/// On so many edges of a set.
template <typename Draw>
void expect_edges(const Draw& draw, int count) {
  for (int i = 1; i <= count; ++i) {
    const EdgeCase c = draw();
    const Trial trial = edge_trial(c, i, count);
    expect_edge(trial, trial.returned([&] { return edge_time(c); }), c);
  }
}

}  // namespace tests

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
  const std::string ends_alone =
      "the ends alone are checked: check the inside of the edge, which touches first";
  const std::string line =
      "the line is taken for the edge: the foot of the perpendicular must be inside the edge";
  return {
      {{.ignored = true}, ends_alone},
      {{.start_alone = true}, ends_alone},
      {{.line_for_edge = true}, line},
      {{.line_for_edge = true, .start_anyhow = true}, line},
      {{.start_missed = true}, "a start at which the inside touches is missed: return 0"},
      {{.thin = true}, "the edge's radius is forgotten in the quartic: use R + r, not R"},
      {{.one_velocity = true},
       "both ends move with the velocity of a: use the velocity of b for b"},
      {{.last = true}, "a later root is returned: return the first"},
      {{.foot_outside = true},
       "the foot is on the wrong side of an end: p.(q - p) <= 0 and q.(q - p) >= 0 on the edge"},
      {{.foot_before_b = true},
       "the foot is checked against one end only: p.(q - p) <= 0 is missing"},
      {{.foot_after_a = true},
       "the foot is checked against one end only: q.(q - p) >= 0 is missing"},
      {{.start_anyhow = true},
       "the line is taken for the edge at the start: check its foot there, too"},
      {{.without_length = true}, "the quartic lacks |q - p|^2: it is (p x q)^2 - rho^2 |q - p|^2"},
      {{.thin_ends = true}, "the edge's radius is forgotten for its ends: use R + r, not R"},
      {{.no_a = true}, "one end is left out: a can touch first, too"},
      {{.no_b = true}, "one end is left out: b can touch first, too"},
      {{.no_a = true, .no_b = true},
       "the ends are left out: t* is the earliest of theirs and the inside's"}};
}

inline std::vector<Suspect<Time>> suspects_of_edge(const EdgeTruth& truth, double dt) {
  std::vector<Suspect<Time>> suspects;
  for (const auto& [reading, story] : misreadings())
    suspects.push_back({truth.time(reading), story});
  const Time end = truth.time({.ignored = true});
  const Time time = truth.time();
  if (!time.seconds) return suspects;
  const std::string share = "the share s of the time is returned: multiply it by the time it is of";
  const bool is_inside = !end.seconds || *end.seconds > *time.seconds;
  const double until_end = end.seconds ? *end.seconds : dt;
  if (is_inside && *time.seconds > 0.0) {
    suspects.push_back({{*time.seconds / dt}, share});
    suspects.push_back({{*time.seconds / until_end}, share});
    suspects.push_back({{std::min(*time.seconds / dt, until_end)}, share});
  }
  return suspects;
}

/// Edges of every kind. Rounding decides on none of them.
inline std::vector<EdgeCase> plain_edges() {
  std::vector<EdgeCase> edges;
  Random random(480);
  for (int i = 0; i < 24; ++i) {
    edges.push_back(random_edge(random));
    edges.push_back(long_sweep(random));
    EdgeCase turning = long_sweep(random);
    turning.edge.velocity_b *= random.uniform(0.0, 1.0);
    edges.push_back(turning);
    for (int near = 0; near < 3; ++near) {  // many of these have a line that meets the disc
      EdgeCase c = random_edge(random);
      for (Vec3* x : {&c.edge.a, &c.edge.b}) *x = 0.6 * *x + 0.5 * random.vector(1.0);
      for (Vec3* v : {&c.edge.velocity_a, &c.edge.velocity_b}) *v *= 0.5;
      edges.push_back(c);
    }
  }
  return edges;
}

/// Whether each time that is found is a sample of one number of samples.
inline bool is_sampled(const std::vector<EdgeCase>& edges, const std::vector<Time>& times) {
  for (const int samples : {8, 10, 16, 20, 32, 50, 64, 100, 128, 200, 256, 500, 512, 1000, 1024}) {
    bool is_sample = true;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double number = times[i].seconds.value_or(0.0) / edges[i].dt * samples;
      is_sample = is_sample && std::abs(number - std::round(number)) <= 1e-9;
    }
    if (is_sample) return true;
  }
  return false;
}

/// Returns the stories that explain the answers to all plain edges, if one of these is wrong.
inline std::vector<std::string> stories_of_edges() {
  const std::vector<EdgeCase> edges = plain_edges();
  std::vector<Time> times;
  std::vector<std::string> stories;
  for (const auto& suspect : suspects_of_edge(EdgeTruth(edges[1]), edges[1].dt)) {
    if (std::find(stories.begin(), stories.end(), suspect.story) == stories.end()) {
      stories.push_back(suspect.story);
    }
  }
  bool is_wrong = false, is_close = true;
  for (const EdgeCase& c : edges) {
    const EdgeTruth truth(c);
    const Time wanted = truth.time();
    const Time got = times.emplace_back(edge_time(c));
    is_wrong = is_wrong || difference(got, wanted) > 1e-13 * c.dt;
    is_close = is_close && difference(got, wanted) <= 1e-5 * c.dt;
    const auto theirs = suspects_of_edge(truth, c.dt);
    std::erase_if(stories, [&](const std::string& story) {
      bool is_told = false;
      for (const Suspect<Time>& suspect : theirs) {
        if (suspect.story != story) continue;
        if (difference(got, suspect.value) <= 1e-9 * c.dt) return false;
        is_told = is_told || difference(suspect.value, wanted) > 1e-9 * c.dt;
      }
      return is_told || difference(got, wanted) > 1e-9 * c.dt;
    });
  }
  if (!is_wrong) return {};
  if (is_close) return {"t* has too few digits: refine it to 1e-14 of dt"};
  if (is_sampled(edges, times)) {
    return {"a sample is returned, and what lies between two samples is missed: find the root"};
  }
  return stories;
}

/// Returns, of what is believed of an edge, what explains the answers to the plain edges, too.
inline std::vector<Suspect<Time>> explaining_edge(const EdgeTruth& truth, const EdgeCase& c) {
  const Time got = edge_time(c);
  std::vector<Suspect<Time>> told;
  for (const std::string& story : stories_of_edges()) {
    bool is_told = false;
    bool fits = false;
    for (const Suspect<Time>& suspect : suspects_of_edge(truth, c.dt)) {
      if (suspect.story != story) continue;
      is_told = true;
      fits = fits || difference(got, suspect.value) <= 1e-9 * c.dt;
    }
    if (fits || !is_told) told.push_back({got, story});
  }
  return told;
}

/// Whether the answer is right about the same edge on a cylinder that is a little thicker, with a
/// little more time: there a touch is no matter of the last bits.
inline bool is_right_beside(EdgeCase c) {
  c.R *= 1.001;
  c.dt *= 1.001;
  return difference(edge_time(c), EdgeTruth(c).time()) <= 1e-9 * c.dt;
}

inline std::vector<Suspect<Time>> edge_suspects(const EdgeTruth& truth, const EdgeCase& c) {
  const bool is_near = difference(edge_time(c), truth.time()) <= 1e-5 * c.dt;
  if (is_near || !is_right_beside(c)) return explaining_edge(truth, c);
  return {{truth.time({.ignored = true}),
           "a touch is not counted: an edge that just reaches rho has an impact, too"}};
}

/// Requires hit or miss as in exact arithmetic, and the time to 1e-14 of dt.
inline void expect_edge(const Trial& trial, const Time& got, const EdgeCase& c) {
  const EdgeTruth truth(c);
  const Time wanted = truth.time();
  const double bound = 1e-14 * c.dt;
  trial.expect(got, wanted, {bound, "1e-14 of dt, as the contract says"},
               [&] { return edge_suspects(truth, c); });
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

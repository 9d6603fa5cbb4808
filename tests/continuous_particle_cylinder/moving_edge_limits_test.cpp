#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "moving_edge_judge.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::edge_time;
using tests::edge_trial;
using tests::EdgeCase;
using tests::Time;

namespace {

/// Of t_i = i dt / count, i = 0 … count, the first at which the edge touches.
Time first_sample(const EdgeCase& c, int count) {
  for (int i = 0; i <= count; ++i) {
    const double t = i * c.dt / count;
    if (tests::distance(c.edge, t) <= rho(c)) return {t};
  }
  return {};
}

std::vector<std::pair<std::string, EdgeCase>> bad_edges() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const EdgeCase good{
      {{0.0, -3.0, 9.0}, {0.0, 3.0, 9.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 0.5}, 1.5, 1.0};
  std::vector<std::pair<std::string, EdgeCase>> bad;
  const auto add = [&](const std::string& why, const auto& change) {
    bad.emplace_back(why, good);
    change(bad.back().second);
  };
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      add("a is not finite", [&](EdgeCase& c) { c.edge.a[i] = value; });
      add("b is not finite", [&](EdgeCase& c) { c.edge.b[i] = value; });
      add("a's velocity is not finite", [&](EdgeCase& c) { c.edge.velocity_a[i] = value; });
      add("b's velocity is not finite", [&](EdgeCase& c) { c.edge.velocity_b[i] = value; });
    }
    add("the edge's radius is not finite", [&](EdgeCase& c) { c.edge.radius = value; });
    add("the cylinder's radius is not finite", [&](EdgeCase& c) { c.R = value; });
    add("dt is not finite", [&](EdgeCase& c) { c.dt = value; });
  }
  for (const double value : {0.0, -1.0, -1e-300}) {
    add("the edge's radius is not above zero", [&](EdgeCase& c) { c.edge.radius = value; });
    add("the cylinder's radius is not above zero", [&](EdgeCase& c) { c.R = value; });
  }
  add("dt is below zero", [](EdgeCase& c) { c.dt = -1e-300; });
  return bad;
}

}  // namespace

TEST_CASE("If both ends pass by the ends alone find no impact", "[4.6]") {
  tests::Random random(471);
  for (int i = 1; i <= 100; ++i) {
    const EdgeCase c = tests::long_sweep(random);
    const tests::EdgeTruth truth(c);
    const tests::Trial trial = edge_trial(c, i, 100);
    const Time got = trial.returned([&] { return edge_time(c); });
    tests::expect_edge(trial, got, c);
    REQUIRE(got.seconds);
    REQUIRE_FALSE(truth.time({.ignored = true}).seconds);
  }
}

TEST_CASE("Samples miss a passage that is shorter than their spacing", "[4.6]") {
  // An edge that crosses the disc square to itself touches from t* on for 2 ρ / |v|. The passage is
  // centred between two of 64 samples: they are outside it as long as it is shorter than dt / 64.
  constexpr int samples = 64;
  const double dt = 1.0;
  const double spacing = dt / samples;
  tests::Random random(472);
  for (const double part : {0.5, 0.9, 1.1, 2.0}) {
    for (int i = 1; i <= 10; ++i) {
      const double duration = part * spacing;
      const double middle = (tests::whole(random, 10, 50) + 0.5) * spacing;
      const double radius = 2.0;
      const Vec3 n = tests::direction_in_plane(random);
      const Vec3 along = random.uniform(2.5, 5.0) * tests::left_of(n);
      const Vec3 v = -(2.0 * radius / duration) * n;
      const EdgeCase c{{-middle * v - along, -middle * v + along, v, v, 0.5}, 1.5, dt};
      const tests::Trial trial = edge_trial(c, i, 10);
      const Time got = trial.returned([&] { return edge_time(c); });
      trial.expect(got, {middle - 0.5 * duration},
                   {2e-14, "1e-14 of dt, and the rounding of the input: a few ulp of the way"});
      const Time sampled = first_sample(c, samples);
      REQUIRE(sampled.seconds.has_value() == (part > 1.0));
      if (sampled.seconds) {
        trial.expect_small("delay of the first sample that touches",
                           *sampled.seconds - *got.seconds,
                           {spacing, "the touch begins before this sample"});
      }
    }
  }
}

// Whole numbers but for the share: an edge of half length 3 that passes along its own line, rests,
// or comes square to itself, for too short a time.
TEST_CASE("An edge that stays just outside has no impact", "[4.6]") {
  const std::string likely = "a near miss is taken for a hit: decide the signs exactly";
  for (const double share : {4.0 * tests::eps, 1e-12, 1e-9, 5e-8}) {
    const double z = 2.0 * (1.0 + share);
    const auto edge = [&](double height, const Vec3& v, double dt) {
      return EdgeCase{{{0.0, -3.0, height}, {1.0, 3.0, height}, v, v, 0.5}, 1.5, dt};
    };
    for (const EdgeCase& c :
         {edge(z, {0.0, 1.0, 0.0}, 2.0), edge(z, {9.0, 0.0, 0.0}, 2.0),
          edge(4.0, {0.0, 0.0, -1.0}, 2.0 * (1.0 - share)), edge(z, {0.0, 0.0, 1.0}, 2.0)}) {
      const tests::Trial trial = edge_trial(c);
      const Time got = trial.returned([&] { return edge_time(c); });
      EdgeCase beside = c;
      beside.R -= 0.02;
      trial.expect(
          got, Time{}, {0.0, "it stays outside by " + tests::text(share) + " of rho"}, [&] {
            const bool right_beside = !edge_time(beside).seconds;
            return right_beside ? tests::TimeSuspects{{got, likely}} : tests::TimeSuspects{};
          });
    }
  }
}

TEST_CASE("A moving edge with bad arguments is refused", "[4.6]") {
  const auto bad = bad_edges();
  int index = 0;
  for (const auto& [why, c] : bad) {
    edge_trial(c, ++index, static_cast<int>(bad.size()))
        .expect_throw([&, &c = c] { return edge_time(c); }, why,
                      "the arguments are not checked: throw std::invalid_argument for a bad one");
  }
}

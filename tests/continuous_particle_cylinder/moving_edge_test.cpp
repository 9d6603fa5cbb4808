#include "catch.hpp"
#include "moving_edge_judge.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::edge_time;
using tests::edge_trial;
using tests::EdgeCase;
using tests::expect_edge;
using tests::expect_edges;
using tests::Time;

namespace {

/// An edge along y, from −3 to 3, above a cylinder with ρ = 2.
EdgeCase level_edge(double height, const Vec3& velocity, double dt) {
  return {{{0.0, -3.0, height}, {0.0, 3.0, height}, velocity, velocity, 0.5}, 1.5, dt};
}

void expect_edge(const EdgeCase& c) {
  const tests::Trial trial = edge_trial(c);
  tests::expect_edge(trial, trial.returned([&] { return edge_time(c); }), c);
}

/// A time known by hand, which the judge knows, too.
void expect_by_hand(const EdgeCase& c, const Time& wanted) {
  const tests::Trial trial = edge_trial(c);
  const Time got = trial.returned([&] { return edge_time(c); });
  const tests::EdgeTruth truth(c);
  trial.expect(got, wanted, {1e-14 * c.dt, "worked by hand; 1e-14 of dt, as the contract says"},
               [&] { return edge_suspects(truth, c); });
  trial.of("the time that the tests compute exactly")
      .expect(truth.time(), wanted, {1e-15 * c.dt, "rounded only at the end"});
}

}  // namespace

TEST_CASE("A falling edge touches with its inside while its ends pass by", "[4.6]") {
  expect_by_hand(level_edge(5.0, {0.0, 0.0, -1.0}, 10.0), {3.0});
  expect_by_hand(level_edge(5.0, {7.0, 0.0, -1.0}, 10.0), {3.0});  // x plays no part
  expect_by_hand(level_edge(5.0, {0.0, 0.0, -1.0}, 2.75), {});
}

TEST_CASE("The line through the ends may touch where the edge is not", "[4.6]") {
  EdgeCase beside = level_edge(5.0, {0.0, 0.0, -1.0}, 10.0);
  beside.edge.a.y() = 2.5;  // the edge passes by, 2.5 from the axis
  expect_by_hand(beside, {});
  EdgeCase near = level_edge(5.0, {0.0, 0.0, -1.0}, 10.0);
  near.edge.a.y() = 1.2;  // a comes to (1.2, 1.6) after its line has touched
  expect_by_hand(near, {3.4});
}

TEST_CASE("An edge that turns about its middle touches as in exact arithmetic", "[4.6]") {
  tests::Random random(461);
  expect_edges(
      [&] {
        const double t = random.uniform(0.1, 0.9);
        const double lever = random.uniform(3.0, 6.0);
        const Vec3 arm = lever * tests::left_of(tests::direction_in_plane(random));
        const Vec3 centre = random.uniform(2.2, 2.9) * tests::direction_in_plane(random);
        const Vec3 speed = random.uniform(2.0, 20.0) * tests::direction_in_plane(random);
        return EdgeCase{{centre - arm, centre + arm, speed, -speed, 0.5}, 1.5, t};
      },
      100);
}

TEST_CASE("Random edges touch as in exact arithmetic", "[4.6]") {
  tests::Random random(462);
  expect_edges([&] { return tests::random_edge(random); }, 300);
}

TEST_CASE("Edges of a cloth touch as in exact arithmetic", "[4.6]") {
  tests::Random random(463);
  expect_edges([&] { return tests::cloth_edge(random); }, 300);
}

TEST_CASE("Edges on long ways touch as in exact arithmetic", "[4.6]") {
  tests::Random random(464);
  expect_edges([&] { return tests::long_sweep(random); }, 200);
}

TEST_CASE("An edge that grazes within rounding touches or not as in exact arithmetic", "[4.6]") {
  tests::Random random(465);
  expect_edges([&] { return tests::grazing_edge(random); }, 200);
}

TEST_CASE("A line that only touches in passing is an impact", "[4.6]") {
  // About (3, 4), which it touches at t = 1 and leaves: turned back from there, it is off.
  EdgeCase c{{{0.0, 7.0 - 4.0, 1.0 - 3.0}, {0.0, -1.0 - 4.0, 7.0 - 3.0}, {}, {}, 0.5}, 4.5, 2.0};
  const Vec3 n(0.0, 3.0, 4.0);
  const Vec3 along(0.0, -4.0, 3.0);
  c.edge.velocity_a = along - n;
  c.edge.velocity_b = along + n;
  c.edge.a = n - along - c.edge.velocity_a;
  c.edge.b = n + along - c.edge.velocity_b;
  expect_edge(c);
  tests::Random random(466);
  expect_edges([&] { return tests::exact_tangency(random); }, 200);
}

TEST_CASE("An arrival at dt is an impact and one just after it is not", "[4.6]") {
  expect_by_hand(level_edge(5.0, {0.0, 0.0, -1.0}, 3.0), {3.0});
  expect_by_hand(level_edge(5.0, {0.0, 0.0, -1.0}, std::nextafter(3.0, 0.0)), {});
}

TEST_CASE("An edge that touches or is inside at the start has an impact at 0", "[4.6]") {
  for (const double height : {0.0, 1.0, 2.0}) {
    for (const double speed : {-3.0, 0.0, 3.0}) {  // deeper, at rest, on its way out
      expect_by_hand(level_edge(height, {0.0, 0.0, speed}, 10.0), {0.0});
    }
  }
  expect_by_hand(level_edge(2.0, {0.0, 5.0, 0.0}, 10.0), {0.0});  // along itself
}

TEST_CASE("Without motion or time everything depends on the start", "[4.6]") {
  expect_by_hand(level_edge(2.0, {0.0, 0.0, -1.0}, 0.0), {0.0});
  expect_by_hand(level_edge(2.5, {0.0, 0.0, -1.0}, 0.0), {});
  expect_by_hand(level_edge(2.5, {0.0, 0.0, 0.0}, 10.0), {});
  expect_by_hand(level_edge(2.5, {4.0, 0.0, 0.0}, 10.0), {});
}

TEST_CASE("An edge that is a point in the yz-plane is like a particle", "[4.6]") {
  const Vec3 velocity(3.0, -2.0, 0.0);
  EdgeCase along_x{{{-1.0, 10.0, 3.0}, {4.0, 10.0, 3.0}, velocity, velocity, 1.0}, 4.0, 10.0};
  expect_by_hand(along_x, {3.0});
  along_x.edge.b = along_x.edge.a;
  expect_by_hand(along_x, {3.0});
  along_x.edge.velocity_b.x() = -8.0;
  expect_by_hand(along_x, {3.0});
}

TEST_CASE("An edge that swaps its ends or shrinks to a point does not touch because of that",
          "[4.6]") {
  // In the middle of the step it is the point (0, 0, 3), where its line is every line and no line.
  EdgeCase swapped{
      {{0.0, -4.0, 3.0}, {0.0, 4.0, 3.0}, {0.0, 8.0, 0.0}, {0.0, -8.0, 0.0}, 0.5}, 1.5, 1.0};
  expect_by_hand(swapped, {});
  EdgeCase upright{
      {{0.0, 0.0, 7.0}, {0.0, 0.0, 5.0}, {0.0, 0.0, -8.0}, {0.0, 0.0, -4.0}, 0.5}, 1.5, 0.5625};
  expect_by_hand(upright, {});  // the ends meet at z = 3; they would touch later
  tests::Random random(467);
  expect_edges([&] { return tests::lattice_edge(random); }, 400);
}

TEST_CASE("An edge is judged alike at any scale", "[4.6]") {
  tests::Random random(468);
  expect_edges([&] { return tests::scaled_edge(random); }, 60);
}

TEST_CASE("An end that is far away costs the inside no digits", "[4.6]") {
  tests::Random random(469);
  expect_edges([&] { return tests::far_edge(random); }, 100);
}

TEST_CASE("An edge with its ends swapped has the same impact", "[4.6]") {
  tests::Random random(470);
  for (int i = 1; i <= 100; ++i) {
    const EdgeCase c = tests::random_edge(random);
    EdgeCase turned = c;
    std::swap(turned.edge.a, turned.edge.b);
    std::swap(turned.edge.velocity_a, turned.edge.velocity_b);
    const tests::Trial trial = edge_trial(c, i, 100);
    trial.expect(trial.returned([&] { return edge_time(c); }),
                 trial.returned([&] { return edge_time(turned); }),
                 {2e-14 * c.dt, "twice 1e-14 of dt: the same edge with its ends swapped"});
  }
}

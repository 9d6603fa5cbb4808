// Step 7.2: outcomes that are pinned.
#include "sequential.hpp"

#include "catch.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::SequentialInput;

namespace {

struct Outcome {
  Scene scene;
  Vector wanted;  ///< the velocities afterwards
  int impulses;
  double restitution = 1.0;
};

/// The bound is rounding: each impulse is six operations on numbers up to 8 for each contact.
void expect_outcomes(const std::vector<Outcome>& all) {
  int index = 0;
  for (const auto& [scene, wanted, impulses, restitution] : all) {
    const SequentialInput in{scene.system(), restitution, 100};
    const tests::Trial trial = tests::sequential_trial(in, ++index, static_cast<int>(all.size()));
    tests::expect_outcome(trial, scene, tests::sequential_by_answer(trial, in), wanted, impulses,
                          {48.0 * eps * (impulses + 1), "six operations an impulse and contact"});
  }
}

}  // namespace

TEST_CASE("A row of balls hands its velocities on", "[7.2]") {
  expect_outcomes(
      {{tests::cradle(Vector{{1.0, 0.0}}), Vector{{0.0, 1.0}}, 1},
       {tests::cradle(Vector{{1.0, 0.0, 0.0}}), Vector{{0.0, 0.0, 1.0}}, 2},
       {tests::cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}), Vector{{0.0, 0.0, 0.0, 0.0, 1.0}}, 4},
       {tests::cradle(Vector{{1.0, 1.0, 0.0, 0.0, 0.0}}), Vector{{0.0, 0.0, 0.0, 1.0, 1.0}}, 6},
       {tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{-1.0, 0.0, 1.0}}, 3}});
  const Vector one_comes{{1.0, 0.0, 0.0}};
  expect_outcomes(
      {{tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, one_comes), Vector{{-3.0, 2.0, 8.0}} / 9.0, 2},
       {tests::row_of_balls(Vector{{2.0, 1.0, 2.0}}, one_comes), Vector{{-5.0, 16.0, 24.0}} / 27.0,
        3}});
}

TEST_CASE("A neighbour that parts is hit only by who is faster", "[7.2]") {
  expect_outcomes(
      {{tests::cradle(Vector{{1.0, 0.0, 0.5}}), Vector{{0.0, 0.5, 1.0}}, 2},
       {tests::cradle(Vector{{1.0, 0.0, 2.0}}), Vector{{0.0, 1.0, 2.0}}, 1},
       {tests::cradle(Vector{{1.0, 0.0, 0.5}}), Vector{{4.0, 9.0, 11.0}} / 16.0, 2, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, 2.0}}), Vector{{0.25, 0.75, 2.0}}, 1, 0.5}});
}

TEST_CASE("Columns and rods that fall on the ground jump", "[7.2]") {
  const Vector falling{{-1.0, -1.0}};
  expect_outcomes({{tests::column(Vector{{3.0, 1.0}}, falling), Vector{{0.0, 2.0}}, 2},
                   {tests::column(Vector{{2.0, 1.0}}, falling), Vector{{1.0, 5.0}} / 3.0, 3},
                   {tests::column(Vector{{1.0, 3.0}}, falling), Vector{{1.0, 1.0}}, 5}});
  expect_outcomes({{tests::rod(1.0 / 3.0, -1.0, 1.0), Vector{{1.0, 1.0}}, 2},
                   {tests::rod(1.0 / 3.0, -1.0, 0.0), Vector{{1.0, 0.0}}, 3},
                   {tests::dumb_bell(), Vector{{1.75, -0.25}}, 1},
                   {tests::dumb_bell().backwards(), Vector{{1.75, 0.25}}, 2}});
}

TEST_CASE("A wedge and a break are worked by hand", "[7.2]") {
  const Vector x{{1.0, 0.0}};
  const Vector y{{0.0, 1.0}};
  expect_outcomes(
      {{tests::wedge(x, y, Vector{{-1.0, -2.0}}), Vector{{1.0, 2.0}}, 2},
       {tests::wedge(y, Vector{{0.8, -0.6}}, Vector{{-1.0, -0.5}}), Vector{{38.0, 41.0}} / 50.0, 3},
       {tests::break_shot(), Vector{{-63.0, -84.0, 400.0, 300.0, 288.0, -216.0}} / 625.0, 2},
       {tests::break_shot(), Vector{{352.0, -189.0, 1200.0, 900.0, 948.0, -711.0}} / 2500.0, 2,
        0.5}});
}

TEST_CASE("With half the speed back impulses take longer", "[7.2]") {
  expect_outcomes(
      {{tests::cradle(Vector{{1.0, 0.0, 0.0}}), Vector{{13.0, 15.0, 36.0}} / 64.0, 3, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{-23.0, 3.0, 20.0}} / 64.0, 3, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}),
        Vector{{2521.0, 2739.0, 2916.0, 3024.0, 5184.0}} / 16384.0, 10, 0.5},
       {tests::cradle(Vector{{1.0, 1.0, 0.0, 0.0, 0.0}}),
        Vector{{1315.0, 1441.0, 1548.0, 1836.0, 2052.0}} / 4096.0, 10, 0.5}});
}

TEST_CASE("A table that falls flat starts to turn since its legs come in an order", "[7.2]") {
  const Vector flat{{-1.0, 0.0, 0.0}};
  const Scene table = tests::table(flat);
  expect_outcomes({{table, Vector{{117575.0, 7128.0, 1188.0}} / 117649.0, 6},
                   {table.backwards(), Vector{{117575.0, -7128.0, -1188.0}} / 117649.0, 6},
                   {tests::table(Vector{{-1.0, -0.5, -0.5}}),
                    Vector{{237130.0, -103333.0, 120035.0}} / 235298.0, 6},
                   {tests::table(Vector{{-1.0, -0.5, -0.5}}).backwards(),
                    Vector{{237158.0, -119881.0, 103319.0}} / 235298.0, 6}});
}

TEST_CASE("From the other end the outcome is another and not the mirror image", "[7.2]") {
  // Each scene is its own mirror image, so an order that did not matter would give (−v, 0, v).
  const Scene row = tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}});
  const Scene half = tests::cradle(Vector{{1.0, 0.0, -1.0}});
  const Scene shot = tests::break_shot();
  expect_outcomes(
      {{row, Vector{{-13.0, -10.0, 33.0}} / 27.0, 3},
       {row.backwards(), Vector{{-33.0, 10.0, 13.0}} / 27.0, 3},
       {half.backwards(), Vector{{-20.0, -3.0, 23.0}} / 64.0, 3, 0.5},
       {shot.backwards(), Vector{{-63.0, 84.0, 288.0, 216.0, 400.0, -300.0}} / 625.0, 2},
       {tests::wedge(Vector{{0.8, -0.6}}, Vector{{0.0, 1.0}}, Vector{{-1.0, -0.5}}),
        Vector{{278.0, 29.0}} / 250.0, 3}});
}

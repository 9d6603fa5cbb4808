// The zone of step 7.6 that is stopped and held.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "impulses.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::ContactSystem;
using tests::Impulses;
using tests::Scene;

namespace {

/// A scene, the impulses that stop it, and how often the zone grows.
struct Stopped {
  Scene scene;
  Vector lambda;
  int count;
};

void expect_stopped(const ContactSystem& system, const Vector& lambda, int rounds,
                    const tests::Bound& bound, int index = 1, int count = 1) {
  const tests::Trial trial = tests::projection_trial(system, index, count);
  tests::expect_impulses(trial, tests::projected_by_answer(system, trial), {lambda, rounds, true},
                         bound);
}

void expect_stopped(const std::vector<Stopped>& all) {
  int index = 0;
  for (const auto& [scene, lambda, rounds] : all) {
    // A row or a column of m contacts has a condition of some 4 (m + 1)²/pi², the others of 16.
    const auto m = static_cast<double>(lambda.size());
    expect_stopped(scene.system(), lambda, rounds,
                   tests::of_solutions(1, 1.0 + tests::length(lambda), 16.0 + 2.0 * m * m), ++index,
                   static_cast<int>(all.size()));
  }
}

}  // namespace

TEST_CASE("A row that is hit goes on together and the zone grows ball by ball", "[7.6]") {
  std::vector<Stopped> all;
  for (const int n : {2, 3, 4, 5, 6, 7, 30}) {
    Vector lambda(n - 1);  // those behind contact i have 1/n each
    for (int i = 0; i < n - 1; ++i) lambda[i] = (n - 1.0 - i) / n;
    all.push_back({tests::cradle(Vector::Unit(n, 0)), lambda, n - 1});
  }
  all.push_back(
      {tests::cradle(Vector{{1.0, 1.0, 0.0, 0.0, 0.0}}), Vector{{3.0, 6.0, 4.0, 2.0}} / 5.0, 3});
  all.push_back({tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{1.0, 1.0}}, 1});
  expect_stopped(all);
}

TEST_CASE("A column that falls on the ground stops and each contact bears what is above", "[7.6]") {
  std::vector<Stopped> all;
  for (int n = 1; n <= 6; ++n) {
    Vector lambda(n);
    for (int i = 0; i < n; ++i) lambda[i] = n - i;
    all.push_back({tests::column(Vector::Ones(n), -Vector::Ones(n)), lambda, n});
  }
  const Vector fall{{-1.0, -1.0}};
  all.push_back({tests::column(Vector{{3.0, 1.0}}, fall), Vector{{4.0, 1.0}}, 2});
  all.push_back({tests::column(Vector{{1.0, 3.0}}, fall), Vector{{4.0, 3.0}}, 2});
  expect_stopped(all);
}

TEST_CASE("Unequal balls and breaks and rods and wedges stop as they must", "[7.6]") {
  const double third = 1.0 / 3.0;
  const Vector one_comes{{1.0, 0.0, 0.0}};
  expect_stopped(
      {{tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, one_comes), Vector{{3.0, 1.0}} / 4.0, 2},
       {tests::row_of_balls(Vector{{2.0, 1.0, 2.0}}, one_comes), Vector{{6.0, 4.0}} / 5.0, 2},
       {tests::break_shot(), Vector{{20.0, 20.0}} / 57.0, 1},
       {tests::rod(third, -1.0, 1.0), Vector{{2.0, 1.0}} / 3.0, 2},
       {tests::rod(third, -1.0, 0.0), Vector{{0.5, 0.5}}, 1},
       {tests::wedge(Vector{{1.0, 0.0}}, Vector{{0.0, 1.0}}, Vector{{-1.0, -2.0}}),
        Vector{{1.0, 2.0}}, 1},
       {tests::wedge(Vector{{0.0, 1.0}}, Vector{{0.8, -0.6}}, Vector{{-1.0, -0.5}}),
        Vector{{1.25, 1.25}}, 1}});
}

TEST_CASE("What is held may pull", "[7.6]") {
  expect_stopped({{tests::dumb_bell(), Vector{{1.75, -0.5}}, 1}});
}

TEST_CASE("What parts is left alone and may part", "[7.6]") {
  // (1, 0, d): the two that meet go on at 1/2, and the third is out of their way from there on.
  int index = 0;
  for (const double d : {0.5, 0.75, 1.0, 2.0}) {
    expect_stopped(tests::cradle(Vector{{1.0, 0.0, d}}).system(), Vector{{0.5, 0.0}}, 1,
                   tests::of_solutions(1, 1.0), ++index, 6);
  }
  // One that rests joins only if it comes to approach: the other supports of rods do not.
  expect_stopped({Matrix{{4.0, 2.0}, {2.0, 4.0}} / 3.0, Vector{{-1.0, 0.0}}}, Vector{{0.75, 0.0}},
                 1, tests::of_solutions(1, 1.0), ++index, 6);
  expect_stopped({Matrix{{4.0, 2.0}, {2.0, 4.0}} / 3.0, Vector{{-1.0, 0.25}}}, Vector{{0.75, 0.0}},
                 1, tests::of_solutions(1, 1.0), ++index, 6);
}

TEST_CASE("Of all impulses that stop it takes the shortest", "[7.6]") {
  // On four legs, and with two contacts where one would do: A is singular.
  const ContactSystem doubled{Matrix{{2.0, 2.0, -1.0}, {2.0, 2.0, -1.0}, {-1.0, -1.0, 2.0}},
                              Vector{{-1.0, -1.0, 0.0}}};
  const ContactSystem three{Matrix::Ones(3, 3), -Vector::Ones(3)};
  const tests::Bound bound = tests::of_solutions(1, 1.0);
  expect_stopped(tests::table(Vector{{-1.0, 0.0, 0.0}}).system(), Vector::Constant(4, 0.25), 1,
                 bound, 1, 5);
  expect_stopped(doubled, Vector::Constant(3, 1.0 / 3.0), 2, bound, 2, 5);
  expect_stopped(three, Vector::Constant(3, 1.0 / 3.0), 1, bound, 3, 5);
  // Tilted, it comes down on three legs, which stop the fourth as well.
  expect_stopped(tests::table(Vector{{-1.0, -0.5, -0.5}}).system(),
                 Vector{{2.0, 5.0, 5.0, 0.0}} / 12.0, 1, bound, 4, 5);
  expect_stopped(tests::jammed_ball().system(), Vector{{1.0, 0.0}}, 1, bound, 5, 5);
}

TEST_CASE("A zone agrees with exact arithmetic and grows as often at most as there are contacts",
          "[7.6]") {
  tests::Random random(761);
  for (int i = 1; i <= 60; ++i) {
    const ContactSystem system = tests::random_impact(random, i);
    const tests::Trial trial = tests::projection_trial(system, i, 60);
    const Impulses done = tests::projected_by_answer(system, trial);
    const Impulses wanted = tests::exact_projection(system);
    trial.expect_small("how much oftener it grew than there are contacts",
                       done.count - static_cast<double>(system.u.size()), tests::counted);
    tests::expect_impulses(
        trial, done, wanted,
        tests::of_solutions(1, 1.0 + tests::length(wanted.lambda), tests::random_condition));
  }
}

TEST_CASE("Afterwards the zone rests and nothing approaches and energy is lost", "[7.6]") {
  tests::Random random(762);
  for (int i = 1; i <= 60; ++i) {
    const ContactSystem system = tests::random_impact(random, i);
    const tests::Trial trial = tests::projection_trial(system, i, 60);
    const Impulses done = tests::projected_by_answer(system, trial);
    const Vector after = tests::exact_row_sums(system.A, done.lambda, system.u);
    const tests::Bound bound =
        tests::of_solutions(1, 1.0 + tests::length(done.lambda), tests::random_condition);
    double moves = 0.0;
    for (int k = 0; k < after.size(); ++k) {
      if (done.lambda[k] != 0.0) moves = std::max(moves, std::abs(after[k]));
    }
    trial.expect_small("how fast contacts of the zone still move", moves, bound);
    trial.expect_small("how fast contacts still approach", -after.minCoeff(), bound);
    // Contact 0 is stopped from 1; A is 2 there at most, and no way to stop it takes less.
    trial.expect_small("0.25 - the energy lost", 0.25 + done.lambda.dot(system.u + after) / 2.0,
                       bound);
  }
}

TEST_CASE("The numbers of the contacts do not matter to a zone", "[7.6]") {
  tests::Random random(763);
  for (int i = 1; i <= 30; ++i) {
    const ContactSystem system = tests::random_impact(random, i);
    const std::vector<int> order = tests::random_order(random, system.u.size());
    const ContactSystem there = tests::renumbered(system, order);
    Impulses wanted = tests::projected_by_answer(system, tests::projection_trial(system, i, 30));
    wanted.lambda = common::entries(wanted.lambda, order);
    const tests::Trial trial = tests::projection_trial(there, i, 30);
    tests::expect_impulses(
        trial, tests::projected_by_answer(there, trial), wanted,
        tests::of_solutions(2, 1.0 + tests::length(wanted.lambda), tests::random_condition));
  }
}

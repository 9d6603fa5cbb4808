// The reflections of step 7.5 whose outcomes are known in fractions.
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "impulses.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::eps;
using tests::Reflecting;
using tests::Scene;

namespace {

/// A scene whose impulses are known, for e = 1.
struct Reflected {
  Scene scene;
  Vector lambda;
  int count;
};

void expect_reflected(const std::vector<Reflected>& all) {
  int index = 0;
  for (const auto& [scene, lambda, count] : all) {
    const Reflecting in{scene.system()};
    const tests::Trial trial = tests::reflections_trial(in, ++index, static_cast<int>(all.size()));
    tests::expect_impulses(trial, tests::reflected_by_answer(in, trial), {lambda, count, true},
                           tests::of_solutions(count, tests::length(lambda)));
  }
}

/// k balls at 1, and behind them n - k at rest.
Scene some_on_the_rest(int k, int n) {
  Vector v = Vector::Zero(n);
  v.head(k).setOnes();
  return tests::cradle(v);
}

}  // namespace

TEST_CASE("As many balls leave a cradle as came after n - 1 reflections", "[7.5]") {
  std::vector<Reflected> all;
  for (int n = 2; n <= 6; ++n) {
    for (int k = 1; k < n; ++k) {
      // What passes contact i is the momentum of what leaves beyond it.
      Vector lambda(n - 1);
      for (int i = 0; i < n - 1; ++i) lambda[i] = std::min({i + 1, k, n - k, n - 1 - i});
      all.push_back({some_on_the_rest(k, n), lambda, n - 1});
    }
  }
  all.push_back({some_on_the_rest(1, 30), Vector::Ones(29), 29});
  expect_reflected(all);
}

TEST_CASE("What comes from all sides is reflected at once", "[7.5]") {
  // n, n - 1, ..., 1 becomes 1, 2, ..., n: all contacts approach, and none is left after one solve.
  std::vector<Reflected> all;
  for (int n = 2; n <= 6; ++n) {
    Vector v(n);
    Vector lambda(n - 1);
    double passed = 0.0;
    for (int i = 0; i < n; ++i) {
      v[i] = n - i;
      passed += v[i] - (i + 1.0);
      if (i < n - 1) lambda[i] = passed;
    }
    all.push_back({tests::cradle(v), lambda, 1});
  }
  all.push_back({tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{2.0, 2.0}}, 1});
  expect_reflected(all);
}

TEST_CASE("A falling column of n equal balls takes 2 n - 1 reflections", "[7.5]") {
  std::vector<Reflected> all;
  for (const int n : {1, 2, 3, 4, 5, 6, 20}) {
    Vector lambda(n);  // all above a contact reverse their momentum
    for (int i = 0; i < n; ++i) lambda[i] = 2.0 * (n - i);
    all.push_back({tests::column(Vector::Ones(n), -Vector::Ones(n)), lambda, 2 * n - 1});
  }
  expect_reflected(all);
}

TEST_CASE("Balls of unequal masses leave as the reflections say", "[7.5]") {
  const Vector one_comes{{1.0, 0.0, 0.0}};
  const Vector fall{{-1.0, -1.0}};
  expect_reflected(
      {{tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, one_comes), Vector{{4.0, 8.0 / 3.0}} / 3.0, 2},
       {tests::row_of_balls(Vector{{2.0, 1.0, 2.0}}, one_comes), Vector{{64.0, 48.0}} / 27.0, 3},
       {tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}}), Vector{{2.0, 2.0}},
        1},
       {tests::column(Vector{{3.0, 1.0}}, fall), Vector{{6.0, 3.0}}, 2},
       {tests::column(Vector{{2.0, 1.0}}, fall), Vector{{16.0, 8.0}} / 3.0, 3},
       {tests::column(Vector{{1.0, 3.0}}, fall), Vector{{8.0, 6.0}}, 5}});
}

TEST_CASE("Bodies on two supports and points in wedges leave as the reflections say", "[7.5]") {
  const double third = 1.0 / 3.0;
  expect_reflected(
      {{tests::rod(third, -1.0, 1.0), Vector{{1.0, 1.0}}, 2},  // the other end jumps
       {tests::rod(third, -1.0, 0.0), Vector{{1.0, 1.0}}, 1},
       {tests::dumb_bell(), Vector{{3.0, 0.0}}, 1},
       {tests::wedge(Vector{{1.0, 0.0}}, Vector{{0.0, 1.0}}, Vector{{-1.0, -2.0}}),
        Vector{{2.0, 4.0}}, 1},
       {tests::wedge(Vector{{0.0, 1.0}}, Vector{{0.8, -0.6}}, Vector{{-1.0, -0.5}}),
        Vector{{2.5, 2.5}}, 1},
       {tests::table(Vector{{-1.0, -0.5, -0.5}}), Vector{{2.0, 5.0, 5.0, 0.0}} / 6.0, 1}});
}

TEST_CASE("A table that falls flat rises flat whatever its legs share", "[7.5]") {
  // A (1, -1, -1, 1) = 0, so lambda is not unique, but its sum and what it does to u are.
  const Reflecting in{tests::table(Vector{{-1.0, 0.0, 0.0}}).system()};
  const tests::Trial trial = tests::reflections_trial(in);
  const auto [lambda, count, ended] = tests::reflected_by_answer(in, trial);
  trial.of("u + A lambda")
      .expect(Vector(in.system.u + common::product(in.system.A, lambda)), Vector(Vector::Ones(4)),
              tests::of_solutions(1, 2.0));
  trial.of("the sum of lambda").expect(lambda.sum(), 2.0, tests::of_solutions(1, 2.0));
  trial.expect_small("the largest -lambda_i", -lambda.minCoeff(), {0.0, "a contact never pulls"});
  trial.of("count").expect(static_cast<double>(count), 1.0, {0.0, "all four come alike"});
}

TEST_CASE("Reflections count the digits of pi", "[7.5]") {
  // Galperin: wall, a mass of 1 at rest, one of M that comes: ceil(pi/atan sqrt(1/M)) - 1 in all.
  const std::vector<std::pair<double, int>> counts{
      {1.0, 3}, {3.0, 5}, {4.0, 6}, {9.0, 9}, {16.0, 12}, {100.0, 31}, {10000.0, 314}, {1e6, 3141}};
  int index = 0;
  for (const auto& [ratio, wanted] : counts) {
    for (const bool enough : {true, false}) {
      const Scene scene = tests::counting_pi(ratio);
      const Reflecting in{scene.system(), 1.0, enough ? wanted : wanted - 1};
      const tests::Trial trial =
          tests::reflections_trial(in, ++index, 2 * static_cast<int>(counts.size()));
      const auto [lambda, count, ended] = tests::reflected_by_answer(in, trial);
      // In (v, V sqrt(M)) a meeting and the wall together turn by twice the angle.
      const double root = std::sqrt(ratio);
      const double turned = 2.0 * ((in.most + 1) / 2) * std::atan(1.0 / root);
      trial.of("the speed of the heavy mass afterwards")
          .expect(
              scene.after(lambda)[1], -std::cos(turned),
              {16.0 * eps * wanted * root,
               "each reflection rounds a u of up to sqrt(M), the others only turn what is off"});
      trial.of("count").expect(static_cast<double>(count), static_cast<double>(in.most),
                               tests::counted);
      trial.of("whether it ended").expect(tests::Decision{ended}, {enough}, tests::counted);
    }
  }
}

TEST_CASE("A break of two is the mirror image of itself", "[7.5]") {
  expect_reflected({{tests::break_shot(), Vector{{40.0, 40.0}} / 57.0, 1}});
}

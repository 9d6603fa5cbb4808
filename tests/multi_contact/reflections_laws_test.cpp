// What the reflections of step 7.5 keep, and that they do not ask in which order contacts stand.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "impulses.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::ContactSystem;
using tests::Impulses;
using tests::Reflecting;
using tests::Scene;

namespace {

tests::Bound of_random(const Impulses& done) {
  return tests::of_solutions(done.count, 1.0 + done.lambda.cwiseAbs().maxCoeff(),
                             tests::random_condition);
}

/// A ball at 1 hits `rows` rows of equal balls head-on, which all touch their neighbours.
Scene rack(int rows) {
  std::vector<Eigen::Vector2d> places{{-1.0, 0.0}};
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k <= row; ++k) {
      places.emplace_back(0.5 * std::numbers::sqrt3 * row, k - 0.5 * row);
    }
  }
  const auto n = static_cast<Eigen::Index>(places.size());
  Scene scene{Matrix(0, 2 * n), Vector::Ones(2 * n), Vector::Unit(2 * n, 0)};
  for (Eigen::Index b = 0; b < n; ++b) {
    for (Eigen::Index a = 0; a < b; ++a) {
      const Eigen::Vector2d way =
          places[static_cast<std::size_t>(b)] - places[static_cast<std::size_t>(a)];
      if (way.norm() > 1.1) continue;
      scene.J.conservativeResize(scene.J.rows() + 1, Eigen::NoChange);
      scene.J.bottomRows(1).setZero();
      scene.J.bottomRows(1).middleCols(2 * a, 2) = -way.transpose();
      scene.J.bottomRows(1).middleCols(2 * b, 2) = way.transpose();
    }
  }
  return scene;
}

}  // namespace

TEST_CASE("Reflections keep the energy and only push and leave nothing that approaches", "[7.5]") {
  tests::Random random(751);
  for (int i = 1; i <= 60; ++i) {
    const ContactSystem system = tests::random_impact(random, i);
    const Reflecting in{system};
    const tests::Trial trial = tests::reflections_trial(in, i, 60);
    const Impulses done = tests::reflected_by_answer(in, trial);
    const Vector after = tests::exact_row_sums(system.A, done.lambda, system.u);
    const tests::Bound bound = of_random(done);
    trial.expect_small("the energy gained", std::abs(done.lambda.dot(system.u + after)) / 2.0,
                       {bound.value * (1.0 + done.lambda.sum()), "lambda times what u is off by"});
    trial.expect_small("the largest -lambda_i", -done.lambda.minCoeff(),
                       {0.0, "a contact never pulls"});
    trial.expect_small("how fast contacts still approach", -after.minCoeff(), bound);
    trial.expect_small("1 - the sum of lambda", 1.0 - done.lambda.sum(),
                       {1e-9, "contact 0 comes at 1 and no entry of A is above 2, so x is 1/2"});
  }
}

TEST_CASE("Reflections agree with exact arithmetic", "[7.5]") {
  tests::Random random(752);
  for (int i = 1; i <= 40; ++i) {
    const Reflecting in{tests::random_impact(random, i), i % 5 * 0.25};
    const Impulses wanted = tests::exact_reflections(in);
    const tests::Trial trial = tests::reflections_trial(in, i, 40);
    tests::expect_impulses(trial, tests::reflected_by_answer(in, trial), wanted, of_random(wanted));
  }
}

TEST_CASE("The numbers of the contacts do not matter to reflections", "[7.5]") {
  tests::Random random(753);
  for (int i = 1; i <= 30; ++i) {
    const Reflecting in{tests::random_impact(random, i), i % 3 * 0.25 + 0.5};
    const std::vector<int> order = tests::random_order(random, in.system.u.size());
    const Reflecting there{tests::renumbered(in.system, order), in.restitution};
    const tests::Trial trial = tests::reflections_trial(in, i, 30);
    Impulses wanted = tests::reflected_by_answer(in, trial);
    const tests::Trial other = tests::reflections_trial(there, i, 30);
    const Impulses got = tests::reflected_by_answer(there, other);
    wanted.lambda = common::entries(wanted.lambda, order);
    tests::expect_impulses(other.of("what other numbers gave"), got, wanted, of_random(wanted));
  }
}

TEST_CASE("A ball that parts already takes what the others bring it", "[7.5]") {
  // (1, 0, d) becomes (0, d, 1): the energy is kept. Faster than 1 it is left alone.
  int index = 0;
  for (const double d : {0.125, 0.25, 0.5, 0.875, 1.0, 1.5, 2.0}) {
    const Reflecting in{tests::cradle(Vector{{1.0, 0.0, d}}).system()};
    const tests::Trial trial = tests::reflections_trial(in, ++index, 7);
    const Vector lambda{{1.0, std::max(0.0, 1.0 - d)}};
    tests::expect_impulses(trial, tests::reflected_by_answer(in, trial),
                           {lambda, d < 1.0 ? 2 : 1, true}, tests::of_solutions(2, 1.0));
  }
}

TEST_CASE("A break of a rack is its own mirror image and keeps the energy", "[7.5]") {
  int index = 0;
  for (int rows = 2; rows <= 5; ++rows) {
    const Scene scene = rack(rows);
    const Reflecting in{scene.system()};
    const tests::Trial trial = tests::reflections_trial(in, ++index, 4);
    const Impulses done = tests::reflected_by_answer(in, trial);
    const Vector v = scene.after(done.lambda);
    const tests::Bound bound = tests::of_solutions(done.count, 2.0, 100.0);
    trial.of("the velocity of the ball that came").expect(v[0], -0.2, bound);
    double apart = 0.0;
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k <= row; ++k) {
        const int first = 2 + row * (row + 1);
        const Eigen::Vector2d one = v.segment<2>(first + 2 * k);
        const Eigen::Vector2d other = v.segment<2>(first + 2 * (row - k));
        apart = std::max({apart, std::abs(one.x() - other.x()), std::abs(one.y() + other.y())});
      }
    }
    trial.expect_small("how far mirror images are apart", apart, bound);
    trial.of("the energy").expect(scene.energy(v), 0.5, bound);
    trial.of("count").expect(static_cast<double>(done.count), rows + 1.0, tests::counted);
    if (rows < 5) continue;
    trial.of("the speed of a ball at the back's corner")
        .expect(v.tail<2>().norm(), 0.5909472366604497, bound);
  }
}

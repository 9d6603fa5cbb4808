// The accelerated solver, step 7.8.
#include <algorithm>
#include <cmath>
#include <limits>

#include "acceleration.hpp"
#include "catch.hpp"
#include "impulses.hpp"
#include "refused.hpp"
#include "sweeps.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::Accelerating;
using tests::ContactSystem;
using tests::eps;

namespace {

const tests::Bound few_steps{256.0 * eps, "some ten operations a step on numbers of up to 2"};

struct Stepped {
  Accelerating in;
  Vector wanted;
};

void expect_stepped(const std::vector<Stepped>& all) {
  int index = 0;
  for (const auto& [in, wanted] : all) {
    const tests::Trial trial = tests::acceleration_trial(in, ++index, static_cast<int>(all.size()));
    trial.expect(tests::accelerated_by_answer(in, trial), wanted, few_steps);
  }
}

ContactSystem system_of_column(int balls) {
  return tests::column(Vector::Ones(balls), -Vector::Ones(balls)).system();
}

}  // namespace

TEST_CASE("The first steps of the acceleration are worked by hand", "[7.8]") {
  const ContactSystem row = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  const ContactSystem held = tests::dumb_bell().system();
  const Matrix apart = Vector{{1.0, 4.0}}.asDiagonal();
  // From step 3 on there is momentum: (c - 1)/c' of the last change, (1, 1)/9.
  const double s = 0.5 * (1.0 + std::sqrt(5.0));
  const double kept = (s - 1.0) / (0.5 + std::sqrt(0.25 + s * s));
  const Vector y = Vector{{4.0 + kept, 1.0 + kept}} / 9.0;
  const Vector third{{y[0] - (2.0 * y[0] - y[1] - 1.0) / 3.0, y[1] - (2.0 * y[1] - y[0]) / 3.0}};
  expect_stepped({{{row.A, row.u, 1}, Vector{{1.0, 0.0}} / 3.0},
                  {{row.A, row.u, 2}, Vector{{4.0, 1.0}} / 9.0},
                  {{row.A, row.u, 3}, third},
                  {{held.A, held.u, 1}, Vector{{1.0, 0.25}}},
                  {{held.A, held.u, 2}, Vector{{1.25, 0.0}}},
                  {{apart, Vector{{-1.0, -4.0}}, 1}, Vector{{0.25, 1.0}}},
                  {{apart, Vector{{-1.0, -4.0}}, 2}, Vector{{0.4375, 1.0}}},
                  {{apart, Vector{{-1.0, 1.0}}, 1}, Vector{{0.25, 0.0}}}});
}

TEST_CASE("A contact alone is done in one step and what parts stays at zero", "[7.8]") {
  const Matrix A = Matrix::Constant(1, 1, 2.0);
  std::vector<Stepped> all;
  for (const int steps : {1, 2, 3, 9}) {
    all.push_back({{A, Vector{{-1.0}}, steps}, Vector{{0.5}}});
    all.push_back({{A, Vector{{1.0}}, steps}, Vector{{0.0}}});
    all.push_back({{A, Vector{{0.0}}, steps}, Vector{{0.0}}});
  }
  expect_stepped(all);
}

TEST_CASE("No steps give zero and no contacts give none", "[7.8]") {
  const ContactSystem row = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  expect_stepped({{{row.A, row.u, 0}, Vector::Zero(2)},
                  {{Matrix(0, 0), Vector(0), 0}, Vector(0)},
                  {{Matrix(0, 0), Vector(0), 7}, Vector(0)}});
}

TEST_CASE("A step that went uphill forgets its momentum", "[7.8]") {
  // The dumb-bell goes uphill in step 4, the cradle in step 6: what follows shows it.
  const ContactSystem held = tests::dumb_bell().system();
  const ContactSystem row = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  int index = 0;
  for (int steps = 3; steps <= 9; ++steps) {
    for (const ContactSystem& system : {held, row}) {
      const Accelerating in{system.A, system.u, steps};
      const tests::Trial trial = tests::acceleration_trial(in, ++index, 14);
      trial.expect(tests::accelerated_by_answer(in, trial), tests::exact_acceleration(in).lambda,
                   few_steps);
    }
  }
}

TEST_CASE("Steps on any system are as worked one by one", "[7.8]") {
  tests::Random random(781);
  for (int i = 1; i <= 60; ++i) {
    const ContactSystem system = tests::random_impact(random, i);
    const Accelerating in{system.A, system.u, 1 + i % 15};
    const auto [wanted, margin] = tests::exact_acceleration(in);
    if (margin < 1e-6) continue;  // as good as level: rounding may say uphill or not
    const tests::Trial trial = tests::acceleration_trial(in, i, 60);
    trial.expect(tests::accelerated_by_answer(in, trial), wanted,
                 {1e-12 * (1.0 + tests::length(wanted)),
                  "some ten operations a step, and momentum doubles what is off at most"});
  }
}

TEST_CASE("No step leaves an impulse below zero", "[7.8]") {
  tests::Random random(782);
  for (int i = 1; i <= 40; ++i) {
    ContactSystem system = tests::random_impact(random, i);
    system.u[1] = 0.5;  // parts
    const Accelerating in{system.A, system.u, i};
    const tests::Trial trial = tests::acceleration_trial(in, i, 40);
    const Vector lambda = tests::accelerated_by_answer(in, trial);
    trial.expect_small("the largest -lambda_i", -lambda.minCoeff(), tests::exact);
    trial.expect_small("0.1 - the largest lambda_i", 0.1 - lambda.maxCoeff(),
                       {0.0, "contact 0 comes at 1, and A's rows have sums of 3 at most"});
  }
}

TEST_CASE("On a column the acceleration is ten times nearer than sweeps and arrives", "[7.8]") {
  const auto [A, u] = system_of_column(10);
  Vector answer(10);
  for (int i = 0; i < 10; ++i) answer[i] = 10.0 - i;
  const auto error = [&](const Vector& lambda) { return (lambda - answer).cwiseAbs().maxCoeff(); };
  for (const int steps : {100, 200}) {
    const Accelerating in{A, u, steps};
    const tests::Trial trial = tests::acceleration_trial(in, steps / 100, 3);
    const double swept = error(tests::lambda_after({A, u, Vector::Zero(10), steps}));
    trial.expect_small("the largest error", error(tests::accelerated_by_answer(in, trial)),
                       {swept / 10.0, "a tenth of what as many sweeps of Gauss-Seidel leave"});
  }
  const Accelerating in{A, u, 400};
  const tests::Trial trial = tests::acceleration_trial(in, 3, 3);
  trial.expect(tests::accelerated_by_answer(in, trial), answer,
               {1e-11, "A has a condition of 175; so many steps leave rounding only"});
}

TEST_CASE("Where impulses are not unique the acceleration finds what they do", "[7.8]") {
  const ContactSystem table = tests::table(Vector{{-1.0, 0.0, 0.0}}).system();
  const ContactSystem tilted = tests::table(Vector{{-1.0, -0.5, -0.5}}).system();
  const ContactSystem doubled{Matrix{{2.0, 2.0, -1.0}, {2.0, 2.0, -1.0}, {-1.0, -1.0, 2.0}},
                              Vector{{-1.0, -1.0, 0.0}}};
  const ContactSystem jammed = tests::jammed_ball().system();
  int index = 0;
  for (const ContactSystem& system : {table, tilted, doubled, jammed}) {
    const Accelerating in{system.A, system.u, 150};
    const tests::Trial trial = tests::acceleration_trial(in, ++index, 4);
    const Vector lambda = tests::accelerated_by_answer(in, trial);
    trial.of("u + A lambda")
        .expect(Vector(system.u + common::product(system.A, lambda)),
                Vector(Vector::Zero(system.u.size())),
                {1e-12, "so many steps leave rounding only"});
    trial.expect_small("the largest -lambda_i", -lambda.minCoeff(), tests::exact);
  }
}

TEST_CASE("Many steps end at the solution", "[7.8]") {
  tests::Random random(783);
  for (int i = 1; i <= 15; ++i) {
    const ContactSystem system = tests::random_impact(random, 2 * i + 1);  // eigenvalues 1/2 to 3/2
    const Accelerating in{system.A, system.u, 120};
    const tests::Trial trial = tests::acceleration_trial(in, i, 15);
    trial.expect(tests::accelerated_by_answer(in, trial),
                 tests::exact_solution(system.A, system.u)->lambda,
                 {1e-12, "so many steps leave rounding only"});
  }
}

TEST_CASE("The least and the most masses and speeds are accelerated alike", "[7.8]") {
  int index = 0;
  const ContactSystem row = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  for (const auto& [yields, speed] : tests::extreme_scales) {
    const double size = speed / yields;
    const Accelerating in{yields * row.A, speed * row.u, 2};
    const tests::Trial trial = tests::acceleration_trial(in, ++index, 6);
    trial.expect(tests::accelerated_by_answer(in, trial), Vector(Vector{{4.0, 1.0}} * (size / 9.0)),
                 {64.0 * eps * size, "two steps of ten operations"});
  }
}

TEST_CASE("A matrix that is symmetric but for rounding is accelerated", "[7.8]") {
  const ContactSystem row = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  Accelerating in{row.A, row.u, 2};
  in.A(1, 0) += 1e-10;
  const tests::Trial trial = tests::acceleration_trial(in);
  trial.expect(tests::accelerated_by_answer(in, trial), Vector(Vector{{4.0, 1.0}} / 9.0),
               {1e-9, "an entry of A is off by 1e-10"});
}

TEST_CASE("The acceleration of bad input is refused", "[7.8]") {
  const std::string f = "7.8 accelerated";
  for (const int steps : {3, 0}) {
    tests::refuse_systems(f, [&](const ContactSystem& bad) {
      return lab::multi_contact::accelerated(bad.A, bad.u, steps);
    });
  }
  const ContactSystem row = tests::good_system();
  for (const int bad : {-1, std::numeric_limits<int>::min()}) {
    tests::trial_of(f)
        .given("steps", bad)
        .expect_throw([&] { return lab::multi_contact::accelerated(row.A, row.u, bad); },
                      "steps are not below zero");
  }
}

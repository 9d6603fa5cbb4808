// Step 7.3: sweeps.
#include "catch.hpp"
#include "refused.hpp"
#include "sweeps.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::SweepsInput;

namespace {

void expect_lambda(const SweepsInput& in, const Vector& wanted, const tests::Bound& bound,
                   int index = 1, int count = 1) {
  const tests::Trial trial = tests::sweeps_trial(in, index, count);
  trial.expect(tests::sweeps_by_answer(trial, in), wanted, bound);
}

const Matrix& cradle_A() {
  static const Matrix A{{2.0, -1.0}, {-1.0, 2.0}};
  return A;
}
const Matrix& dumb_bell_A() {
  static const Matrix A = Matrix{{4.0, 2.0}, {2.0, 4.0}} / 3.0;
  return A;
}

/// The f that is least at the solution: ½ λ·A λ + b·λ.
double slope_of(const Matrix& A, const Vector& b, const Vector& lambda) {
  return lambda.dot(0.5 * common::product(A, lambda) + b);
}

}  // namespace

TEST_CASE("The first sweeps on a cradle are worked by hand", "[7.3]") {
  const Vector zero = Vector::Zero(2);
  const Vector b{{-1.0, 0.0}};
  expect_lambda({cradle_A(), b, zero, 1}, Vector{{2.0, 1.0}} / 4.0, tests::exact, 1, 6);
  expect_lambda({cradle_A(), b, zero, 2}, Vector{{10.0, 5.0}} / 16.0, tests::exact, 2, 6);
  expect_lambda({cradle_A(), b, zero, 3}, Vector{{42.0, 21.0}} / 64.0, tests::exact, 3, 6);
  expect_lambda({cradle_A(), 2.0 * b, zero, 1}, Vector{{2.0, 1.0}} / 2.0, tests::exact, 4, 6);
  expect_lambda({cradle_A(), 2.0 * b, zero, 2}, Vector{{10.0, 5.0}} / 8.0, tests::exact, 5, 6);
  expect_lambda({cradle_A(), 2.0 * b, zero, 3}, Vector{{42.0, 21.0}} / 32.0, tests::exact, 6, 6);
}

TEST_CASE("A contact gives back what it got too much", "[7.3]") {
  const Vector b{{-2.0, -0.5}};
  const Vector ones{{1.0, 1.0}};
  const tests::Bound rounding{16.0 * eps, "thirds, and four operations a contact"};
  // Contact 1 gives all back, then contact 0 takes over.
  expect_lambda({dumb_bell_A(), b, ones, 1}, Vector{{1.0, 0.0}}, rounding, 1, 4);
  expect_lambda({dumb_bell_A(), b, ones, 2}, Vector{{1.5, 0.0}}, rounding, 2, 4);
  // From zero, with the slower one first: it gets 3/8, and has to return it.
  const Vector slow_first{{-0.5, -2.0}};
  expect_lambda({dumb_bell_A(), slow_first, Vector::Zero(2), 1}, Vector{{6.0, 21.0}} / 16.0,
                rounding, 3, 4);
  expect_lambda({dumb_bell_A(), slow_first, Vector::Zero(2), 2}, Vector{{0.0, 1.5}}, rounding, 4,
                4);
}

TEST_CASE("A start below zero counts as it is until its turn", "[7.3]") {
  int index = 0;
  for (const Vector& start : {Vector{{1.0, 2.0}}, Vector{{-3.0, 0.5}}, Vector{{-1e-300, -0.0}}}) {
    expect_lambda({cradle_A(), Vector{{-1.0, 0.0}}, start, 0}, start,
                  {0.0, "nothing has been done"}, ++index, 3);
  }
  // Row 0: 2 λ₀ = 1 + λ₁ = −3 is clamped. Row 1: 2 λ₁ = 0 + λ₀.
  expect_lambda({cradle_A(), Vector{{-1.0, 0.0}}, Vector{{7.0, -4.0}}, 1}, Vector::Zero(2),
                tests::exact, 1, 3);
  expect_lambda({cradle_A(), Vector{{-1.0, -1.0}}, Vector{{7.0, -4.0}}, 1}, Vector{{0.0, 0.5}},
                tests::exact, 2, 3);
  expect_lambda({cradle_A(), Vector{{-1.0, 0.0}}, Vector{{-8.0, -0.5}}, 1}, Vector{{0.25, 0.125}},
                tests::exact, 3, 3);
}

TEST_CASE("A sweep at the answer stays there", "[7.3]") {
  const tests::Bound rounding{8.0 * eps, "a row and a quotient at each contact"};
  expect_lambda({cradle_A(), Vector{{-1.0, 0.0}}, Vector{{2.0, 1.0}} / 3.0, 1},
                Vector{{2.0, 1.0}} / 3.0, rounding, 1, 4);
  expect_lambda({dumb_bell_A(), Vector{{-2.0, -0.5}}, Vector{{1.5, 0.0}}, 5}, Vector{{1.5, 0.0}},
                rounding, 2, 4);
  // On a table any of these; three legs do, too.
  const Matrix A = tests::table(Vector{{-1.0, 0.0, 0.0}}).system().A;
  const Vector flat = -Vector::Ones(4);
  expect_lambda({A, flat, Vector{{0.5, 0.0, 0.0, 0.5}}, 5}, Vector{{0.5, 0.0, 0.0, 0.5}}, rounding,
                3, 4);
  expect_lambda({A, flat, Vector::Constant(4, 0.25), 5}, Vector::Constant(4, 0.25), rounding, 4, 4);
}

TEST_CASE("Sweeps on any system are as worked contact by contact", "[7.3]") {
  tests::Random random(741);
  for (int i = 1; i <= 40; ++i) {
    const ContactSystem system = tests::random_system(random, 1 + i % 8);
    const Vector start = tests::random_vector(random, system.u.size(), 1.0);
    const SweepsInput in{system.A, system.u, start, 1 + i % 4};
    const double size = 1.0 + system.u.norm() + system.A.norm() * (1.0 + start.norm());
    expect_lambda(
        in, tests::lambda_after(in),
        {64.0 * eps * size * in.sweeps, "a row and a quotient at each contact, A_ii > 1/4"}, i, 40);
  }
}

TEST_CASE("The order of the contacts is the order of the sweep", "[7.3]") {
  // With the ground first its impulse is at the top after one sweep; with it last it stays below.
  const Matrix up{{1.0, -1.0, 0.0}, {-1.0, 2.0, -1.0}, {0.0, -1.0, 2.0}};
  const Matrix down = up.reverse();
  const Vector fall_up{{-1.0, 0.0, 0.0}};
  const Vector fall_down{{0.0, 0.0, -1.0}};
  expect_lambda({up, fall_up, Vector::Zero(3), 1}, Vector{{1.0, 0.5, 0.25}}, tests::exact, 1, 2);
  expect_lambda({down, fall_down, Vector::Zero(3), 1}, Vector{{0.0, 0.0, 1.0}}, tests::exact, 2, 2);
}

TEST_CASE("In a column or a row the error shrinks as heights and masses say", "[7.3]") {
  struct Rate {
    Matrix A;
    double a_sweep;
    int late;
  };
  const auto cosine = [](double angle) { return std::pow(std::cos(angle), 2); };
  const double pi = 3.14159265358979324;
  const Vector ten = Vector::Ones(10);
  const Vector three = Vector::Ones(3);
  const std::vector<Rate> rates{
      {tests::column(ten, ten).system().A, cosine(pi / 20.0), 200},
      {tests::column(three, three).system().A, cosine(pi / 6.0), 30},
      {tests::cradle(Vector::Ones(6)).system().A, cosine(pi / 6.0), 40},
      {tests::column(Vector{{1.0, 100.0}}, Vector::Ones(2)).system().A, 100.0 / 101.0, 5},
      {tests::column(Vector{{1.0, 3.0}}, Vector::Ones(2)).system().A, 0.75, 5},
      {tests::column(Vector{{4.0, 1.0}}, Vector::Ones(2)).system().A, 0.2, 5}};
  int index = 0;
  for (const auto& [A, a_sweep, late] : rates) {
    // From far above the answer nothing is clamped: b = −A λ for λ of ones.
    const Vector ones = Vector::Ones(A.rows());
    const Vector b = -common::product(A, ones);
    SweepsInput in{A, b, 1e6 * ones + ones, late};
    const tests::Trial trial = tests::sweeps_trial(in, ++index, 6);
    const Vector before = tests::sweeps_by_answer(trial, in);
    in.sweeps = late + 1;
    const Vector after = tests::sweeps_by_answer(trial, in);
    trial.of("by what one more sweep multiplies the error of lambda")
        .expect((after - ones).norm() / (before - ones).norm(), a_sweep,
                {1e-4, "other errors than the slowest have died down by then"});
  }
}

TEST_CASE("Many sweeps end at the solution", "[7.3]") {
  tests::Random random(742);
  for (int i = 1; i <= 16; ++i) {
    const Eigen::Index m = i % 8 == 0 ? 10 : 1 + i % 8;
    const auto [A, u] = tests::random_system(random, m);
    const SweepsInput in{A, u, tests::random_vector(random, m, 1.0), 400};
    expect_lambda(in, tests::exact_solution(A, u).value().lambda,
                  {1e-9, "400 sweeps, each shrinks the error by a tenth and more"}, i, 16);
  }
}

TEST_CASE("A sweep never raises the energy that it brings to its least", "[7.3]") {
  tests::Random random(743);
  for (int i = 1; i <= 20; ++i) {
    const auto [A, u] = tests::random_system(random, 1 + i % 6);
    SweepsInput in{A, u, Vector::Constant(u.size(), 3.0), 0};
    double before = slope_of(A, u, in.start);
    for (int sweep = 1; sweep <= 5; ++sweep) {
      in.sweeps = sweep;
      const tests::Trial trial = tests::sweeps_trial(in, i, 20);
      const Vector got = tests::sweeps_by_answer(trial, in);
      const double now = slope_of(A, u, got);
      trial.of("lambda").expect(got, tests::lambda_after(in),
                                {1e-12, "some 30 operations on numbers up to 100"});
      trial.expect_small("by how much a sweep raises lambda.(A lambda/2 + b)",
                         std::max(now - before, 0.0), {1e-12, "rounding of numbers up to 100"});
      before = now;
    }
  }
}

TEST_CASE("On a table sweeps agree on velocities though not on impulses", "[7.3]") {
  const ContactSystem table = tests::table(Vector{{-1.0, 0.125, -0.25}}).system();
  const Vector wanted = tests::exact_solution(table.A, table.u).value().u;
  int index = 0;
  for (const Vector& start :
       {Vector{{0.0, 0.0, 0.0, 0.0}}, Vector{{3.0, 0.0, 0.0, 1.0}}, Vector{{0.0, 2.0, 0.5, 0.0}}}) {
    const SweepsInput in{table.A, table.u, start, 100};
    const tests::Trial trial = tests::sweeps_trial(in, ++index, 3);
    const Vector got = tests::sweeps_by_answer(trial, in);
    trial.of("A lambda + b")
        .expect(tests::exact_row_sums(table.A, got, table.u), wanted,
                {1e-12, "each sweep shrinks the error to 5/49; then rounding"});
    trial.expect_small("how far some lambda pulls", std::max(-got.minCoeff(), 0.0),
                       {0.0, "it is clamped"});
  }
}

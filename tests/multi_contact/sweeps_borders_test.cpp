// Step 7.3: sizes, borders and what is refused; the residual.
#include "catch.hpp"
#include "refused.hpp"
#include "sweeps.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::SweepsInput;
using tests::Trial;

namespace {

Trial residual_trial(const Matrix& A, const Vector& b, const Vector& lambda, int index = 1,
                     int count = 1) {
  return tests::system_trial("7.3 residual", A, b, index, count).given("lambda", lambda);
}

void expect_residual(const Matrix& A, const Vector& b, const Vector& lambda, double wanted,
                     const tests::Bound& bound, int index = 1, int count = 1) {
  const Trial trial = residual_trial(A, b, lambda, index, count);
  trial.expect(trial.returned([&] { return residual(A, b, lambda); }), wanted, bound);
}

const Matrix two_balls_A{{2.0, -1.0}, {-1.0, 2.0}};
const Matrix apart{{2.0, 0.0}, {0.0, 4.0}};

}  // namespace

TEST_CASE("Sweeps have the size of speeds and masses and no speed is too small", "[7.3]") {
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    for (const auto& [of_A, of_b] : {std::pair(1.0, size), std::pair(size, 1.0)}) {
      const double of_lambda = of_b / of_A;
      const SweepsInput in{of_A * two_balls_A, Vector{{-of_b, 0.0}}, Vector::Zero(2), 2};
      const Trial trial = tests::sweeps_trial(in, ++index, 12);
      trial.expect(tests::sweeps_by_answer(trial, in), Vector(Vector{{0.625, 0.3125}} * of_lambda),
                   {16.0 * eps * of_lambda, "ten operations of this size"});
    }
  }
  int number = 0;
  for (const double small : {1e-9, 1e-13, 1e-17, 1e-90, -1e-9, -1e-13, -1e-17, -1e-90}) {
    const SweepsInput in{apart, Vector{{-1.0, -small}}, Vector::Zero(2), 1};
    const Trial trial = tests::sweeps_trial(in, ++number, 8);
    const Vector got = tests::sweeps_by_answer(trial, in);
    const double wanted = std::max(0.0, small / 4.0);
    trial.of("lambda of contact 0").expect(got[0], 0.5, tests::exact);
    trial.of("lambda of contact 1").expect(got[1], wanted, {2.0 * eps * wanted, "a quotient"});
  }
}

TEST_CASE("No contacts and a matrix that is symmetric but for rounding are swept", "[7.3]") {
  const SweepsInput empty{Matrix(0, 0), Vector(0), Vector(0), 3};
  const Trial trial = tests::sweeps_trial(empty);
  trial.expect(tests::sweeps_by_answer(trial, empty), Vector(Vector(0)), tests::exact);
  expect_residual(Matrix(0, 0), Vector(0), Vector(0), 0.0, tests::exact);
  const Matrix rounded{{2.0, -1.0}, {-1.0 + 1e-9, 2.0}};
  const SweepsInput in{rounded, Vector{{-1.0, 0.0}}, Vector::Zero(2), 1};
  const Trial other = tests::sweeps_trial(in);
  other.expect(tests::sweeps_by_answer(other, in), Vector(Vector{{0.5, 0.25}}),
               {1e-9, "A is symmetric to 1e-9"});
}

TEST_CASE("Sweeps of what cannot be are refused", "[7.3]") {
  const std::string f = "7.3 gauss_seidel";
  const auto [A, b] = tests::good_system();
  for (const int sweeps : {0, 1}) {  // also where there is nothing to do
    tests::refuse_systems(f, [&](const ContactSystem& bad) {
      return gauss_seidel(bad.A, bad.u, Vector::Zero(bad.u.size()), sweeps);
    });
    tests::refuse(f, tests::bad_vectors(), "start", [&, &good_A = A, &good_b = b](const Vector& v) {
      return gauss_seidel(good_A, good_b, v, sweeps);
    });
  }
  for (const int sweeps : {-1, -1000000000}) {
    tests::system_trial(f, A, b)
        .given("sweeps", static_cast<double>(sweeps))
        .expect_throw(
            [&, &good_A = A, &good_b = b] {
              return gauss_seidel(good_A, good_b, Vector::Zero(2), sweeps);
            },
            "a number of sweeps is not below zero");
  }
}

TEST_CASE("The residual of what cannot be is refused", "[7.3]") {
  tests::refuse_systems("7.3 residual", [](const ContactSystem& bad) {
    return residual(bad.A, bad.u, Vector::Zero(bad.u.size()));
  });
  const auto [A, b] = tests::good_system();
  tests::refuse("7.3 residual", tests::bad_vectors(), "lambda",
                [&good_A = A, &good_b = b](const Vector& lambda) {
                  return residual(good_A, good_b, lambda);
                });
}

TEST_CASE("The residual is the largest breach and worked by hand", "[7.3]") {
  const Vector b{{-1.0, 0.0}};
  // What the first three sweeps leave, on the way to (2/3, 1/3).
  expect_residual(two_balls_A, b, Vector{{2.0, 1.0}} / 4.0, 0.25, tests::exact, 1, 10);
  expect_residual(two_balls_A, b, Vector{{10.0, 5.0}} / 16.0, 0.0625, tests::exact, 2, 10);
  expect_residual(two_balls_A, b, Vector{{42.0, 21.0}} / 64.0, 1.0 / 64.0, tests::exact, 3, 10);
  // Nothing pushes what approaches; it is pulled; it is pushed though it parts, by λ or by u.
  expect_residual(two_balls_A, b, Vector{{0.0, 0.0}}, 1.0, tests::exact, 4, 10);
  expect_residual(apart, Vector{{4.0, 1.0}}, Vector{{-0.5, 0.0}}, 0.5, tests::exact, 5, 10);
  expect_residual(apart, Vector{{4.0, 1.0}}, Vector{{0.5, 0.0}}, 0.5, tests::exact, 6, 10);
  expect_residual(apart, Vector{{-8.0, 1.0}}, Vector{{5.0, 0.0}}, 2.0, tests::exact, 7, 10);
  // Both below zero: the lower one counts. Of two breaches the larger one.
  expect_residual(apart, Vector{{-1.0, 1.0}}, Vector{{-3.0, 0.0}}, 7.0, tests::exact, 8, 10);
  expect_residual(apart, Vector{{-1.0, -2.0}}, Vector{{0.0, 0.0}}, 2.0, tests::exact, 9, 10);
  expect_residual(apart, Vector{{-2.0, -1.0}}, Vector{{0.0, 0.0}}, 2.0, tests::exact, 10, 10);
}

TEST_CASE("The residual is zero for a solution and for no other", "[7.3]") {
  tests::Random random(744);
  for (int i = 1; i <= 24; ++i) {
    const Eigen::Index m = 1 + i % 6;
    const auto [A, b] = tests::random_system(random, m);
    const Vector solution = tests::exact_solution(A, b).value().lambda;
    const tests::Bound rounding{16.0 * eps * (b.norm() + A.norm() * (1.0 + solution.norm())),
                                "a row of A lambda + b"};
    expect_residual(A, b, solution, 0.0, rounding, i, 24);
    const Vector off = solution + 0.125 * Vector::Unit(m, i % m) * (i % 2 == 0 ? 1.0 : -1.0);
    REQUIRE(tests::residual_of(A, b, off) > 1e-3);
    expect_residual(A, b, off, tests::residual_of(A, b, off), rounding, i, 24);
    const Vector any = tests::random_vector(random, m, 2.0);
    expect_residual(A, b, any, tests::residual_of(A, b, any), rounding, i, 24);
  }
  const ContactSystem table = tests::table(Vector{{-1.0, 0.0, 0.0}}).system();
  // The last: u = (7, 1, 1, -5)/2 - 1 = (5/2, -1/2, -1/2, -7/2).
  const std::vector<std::pair<Vector, double>> all{{Vector{{0.25, 0.25, 0.25, 0.25}}, 0.0},
                                                   {Vector{{0.5, 0.0, 0.0, 0.5}}, 0.0},
                                                   {Vector{{0.0, 0.5, 0.5, 0.0}}, 0.0},
                                                   {Vector{{0.75, -0.25, -0.25, 0.75}}, 0.25},
                                                   {Vector{{0.5, 0.0, 0.0, 0.0}}, 3.5}};
  int index = 0;
  for (const auto& [lambda, wanted] : all) {
    expect_residual(table.A, table.u, lambda, wanted, tests::exact, ++index, 5);
  }
}

TEST_CASE("The residual has the size of impulses and speeds and none is too small", "[7.3]") {
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    const tests::Bound rounding{8.0 * eps * size, "a row of A lambda + b"};
    expect_residual(apart, Vector{{-size, size}}, Vector::Zero(2), size, rounding, ++index, 12);
    expect_residual(size * apart, Vector{{size, size}}, Vector{{-1.0, 0.0}}, std::max(1.0, size),
                    {8.0 * eps * std::max(1.0, size), "a row of A lambda + b"}, ++index, 12);
  }
}

// How far impulses are from Coulomb's law, step 7.7.
#include <cmath>

#include "catch.hpp"
#include "friction.hpp"
#include "refused.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::eps;
using tests::Judging;

namespace {

void expect_judged(const Judging& in, double wanted, const tests::Bound& bound, int index = 1,
                   int count = 1) {
  const tests::Trial trial = tests::judging_trial(in, index, count);
  trial.expect(tests::judged_by_answer(in, trial), wanted, bound);
}

const tests::Bound of_lengths{64.0 * eps, "sums, a length and a division of numbers of up to 6"};

Matrix uneven_A() { return tests::diagonal(1.0, 2.0, 4.0); }
Vector uneven_b() { return Vector{{-1.0, 3.6, 5.6}}; }

/// Contacts that know nothing of each other.
Judging side_by_side(const std::vector<Judging>& contacts) {
  const auto rows = static_cast<Eigen::Index>(3 * contacts.size());
  Judging all{Matrix::Zero(rows, rows), Vector(rows), Vector(rows), contacts[0].friction};
  Eigen::Index first = 0;
  for (const Judging& one : contacts) {
    all.A.block(first, first, 3, 3) = one.A;
    all.b.segment(first, 3) = one.b;
    all.lambda.segment(first, 3) = one.lambda;
    first += 3;
  }
  return all;
}

}  // namespace

TEST_CASE("The residual of friction is zero where bodies slide and stick and part", "[7.7]") {
  const Matrix rod = tests::leaning_rod();
  const auto leaning = [&](double n, double t, double lambda_n, double lambda_t, double friction) {
    return Judging{rod, Vector{{n, t, 0.0}}, Vector{{lambda_n, lambda_t, 0.0}}, friction};
  };
  const std::vector<Judging> solutions{
      {uneven_A(), uneven_b(), Vector{{1.0, -0.3, -0.4}}, 0.5},
      leaning(-1.0, 10.0, 2.5, -2.5, 1.0),
      leaning(-1.0, 10.0, 3.85, -4.3, 2.0),
      leaning(-1.0, -10.0, 5.0 / 14.0, 5.0 / 14.0, 1.0),
      leaning(-1.0, -10.0, 0.25, 0.5, 2.0),
      leaning(0.0, 10.0, 3.0, -4.0, 2.0),  // it jams, with no approach
      leaning(0.0, 10.0, 0.0, 0.0, 2.0),
      leaning(0.5, 7.0, 0.0, 0.0, 2.0),  // all three of these are the law
      leaning(0.5, 7.0, 0.625, -1.25, 2.0),
      leaning(0.5, 7.0, 1.675, -2.65, 2.0),
      {Matrix::Identity(3, 3), Vector{{-1.0, 3.0, 4.0}}, Vector{{1.0, 0.0, 0.0}}, 0.0},
      {Matrix::Identity(3, 3), Vector{{-1.0, 3.0, 4.0}}, Vector{{1.0, -3.0, -4.0}}, 5.0},
      {Matrix::Identity(3, 3), Vector{{0.5, 3.0, 4.0}}, Vector::Zero(3), 0.5}};
  int index = 0;
  for (const Judging& in : solutions) expect_judged(in, 0.0, of_lengths, ++index, 13);
}

TEST_CASE("The residual of friction by other rules is what the disc would change", "[7.7]") {
  // lambda - P(lambda - u): u = (2.6, 3.6) for the box, (3.6, 3.6) for the diamond.
  const double box =
      std::hypot(-0.5 + 0.5 * 3.1 / std::sqrt(26.42), -0.5 + 0.5 * 4.1 / std::sqrt(26.42));
  const double diamond =
      std::hypot(0.5 * 3.6 / std::sqrt(29.77), -0.5 + 0.5 * 4.1 / std::sqrt(29.77));
  expect_judged({uneven_A(), uneven_b(), Vector{{1.0, -0.5, -0.5}}, 0.5}, box, of_lengths, 1, 6);
  expect_judged({uneven_A(), uneven_b(), Vector{{1.0, 0.0, -0.5}}, 0.5}, diamond, of_lengths, 2, 6);
  // A sixth, once more from the text: 0.22 and 0.35.
  expect_judged({uneven_A(), uneven_b(), Vector{{1.0, -0.5, -0.5}}, 0.5}, 0.2227,
                {5e-5, "four digits"}, 3, 6);
  expect_judged({uneven_A(), uneven_b(), Vector{{1.0, 0.0, -0.5}}, 0.5}, 0.3525,
                {5e-5, "four digits"}, 4, 6);
  // The convex cone makes a block that slides lift: it is pressed while it opens at 1.
  expect_judged({Matrix::Identity(3, 3), Vector{{-1.0, 3.0, 0.0}}, Vector{{2.0, -1.0, 0.0}}, 0.5},
                1.0, of_lengths, 5, 6);
  expect_judged({Matrix::Identity(3, 3), Vector{{-1.0, 3.0, 0.0}}, Vector{{1.0, -0.5, 0.0}}, 0.5},
                0.0, of_lengths, 6, 6);
}

TEST_CASE("The residual of friction tells each breach worked by hand", "[7.7]") {
  const Matrix A = Matrix::Identity(3, 3);
  const auto one = [&](const Vector& b, const Vector& lambda, double friction) -> Judging {
    return {A, b, lambda, friction};
  };
  const std::vector<std::pair<Judging, double>> all{
      {one(Vector{{-2.0, 0.0, 0.0}}, Vector{{0.0, 0.0, 0.0}}, 0.5), 2.0},    // approaches
      {one(Vector{{1.0, 0.0, 0.0}}, Vector{{0.5, 0.0, 0.0}}, 0.5), 0.5},     // pressed, but open
      {one(Vector{{1.0, 0.0, 0.0}}, Vector{{3.0, 0.0, 0.0}}, 0.5), 3.0},     // u is 4
      {one(Vector{{3.0, 0.0, 0.0}}, Vector{{-0.5, 0.0, 0.0}}, 0.5), 0.5},    // pulls
      {one(Vector{{3.0, -1.0, 0.0}}, Vector{{-0.5, 1.0, 0.0}}, 0.5), 1.0},   // and rubs: limit 0
      {one(Vector{{-1.0, -3.0, -4.0}}, Vector{{1.0, 3.0, 4.0}}, 0.5), 4.5},  // beyond the limit
      {one(Vector{{-1.0, 0.0, 3.0}}, Vector{{1.0, 0.0, 0.0}}, 0.5), 0.5},    // slips without
      {one(Vector{{-1.0, 0.25, 0.0}}, Vector{{1.0, 0.0, 0.0}}, 0.5), 0.25},  // it should stick
      {one(Vector{{-1.0, 3.0, 0.0}}, Vector{{1.0, 0.5, 0.0}}, 0.5), 1.0}};   // pushes on
  int index = 0;
  for (const auto& [in, wanted] : all) expect_judged(in, wanted, of_lengths, ++index, 9);
}

TEST_CASE("The residual of friction is the largest of all contacts wherever it is", "[7.7]") {
  const Matrix A = Matrix::Identity(3, 3);
  const Judging right{A, Vector{{-1.0, 0.0, 0.0}}, Vector{{1.0, 0.0, 0.0}}, 0.5};
  const Judging opens{A, Vector{{1.0, 0.0, 0.0}}, Vector{{0.25, 0.0, 0.0}}, 0.5};
  const Judging slips{A, Vector{{-1.0, 3.0, 0.0}}, Vector{{1.0, 0.25, 0.0}}, 0.5};  // 3/4
  int index = 0;
  for (const std::vector<Judging>& contacts :
       {std::vector{opens, right, slips}, {slips, opens, right}, {right, slips, opens}}) {
    expect_judged(side_by_side(contacts), 0.75, of_lengths, ++index, 4);
  }
  expect_judged({Matrix(0, 0), Vector(0), Vector(0), 0.5}, 0.0, tests::exact, ++index, 4);
}

TEST_CASE("No breach of the law of friction is too small to be told", "[7.7]") {
  const Matrix A = Matrix::Identity(3, 3);
  int index = 0;
  for (const double small : {1e-6, 1e-9, 1e-12, 1e-50, 1e-100}) {
    const tests::Bound bound{16.0 * eps * small, "a length and a division"};
    expect_judged({A, Vector{{-small, 0.0, 0.0}}, Vector::Zero(3), 0.5}, small, bound, ++index, 10);
    expect_judged({A, Vector{{-1.0, 0.0, small}}, Vector{{1.0, 0.0, 0.0}}, 0.5}, small, bound,
                  ++index, 10);
  }
}

TEST_CASE("The residual of friction of any impulses is as worked contact by contact", "[7.7]") {
  tests::Random random(774);
  for (int i = 1; i <= 60; ++i) {
    const tests::Sweeping in = tests::random_sweeping(random, 1 + i % 3);
    const Judging judging{in.A, in.b, in.start, in.friction};
    expect_judged(judging, tests::exact_coulomb_residual(judging),
                  {1e-13, "a hundred operations on numbers of up to 6"}, i, 60);
  }
}

TEST_CASE("The residual of friction of bad input is refused", "[7.7]") {
  using lab::multi_contact::coulomb_residual;
  const std::string f = "7.7 coulomb_residual";
  const Vector right{{1.0, -0.3, -0.4}};
  for (const auto& [system, why] : tests::bad_triples()) {
    tests::system_trial(f, system.A, system.u)
        .expect_throw(
            [&, bad = system] {
              return coulomb_residual(bad.A, bad.u, Vector::Zero(bad.u.size()), 0.5);
            },
            why);
  }
  tests::refuse(f, tests::bad_triple_vectors(), "lambda", [&](const Vector& bad) {
    return coulomb_residual(uneven_A(), uneven_b(), bad, 0.5);
  });
  tests::refuse(f, tests::bad_not_negative(), "friction",
                [&](double bad) { return coulomb_residual(uneven_A(), uneven_b(), right, bad); });
}

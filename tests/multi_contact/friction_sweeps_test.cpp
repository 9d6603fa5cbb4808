// Sweeps with friction, step 7.7, whose outcome is known in fractions.
#include <cmath>

#include "catch.hpp"
#include "friction.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::eps;
using tests::FrictionRule;
using tests::Sweeping;

namespace {

struct Swept {
  Sweeping in;
  Vector wanted;
};

const tests::Bound few_products{64.0 * eps, "some 20 operations on numbers of up to 4"};

void expect_swept(const Sweeping& in, const Vector& wanted, const tests::Bound& bound,
                  int index = 1, int count = 1) {
  const tests::Trial trial = tests::friction_trial(in, index, count);
  trial.expect(tests::swept_by_answer(in, trial), wanted, bound);
}

void expect_swept(const std::vector<Swept>& all) {
  int index = 0;
  for (const auto& [in, wanted] : all) {
    expect_swept(in, wanted, few_products, ++index, static_cast<int>(all.size()));
  }
}

Vector none() { return Vector::Zero(3); }

/// The rod, its lower end comes down at 1 and slips.
Sweeping leaning(double slip, double friction, int sweeps, const Vector& start = none()) {
  return {
      tests::leaning_rod(), Vector{{-1.0, slip, 0.0}}, start, friction, FrictionRule::disc, sweeps};
}

/// The case in which one step for both tangents and a step for each part.
Sweeping uneven(FrictionRule rule, int sweeps, const Vector& start = none()) {
  return {tests::diagonal(1.0, 2.0, 4.0), Vector{{-1.0, 3.6, 5.6}}, start, 0.5, rule, sweeps};
}

}  // namespace

TEST_CASE("What yields alike in all directions is done in one sweep", "[7.7]") {
  // u = (-5, 3, 4), and the limit is 5/2.
  const Vector b{{-5.0, 3.0, 4.0}};
  const Matrix A = Matrix::Identity(3, 3);
  expect_swept({{{A, b, none(), 0.5, FrictionRule::disc, 1}, Vector{{5.0, -1.5, -2.0}}},
                {{A, b, none(), 0.5, FrictionRule::box, 1}, Vector{{5.0, -2.5, -2.5}}},
                {{A, b, none(), 0.5, FrictionRule::diamond, 1}, Vector{{5.0, -0.75, -1.75}}},
                {{A, b, none(), 1.5, FrictionRule::disc, 1}, Vector{{5.0, -3.0, -4.0}}},
                {{2.0 * A, b, none(), 0.5, FrictionRule::disc, 1}, Vector{{2.5, -0.75, -1.0}}}});
}

TEST_CASE("The first sweeps of a leaning rod are worked by hand", "[7.7]") {
  // The normal impulse 5/8 makes the slip -10 + 3/4. 5/17 of it is beyond the limit.
  expect_swept({{leaning(-10.0, 1.0, 1), Vector{{5.0, 5.0, 0.0}} / 8.0},
                {leaning(-10.0, 1.0, 2), Vector{{5.0, 5.0, 0.0}} / 32.0},
                {leaning(-10.0, 1.0, 3), Vector{{65.0, 65.0, 0.0}} / 128.0},
                {leaning(10.0, 1.0, 2), Vector{{35.0, -35.0, 0.0}} / 32.0},
                {leaning(-10.0, 0.0, 3), Vector{{5.0, 0.0, 0.0}} / 8.0},
                {leaning(1.0, 2.0, 1), Vector{{85.0, -70.0, 0.0}} / 136.0}});
}

TEST_CASE("Many sweeps of a leaning rod end where it slides or sticks", "[7.7]") {
  const tests::Bound bound{1e-12, "120 sweeps, each of which leaves 3/4 of the error or less"};
  expect_swept(leaning(-10.0, 1.0, 120), Vector{{5.0, 5.0, 0.0}} / 14.0, bound, 1, 4);
  expect_swept(leaning(10.0, 1.0, 120), Vector{{2.5, -2.5, 0.0}}, bound, 2, 4);
  expect_swept(leaning(10.0, 4.0 / 3.0, 120), Vector{{3.85, -4.3, 0.0}}, bound, 3, 4);
  expect_swept(leaning(10.0, 2.0, 120), Vector{{3.85, -4.3, 0.0}}, bound, 4, 4);
}

TEST_CASE("With much friction the sweeps of a leaning rod go in a circle", "[7.7]") {
  // They go past (1/4, 1/2), the one solution, to (5/8, 5/4) and back to nothing.
  for (int sweeps = 1; sweeps <= 8; ++sweeps) {
    const Vector wanted = sweeps % 2 == 0 ? none() : Vector{{0.625, 1.25, 0.0}};
    expect_swept(leaning(-10.0, 2.0, sweeps), wanted, few_products, sweeps, 8);
  }
}

TEST_CASE("One step for both tangents turns friction against the slip", "[7.7]") {
  const Vector answer{{1.0, -0.3, -0.4}};  // and then u = (0, 3, 4)
  const tests::Bound bound{1e-13, "each sweep leaves a fifth of the error or less"};
  int index = 0;
  for (const int sweeps : {20, 30}) {
    expect_swept(uneven(FrictionRule::disc, sweeps), answer, bound, ++index, 4);
  }
  expect_swept(uneven(FrictionRule::box, 30), Vector{{1.0, -0.5, -0.5}}, bound, ++index, 4);
  expect_swept(uneven(FrictionRule::diamond, 30), Vector{{1.0, 0.0, -0.5}}, bound, ++index, 4);
}

TEST_CASE("Tangents that know of each other share the step of their largest eigenvalue", "[7.7]") {
  // A_TT has the eigenvalues 1 and 3. Nothing slips in the end: A lambda = -b.
  const Matrix A{{1.0, 0.0, 0.0}, {0.0, 2.0, 1.0}, {0.0, 1.0, 2.0}};
  const Vector b{{-1.0, 3.0, 6.0}};
  const auto in = [&](int sweeps) -> Sweeping {
    return {A, b, none(), 9.0, FrictionRule::disc, sweeps};
  };
  expect_swept({{in(1), Vector{{1.0, -1.0, -2.0}}}, {in(2), Vector{{3.0, -2.0, -7.0}} / 3.0}});
  expect_swept(in(90), Vector{{1.0, 0.0, -3.0}},
               {1e-12, "each sweep leaves 2/3 of the error or less"});
  // The other way round: eigenvalues 3/2 and 5/2.
  expect_swept({Matrix{{1.0, 0.0, 0.0}, {0.0, 2.0, -0.5}, {0.0, -0.5, 2.0}},
                Vector{{-1.0, 5.0, -2.5}}, none(), 9.0, FrictionRule::disc, 1},
               Vector{{1.0, -2.0, 1.0}}, few_products);
}

TEST_CASE("A sweep at the answer stays there and none returns the start", "[7.7]") {
  const std::vector<Swept> answers{{uneven(FrictionRule::disc, 1), Vector{{1.0, -0.3, -0.4}}},
                                   {uneven(FrictionRule::box, 1), Vector{{1.0, -0.5, -0.5}}},
                                   {leaning(-10.0, 2.0, 1), Vector{{0.25, 0.5, 0.0}}},
                                   {leaning(10.0, 1.0, 1), Vector{{2.5, -2.5, 0.0}}},
                                   {leaning(10.0, 2.0, 1), Vector{{3.85, -4.3, 0.0}}}};
  int index = 0;
  for (auto [in, answer] : answers) {
    in.start = answer;
    expect_swept(in, answer, few_products, ++index, 8);
  }
  for (const Vector& start : {Vector{{-1.0, 2.0, 3.0}}, Vector{{1.0, 9.0, -9.0}}, none()}) {
    Sweeping in = leaning(10.0, 1.0, 0, start);
    expect_swept(in, start, {0.0, "it is returned as it is"}, ++index, 8);
  }
}

TEST_CASE("From a start each impulse gives back what is too much", "[7.7]") {
  // u = b + start. The normal gives 2 of its 3 back, then the tangents what is over the limit.
  const Matrix A = Matrix::Identity(3, 3);
  const auto from = [&](const Vector& b, const Vector& start) -> Sweeping {
    return {A, b, start, 0.5, FrictionRule::box, 1};
  };
  expect_swept(
      {{from(Vector{{-1.0, 0.0, 0.0}}, Vector{{3.0, 1.0, -1.0}}), Vector{{1.0, 0.0, 0.0}}},
       {from(Vector{{-1.0, -2.0, 2.0}}, Vector{{3.0, 1.0, -1.0}}), Vector{{1.0, 0.5, -0.5}}},
       {from(Vector{{1.0, -2.0, 2.0}}, Vector{{3.0, 1.0, -1.0}}), none()},
       {from(Vector{{-1.0, -0.25, 2.0}}, Vector{{-3.0, 1.0, -1.0}}), Vector{{1.0, 0.25, -0.5}}}});
}

TEST_CASE("However slowly it slips or presses friction has its share", "[7.7]") {
  const Matrix A = Matrix::Identity(3, 3);
  int index = 0;
  for (const double small : {1e-6, 1e-9, 1e-12, 1e-50, 1e-99}) {
    for (const FrictionRule rule : {FrictionRule::disc, FrictionRule::box}) {
      // It sticks with what stops 3 and 4 of these, and slips with a limit of as many.
      const tests::Bound bound{32.0 * eps * small, "some operations on numbers of this size"};
      const Sweeping sticks{A, Vector{{-1.0, 3.0 * small, 4.0 * small}}, none(), 0.5, rule, 1};
      const tests::Trial trial = tests::friction_trial(sticks, ++index, 20);
      trial.of("the tangential impulse")
          .expect(tests::Vec2(tests::swept_by_answer(sticks, trial).tail<2>()),
                  tests::Vec2(-3.0 * small, -4.0 * small), bound);
      const Vector wanted =
          rule == FrictionRule::disc ? Vector{{10.0, -3.0, -4.0}} : Vector{{10.0, -5.0, -5.0}};
      expect_swept({A, Vector{{-10.0 * small, 30.0, 40.0}}, none(), 0.5, rule, 1}, small * wanted,
                   bound, ++index, 20);
    }
  }
}

TEST_CASE("A contact that parts has neither pressure nor friction", "[7.7]") {
  int index = 0;
  for (const FrictionRule rule : tests::all_rules) {
    for (const double opens : {0.0, 0.5}) {
      const Vector b{{opens, 3.0, -4.0}};
      expect_swept({tests::diagonal(1.0, 2.0, 4.0), b, none(), 0.5, rule, 3}, none(),
                   {0.0, "the limit is zero"}, ++index, 6);
    }
  }
}

TEST_CASE("Without friction and without contacts the sweeps are those of the normals", "[7.7]") {
  int index = 0;
  for (const FrictionRule rule : tests::all_rules) {
    expect_swept(
        {tests::leaning_rod(), Vector{{-2.0, 3.0, 4.0}}, Vector{{0.0, 5.0, -5.0}}, 0.0, rule, 2},
        Vector{{1.25, 0.0, 0.0}}, few_products, ++index, 4);
  }
  expect_swept({Matrix(0, 0), Vector(0), Vector(0), 0.5, FrictionRule::disc, 3}, Vector(0),
               tests::exact, ++index, 4);
}

TEST_CASE("A matrix that is symmetric but for rounding is swept with friction", "[7.7]") {
  Sweeping in = leaning(-10.0, 1.0, 3);
  in.A(0, 1) += 1e-10;
  expect_swept(in, Vector{{65.0, 65.0, 0.0}} / 128.0, {1e-9, "an entry of A is off by 1e-10"});
}

// Step 7.2: how many impulses there are, and when it ends.
#include "sequential.hpp"

#include "catch.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::SequentialInput;

namespace {

/// The count alone, of what has ended, with twice as many impulses allowed.
void expect_count(const Scene& scene, double restitution, int wanted, int index, int count) {
  const SequentialInput in{scene.system(), restitution, 2 * wanted};
  const tests::Trial trial = tests::sequential_trial(in, index, count);
  const Impulses got = tests::sequential_by_answer(trial, in);
  trial.of("lambda").expect(got.lambda, tests::sequential_outcome(in).done.lambda,
                            {64.0 * eps * wanted * (1.0 + got.lambda.norm()),
                             "some operations an impulse, on numbers of the size of lambda"});
  trial.of("the count")
      .expect(static_cast<double>(got.count), static_cast<double>(wanted), tests::counted);
  trial.of("whether it ended")
      .expect(tests::Decision{got.ended}, tests::Decision{true}, tests::counted);
}

void expect_as_oracle(const SequentialInput& in, const tests::Bound& bound, int index, int count) {
  const tests::Trial trial = tests::sequential_trial(in, index, count);
  tests::expect_impulses(trial, tests::sequential_by_answer(trial, in),
                         tests::sequential_outcome(in).done, bound);
}

}  // namespace

TEST_CASE("If k balls hit n - k there are k times n - k impulses", "[7.2]") {
  int index = 0;
  for (int n = 2; n <= 7; ++n) {
    for (int k = 1; k < n; ++k) {
      Vector v = Vector::Zero(n);
      v.head(k).setOnes();
      expect_count(tests::cradle(v), 1.0, k * (n - k), ++index, 21);
    }
  }
  for (int n = 2; n <= 7; ++n) {
    const Vector v = Vector::LinSpaced(n, n, 1.0);
    expect_count(tests::cradle(v), 1.0, n * (n - 1) / 2, n - 1, 6);
  }
}

TEST_CASE("A falling column has as many impulses as pairs of its balls and the ground", "[7.2]") {
  for (int n = 1; n <= 7; ++n) {
    const Scene scene = tests::column(Vector::Ones(n), -Vector::Ones(n));
    expect_count(scene, 1.0, n * (n + 1) / 2, n, 7);
  }
}

TEST_CASE("A heavy ball against a light one at a wall counts the digits of pi", "[7.2]") {
  int index = 0;
  const std::vector<std::pair<double, int>> counts{
      {1.0, 3}, {3.0, 5}, {4.0, 6}, {9.0, 9}, {16.0, 12}, {100.0, 31}, {1e4, 314}, {1e6, 3141}};
  for (const auto& [mass_ratio, impulses] : counts) {
    expect_count(tests::counting_pi(mass_ratio), 1.0, impulses, ++index, 8);
  }
}

TEST_CASE("Two contacts at an angle need no more impulses than angles in pi", "[7.2]") {
  int index = 0;
  for (const auto& [degrees, most] : std::vector<std::pair<double, int>>{
           {80.0, 3}, {50.0, 4}, {40.0, 5}, {25.0, 8}, {7.0, 26}, {3.1, 59}}) {
    const double cosine = std::cos(degrees * 3.141592653589793 / 180.0);
    const SequentialInput in{
        {Matrix{{1.0, -cosine}, {-cosine, 1.0}}, Vector{{-1.0, cosine - 1e-3}}}, 1.0, 2 * most};
    expect_as_oracle(in, {64.0 * eps * most * most, "some operations an impulse"}, ++index, 6);
    const tests::Trial trial = tests::sequential_trial(in, index, 6);
    trial.of("the count")
        .expect_small(
            "impulses above pi over the angle",
            std::max(0.0, static_cast<double>(tests::sequential_by_answer(trial, in).count - most)),
            tests::counted);
  }
}

TEST_CASE("Below its border restitution lets impulses collapse", "[7.2]") {
  // Three equal balls: for e < 7 − 4√3, about 1/13.93, there is no last impulse.
  const ContactSystem cradle = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  const double border = 7.0 - 4.0 * std::sqrt(3.0);
  const tests::Bound bound{1e-12, "20 impulses, each some roundings of numbers below 1"};
  int index = 0;
  for (const double e :
       {1.0 / 14.0, 1.0 / 13.0, 0.9 * border, 1.1 * border, 1.0 / 12.0, 1.0 / 10.0, 1.0 / 8.0}) {
    expect_as_oracle({cradle, e, 20}, bound, ++index, 7);
  }
  const std::vector<std::pair<double, int>> counts{{13.0, 12}, {12.0, 8}, {10.0, 6}, {8.0, 4}};
  for (const auto& [inverse, impulses] : counts) {
    const SequentialInput in{cradle, 1.0 / inverse, 20};
    const tests::Trial trial = tests::sequential_trial(in);
    const Impulses got = tests::sequential_by_answer(trial, in);
    trial.of("the count")
        .expect(static_cast<double>(got.count), static_cast<double>(impulses), tests::counted);
    trial.of("whether it ended")
        .expect(tests::Decision{got.ended}, tests::Decision{true}, tests::counted);
  }
  for (const double e : {1.0 / 14.0, 0.9 * border}) {
    const SequentialInput in{cradle, e, 20};
    const tests::Trial trial = tests::sequential_trial(in);
    const Impulses got = tests::sequential_by_answer(trial, in);
    trial.of("the count").expect(static_cast<double>(got.count), 20.0, tests::counted);
    trial.of("whether it ended")
        .expect(tests::Decision{got.ended}, tests::Decision{false}, tests::counted);
  }
}

TEST_CASE("The cap is obeyed to the impulse and ended says if that was enough", "[7.2]") {
  // Three impulses, at contacts 0, 1 and 0; then 45 of ten balls; then as many as are allowed.
  std::vector<SequentialInput> all;
  for (int cap = 0; cap <= 4; ++cap) {
    all.push_back({tests::cradle(Vector{{1.0, 0.0, -1.0}}).system(), 1.0, cap});
  }
  const ContactSystem row = tests::cradle(Vector::LinSpaced(10, 10.0, 1.0)).system();
  for (const int cap : {0, 1, 8, 9, 10, 44, 45, 46, 1000000000}) all.push_back({row, 1.0, cap});
  for (const int cap : {0, 1, 50, 20000}) all.push_back({tests::jammed_ball().system(), 1.0, cap});
  int index = 0;
  for (const SequentialInput& in : all) {
    expect_as_oracle(in, {64.0 * eps * 45.0, "six operations an impulse"}, ++index, 18);
  }
}

TEST_CASE("Without restitution the last impulse is as small as the tolerance", "[7.2]") {
  // Every impulse halves the approach: −1, −1/2, … and 2^-40 is below 1e-12, 2^-39 is not.
  const ContactSystem cradle = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  int index = 0;
  for (const int cap : {6, 39, 40, 100}) {
    expect_as_oracle({cradle, 0.0, cap}, {16.0 * eps, "halves are exact"}, ++index, 4);
  }
}

TEST_CASE("What does not approach is left alone", "[7.2]") {
  int index = 0;
  for (const Vector& u : {Vector{{0.0, 0.0}}, Vector{{1.0, 0.0}}, Vector{{0.5, 2.0}},
                          Vector{{1.0, -0.9e-12}}, Vector{{1e50, 1e-50}}}) {
    for (const int cap : {0, 1, 10}) {
      const SequentialInput in{{Matrix{{2.0, -1.0}, {-1.0, 2.0}}, u}, 0.5, cap};
      const tests::Trial trial = tests::sequential_trial(in, ++index, 15);
      tests::expect_impulses(trial, tests::sequential_by_answer(trial, in),
                             {Vector::Zero(2), 0, true}, {0.0, "zero is exact"});
    }
  }
}

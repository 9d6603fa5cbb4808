// Step 7.2: laws on any system, thresholds, sizes, and what is refused.
#include "sequential.hpp"

#include "catch.hpp"
#include "refused.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::SequentialInput;

namespace {

/// Balls of masses from 1 to 9 in a row; every other row stands on the ground.
Scene random_row(tests::Random& random, int index) {
  const auto n = static_cast<Eigen::Index>(random.uniform(2.0, 7.0));
  Vector masses(n);
  for (double& mass : masses) mass = std::floor(random.uniform(1.0, 10.0));
  const Vector v = tests::random_vector(random, n, 1.0);
  return index % 2 == 0 ? tests::row_of_balls(masses, v) : tests::column(masses, v);
}

double lowest(const Vector& u) { return u.size() == 0 ? 0.0 : u.minCoeff(); }

/// That something happened, as a number of contacts that approached.
int approaching_at_first(const Scene& scene) {
  const Vector u = scene.system().u;
  return static_cast<int>((u.array() < -1e-12 * u.cwiseAbs().maxCoeff()).count());
}

}  // namespace

TEST_CASE("One after the other on any system is as worked impulse by impulse", "[7.2]") {
  tests::Random random(731);
  int judged = 0;
  for (int i = 1; i <= 60; ++i) {
    const Scene scene = random_row(random, i);
    const double e = i % 3 == 0 ? 1.0 : random.uniform(0.4, 1.0);
    const SequentialInput in{scene.system(), e, i % 5 == 0 ? 3 : 60};
    const auto [wanted, margin] = tests::sequential_outcome(in);
    if (margin < 1e-9) continue;  // rounding may decide
    ++judged;
    const tests::Trial trial = tests::sequential_trial(in, i, 60);
    tests::expect_impulses(trial, tests::sequential_by_answer(trial, in), wanted,
                           {64.0 * eps * 9.0 * (wanted.count + 1.0) * (wanted.count + 1.0),
                            "masses up to 9; each impulse adds some roundings to all speeds"});
  }
  REQUIRE(judged > 40);
}

TEST_CASE("Elastic impulses keep energy and momentum and only push", "[7.2]") {
  tests::Random random(732);
  int impulses = 0;
  for (int i = 1; i <= 60; ++i) {
    const Scene scene = random_row(random, i);
    const SequentialInput in{scene.system(), 1.0, 200};
    const tests::Trial trial = tests::sequential_trial(in, i, 60);
    const Impulses got = tests::sequential_by_answer(trial, in);
    const Vector after = scene.after(got.lambda);
    const double rounding = 64.0 * eps * 9.0 * (got.count + 1.0);
    impulses += got.count;
    trial.of("the energy afterwards")
        .expect(scene.energy(after), scene.energy(scene.v),
                {rounding * 54.0, "masses of 54 in all, and some roundings an impulse"});
    const bool is_free = i % 2 == 0;
    trial.of("the momentum afterwards, with the ground's impulse")
        .expect(scene.momentum(after) - (is_free ? 0.0 : got.lambda[0]), scene.momentum(scene.v),
                {rounding * 54.0, "masses of 54 in all, and some roundings an impulse"});
    trial.expect_small("how far some contact still approaches",
                       std::max(-lowest(common::product(scene.J, after)), 0.0),
                       {rounding, "1e-12 of u, and some roundings an impulse"});
    trial.expect_small("how far some lambda pulls", std::max(-lowest(got.lambda), 0.0),
                       {0.0, "each impulse pushes"});
    trial.expect_small("how many of the contacts that approached got nothing",
                       static_cast<double>(std::max(0, approaching_at_first(scene) - got.count)),
                       tests::counted);
  }
  REQUIRE(impulses > 100);
}

TEST_CASE("An impulse takes the share 1 - e squared of its energy and no more", "[7.2]") {
  int index = 0;
  for (const double e : {0.0, 1e-9, 0.5, 1.0 - 1e-9, 1.0}) {
    const SequentialInput in{{Matrix{{2.0, 0.0}, {0.0, 0.5}}, Vector{{-3.0, 1.0}}}, e, 10};
    const tests::Trial trial = tests::sequential_trial(in, ++index, 5);
    const Impulses got = tests::sequential_by_answer(trial, in);
    tests::expect_impulses(trial, got, {Vector{{1.5 * (1.0 + e), 0.0}}, 1, true},
                           {4.0 * eps, "three operations"});
    // λ (u + A λ/2), by hand: −(1 − e²) 9/4.
    trial.of("the energy gained")
        .expect(got.lambda[0] * (-3.0 + got.lambda[0]), -2.25 * (1.0 - e) * (1.0 + e),
                {64.0 * eps, "some five operations on numbers up to 9"});
  }
}

TEST_CASE("An approach is beyond 1e-12 of the largest speed handed in", "[7.2]") {
  // The contacts do not notice each other, so the small speed stays what it is.
  const Matrix A{{1.0, 0.0}, {0.0, 2.0}};
  int index = 0;
  for (const double largest : {-1.0, 1.0, -8.0, 0x1p-300, -0x1p300}) {
    for (const double share : {0.0, 1e-15, 0.99e-12, 1e-12, 1.01e-12, 1e-9, 1e-3}) {
      const SequentialInput in{{A, Vector{{largest, -share * std::abs(largest)}}}, 0.5, 10};
      const double first = largest < 0.0 ? -1.5 * largest : 0.0;
      const double second = share > 1e-12 ? 0.75 * share * std::abs(largest) : 0.0;
      const int impulses = (first > 0.0 ? 1 : 0) + (second > 0.0 ? 1 : 0);
      const tests::Trial trial = tests::sequential_trial(in, ++index, 35);
      const Impulses got = tests::sequential_by_answer(trial, in);
      tests::expect_impulses(trial, got, {Vector{{first, second}}, impulses, true},
                             {4.0 * eps * std::abs(largest), "three operations"});
      trial.of("the second impulse")
          .expect(got.lambda[1], second, {4.0 * eps * second, "three operations"});
    }
  }
}

TEST_CASE("The border stays where it was set while speeds grow or shrink", "[7.2]") {
  // The impulse at contact 0 leaves contact 1 the largest speed by far, or makes that of 2 grow.
  const double border = 1e-12;
  const Matrix shrinks{{1.0, 0.0}, {0.0, 1.0}};
  const Matrix grows{{1.0, 0.0, 1e6}, {0.0, 1.0, 0.0}, {1e6, 0.0, 1e13}};
  const std::vector<SequentialInput> all{
      {{shrinks, Vector{{-1.0, -0.5 * border}}}, 0.0, 10},
      {{shrinks, Vector{{-1.0, -2.0 * border}}}, 0.0, 10},
      {{grows, Vector{{-1.0, -2.0 * border, 0.0}}}, 1.0, 10},
      // It is of the largest speed, not of all together.
      {{Matrix::Identity(3, 3), Vector{{-1.0, -1.25 * border, 1.0}}}, 1.0, 10}};
  int index = 0;
  for (const SequentialInput& in : all) {
    const tests::Trial trial = tests::sequential_trial(in, ++index, 4);
    const Impulses got = tests::sequential_by_answer(trial, in);
    const Impulses wanted = tests::sequential_outcome(in).done;
    tests::expect_impulses(trial, got, wanted, {8.0 * eps, "three operations an impulse"});
    trial.of("the second impulse")
        .expect(got.lambda[1], wanted.lambda[1], {8.0 * eps * border, "three operations"});
  }
}

TEST_CASE("Impulses have the size of the speeds and of the masses", "[7.2]") {
  const Scene row = tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}});
  const ContactSystem system = row.system();
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-13, 1e13, 1e50, 1e100}) {
    const Vector wanted = Vector{{40.0, 60.0}} / 27.0;
    const SequentialInput fast{{system.A, size * system.u}, 1.0, 10};
    const SequentialInput light{{size * system.A, system.u}, 1.0, 10};
    const tests::Trial trial = tests::sequential_trial(fast, ++index, 12);
    const tests::Bound rounding{64.0 * eps * size, "18 operations"};
    tests::expect_impulses(trial, tests::sequential_by_answer(trial, fast),
                           {size * wanted, 3, true}, rounding);
    const tests::Trial other = tests::sequential_trial(light, ++index, 12);
    tests::expect_impulses(other, tests::sequential_by_answer(other, light),
                           {wanted / size, 3, true}, {64.0 * eps / size, "18 operations"});
  }
  const SequentialInput empty{{Matrix(0, 0), Vector(0)}, 1.0, 5};
  const tests::Trial third = tests::sequential_trial(empty, 1, 2);
  tests::expect_impulses(third, tests::sequential_by_answer(third, empty), {Vector(0), 0, true},
                         tests::exact);
  const SequentialInput rounded{
      {Matrix{{2.0, -1.0}, {-1.0 + 1e-9, 2.0}}, Vector{{-1.0, 0.0}}}, 1.0, 5};
  const tests::Trial fourth = tests::sequential_trial(rounded, 2, 2);
  tests::expect_impulses(fourth, tests::sequential_by_answer(fourth, rounded),
                         {Vector{{1.0, 1.0}}, 2, true}, {4e-9, "A is symmetric to 1e-9"});
}

TEST_CASE("Impulses of what cannot be are refused", "[7.2]") {
  const std::string f = "7.2 sequential_impulses";
  tests::refuse_systems(
      f, [](const ContactSystem& bad) { return sequential_impulses(bad, 0.5, 10).lambda; });
  for (const Vector& u : {Vector{{-1.0, 0.0}}, Vector{{1.0, 1.0}}}) {  // and with nothing to do
    const ContactSystem system{tests::good_system().A, u};
    tests::refuse(f, tests::bad_fractions(), "restitution",
                  [&](double e) { return sequential_impulses(system, e, 10).lambda; });
    for (const int cap : {-1, -1000000000}) {
      tests::system_trial(f, system)
          .given("max_impulses", static_cast<double>(cap))
          .expect_throw([&, most = cap] { return sequential_impulses(system, 0.5, most).lambda; },
                        "a cap is not below zero");
    }
  }
}

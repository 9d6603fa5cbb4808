// What sweeps with friction, step 7.7, come to on any system, on slopes and in slides.
#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "friction.hpp"
#include "refused.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::eps;
using tests::FrictionRule;
using tests::Sweeping;
using tests::Vec2;
using tests::Vec3;

namespace {

/// A block of mass 1 that slides until it rests, from this velocity, by small steps of pressure.
/// returns  the way, which is v |v| for the disc
Vec2 slide_by_answer(Vec2 v, FrictionRule rule) {
  constexpr double pressure = 1.0 / 128.0;
  Vec2 way = Vec2::Zero();
  for (int step = 0; step < 300 && v != Vec2::Zero(); ++step) {
    const Sweeping in{
        Matrix::Identity(3, 3), Vector{{-pressure, v.x(), v.y()}}, Vector::Zero(3), 1.0, rule, 1};
    const Vector lambda = tests::swept_by_answer(in, tests::friction_trial(in));
    const Vec2 next = v + lambda.tail<2>();
    way += pressure * (v + next);
    v = next;
  }
  return way;
}

double angle_of(const Vec2& way) { return std::atan2(way.y(), way.x()) * 180.0 / std::numbers::pi; }

}  // namespace

TEST_CASE("Sweeps with friction on any system are as worked contact by contact", "[7.7]") {
  tests::Random random(772);
  for (int i = 1; i <= 60; ++i) {
    Sweeping in = tests::random_sweeping(random, i % 20 == 0 ? 9 : 1 + i % 3);
    in.rule = tests::all_rules[i % 3 == 0 ? i / 3 % 3 : i % 3];
    in.sweeps = 1 + i % 4;
    const tests::Trial trial = tests::friction_trial(in, i, 60);
    trial.expect(tests::swept_by_answer(in, trial), tests::exact_friction_sweeps(in),
                 {1e-12,
                  "some hundred operations; a sweep makes what is off larger at most by the "
                  "ratio of A's entries, three times or so"});
  }
}

TEST_CASE("Sweeps of bodies on four corners come to obey the law of Coulomb", "[7.7]") {
  // Velocities are not unique here: the law is what can be judged.
  int index = 0;
  for (const Vec3& sides : {Vec3(1.0, 1.0, 1.0), Vec3(1.0, 0.5, 0.25), Vec3(2.0, 2.0, 1.0)}) {
    for (const double friction : {0.1, 0.3}) {
      const auto [A, b] = tests::falling_box(sides, Vec3(0.5, 0.25, -1.0), Vec3(0.125, -0.25, 0.5));
      const Sweeping in{A, b, Vector::Zero(12), friction, FrictionRule::disc, 250};
      const tests::Trial trial = tests::friction_trial(in, ++index, 6);
      const Vector lambda = tests::swept_by_answer(in, trial);
      trial.expect_small("the largest breach of Coulomb's law",
                         tests::exact_coulomb_residual({A, b, lambda, friction}),
                         {1e-12, "so many sweeps leave rounding only"});
      trial.expect_small("0.25 - the sum of lambda_n",
                         0.25 - (lambda[0] + lambda[3] + lambda[6] + lambda[9]),
                         {0.0, "a mass of 1 comes down at 1"});
    }
  }
}

TEST_CASE("Sweeps with a little friction come to obey the law of Coulomb", "[7.7]") {
  tests::Random random(773);
  for (int i = 1; i <= 20; ++i) {
    Sweeping in = tests::random_sweeping(random, 1 + i % 3);
    in.friction *= 0.3;
    in.sweeps = 300;
    const tests::Trial trial = tests::friction_trial(in, i, 20);
    const Vector lambda = tests::swept_by_answer(in, trial);
    trial.expect_small("the largest breach of Coulomb's law",
                       tests::exact_coulomb_residual({in.A, in.b, lambda, in.friction}),
                       {1e-12, "so many sweeps leave rounding only"});
  }
}

TEST_CASE("On a slope along the diagonal the box holds longer and the diamond less long", "[7.7]") {
  // A block that rests, gravity along (1, 1): the bounds reach sqrt(2) mu, mu, mu/sqrt(2) there.
  const double root = std::numbers::sqrt2;
  const double mu = 0.5;
  int index = 0;
  for (const auto& [rule, reach] : {std::pair{FrictionRule::box, root * mu},
                                    {FrictionRule::disc, mu},
                                    {FrictionRule::diamond, mu / root}}) {
    for (const double tangent : {0.6 * mu, 0.9 * mu, 1.1 * mu, 0.9 * root * mu, 1.1 * root * mu}) {
      const double along = tangent / root;
      const Sweeping in{
          Matrix::Identity(3, 3), Vector{{-1.0, along, along}}, Vector::Zero(3), mu, rule, 2};
      const tests::Trial trial = tests::friction_trial(in, ++index, 15);
      const Vector lambda = tests::swept_by_answer(in, trial);
      const double slips = std::max(0.0, tangent - reach) / root;
      trial.of("the speed after a moment on the slope")
          .expect(Vec2(in.b.tail<2>() + lambda.tail<2>()), Vec2(slips, slips),
                  {64.0 * eps, "a root and some products"});
    }
  }
}

TEST_CASE("A slide to rest goes straight by the disc and bends by box and diamond", "[7.7]") {
  // For v = (c, s), c > s: the box leaves (c², s²), the diamond c² + s² and 2 c s, see README.
  const tests::Bound bound{6e-5, "the last step of 1/128: its square"};
  int index = 0;
  for (const double degrees : {15.0, 35.0, 45.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (const auto& [rule, wanted] : {std::pair{FrictionRule::disc, Vec2(c, s)},
                                       {FrictionRule::box, Vec2(c * c, s * s)},
                                       {FrictionRule::diamond, Vec2(1.0, 2.0 * c * s)}}) {
      const tests::Trial trial = tests::trial_of("7.7 friction_sweeps", ++index, 9)
                                     .given("v", Vec2(c, s))
                                     .given("rule", tests::code_of(rule));
      trial.of("the way of a block that slides to rest")
          .expect(slide_by_answer({c, s}, rule), wanted, bound);
    }
  }
  // The box is worst where tan + cot = 1 + sqrt(3).
  const double sum = 1.0 + std::numbers::sqrt3;
  const double slope = 0.5 * (sum - std::sqrt(sum * sum - 4.0));
  const Vec2 v = Vec2(1.0, slope).normalized();
  tests::trial_of("7.7 friction_sweeps")
      .given("v", v)
      .of("by how many degrees the box bends a slide")
      .expect(angle_of(v) - angle_of(slide_by_answer(v, FrictionRule::box)), 12.794,
              {5e-3, "the last digit, and the last step of 1/128"});
}

TEST_CASE("The least and the most impulses of friction are alike", "[7.7]") {
  int index = 0;
  for (const auto& [yields, speed] : tests::extreme_scales) {
    const double size = speed / yields;
    const Sweeping in{yields * tests::leaning_rod(),
                      speed * Vector{{-1.0, -10.0, 0.0}},
                      Vector::Zero(3),
                      1.0,
                      FrictionRule::disc,
                      3};
    const tests::Trial trial = tests::friction_trial(in, ++index, 6);
    trial.expect(tests::swept_by_answer(in, trial),
                 Vector(Vector{{65.0, 65.0, 0.0}} * (size / 128.0)),
                 {64.0 * eps * 4.0 * size, "some 40 operations"});
  }
}

TEST_CASE("Sweeps with friction of bad input are refused", "[7.7]") {
  using lab::multi_contact::friction_sweeps;
  const std::string f = "7.7 friction_sweeps";
  const Matrix A = tests::leaning_rod();
  const Vector b{{-1.0, 2.0, 0.5}};
  const Vector zero = Vector::Zero(3);
  for (const int sweeps : {2, 0}) {
    for (const auto& [system, why] : tests::bad_triples()) {
      tests::system_trial(f, system.A, system.u)
          .expect_throw(
              [&, bad = system] {
                return friction_sweeps(bad.A, bad.u, Vector::Zero(bad.u.size()), 0.5,
                                       FrictionRule::disc, sweeps);
              },
              why);
    }
    tests::refuse(f, tests::bad_triple_vectors(), "start", [&](const Vector& bad) {
      return friction_sweeps(A, b, bad, 0.5, FrictionRule::disc, sweeps);
    });
    tests::refuse(f, tests::bad_not_negative(), "friction", [&](double bad) {
      return friction_sweeps(A, b, zero, bad, FrictionRule::box, sweeps);
    });
  }
  for (const int bad : {-1, std::numeric_limits<int>::min()}) {
    tests::trial_of(f)
        .given("sweeps", bad)
        .expect_throw([&] { return friction_sweeps(A, b, zero, 0.5, FrictionRule::disc, bad); },
                      "sweeps are not below zero");
  }
}

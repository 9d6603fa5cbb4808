// Restitution, the cap, jams, and what counts as an approach in step 7.5.
#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "impulses.hpp"
#include "refused.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::ContactSystem;
using tests::eps;
using tests::Impulses;
using tests::Reflecting;
using tests::Scene;

namespace {

void expect_reflections(const Reflecting& in, const Impulses& wanted, const tests::Bound& bound,
                        int index = 1, int count = 1) {
  const tests::Trial trial = tests::reflections_trial(in, index, count);
  tests::expect_impulses(trial, tests::reflected_by_answer(in, trial), wanted, bound);
}

/// Two contacts of one ball with opposite walls, which open as fast as this.
ContactSystem between_walls(double left, double right) {
  return {Matrix{{1.0, -1.0}, {-1.0, 1.0}}, Vector{{left, right}}};
}

}  // namespace

TEST_CASE("Restitution goes straight from the outcome without it to that with all of it", "[7.5]") {
  // The cradle: (1/3, 1/3, 1/3) and (0, 0, 1). Energies above the first go with the square of e.
  const Scene scene = tests::cradle(Vector{{1.0, 0.0, 0.0}});
  int index = 0;
  for (const double e : {0.0, 1e-100, 0.125, 0.25, 0.5, 0.75, 1.0}) {
    const Reflecting in{scene.system(), e};
    const tests::Trial trial = tests::reflections_trial(in, ++index, 7);
    const Impulses done = tests::reflected_by_answer(in, trial);
    tests::expect_impulses(trial, done,
                           {Vector{{2.0 + e, 1.0 + 2.0 * e}} / 3.0, e > 0.0 ? 2 : 0, true},
                           tests::of_solutions(3, 1.0));
    trial.of("the energy afterwards")
        .expect(scene.energy(scene.after(done.lambda)), 1.0 / 6.0 + e * e / 3.0,
                tests::of_solutions(3, 1.0));
  }
}

TEST_CASE("Restitution blends what unequal balls and breaks do", "[7.5]") {
  // lambda for e = 0, lambda for e = 1: see the other cases.
  const auto blend = [](double e, const Vector& none, const Vector& all) -> Vector {
    return (1.0 - e) * none + e * all;
  };
  int index = 0;
  for (const double e : {0.25, 0.5, 0.875}) {
    expect_reflections({tests::break_shot().system(), e},
                       {Vector{{1.0, 1.0}} * (20.0 * (1.0 + e) / 57.0), 1, true},
                       tests::of_solutions(2, 1.0), ++index, 9);
    expect_reflections(
        {tests::row_of_balls(Vector{{2.0, 1.0, 2.0}}, Vector{{1.0, 0.0, 0.0}}).system(), e},
        {blend(e, Vector{{1.2, 0.8}}, Vector{{64.0, 48.0}} / 27.0), 3, true},
        tests::of_solutions(4, 3.0), ++index, 9);
    expect_reflections({tests::cradle(Vector{{1.0, 0.0, 0.5}}).system(), e},
                       {blend(e, Vector{{0.5, 0.0}}, Vector{{1.0, 0.5}}), 2, true},
                       tests::of_solutions(3, 1.0), ++index, 9);
  }
}

TEST_CASE("Without restitution there is no reflection and it has ended", "[7.5]") {
  int index = 0;
  for (const int most : {0, 1, 9}) {
    expect_reflections({tests::cradle(Vector{{1.0, 0.0, 0.0}}).system(), 0.0, most},
                       {Vector{{2.0, 1.0}} / 3.0, 0, true}, tests::of_solutions(1, 1.0), ++index,
                       6);
    expect_reflections({tests::dumb_bell().system(), 0.0, most}, {Vector{{1.5, 0.0}}, 0, true},
                       tests::of_solutions(1, 1.5), ++index, 6);
  }
}

TEST_CASE("After the cap there is no reflection more", "[7.5]") {
  // One on four: each reflection hands the momentum on by one ball, and four are enough.
  const Vector inelastic = Vector{{4.0, 3.0, 2.0, 1.0}} / 5.0;
  int index = 0;
  for (const double e : {1.0, 0.5}) {
    for (int most = 0; most <= 6; ++most) {
      Vector handed_on = Vector::Zero(4);
      handed_on.head(std::min(most, 4)).setOnes();
      const Vector lambda = (1.0 - e) * inelastic + e * handed_on;
      expect_reflections({tests::cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}).system(), e, most},
                         {lambda, std::min(most, 4), most >= 4}, tests::of_solutions(5, 1.0),
                         ++index, 14);
    }
  }
}

TEST_CASE("A jammed ball is reflected until the cap and has not ended", "[7.5]") {
  int index = 0;
  for (const int most : {0, 1, 2, 3, 8}) {
    const Reflecting in{tests::jammed_ball().system(), 1.0, most};
    const Vector lambda{{2.0 * ((most + 1) / 2), 2.0 * (most / 2)}};
    expect_reflections(in, {lambda, most, false}, tests::of_solutions(most, 8.0), ++index, 15);
    for (const double e : {0.0, 0.25}) {  // for e = 0 it stops, but lambda is not unique
      const Reflecting softer{in.system, e, most};
      const tests::Trial trial = tests::reflections_trial(softer, ++index, 15);
      const auto [other, count, ended] = tests::reflected_by_answer(softer, trial);
      const double u = most % 2 == 0 ? -e : e;
      trial.of("u + A lambda")
          .expect(Vector(in.system.u + common::product(in.system.A, other)), Vector{{u, -u}},
                  tests::of_solutions(most, 8.0));
      trial.of("count").expect(static_cast<double>(count), e == 0.0 ? 0.0 : most,
                               {0.0, "it never ends but for e = 0"});
      trial.of("whether it ended").expect(tests::Decision{ended}, {e == 0.0}, tests::counted);
    }
  }
}

TEST_CASE("What rests or parts is not reflected", "[7.5]") {
  int index = 0;
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const int most : {0, 5}) {
      for (const Vector& v : {Vector{{0.0, 0.0, 0.5, 2.0}}, Vector{{1.0, 1.0, 1.0, 1.0}}}) {
        expect_reflections({tests::cradle(v).system(), e, most}, {Vector::Zero(3), 0, true},
                           {0.0, "nothing approaches"}, ++index, 13);
      }
    }
  }
  expect_reflections({{Matrix(0, 0), Vector(0)}, 0.5, 5}, {Vector(0), 0, true},
                     {0.0, "no contacts at all"}, ++index, 13);
}

TEST_CASE("A contact approaches if it does by 1e-12 of the largest speed", "[7.5]") {
  int index = 0;
  for (const double size : {1.0, 1e-6, 1e6}) {
    for (const double share : {0.5, 1.0 - 1e-12, 1.0 + 1e-12, 2.0, 1e3, 1e8}) {
      // Contacts that know nothing of each other; the other one parts.
      const double u = -share * 1e-12 * size;
      const bool comes = share > 1.0;
      expect_reflections({{Matrix::Identity(2, 2), Vector{{size, u}}}},
                         {Vector{{0.0, comes ? -2.0 * u : 0.0}}, comes ? 1 : 0, true},
                         {8.0 * eps * -u, "twice u"}, ++index, 21);
    }
  }
  expect_reflections({{Matrix::Identity(2, 2), Vector{{-1.0, -0.9e-12}}}},
                     {Vector{{2.0, 0.0}}, 1, true}, {8.0 * eps, "twice u"}, ++index, 21);
  // It is the largest that counts, and not all of them together.
  expect_reflections({{Matrix::Identity(4, 4), Vector{{1.0, 1.0, 1.0, -1.2e-12}}}},
                     {Vector{{0.0, 0.0, 0.0, 2.4e-12}}, 1, true}, {1e-26, "twice u"}, ++index, 21);
  // The speeds grow to 4/3, and the last contact comes at 1.2e-12 in the end.
  const ContactSystem growing{
      Matrix{{1.0, -1.0, -0.45e-12}, {-1.0, 3.0, 0.0}, {-0.45e-12, 0.0, 1.0}},
      Vector{{-1.0, 0.0, 0.0}}};
  expect_reflections({growing}, {Vector{{8.0 / 3.0, 4.0 / 3.0, 2.4e-12}}, 4, true},
                     {64.0 * eps, "four solutions for one contact each"}, ++index, 21);
}

TEST_CASE("Walls that close in on a body cannot be reflected", "[7.5]") {
  for (const auto& [system, e] : {std::pair{between_walls(-1.0, -1.0), 0.0},
                                  {between_walls(-1.0, -1.0), 0.5},
                                  {between_walls(-1.0, -1.0), 1.0},
                                  {between_walls(-3.0, 1.0), 0.0},
                                  {between_walls(-3.0, 1.0), 0.5}}) {
    const Reflecting in{system, e, 5};
    tests::reflections_trial(in).expect_throw<std::domain_error>(
        [&] {
          return lab::multi_contact::generalized_reflections(in.system, in.restitution, in.most)
              .lambda;
        },
        "the walls come, and no impulses open both contacts");
  }
}

TEST_CASE("The least and the most masses and speeds are reflected alike", "[7.5]") {
  int index = 0;
  const Scene scene = tests::cradle(Vector{{1.0, 0.0, 0.0}});
  for (const auto& [yields, speed] : tests::extreme_scales) {
    const double size = speed / yields;
    expect_reflections({{yields * scene.system().A, speed * scene.system().u}, 0.5},
                       {Vector{{5.0, 4.0}} * (size / 6.0), 2, true}, tests::of_solutions(3, size),
                       ++index, 6);
  }
}

TEST_CASE("A matrix that is symmetric but for rounding and any cap are taken", "[7.5]") {
  Reflecting in{tests::cradle(Vector{{1.0, 0.0, 0.0}}).system(), 1.0,
                std::numeric_limits<int>::max()};
  expect_reflections(in, {Vector{{1.0, 1.0}}, 2, true}, tests::of_solutions(2, 1.0), 1, 2);
  in.system.A(0, 1) += 1e-10;
  expect_reflections(in, {Vector{{1.0, 1.0}}, 2, true}, {1e-9, "an entry of A is off by 1e-10"}, 2,
                     2);
}

TEST_CASE("Reflections of bad input are refused", "[7.5]") {
  using lab::multi_contact::generalized_reflections;
  const std::string f = "7.5 generalized_reflections";
  for (const double e : {0.5, 0.0}) {
    for (const int most : {3, 0}) {
      tests::refuse_systems(f, [&](const ContactSystem& bad) {
        return generalized_reflections(bad, e, most).lambda;
      });
    }
  }
  // Also where nothing approaches.
  for (const ContactSystem& system :
       {tests::good_system(), tests::cradle(Vector{{0.0, 0.0, 1.0}}).system()}) {
    tests::refuse(f, tests::bad_fractions(), "restitution",
                  [&](double bad) { return generalized_reflections(system, bad, 3).lambda; });
    for (const double e : {0.5, 0.0}) {
      for (const int bad : {-1, std::numeric_limits<int>::min()}) {
        tests::trial_of(f)
            .given("max_reflections", bad)
            .expect_throw([&] { return generalized_reflections(system, e, bad).lambda; },
                          "a cap is not below zero");
      }
    }
  }
}

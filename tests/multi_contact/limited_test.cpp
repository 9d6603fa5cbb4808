// The bounds of friction, step 7.7.
#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "friction.hpp"
#include "refused.hpp"

using tests::eps;
using tests::FrictionRule;
using tests::Limiting;
using tests::Vec2;

namespace {

struct Within {
  Limiting in;
  Vec2 wanted;
};

void expect_limited(const Limiting& in, const Vec2& wanted, const tests::Bound& bound, int index,
                    int count) {
  const tests::Trial trial = tests::limited_trial(in, index, count);
  trial.expect(tests::limited_by_answer(in, trial), wanted, bound);
}

void expect_limited(const std::vector<Within>& all) {
  int index = 0;
  for (const auto& [in, wanted] : all) {
    expect_limited(in, wanted, {8.0 * eps * in.limit, "a length, a division and products"}, ++index,
                   static_cast<int>(all.size()));
  }
}

/// How far the bounds reach along d: the largest d·x of their points.
double reach(const Vec2& d, double limit, FrictionRule rule) {
  if (rule == FrictionRule::disc) return limit * d.norm();
  const Vec2 size = d.cwiseAbs();
  return limit * (rule == FrictionRule::box ? size.sum() : size.maxCoeff());
}

/// By how much a point is outside of the bounds.
double outside(const Vec2& x, double limit, FrictionRule rule) {
  if (rule == FrictionRule::disc) return x.norm() - limit;
  const Vec2 size = x.cwiseAbs();
  return (rule == FrictionRule::box ? size.maxCoeff() : size.sum()) - limit;
}

}  // namespace

TEST_CASE("A pair is scaled to the disc and cut to the box and shrunk to the diamond", "[7.7]") {
  expect_limited({{{{-3.0, -4.0}, 2.5, FrictionRule::disc}, {-1.5, -2.0}},
                  {{{-3.0, -4.0}, 2.5, FrictionRule::box}, {-2.5, -2.5}},
                  {{{-3.0, -4.0}, 2.5, FrictionRule::diamond}, {-0.75, -1.75}},
                  {{{-3.0, 1.0}, 2.0, FrictionRule::box}, {-2.0, 1.0}},
                  {{{1.5, -3.0}, 2.0, FrictionRule::box}, {1.5, -2.0}},
                  {{{1.0, -2.0}, 2.0, FrictionRule::diamond}, {0.5, -1.5}},
                  {{{6.0, -8.0}, 5.0, FrictionRule::disc}, {3.0, -4.0}}});
}

TEST_CASE("Beyond a corner of the diamond one component is zero", "[7.7]") {
  std::vector<Within> all;
  for (const double sign : {1.0, -1.0}) {
    for (const double other : {1.0, -1.0}) {
      for (const double far : {3.0, 2.5, 2.0}) {  // 2 is the corner's own edge
        const double near = far - 2.0;
        all.push_back(
            {{{sign * far, other * near}, 2.0, FrictionRule::diamond}, {sign * 2.0, 0.0}});
        all.push_back(
            {{{other * near, sign * far}, 2.0, FrictionRule::diamond}, {0.0, sign * 2.0}});
      }
      all.push_back({{{sign * 9.0, other}, 2.0, FrictionRule::diamond}, {sign * 2.0, 0.0}});
    }
  }
  expect_limited(all);
}

TEST_CASE("What is within or on the rim stays as it is", "[7.7]") {
  int index = 0;
  for (const double size : {1.0, 0.1, 1e-100, 1e99}) {
    for (const auto& [pair, rule] : {std::pair{Vec2(0.5, -0.75), FrictionRule::disc},
                                     {Vec2(0.0, -1.0), FrictionRule::disc},
                                     {Vec2(0.0, 0.0), FrictionRule::disc},
                                     {Vec2(0.875, -0.9375), FrictionRule::box},
                                     {Vec2(1.0, -1.0), FrictionRule::box},
                                     {Vec2(0.0, 0.0), FrictionRule::box},
                                     {Vec2(-0.25, 0.5), FrictionRule::diamond},
                                     {Vec2(-0.25, 0.75), FrictionRule::diamond},
                                     {Vec2(0.0, -1.0), FrictionRule::diamond},
                                     {Vec2(0.0, 0.0), FrictionRule::diamond}}) {
      expect_limited({size * pair, size, rule}, size * pair, {0.0, "it is returned as it is"},
                     ++index, 40);
    }
  }
}

TEST_CASE("Without a limit above zero there is no friction", "[7.7]") {
  int index = 0;
  for (const FrictionRule rule : tests::all_rules) {
    for (const Vec2& pair : {Vec2(3.0, -4.0), Vec2(0.0, 1e-100), Vec2(0.0, 0.0)}) {
      expect_limited({pair, 0.0, rule}, Vec2::Zero(), {0.0, "the bounds are one point"}, ++index,
                     9);
    }
  }
}

TEST_CASE("Along an axis all bounds are alike", "[7.7]") {
  std::vector<Within> all;
  for (const FrictionRule rule : tests::all_rules) {
    for (const double sign : {1.0, -1.0}) {
      all.push_back({{{sign * 5.0, 0.0}, 2.0, rule}, {sign * 2.0, 0.0}});
      all.push_back({{{0.0, sign * 5.0}, 2.0, rule}, {0.0, sign * 2.0}});
    }
  }
  expect_limited(all);
}

TEST_CASE("No point within the bounds is nearer", "[7.7]") {
  // x of a convex set is nearest to p if and only if no point y has (p - x)·y > (p - x)·x.
  tests::Random random(771);
  for (int i = 1; i <= 120; ++i) {
    const Limiting in{{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)},
                      random.uniform(0.0, 2.0),
                      tests::all_rules[i % 3]};
    const tests::Trial trial = tests::limited_trial(in, i, 120);
    const Vec2 x = tests::limited_by_answer(in, trial);
    trial.expect(x, x, tests::exact);  // finite
    const Vec2 way = in.tangential - x;
    trial.expect_small("how far it is outside", outside(x, in.limit, in.rule),
                       {8.0 * eps * in.limit, "a length, a division and products"});
    trial.expect_small("by how much another point is nearer",
                       reach(way, in.limit, in.rule) - way.dot(x),
                       {32.0 * eps * 9.0, "products of numbers of up to 3"});
    trial.expect(x, tests::exact_limited(in), {16.0 * eps * 3.0, "as before"});
  }
}

TEST_CASE("Just inside of the bounds nothing changes and just outside it is on the rim", "[7.7]") {
  int index = 0;
  for (const double share : {1.0 - 1e-3, 1.0 - 1e-9, 1.0 - 1e-12, 1.0 + 1e-12, 1.0 + 1e-9, 1.001}) {
    const bool is_inside = share < 1.0;
    const Vec2 pair(3.0, -4.0);
    const tests::Bound bound{is_inside ? 0.0 : 64.0 * eps, "a length, a division and products"};
    expect_limited({share * pair, 5.0, FrictionRule::disc}, is_inside ? share * pair : pair, bound,
                   ++index, 18);
    expect_limited({share * pair, 4.0, FrictionRule::box},
                   Vec2(3.0 * share, std::max(-4.0, -4.0 * share)), bound, ++index, 18);
    const double less = std::max(0.0, 3.5 * (share - 1.0));
    expect_limited({share * pair, 7.0, FrictionRule::diamond},
                   Vec2(3.0 * share - less, -4.0 * share + less), bound, ++index, 18);
  }
}

TEST_CASE("The least and the most impulses are limited alike", "[7.7]") {
  std::vector<Within> all;
  for (const double size : {1e-100, 1e-50, 1e50, 1e99}) {
    for (const double beyond : {1.0, 1e60}) {
      if (size * beyond > 1e100) continue;
      const Vec2 far = beyond * size * Vec2(-3.0, -4.0);
      all.push_back({{far, 2.5 * size, FrictionRule::disc}, size * Vec2(-1.5, -2.0)});
      all.push_back({{far, 2.5 * size, FrictionRule::box}, size * Vec2(-2.5, -2.5)});
      const Vec2 diamond = beyond == 1.0 ? Vec2(-0.75, -1.75) : Vec2(0.0, -2.5);
      all.push_back({{far, 2.5 * size, FrictionRule::diamond}, size * diamond});
    }
  }
  expect_limited(all);
}

TEST_CASE("A bound of bad input is refused", "[7.7]") {
  using tests::infinite;
  using tests::not_a_number;
  const std::string f = "7.7 limited";
  for (const FrictionRule rule : tests::all_rules) {
    for (const Vec2& good : {Vec2(3.0, 4.0), Vec2(0.0, 0.0)}) {
      tests::refuse(f, tests::bad_not_negative(), "limit",
                    [&](double bad) { return lab::multi_contact::limited(good, bad, rule); });
    }
    const std::vector<tests::Bad<Vec2>> pairs{{{not_a_number, 0.0}, "t is NaN"},
                                              {{0.0, not_a_number}, "s is NaN"},
                                              {{infinite, 0.0}, "t is infinite"},
                                              {{0.0, -infinite}, "s is infinite"}};
    for (const double limit : {0.0, 1.0}) {
      tests::refuse(f, pairs, "tangential",
                    [&](const Vec2& bad) { return lab::multi_contact::limited(bad, limit, rule); });
    }
  }
}

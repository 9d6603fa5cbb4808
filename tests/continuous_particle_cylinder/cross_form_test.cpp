#include <functional>

#include "bad_input.hpp"
#include "catch.hpp"
#include "cross_form_beliefs.hpp"
#include "judge_ties.hpp"
#include "narrow.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::eps;
using tests::Query;
using tests::Time;

namespace {

using tests::cross_form;
using tests::missed_by_rounded_end;
using tests::missed_by_rounded_graze;
using tests::missed_by_rounded_start;

const std::string cross_form_step = "4.2 time_of_impact";

tests::TimeSuspects cross_form_suspects(const Query& query) {
  return tests::explaining(cross_form, query, tests::beliefs_of_cross_form);
}

tests::Trial cross_form_trial(const Query& query, int index, int count) {
  return tests::trial(cross_form_step, query, index, count).suspecting([] {
    return tests::nan_without_root(cross_form);
  });
}

/// Where nothing is ill-conditioned: the line passes within 0.7 ρ and the start is 1.5 ρ away or
/// more, so that neither the discriminant nor c loses more than the half of its size.
Query deep_query(tests::Random& random, double distance, double speed) {
  return tests::aimed(random, {distance, random.uniform(-0.7, 0.7), speed});
}

/// Of t*, by c as the handout has it and any hypot, in units u = eps/2 of what each is off by at
/// most. The start is d ρ, the line h ρ off: d = 1.5 and h = 0.7 are the worst.
///   c       by ρ: 2/(d² − 1) = 1.6; (4) is off by 3 of itself, the other square by 1: 3 at most
///           of both; their sum 1. Together 5.6
///   ρ|v|    ρ 1, hypot 2, the product 1: 4;  w: 3, by (4)
///   √D      (2 · 4 + 2 · 3 h²)/(1 − h²) = 21.5 of D, and 3 for its operations: half, and 1: 13.2
///   −b + √D 3 of −b and 13.2 of √D, which are as √(d² − h²) to √(1 − h²): 6.6, and 1: 7.6
///   t       5.6 + 7.6 and 1: 14.2 u = 7.1 eps. What is wanted is rounded, too: half an eps
constexpr double deep_bound = 8.0 * eps;

void expect_deep(const Query& query, int index, int count,
                 const std::function<tests::TimeSuspects()>& suspects) {
  const auto trial = cross_form_trial(query, index, count);
  const Time got{trial.returned([&] { return cross_form(query); })};
  const Time wanted = tests::time_of(query);
  trial.expect(got, wanted,
               {deep_bound * wanted.seconds.value_or(0.0),
                "a root of a difference; the test derives this bound"},
               suspects);
}
void expect_deep(const Query& query, int index, int count) {
  expect_deep(query, index, count, [&] { return cross_form_suspects(query); });
}

/// The path is a miss, and so it is for a cylinder that is wider by 64 eps and lasts as much
/// longer: no rounding of a few operations may make a hit of it.
bool clearly_missed(Query query) {
  query.cylinder.radius += 64.0 * eps * tests::rho(query);
  query.dt *= 1.0 + 64.0 * eps;
  return !tests::exact_time(query);
}

tests::TimeSuspects none() { return {}; }

/// No impact is missed; a miss is one where it is clear.
/// missed  what it may be if an impact is missed
void expect_not_missed(const Query& query, int index, int count,
                       tests::TimeSuspects (*missed)() = none) {
  const auto trial = cross_form_trial(query, index, count);
  const Time got{trial.returned([&] { return cross_form(query); })};
  const Time wanted = tests::time_of(query);
  if (wanted.seconds && !got.seconds) {
    trial.expect(got, wanted, {0.0, "no impact may be missed"}, missed);
  }
  if (!wanted.seconds && got.seconds && clearly_missed(query)) {
    trial.expect(got, wanted, {0.0, "the path stays outside by more than 64 eps"},
                 [&] { return cross_form_suspects(query); });
  }
  const double t = got.seconds.value_or(0.0);
  trial.expect_small("time out of [0, dt]", std::max(-t, t - query.dt) + 0.0 * t,
                     {0.0, "the time of an impact is in [0, dt]"});
}

void expect_none_missed(Query (*draw)(tests::Random&), int seed, int count = 400,
                        tests::TimeSuspects (*missed)() = none) {
  tests::Random random(static_cast<std::uint64_t>(seed));
  for (int i = 1; i <= count; ++i) expect_not_missed(draw(random), i, count, missed);
}

/// It starts inside and leaves, but |x| by hypot is above ρ. If hypot rounds right, there is none
/// in so many draws, and if not, there is one in some 7000.
Query outside_by_hypot(tests::Random& random) {
  Query query = tests::leaving_query(random);
  for (int draws = 1; draws < 20000; ++draws) {
    const Vec3& x = query.particle.position;
    const bool seems_outside = std::hypot(x.y(), x.z()) > tests::rho(query);
    if (seems_outside && tests::quadratic(query).c <= 0) break;
    query = tests::leaving_query(random);
  }
  return query;
}

}  // namespace

TEST_CASE("The cross form is right on paths of whole numbers", "[4.2]") {
  const auto cases = tests::hand_cases();
  int index = 0;
  for (const auto& [query, time] : cases) {
    const auto trial = cross_form_trial(query, ++index, static_cast<int>(cases.size()));
    trial.expect(Time{trial.returned([&, &q = query] { return cross_form(q); })}, Time{time},
                 {8.0 * eps * time.value_or(0.0), "4 ulp"},
                 [&, &q = query] { return cross_form_suspects(q); });
  }
}

TEST_CASE("The cross form counts touches at the start and in passing and at dt", "[4.2]") {
  const auto ties = tests::ties();
  int index = 0;
  for (const tests::Tie& tie : ties) {
    const auto trial = cross_form_trial(tie.query, ++index, static_cast<int>(ties.size()));
    // Deeper by 64 eps of ρ the line would enter √(2 · 64 eps) ρ earlier.
    const double way = std::sqrt(128.0 * eps) * tests::rho(tie.query);
    tests::expect_tie(
        trial, cross_form, tie,
        {way,
         "at a touch in passing an error of a few eps in depth is one of a root of eps in time"},
        [&] { return cross_form_suspects(tie.query); });
  }
}

TEST_CASE("On deep paths the cross form is right to 8 eps near and far and at any speed", "[4.2]") {
  tests::Random random(424);
  for (int i = 1; i <= 600; ++i) {
    const double distance =
        i % 2 == 0 ? random.uniform(1.5, 5.0) : tests::power_of_ten(random, 0.2, 8.5);
    const double speed = tests::power_of_ten(random, -9.0, 9.0);
    expect_deep(deep_query(random, distance, speed), i, 600);
  }
}

TEST_CASE("Far off the cross form keeps the digits that the textbook loses", "[4.2]") {
  // Along −y at a whole speed, 2^k away: here b² − a c as a difference of rounded squares is 0, and
  // the root of that the time of the closest approach.
  int index = 0;
  for (int k = 28; k <= 45; ++k) {
    for (const double z : {0.0, 0.5, -0.75}) {
      const double D = std::ldexp(1.0, k);
      const Query query = tests::query({3.0, D, z}, {0.0, -2.0, 0.0}, D, 0.75, 0.5);
      const auto suspects = [&] {
        auto all = cross_form_suspects(query);
        all.push_back({{0.5 * D},
                       "the discriminant cancels, because far off b^2 - a c of rounded squares is "
                       "noise: use the cross product"});
        return all;
      };
      expect_deep(query, ++index, 54, suspects);
    }
  }
}

TEST_CASE("Time scales as length over speed from 1e-60 to 1e60", "[4.2]") {
  tests::Random random(425);
  for (int i = 1; i <= 200; ++i) {
    const Query query = deep_query(random, random.uniform(1.5, 5.0), 1.0);
    const int length = static_cast<int>(random.uniform(-170.0, 170.0));
    const int speed = static_cast<int>(random.uniform(-170.0, 170.0));
    expect_deep(tests::scaled(query, length, speed), i, 200);
  }
}

TEST_CASE("The cross form misses no generic impact and finds no clear miss", "[4.2]") {
  expect_none_missed(tests::generic_query, 426);
}

TEST_CASE("The cross form misses no impact far off", "[4.2]") {
  expect_none_missed(tests::far_query, 427);
}

TEST_CASE("The cross form misses no impact of a fast particle", "[4.2]") {
  expect_none_missed(tests::fast_query, 428);
}

TEST_CASE("The cross form misses no impact of a slow particle next to the surface", "[4.2]") {
  expect_none_missed(tests::slow_query, 429);
}

// Here |x| − ρ is rounding alone, and no later contact makes up for a start that is missed.
TEST_CASE("The cross form misses no start on the surface of a particle that leaves", "[4.2]") {
  expect_none_missed(tests::leaving_query, 4216, 1000, missed_by_rounded_start);
  expect_none_missed(outside_by_hypot, 4217, 20, missed_by_rounded_start);
}

TEST_CASE("The cross form misses no grazing impact", "[4.2]") {
  expect_none_missed(tests::grazing_query, 4210, 1000, missed_by_rounded_graze);
}

TEST_CASE("The cross form misses no oblique grazing impact from near or far", "[4.2]") {
  tests::Random random(4214);
  std::vector<Query> queries;
  queries.reserve(1000);
  for (int i = 0; i < 1000; ++i) queries.push_back(tests::oblique_grazing_query(random));
  int index = 0;
  for (const Query& query : queries) {
    const auto trial = cross_form_trial(query, ++index, 1000);
    const Time got{trial.returned([&] { return cross_form(query); })};
    const Time wanted = tests::time_of(query);
    if (!wanted.seconds || got.seconds) continue;
    trial.expect(got, wanted, {0.0, "no impact may be missed"}, [&] {
      return tests::misses_by_rounded_products(queries)
                 ? tests::TimeSuspects{{{},
                                        "the products of x × v are rounded before they cancel: use "
                                        "difference_of_products"}}
                 : missed_by_rounded_graze();
    });
  }
  for (index = 1; index <= 1000; ++index) {
    expect_not_missed(queries[static_cast<std::size_t>(index) - 1], index, 1000);
  }
}

TEST_CASE("The cross form finds no impact if a path stays just outside", "[4.2]") {
  tests::expect_narrow_misses_missed(cross_form_step, cross_form, 4215);
}

TEST_CASE("The cross form misses no impact within an ulp of dt", "[4.2]") {
  expect_none_missed(
      [](tests::Random& random) {
        return tests::ending_at_impact(random, tests::generic_query(random));
      },
      4211, 1000, missed_by_rounded_end);
}

TEST_CASE("The cross form misses no touch between whole numbers", "[4.2]") {
  expect_none_missed(tests::lattice_query, 4212, 1000);
}

TEST_CASE("The cross form misses no touch of large whole numbers", "[4.2]") {
  expect_none_missed(tests::pythagorean_query, 4213, 400, missed_by_rounded_graze);
}

TEST_CASE("The cross form refuses bad arguments", "[4.2]") {
  tests::expect_bad_queries_throw(cross_form_step, cross_form);
}

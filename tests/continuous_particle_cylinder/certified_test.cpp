#include <concepts>

#include "bad_input.hpp"
#include "catch.hpp"
#include "certified_beliefs.hpp"
#include "judge_ties.hpp"
#include "narrow.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::Query;
using tests::Time;

namespace {

const std::string certified_step = "4.3 time_of_impact_certified";

using tests::certified;

tests::TimeSuspects certified_suspects(const Query& query) {
  const tests::TimeSuspects suspects =
      tests::explaining(certified, query, tests::beliefs_of_cross_form);
  return suspects.empty() ? tests::suspects_of_digits(query) : suspects;
}

tests::Trial certified_trial(const Query& query, int index, int count) {
  return tests::trial(certified_step, query, index, count).suspecting([] {
    return tests::nan_without_root(certified);
  });
}

tests::TimeSuspects none() { return {}; }

/// suspects  of no argument, as in Trial::expect
template <std::invocable Suspects>
void expect_certain(const Query& query, int index, int count, const Suspects& suspects) {
  const auto trial = certified_trial(query, index, count);
  const Time got{trial.returned([&] { return certified(query); })};
  tests::expect_exact(trial, got, query, 1.0, suspects);
}

template <typename Draw>
void expect_all_certain(const Draw& draw, int seed, int count) {
  tests::Random random(static_cast<std::uint64_t>(seed));
  for (int i = 1; i <= count; ++i) {
    const Query query = draw(random);
    expect_certain(query, i, count, [&] { return certified_suspects(query); });
  }
}

/// The same where rounding or a double's range decides: lost digits may be named, by default.
template <typename Draw>
void expect_all_hard_certain(
    const Draw& draw, int seed, int count,
    tests::TimeSuspects (*suspects)(const Query&) = tests::suspects_of_digits) {
  tests::Random random(static_cast<std::uint64_t>(seed));
  for (int i = 1; i <= count; ++i) {
    const Query query = draw(random);
    expect_certain(query, i, count, [&] { return suspects(query); });
  }
}

/// By powers of two to either end of a double's range; dt is kept finite.
Query at_any_scale(tests::Random& random, const Query& query) {
  const int length = static_cast<int>(random.uniform(-1074.0, 1000.0));
  const double lowest = std::max(-1074.0, length - 1000.0);
  Query moved = tests::scaled(query, length, static_cast<int>(random.uniform(lowest, 1000.0)));
  for (double* radius : {&moved.particle.radius, &moved.cylinder.radius}) {
    *radius = std::max(*radius, std::numeric_limits<double>::denorm_min());
  }
  return moved;
}

/// A path to the cylinder along y, every size of its own: start, offset, drift, radii.
Query mixed_query(tests::Random& random) {
  const auto power = [&](double low, double high) {
    return std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.uniform(low, high)));
  };
  const double size = power(-400.0, 400.0);
  const double D = size * power(0.0, 300.0);
  const double speed = power(-200.0, 200.0);
  const double time = D / speed;
  const double sign = random.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  Query query;
  query.cylinder.radius = size;
  query.particle.radius = size * power(-120.0, 1.0);
  query.particle.position = {0.0, sign * D, size * random.uniform(-3.0, 3.0) * power(-60.0, 0.0)};
  query.particle.velocity = {0.0, -sign * speed,
                             size / time * random.uniform(-3.0, 3.0) * power(-60.0, 0.0)};
  query.dt = time * random.uniform(0.5, 2.0);
  return query;
}

Query wild_query(tests::Random& random) {
  const auto number = [&] { return tests::any_number(random); };
  Query query;
  for (double& x : query.particle.position) x = number();
  for (double& v : query.particle.velocity) v = number();
  query.particle.radius = std::abs(number());
  query.cylinder.radius = std::abs(number());
  query.dt = std::abs(number());
  return query;
}

}  // namespace

TEST_CASE("The certified root is right on paths of whole numbers", "[4.3]") {
  const auto cases = tests::hand_cases();
  int index = 0;
  for (const auto& [query, time] : cases) {
    expect_certain(query, ++index, static_cast<int>(cases.size()),
                   [&, &q = query] { return certified_suspects(q); });
  }
}

TEST_CASE("The certified root counts touches and nothing next to them", "[4.3]") {
  const auto ties = tests::ties();
  const auto count = static_cast<int>(ties.size());
  int index = 0;
  for (const tests::Tie& tie : ties) {
    const auto trial = certified_trial(tie.query, ++index, count);
    tests::expect_tie(trial, certified, tie,
                      {2.0 * tests::eps * tie.time, "1 ulp of t, as the contract says"},
                      [&] { return certified_suspects(tie.query); });
    // r, R, dt by one ulp: 1 + 4 is ρ exactly, however small the difference.
    Query query = tie.query;
    query.particle.radius = std::nextafter(query.particle.radius, 0.0);
    expect_certain(query, index, count, none);
    query = tie.query;
    query.cylinder.radius = std::nextafter(query.cylinder.radius, 0.0);
    expect_certain(query, index, count, none);
    query = tie.query;
    if (query.dt > 0.0) query.dt = std::nextafter(query.dt, 0.0);
    expect_certain(query, index, count, none);
  }
}

TEST_CASE("The certified root is right to one ulp on generic paths", "[4.3]") {
  expect_all_certain(tests::generic_query, 431, 1000);
}

TEST_CASE("The certified root is right to one ulp far off", "[4.3]") {
  expect_all_certain(tests::far_query, 432, 500);
}

TEST_CASE("The certified root is right to one ulp at a million radii per step", "[4.3]") {
  expect_all_certain(tests::fast_query, 433, 500);
}

TEST_CASE("The certified root is right to one ulp for very slow paths next to the surface",
          "[4.3]") {
  expect_all_hard_certain(tests::slow_query, 434, 500);
}

TEST_CASE("The certified root is right for paths that leave the surface", "[4.3]") {
  expect_all_hard_certain(tests::leaving_query, 4316, 500);
}

TEST_CASE("The certified root is right on paths that graze by an ulp", "[4.3]") {
  expect_all_hard_certain(tests::grazing_query, 435, 1000);
}

TEST_CASE("The certified root is right on oblique paths that graze from near or far", "[4.3]") {
  expect_all_hard_certain(tests::oblique_grazing_query, 4314, 500);
}

TEST_CASE("The certified root finds nothing if a path stays outside by a few ulp", "[4.3]") {
  tests::expect_narrow_misses_missed(certified_step, certified, 4315,
                                     {8.0 * tests::eps, 256.0 * tests::eps, 1e-12, 1e-9, 5e-8});
}

TEST_CASE("The certified root is right if the impact is within an ulp of dt", "[4.3]") {
  expect_all_hard_certain(
      [](tests::Random& random) {
        return tests::ending_at_impact(random, tests::generic_query(random));
      },
      436, 1000, tests::suspects_of_arrival);
}

TEST_CASE("The certified root is right between whole numbers where many paths touch", "[4.3]") {
  expect_all_hard_certain(tests::lattice_query, 437, 1000);
}

TEST_CASE("The certified root is right if 106 bits cannot decide a touch", "[4.3]") {
  expect_all_hard_certain(tests::pythagorean_query, 4312, 300, tests::suspects_of_sign);
}

TEST_CASE("The sum of the radii is not rounded", "[4.3]") {
  tests::Random random(4313);
  for (int i = 1; i <= 100; ++i) {
    const Query query = tests::rounded_sum_query(random);
    Query wide = query;
    wide.cylinder.radius = query.particle.position.z();
    expect_certain(query, i, 100, [&] {
      return tests::TimeSuspects{
          {tests::rounded(tests::first_time(tests::quadratic(wide, 0.0), query.dt)),
           "R + r is rounded to a double: use the exact sum"}};
    });
  }
}

TEST_CASE("The certified root is right at every scale down to the last subnormal", "[4.3]") {
  expect_all_hard_certain(
      [](tests::Random& random) { return at_any_scale(random, tests::generic_query(random)); }, 438,
      300);
  expect_all_hard_certain(
      [](tests::Random& random) { return at_any_scale(random, tests::lattice_query(random)); }, 439,
      300);
}

TEST_CASE("The certified root is right if all numbers have different orders of magnitude",
          "[4.3]") {
  expect_all_hard_certain(mixed_query, 4310, 300);
  expect_all_hard_certain(wild_query, 4311, 300);
}

TEST_CASE("The certified root refuses bad arguments", "[4.3]") {
  tests::expect_bad_queries_throw(certified_step, certified);
}

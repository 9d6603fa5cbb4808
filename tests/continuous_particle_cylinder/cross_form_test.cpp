#include "bad_input.hpp"
#include "catch.hpp"
#include "judge_ties.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::eps;
using tests::Query;
using tests::Time;

namespace {

const std::string cross_form_step = "4.2 time_of_impact";

std::optional<double> cross_form(const Query& query) {
  return time_of_impact(query.particle, query.cylinder, query.dt);
}

/// Where nothing is ill-conditioned: the line passes within 0.7 ρ and the start is 1.5 ρ away or
/// more, so that neither the discriminant nor c loses more than the half of its size.
Query deep_query(tests::Random& random, double distance, double speed) {
  return tests::aimed(random, {distance, random.uniform(-0.7, 0.7), speed});
}

void expect_four_ulp(const Query& query, int index, int count) {
  const auto trial = tests::trial(cross_form_step, query, index, count);
  const Time got{trial.returned([&] { return cross_form(query); })};
  tests::expect_exact(trial, got, query, 4.0);
}

/// The path is a miss, and so it is for a cylinder that is wider by 64 eps and lasts as much
/// longer: no rounding of a few operations may make a hit of it.
bool clearly_missed(Query query) {
  query.cylinder.radius += 64.0 * eps * tests::rho(query);
  query.dt *= 1.0 + 64.0 * eps;
  return !tests::exact_time(query);
}

/// No impact is missed; a miss is one where it is clear.
void expect_not_missed(const Query& query, int index, int count) {
  const auto trial = tests::trial(cross_form_step, query, index, count);
  const Time got{trial.returned([&] { return cross_form(query); })};
  const Time wanted = tests::time_of(query);
  if (wanted.seconds && !got.seconds) trial.expect(got, wanted, {0.0, "no impact is missed"});
  if (!wanted.seconds && got.seconds && clearly_missed(query)) {
    trial.expect(got, wanted, {0.0, "it passes by more than 64 eps"},
                 [&] { return tests::suspects_of(query); });
  }
  const double t = got.seconds.value_or(0.0);
  trial.expect_small("time out of [0, dt]", std::max(-t, t - query.dt) + 0.0 * t,
                     {0.0, "an impact is in [0, dt]"});
}

void expect_none_missed(Query (*draw)(tests::Random&), int seed, int count = 400) {
  tests::Random random(static_cast<std::uint64_t>(seed));
  for (int i = 1; i <= count; ++i) {
    expect_not_missed(draw(random), i, count);
  }
}

}  // namespace

TEST_CASE("The cross form is right on paths of whole numbers", "[4.2]") {
  const auto cases = tests::hand_cases();
  int index = 0;
  for (const auto& [query, time] : cases) {
    const auto trial =
        tests::trial(cross_form_step, query, ++index, static_cast<int>(cases.size()));
    trial.expect(Time{trial.returned([&, &q = query] { return cross_form(q); })}, Time{time},
                 {8.0 * eps * time.value_or(0.0), "4 ulp"},
                 [&, &q = query] { return tests::suspects_of(q); });
  }
}

TEST_CASE("The cross form counts touches at the start and in passing and at dt", "[4.2]") {
  const auto ties = tests::ties();
  int index = 0;
  for (const tests::Tie& tie : ties) {
    const auto trial =
        tests::trial(cross_form_step, tie.query, ++index, static_cast<int>(ties.size()));
    // Deeper by 64 eps of ρ the line would enter √(2 · 64 eps) ρ earlier.
    const double way = std::sqrt(128.0 * eps) * tests::rho(tie.query);
    tests::expect_tie(trial, cross_form, tie,
                      {way, "at a touch in passing a few eps of depth are a root of eps of time"},
                      [&] { return tests::suspects_of(tie.query); });
  }
}

TEST_CASE("On deep paths the cross form is right to four ulp near and far and at any speed",
          "[4.2]") {
  tests::Random random(424);
  for (int i = 1; i <= 600; ++i) {
    const double distance =
        i % 2 == 0 ? random.uniform(1.5, 5.0) : tests::power_of_ten(random, 0.2, 8.5);
    const double speed = tests::power_of_ten(random, -9.0, 9.0);
    expect_four_ulp(deep_query(random, distance, speed), i, 600);
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
        auto all = tests::suspects_of(query);
        all.push_back(
            {{0.5 * D}, "the discriminant cancels: far off b^2 - a c of rounded squares is noise"});
        return all;
      };
      const auto trial = tests::trial(cross_form_step, query, ++index, 54);
      tests::expect_exact(trial, Time{trial.returned([&] { return cross_form(query); })}, query,
                          4.0, suspects);
    }
  }
}

TEST_CASE("Time goes as length over speed from 1e-60 to 1e60", "[4.2]") {
  tests::Random random(425);
  for (int i = 1; i <= 200; ++i) {
    const Query query = deep_query(random, random.uniform(1.5, 5.0), 1.0);
    const int length = static_cast<int>(random.uniform(-170.0, 170.0));
    const int speed = static_cast<int>(random.uniform(-170.0, 170.0));
    expect_four_ulp(tests::scaled(query, length, speed), i, 200);
  }
}

TEST_CASE("The cross form misses no generic impact and finds none that is clearly missed",
          "[4.2]") {
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

TEST_CASE("The cross form misses no grazing impact", "[4.2]") {
  expect_none_missed(tests::grazing_query, 4210, 1000);
}

TEST_CASE("The cross form misses no impact within an ulp of dt", "[4.2]") {
  expect_none_missed(
      [](tests::Random& random) {
        return tests::ending_at_impact(random, tests::generic_query(random));
      },
      4211, 1000);
}

TEST_CASE("The cross form misses no touch between whole numbers", "[4.2]") {
  expect_none_missed(tests::lattice_query, 4212, 1000);
}

TEST_CASE("The cross form misses no touch of large whole numbers", "[4.2]") {
  expect_none_missed(tests::pythagorean_query, 4213);
}

TEST_CASE("The cross form refuses bad arguments", "[4.2]") {
  tests::expect_bad_queries_throw(cross_form_step, cross_form);
}

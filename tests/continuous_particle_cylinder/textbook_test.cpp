#include <algorithm>

#include "bad_input.hpp"
#include "catch.hpp"
#include "judge_ties.hpp"
#include "narrow.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::eps;
using tests::Query;
using tests::Time;

namespace {

const std::string textbook_step = "4.1 time_of_impact_textbook";
const std::string not_the_textbook =
    "this is not the textbook's formula, because it is too exact far off: write eq. (3) as it "
    "stands";

std::optional<double> textbook(const Query& query) {
  return time_of_impact_textbook(query.particle, query.cylinder, query.dt);
}

tests::TimeSuspects textbook_suspects(const Query& query) {
  return tests::explaining(textbook, query, tests::beliefs_of_textbook);
}

tests::Trial textbook_trial(const Query& query, int index = 1, int count = 1) {
  return tests::trial(textbook_step, query, index, count).suspecting([] {
    return tests::nan_without_root(textbook);
  });
}

/// The way from the exact place of impact to that of a time, in units of ρ.
double place_error(const Query& query, double time) {
  const tests::Digits50 exact = *tests::exact_time(query);
  const Vec3& v = query.particle.velocity;
  return static_cast<double>(tests::Digits50(abs(tests::Digits50(time) - exact))) *
         std::hypot(v.y(), v.z()) / tests::rho(query);
}

/// See the derivation at the test of the loss by distance.
double largest_place_error(double distance, double offset) {
  const double half_chord = std::sqrt(1.0 - offset * offset);
  return (5.5 * distance * distance / half_chord + 8.0 * distance) * eps;
}

}  // namespace

TEST_CASE("The textbook root is right on paths of whole numbers", "[4.1]") {
  const auto cases = tests::hand_cases();
  int index = 0;
  for (const auto& [query, time] : cases) {
    const auto trial = textbook_trial(query, ++index, static_cast<int>(cases.size()));
    trial.expect(Time{trial.returned([&, &q = query] { return textbook(q); })}, Time{time},
                 {4.0 * eps * time.value_or(0.0), "whole numbers, so only the division may round"},
                 [&, &q = query] { return textbook_suspects(q); });
  }
}

TEST_CASE("The textbook root counts touches at the start and in passing and at dt", "[4.1]") {
  const auto ties = tests::ties();
  int index = 0;
  for (const tests::Tie& tie : ties) {
    tests::expect_tie(textbook_trial(tie.query, ++index, static_cast<int>(ties.size())), textbook,
                      tie, {4.0 * eps * tie.time, "whole numbers, so everything is exact"},
                      [&] { return textbook_suspects(tie.query); });
  }
}

TEST_CASE("Near size one the textbook root is right up to rounding", "[4.1]") {
  tests::Random random(411);
  for (int i = 1; i <= 300; ++i) {
    const double distance = random.uniform(1.1, 5.0);
    const double offset = random.uniform(-0.9, 0.9);
    Query query = tests::aimed(random, {distance, offset, random.uniform(0.5, 2.0)});
    if (i % 3 == 0) query.dt *= 0.1;  // too short for most
    if (i % 4 == 0) query.particle.velocity *= -1.0;
    const Time wanted = tests::time_of(query);
    if (wanted.seconds && *wanted.seconds > 0.999 * query.dt) continue;  // rounding may decide
    const double bound = largest_place_error(distance, offset) * tests::rho(query) /
                         std::hypot(query.particle.velocity.y(), query.particle.velocity.z());
    textbook_trial(query, i, 300)
        .expect(Time{textbook(query)}, wanted,
                {bound, "eleven roundings in b^2 - 4 a c, each relative to b^2"},
                [&] { return textbook_suspects(query); });
  }
}

// With D the distance of the start and h the offset of the line, in units of ρ, D ≫ 1:
// b² ≈ 4 D² |v|², and b² − 4 a c = 4 |v|² (1 − h²), by D² smaller. An error δ of the discriminant
// moves the place of impact by |v| δ / (4 a √(b² − 4 a c)) = δ / (8 |v|² √(1 − h²)).
// At most: 5 half-ulp in b², 6 in 4 a c, so δ ≤ 5.5 eps b² and the place is off by
// 2.75 eps D² / √(1 − h²); the square root's own curve can double that, and the two
// roundings of −b − √ add some eps D.
// At least: of all the roundings take that of b² alone, evenly spread over ± half an ulp of it, no
// less than ± eps b²/4. Whatever the rest is, |δ| stays below eps b²/8 for no more than half of all
// paths: the median of the place's error is eps D²/16 or more.
TEST_CASE("The textbook root loses digits with the square of the distance", "[4.1]") {
  tests::Random random(412);
  for (const double distance : {1e2, 1e3, 1e4, 1e5, 1e6, 1e7}) {
    std::vector<double> errors;
    Query query;
    for (int i = 1; i <= 201; ++i) {
      query = tests::aimed(random, {distance, random.uniform(-0.5, 0.5), 1.0});
      const auto trial = textbook_trial(query, i, 201);
      const Time got{textbook(query)};
      const double way = largest_place_error(distance, 0.5);
      trial.expect(got, tests::time_of(query),
                   {way * tests::rho(query), "5.5 eps |x|^2/sqrt(1 - beta^2), in rho"},
                   [&] { return textbook_suspects(query); });
      errors.push_back(place_error(query, *got.seconds));
    }
    std::nth_element(errors.begin(), errors.begin() + 100, errors.end());
    const double least = distance * distance * eps / 16.0;
    textbook_trial(query).expect_small(
        "eps |x|^2/16 over the median error of the place", least / errors[100],
        {1.0, "the rounding of b^2 alone makes an error of this size"},
        "this is not the textbook's formula, because it is too exact far off: write "
        "eq. (3) as it stands");
  }
}

TEST_CASE("Very far off the textbook root misses hits and finds false ones", "[4.1]") {
  // At 1e9 ρ the discriminant, 4 |v|² (ρ² − h²), is below an ulp of b²: what is left is noise.
  tests::Random random(413);
  int missed = 0;
  int false_hits = 0;
  Query query;
  for (int i = 0; i < 400; ++i) {
    query = tests::aimed(random, {1e9, i % 2 == 0 ? 0.0 : 3.0, 1.0});
    const Time got{textbook(query)};
    // Whatever of it is a time must be one: the noise may not reach the answer as NaN.
    textbook_trial(query).expect_small(
        "time out of [0, dt]",
        got.seconds ? std::max({0.0, -*got.seconds, *got.seconds - query.dt}) + 0.0 * *got.seconds
                    : 0.0,
        {0.0, "the time of an impact is in [0, dt]"});
    if (i % 2 == 0 && !got.seconds) ++missed;
    if (i % 2 == 1 && got.seconds) ++false_hits;
  }
  // Only where neither happens are the digits there: a mistake may miss all alike.
  const bool too_good = missed == 0 && false_hits == 0;
  const std::string likely = too_good ? not_the_textbook : "";
  const auto trial = textbook_trial(query);
  trial.expect_small("1 - hits missed", 1.0 - missed, {0.0, "200 paths through the axis"}, likely);
  trial.expect_small("1 - false hits", 1.0 - false_hits, {0.0, "200 paths that pass at 3 rho"},
                     likely);
}

TEST_CASE("Near size one the textbook root finds nothing if a path stays just outside", "[4.1]") {
  // Up to 5 ρ away the discriminant is off by 5.5 eps · 25 of 4 a ρ², and 1e-12 is 4504 eps.
  tests::expect_narrow_misses_missed(textbook_step, textbook, 414, {1e-12, 1e-10, 1e-9, 5e-8});
}

TEST_CASE("The textbook root refuses bad arguments", "[4.1]") {
  tests::expect_bad_queries_throw(textbook_step, textbook);
}

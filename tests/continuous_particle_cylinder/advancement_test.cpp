#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "advancement.hpp"
#include "bad_input.hpp"
#include "catch.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::eps;
using tests::infinity;
using tests::Query;
using tests::Time;

TEST_CASE("A particle that moves straight to the axis arrives in one step", "[4.3]") {
  const Query query = tests::query({0, 10, 0}, {0, -2, 0}, 10.0);
  tests::expect_sequence(query, 1e-6);
  const Advancement got = tests::advanced(query, 1e-6);
  tests::advancement_trial(query, 1e-6).expect(Time{got.time}, Time{2.5}, {8.0 * eps, "5/2"});
  tests::advancement_trial(query, 1e-6)
      .expect(static_cast<double>(got.iterations), 2.0, {0.0, "before and after"});
}

TEST_CASE("Advancement follows its sequence step by step", "[4.3]") {
  const auto cases = tests::hand_cases();
  int index = 0;
  for (const auto& [query, time] : cases) {
    tests::expect_sequence(query, 1e-6, ++index, static_cast<int>(cases.size()));
  }
  tests::Random random(4321);
  for (int i = 1; i <= 150; ++i) {
    const double distance = random.uniform(1.1, 5.0);
    Query query = tests::aimed(
        random, {distance, random.uniform(-1.1, 1.1), tests::power_of_ten(random, -1.0, 1.0)});
    query.dt *= random.uniform(0.2, 1.0);
    tests::expect_sequence(query, tests::power_of_ten(random, -9.0, -2.0), i, 150);
  }
}

TEST_CASE("Advancement is never late and early only by its tolerance", "[4.3]") {
  tests::Random random(4322);
  for (int i = 1; i <= 200; ++i) {
    const double distance = random.uniform(1.1, 5.0);
    const Query query = tests::aimed(
        random, {distance, random.uniform(-1.05, 1.05), tests::power_of_ten(random, -3.0, 3.0)});
    tests::expect_between(query, tests::power_of_ten(random, -8.0, -2.0), i, 200);
  }
}

// A gap φ above a plane that is met at the angle θ to its normal: the way φ brings it φ cos θ down.
// The cylinder's curve changes the ratio 1 − cos θ by some 13 φ/ρ of itself for the flattest
// of these angles, which all in all, below φ = 1e-4 ρ, is less than one advance.
TEST_CASE("At an angle of incidence each iteration multiplies the gap by 1 - cos", "[4.3]") {
  for (const double degrees : {30.0, 45.0, 60.0, 75.0, 85.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double ratio = 1.0 - std::cos(angle);
    const double more = std::floor(std::log(1e-6) / std::log(ratio));
    const double coarse = 1e-4;
    const double fine = coarse * std::pow(ratio, more);
    const Query query = tests::query({0, 3, std::sin(angle)}, {0, -1, 0}, 10.0, 0.75, 0.25);
    const Advancement first = tests::advanced(query, coarse);
    const Advancement second = tests::advanced(query, fine);
    tests::advancement_trial(query, fine)
        .expect(Time{second.time}, tests::time_of(query),
                {1.01 * fine / std::cos(angle), "the time that the tolerance saves"});
    tests::advancement_trial(query, fine)
        .expect_small(
            "iterations between tolerance 1e-4 and this one, minus ln(ratio)/ln(1 - cos)",
            std::abs(second.iterations - first.iterations - more),
            {1.0, "each iteration multiplies the gap by 1 - cos; the first gap may cost one more"});
  }
}

// With s the way left to the point of tangency and ρ = 1, φ = √(1 + s²) − 1, and u = 1/s grows by
// 1/(√(1 + s²) + 1 − s) an advance: by 1/2 or more, and, from s = 1 on, by 1/2 + 1/(k + 2) or less
// at advance k. It ends at s = √(2 tolerance), about, where u = N/2 with N = √(2/tolerance).
TEST_CASE("At tangency the iterations grow as the root of 2 rho over the tolerance", "[4.3]") {
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    const Query query = tests::query({0, 1, 1}, {0, -1, 0}, 10.0, 0.75, 0.25);
    const Advancement got = tests::advanced(query, tolerance);
    const double N = std::sqrt(2.0 / tolerance);
    tests::advancement_trial(query, tolerance)
        .expect(Time{got.time}, Time{1.0},
                {1.01 * std::sqrt(2.0 * tolerance),
                 "at the end the gap is s^2/2, so the way s is left"});
    tests::advancement_trial(query, tolerance)
        .expect_small("|iterations/sqrt(2 rho/tolerance) - 1|", std::abs(got.iterations / N - 1.0),
                      {(3.0 + 2.0 * std::log(N)) / N, "1/s grows by 1/2 to 1/2 + 1/(k + 2)"});
  }
}

TEST_CASE("A pass within the tolerance is a hit and one beyond it is not", "[4.3]") {
  for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
    for (const double share : {0.9, 1.1}) {
      const Query query =
          tests::query({0, 2, 1.0 + share * tolerance}, {0, -0.5, 0}, 10.0, 0.75, 0.25);
      // √((1 + tolerance)² − (1 + 0.9 tolerance)²) before the closest, or less.
      const Time wanted{share < 1.0 ? std::optional<double>(4.0) : std::nullopt};
      tests::advancement_trial(query, tolerance)
          .expect(Time{tests::advanced(query, tolerance).time}, wanted,
                  {2.0 * std::sqrt(0.21 * tolerance),
                   "the way on which it is within the tolerance before the closest point"});
    }
  }
}

// φ and t are sums of whole numbers, so that none of them is rounded.
TEST_CASE("Advancement that arrives exactly at dt is an impact", "[4.3]") {
  for (const double speed : {1.0, 2.0, 0.25}) {
    for (const double way : {1.0, 2.0, 64.0}) {
      for (const double tolerance : {1e-6, 1e-300}) {
        const double dt = way / speed;
        const Query query = tests::query({5, -1.0 - way, 0}, {7, speed, 0}, dt, 0.75, 0.25);
        const auto here = tests::advancement_trial(query, tolerance);
        const Advancement got = tests::advanced(query, tolerance);
        Query longer = query;
        longer.dt = 1.001 * dt;
        here.expect(Time{got.time}, Time{dt}, {0.0, "whole numbers"}, [&] {
          const bool right_beside = tests::advanced(longer, tolerance).time == dt;
          return right_beside
                     ? tests::TimeSuspects{{{}, "an arrival at dt is lost: stop only if t > dt"}}
                     : tests::TimeSuspects{};
        });
        here.of("iterations")
            .expect(static_cast<double>(got.iterations), 2.0, {0.0, "before and after"});
        Query shorter = query;
        shorter.dt = std::nextafter(dt, 0.0);
        tests::advancement_trial(shorter, tolerance)
            .expect(Time{tests::advanced(shorter, tolerance).time}, Time{}, {0.0, "t is after dt"},
                    tests::TimeSuspects{
                        {{dt}, "dt is ignored: this impact is after dt, so return none"}});
      }
    }
  }
}

// On an axis, and with whole numbers or their halves, φ is the tolerance itself, without rounding.
TEST_CASE("A gap that equals the tolerance is within it", "[4.3]") {
  for (const double tolerance : {5.0, 0.5, 0.0078125}) {
    for (const double speed : {2.0, -2.0, 0.0}) {  // away, nearer, at rest
      const Query query = tests::query({0, -5.0 - tolerance, 0}, {3, -speed, 0}, 10.0);
      const auto here = tests::advancement_trial(query, tolerance);
      const Advancement got = tests::advanced(query, tolerance);
      here.expect(Time{got.time}, Time{0.0}, {0.0, "phi is exactly the tolerance"}, [&] {
        const bool right_beside = tests::advanced(query, 1.001 * tolerance).time == 0.0;
        const char* const story = "a gap that equals the tolerance is not counted: compare by <=";
        return right_beside ? tests::TimeSuspects{{Time{got.time}, story}} : tests::TimeSuspects{};
      });
      here.of("iterations")
          .expect(static_cast<double>(got.iterations), 1.0, {0.0, "the start alone"});
    }
  }
}

TEST_CASE("A gap just above the tolerance is not an impact", "[4.3]") {
  for (const double tolerance : {0.5, 0.0078125}) {
    for (const double share : {1e-9, 1e-12, 256.0 * eps}) {
      for (const double speed : {0.0, 1.0}) {  // at rest, and on its way out
        const double gap = tolerance * (1.0 + share);
        const Query query = tests::query({0, 0, 1.0 + gap}, {0, 0, speed}, 1.0, 0.75, 0.25);
        if (gap - tolerance < 8.0 * eps) continue;  // nor may rounding decide
        tests::advancement_trial(query, tolerance)
            .expect(Time{tests::advanced(query, tolerance).time}, Time{},
                    {0.0, "the gap is never within the tolerance"},
                    tests::TimeSuspects{{{0.0},
                                         "the tolerance is taken too wide: compare the gap with "
                                         "the tolerance itself"}});
      }
    }
  }
}

TEST_CASE("Advancement ends if t cannot grow any more", "[4.3]") {
  // The last gaps are roundings of a place 81 away, and φ/|v| is less than half an ulp of t. There
  // t stays; an answer that goes on until φ ≤ tolerance never ends.
  const auto ends = [](const Query& query, double tolerance, int index, int count) {
    const Advancement got = tests::advanced(query, tolerance);
    const auto here = tests::advancement_trial(query, tolerance, index, count);
    const Vec3& x = query.particle.position;
    const double steep = std::sqrt(1.0 - std::pow(tests::offset_of(query) / rho(query), 2));
    const double way = 8.0 * eps * (std::hypot(x.y(), x.z()) + 2.0 * rho(query)) / steep;
    here.expect(Time{got.time}, tests::time_of(query),
                {way * got.iterations / tests::speed_of(query),
                 "8 eps of the lengths for each evaluation"});
    here.expect_small("evaluations", got.iterations,
                      {400.0, "each evaluation leaves 1 - cos of the gap"});
  };
  ends(tests::query({0, -81.054912723692809, 0.61900124472615581}, {0, 14.993368607812629, 0}, 10.0,
                    0.5, 0.5),
       8.1e-16, 1, 201);
  tests::Random random(4323);
  for (int i = 2; i <= 201; ++i) {
    const double distance = tests::power_of_ten(random, 0.1, 3.0);
    const double offset = random.uniform(-0.8, 0.8);
    const Query query = tests::aimed(random, {distance, offset, random.uniform(1.0, 20.0)});
    ends(query, tests::power_of_ten(random, -300.0, -15.0), i, 201);
  }
}

TEST_CASE("Within the tolerance at the start it takes one evaluation", "[4.3]") {
  const Query query = tests::query({3, 3, 4.0005}, {1, 3, 4}, 1.0);
  for (const double tolerance : {1e-3, 0.5}) tests::expect_sequence(query, tolerance);
}

TEST_CASE("Advancement refuses bad arguments", "[4.3]") {
  tests::expect_bad_queries_throw(tests::advancement_step, [](const Query& query) {
    return tests::advanced(query, 1e-6).time;
  });
  const Query query = tests::query({0, 10, 20}, {0, -1, 0}, 1.0);
  for (const double tolerance : {0.0, -1e-6, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    tests::advancement_trial(query, tolerance)
        .expect_throw([&] { return Time{tests::advanced(query, tolerance).time}; },
                      "the tolerance is not a finite number above zero",
                      "the arguments are not checked: throw std::invalid_argument for a bad one");
  }
}

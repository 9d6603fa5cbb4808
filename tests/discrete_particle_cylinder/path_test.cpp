#include "path.hpp"
#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::Flight;
using tests::FoundTime;
namespace story = tests::story;

namespace {

std::optional<ParticleContact> answer(const Flight& f) {
  return first_sampled_contact(f.path, f.samples, f.particle_radius, f.cylinder);
}

/// Judges presence and time, then the contact itself.
void expect_right(const Flight& f, int index = 1, int count = 1) {
  const auto got = answer(f);
  const tests::Trial trial = tests::flight_trial(f, index, count);
  const FoundTime wanted = tests::first_in(f, tests::sample_times(f));
  trial.expect(
      FoundTime{got ? std::optional(got->time) : std::nullopt}, wanted,
      {4.0 * tests::eps * f.path.duration, "the rounding of k T/N"}, [&] {
        const bool apart = got && got->gap > 16.0 * tests::eps * f.size();
        return apart ? std::vector<tests::Suspect<FoundTime>>{{{got->time}, story::tolerance}}
                     : tests::suspects_of_time(f);
      });
  if (got) {
    // A product and a sum round, on numbers as great as the whole way.
    tests::expect_contact(trial, got, f.at(*wanted.time), 4.0 * tests::eps * f.size());
  }
}

Flight random_flight(tests::Random& random) {
  Flight f;
  do {
    f.path.position = random.vector(4.0);
    f.path.velocity = random.vector(4.0);
    f.path.duration = random.uniform(0.5, 4.0);
    f.samples = static_cast<int>(random.uniform(1.0, 20.0));
    f.particle_radius = random.uniform(0.1, 0.5);
    f.cylinder.radius = random.uniform(0.3, 1.5);
  } while (tests::nearest_to_touching(f) < 1e-9);
  return f;
}

}  // namespace

TEST_CASE("A fall that is in contact at four of its five samples returns the first", "[3.4]") {
  // y = 10, 6, 2, −2, −6 at t = 0, 1, 2, 3, 4: the second sample touches.
  Flight f;
  f.path = {Vec3(1.0, 10.0, 0.0), Vec3(0.0, -4.0, 0.0), 4.0};
  f.samples = 4;
  f.particle_radius = 1.0;
  f.cylinder.radius = 5.0;
  expect_right(f);
}

TEST_CASE("Of the samples of a path the first in contact is returned", "[3.4]") {
  tests::Random random(341);
  for (int i = 1; i <= 200; ++i) expect_right(random_flight(random), i, 200);
}

TEST_CASE("The start is a sample", "[3.4]") {
  for (const int samples : {1, 2, 7}) {
    Flight f;  // inside at the start, outside at all later samples
    f.path = {Vec3(0.0, 0.5, 0.25), Vec3(1.0, 30.0, 2.0), 2.0};
    f.samples = samples;
    expect_right(f);
  }
}

TEST_CASE("The end is a sample", "[3.4]") {
  for (const int samples : {1, 2, 7, 49}) {
    Flight f;  // inside at the end alone
    f.path = {Vec3(0.0, 0.5, 60.25), Vec3(1.0, 0.0, -60.0), 1.0};
    f.samples = samples;
    f.particle_radius = 0.25;
    f.cylinder.radius = 0.5;
    expect_right(f);
  }
}

TEST_CASE("A particle that does not move is judged by its start alone", "[3.4]") {
  // R + r is 1.5, so three of them are just outside.
  for (const double distance : {0.5, 1.75, 1.5 + 1e-9, 1.5 + 1e-12, 1.5 + 8.0 * tests::eps}) {
    for (const Vec3& velocity : {Vec3(0.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)}) {
      for (const double duration : {0.0, 2.0}) {
        Flight f;
        f.path = {Vec3(1.0, 0.0, distance), velocity, duration};
        f.samples = 3;
        expect_right(f);
      }
    }
    Flight brief;
    brief.path = {Vec3(1.0, 0.0, distance), Vec3(0.0, 0.0, -1.0), 0.0};
    expect_right(brief);
  }
}

TEST_CASE("Paths of any size are sampled alike", "[3.4]") {
  for (const double size : {1e-200, 1e-100, 1e100, 1e200}) {
    Flight f;
    f.path = {Vec3(size, -4.0 * size, 0.3 * size), Vec3(size, size, 0.0), 8.0};
    f.samples = 9;
    f.particle_radius = 0.25 * size;
    f.cylinder.radius = size;
    expect_right(f);
  }
  Flight slow;  // the same way in a long time
  slow.path = {Vec3(0.0, -4.0, 0.3), Vec3(0.0, 1e-200, 0.0), 8e200};
  slow.samples = 9;
  expect_right(slow);
}

TEST_CASE("Samples s apart miss a chord L for a share 1 - L over s of all phases", "[3.4]") {
  // Of evenly spaced phases the share that misses is right to one phase, of 2000.
  constexpr int phases = 2000;
  tests::Random random(342);
  for (const double ratio : {0.1, 0.5, 0.9, 0.99, 1.01, 1.1, 2.5}) {  // L/s
    const tests::Crossing crossing = tests::random_crossing(random);
    double missed = 0.0;
    for (int i = 0; i < phases; ++i) {
      const auto got = answer(crossing.flight(ratio, (i + 0.5) / phases));
      missed += got ? 0.0 * got->gap : 1.0;  // NaN in a contact stays seen
    }
    tests::flight_trial(crossing.flight(ratio, 0.0))
        .of("the share of phases that miss")
        .expect(missed / phases, std::max(0.0, 1.0 - ratio), {1e-3, "2000 phases, evenly spaced"},
                {{0.0, "the path is checked between its samples: check the samples only"}});
  }
}

TEST_CASE("A hit is found at most one step late and half a step on average", "[3.4]") {
  constexpr int phases = 500;
  tests::Random random(343);
  for (const double ratio : {1.1, 2.0, 4.0}) {  // L/s
    const tests::Crossing crossing = tests::random_crossing(random);
    double sum = 0.0;
    for (int i = 0; i < phases; ++i) {
      const Flight f = crossing.flight(ratio, (i + 0.5) / phases);
      const auto got = answer(f);
      const tests::Trial trial = tests::flight_trial(f, i + 1, phases);
      trial.expect(tests::Presence{got}, tests::Presence{ParticleContact{}},
                   {0.0, "samples less than a chord apart cannot miss"});
      const double late = (got->time - crossing.entry(f)) / f.step();
      trial.expect_small("steps by which the contact is outside [entry, entry + step]",
                         std::max({-late, late - 1.0, 0.0 * late}),
                         {1e-9, "the entry in closed form, to rounding"},
                         late > 1.0 ? story::last_sample : "");
      sum += late;
    }
    tests::flight_trial(crossing.flight(ratio, 0.0))
        .of("the mean delay in steps")
        .expect(sum / phases, 0.5, {1.0 / phases, "delays are spread evenly over a step"});
  }
}

TEST_CASE("A path refuses numbers that are not finite and less than one sample", "[3.4]") {
  const char* const function = "3.4 first_sampled_contact";
  const StraightPath path{Vec3(0.0, 0.5, 0.0), Vec3(0.0, -1.0, 0.0), 2.0};
  const auto refused = [&](const StraightPath& bad, int samples, const char* why) {
    tests::Trial(function)
        .given("path.duration", bad.duration)
        .given("samples", static_cast<double>(samples))
        .expect_throw(
            [&] {
              return tests::Presence{first_sampled_contact(bad, samples, 0.5, Cylinder{1.0})};
            },
            why, story::unchecked);
  };
  for (const int samples : {0, -1}) refused(path, samples, "there must be at least one sample");
  for (const double duration : {-1.0, tests::nan, tests::infinity}) {
    refused({path.position, path.velocity, duration}, 4,
            "the duration must be finite and not below 0");
  }
  tests::expect_radii_checked(function, [&](double r, const Cylinder& c) {
    return tests::Presence{first_sampled_contact(path, 4, r, c)};
  });
  tests::expect_position_checked(function, "path.position", [&](const Vec3& bad) {
    return tests::Presence{first_sampled_contact({bad, path.velocity, 2.0}, 4, 0.5, Cylinder{1.0})};
  });
  tests::expect_position_checked(function, "path.velocity", [&](const Vec3& bad) {
    return tests::Presence{first_sampled_contact({path.position, bad, 2.0}, 4, 0.5, Cylinder{1.0})};
  });
}

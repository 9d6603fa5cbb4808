#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "judgement.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::Meeting;
using tests::Presence;
namespace story = tests::story;

namespace {

std::optional<ParticleContact> contact_of(const Meeting& m) {
  return contact(m.position, m.particle_radius, m.cylinder, m.time);
}

tests::Trial contact_trial(const Meeting& m, int index = 1, int count = 1) {
  return tests::trial_of("3.2 contact", m, index, count).given("time", m.time);
}

/// Of a contact where the surfaces are a little apart: there may be one wherever they are.
std::string why_apart() {
  return contact(Vec3(0.0, 0.0, 9.0), 0.5, Cylinder{1.0}, 0.0)
             ? "a contact is returned although the surfaces are apart: return none if the gap is "
               "above zero"
             : story::tolerance;
}

/// Right angles in whole numbers, whose root is exact; R + r is the hypotenuse.
std::vector<Meeting> touching_meetings() {
  std::vector<Meeting> all;
  for (const double scale : {1.0, -0.25, 0x1p600, 0x1p-600}) {
    const double size = std::abs(scale);
    all.push_back({Vec3(scale, 3.0 * scale, 4.0 * scale), size, {4.0 * size}, 1.0});
    all.push_back({Vec3(scale, -12.0 * scale, 5.0 * scale), 2.0 * size, {11.0 * size}, 2.0});
    all.push_back({Vec3(0.0, 0.0, 2.0 * scale), 0.5 * size, {1.5 * size}, 3.0});
  }
  return all;
}

}  // namespace

TEST_CASE("A particle one metre deep has its contact on the line across the axis", "[3.2]") {
  const Meeting m{Vec3(7.0, 3.0, 4.0), 2.0, {4.0}, 0.25};
  const auto got = contact_of(m);
  tests::expect_contact(contact_trial(m), got, m);
  contact_trial(m)
      .of("the point on the cylinder")
      .expect(got->point_on_cylinder, Vec3(7.0, 2.4, 3.2), tests::few_ulp(16.0));
  contact_trial(m)
      .of("the point on the particle")
      .expect(got->point_on_particle, Vec3(7.0, 1.8, 2.4), tests::few_ulp(16.0));
}

TEST_CASE("Contacts agree with a hundred digits", "[3.2]") {
  tests::Random random(321);
  for (int i = 1; i <= 200; ++i) {
    const Meeting m = tests::random_meeting(random, random.uniform(0.01, 0.999));
    tests::expect_contact(contact_trial(m, i, 200), contact_of(m), m);
  }
}

TEST_CASE("If the surfaces are apart there is no contact", "[3.2]") {
  tests::Random random(322);
  for (int i = 1; i <= 50; ++i) {
    // The same particle a little inside, so that an answer without contacts does not pass.
    const double share = std::pow(10.0, 1.0 - 0.28 * i);
    const Meeting apart = tests::random_meeting(random, 1.0 + share);
    contact_trial(apart, i, 50)
        .expect(Presence{contact_of(apart)}, Presence{}, {0.0, "the gap is above zero"},
                {{Presence{ParticleContact{}},
                  share < 1e-6 ? story::tolerance
                               : "a contact is returned although the surfaces are apart: return "
                                 "none if the gap is above zero"}});
    const Meeting inside = tests::random_meeting(random, 1.0 - 0.05 * share);
    tests::expect_contact(contact_trial(inside, i, 50), contact_of(inside), inside);
  }
}

TEST_CASE("A particle above or below touching by a few ulp is judged rightly", "[3.2]") {
  // Straight above the axis nothing is rounded.
  int index = 0;
  for (const double share : {1e-9, 1e-12, 4.0 * tests::eps}) {
    const Meeting apart{Vec3(1.0, 0.0, 1.5 * (1.0 + share)), 0.5, {1.0}, 1.0};
    contact_trial(apart, ++index, 3)
        .expect(Presence{contact_of(apart)}, Presence{}, {0.0, "the gap is above zero"},
                {{Presence{ParticleContact{}}, why_apart()}});
    const Meeting inside{Vec3(1.0, 0.0, 1.5 * (1.0 - share)), 0.5, {1.0}, 1.0};
    tests::expect_contact(contact_trial(inside, index, 3), contact_of(inside), inside);
  }
}

TEST_CASE("A particle that only touches is in contact", "[3.2]") {
  const std::vector<Meeting> all = touching_meetings();
  int index = 0;
  for (const Meeting& m : all) {
    const tests::Trial trial = contact_trial(m, ++index, static_cast<int>(all.size()));
    Meeting deeper = m;
    deeper.position *= 1.0 - 1e-9;
    tests::expect_contact(contact_trial(deeper), contact_of(deeper), deeper);
    const auto got = contact_of(m);
    trial.expect(Presence{got}, Presence{ParticleContact{}}, {0.0, "the gap is zero, exactly"},
                 {{Presence{}, story::touching}});
    tests::expect_contact(trial, got, m);
  }
}

TEST_CASE("A particle on the axis is pushed up", "[3.2]") {
  const Meeting m{Vec3(-2.0, 0.0, 0.0), 0.25, {1.5}, 4.0};
  const auto got = contact_of(m);
  tests::expect_contact(contact_trial(m), got, m);
  contact_trial(m)
      .of("the point on the cylinder")
      .expect(got->point_on_cylinder, Vec3(-2.0, 1.5, 0.0), tests::few_ulp(4.0));
}

TEST_CASE("The two points are the gap apart along the normal", "[3.2]") {
  tests::Random random(323);
  for (int i = 1; i <= 50; ++i) {
    const Meeting m = tests::random_meeting(random, random.uniform(0.01, 0.99));
    const auto got = contact_of(m);
    tests::expect_contact(contact_trial(m, i, 50), got, m);
    const Vec3 between = got->point_on_particle - got->point_on_cylinder;
    contact_trial(m, i, 50)
        .of("the way from the cylinder's point to the particle's")
        .expect(between, Vec3(got->gap * got->normal),
                tests::few_ulp(8.0 * (m.size() + std::abs(m.position.x()))));
  }
}

TEST_CASE("Contacts are right at any size", "[3.2]") {
  for (const double size : {1e-300, 1e-200, 1e200, 1e300}) {
    const Meeting m{Vec3(size, -0.3 * size, 0.4 * size), 0.25 * size, {size}, 0.5};
    tests::expect_contact(contact_trial(m), contact_of(m), m);
  }
}

TEST_CASE("A contact refuses numbers that are not finite and radii not above zero", "[3.2]") {
  const Vec3 p(1.0, 0.2, 0.3);
  tests::expect_radii_checked(
      "3.2 contact", [&](double r, const Cylinder& c) { return Presence{contact(p, r, c, 0.0)}; });
  tests::expect_position_checked("3.2 contact", "position", [](const Vec3& bad) {
    return Presence{contact(bad, 0.5, Cylinder{1.0}, 0.0)};
  });
  for (const double bad : {tests::nan, tests::infinity, -tests::infinity}) {
    for (const double R : {1.0, 0.01}) {  // in contact and apart
      tests::Trial("3.2 contact")
          .given("time", bad)
          .given("cylinder.radius", R)
          .expect_throw([&] { return Presence{contact(p, 0.25, Cylinder{R}, bad)}; },
                        "the time must be finite", story::unchecked);
    }
  }
}

#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "sheet.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::Exact;
using tests::IndexList;
using tests::Suspect;

namespace {

struct Margin {
  double longest_edge = 1.0;
  double particle_radius = 0.5;
  Cylinder cylinder = {};

  [[nodiscard]] Exact rho() const { return tests::rho(particle_radius, cylinder); }
};

/// Where the ends of an edge must be, and where the corners of a pierced triangle may be.
Exact held(const Exact& rho, const Exact& h) { return sqrt(rho * rho + h * h / 4); }
Exact pierced(const Exact& h) { return h / sqrt(Exact(3)); }

double wanted(const Margin& m) {
  const Exact h = m.longest_edge;
  return tests::rounded(std::max(held(m.rho(), h), pierced(h)) - m.rho());
}

/// Near one a root of squares is right.
std::string why_without_edges() {
  const bool right_near_one = std::abs(particle_margin(8.0, 0.5, {2.5}) - 2.0) < 1e-9;
  return right_near_one ? tests::story::underflow
                        : "edges are forgotten: their ends must be farther from the axis";
}

std::vector<Suspect<double>> suspects(const Margin& m) {
  const Exact h = m.longest_edge;
  const Exact R = m.cylinder.radius;
  const Exact rho = m.rho();
  const auto value = [](const Exact& x) { return tests::rounded(x); };
  const char* const no_rho = "R is used instead of rho: add the particle's radius";
  return {
      {value(std::max(held(R, h), pierced(h)) - R), no_rho},
      {value(std::max(held(R, h), pierced(h)) - rho), no_rho},
      {value(std::max(held(rho, h), pierced(h)) - R), no_rho},
      {value(std::max(held(rho, 2 * h), pierced(h)) - rho),
       "h is used instead of h/2: the middle is half an edge from its ends"},
      {value(held(rho, h) - rho),
       "a large triangle is forgotten: its corners can be h/sqrt(3) from an axis inside it"},
      {value(pierced(h) - rho), why_without_edges()},
      {value(std::max(held(rho, h), pierced(h))),
       "this is a distance from the axis: a margin is a gap, so subtract rho"},
      {value(rho - sqrt(abs(rho * rho - h * h / 4))),
       "this is how deep an edge sinks if its ends touch: return how far off they must be held"}};
}

tests::Trial margin_trial(const Margin& m, int index = 1, int count = 1) {
  return tests::radii_trial("3.6 particle_margin", m.particle_radius, m.cylinder, index, count)
      .given("longest_edge", m.longest_edge);
}

/// Judges the margin and returns it.
double expect_margin(const Margin& m, int index = 1, int count = 1) {
  const double got = particle_margin(m.longest_edge, m.particle_radius, m.cylinder);
  const double size = m.longest_edge + tests::rounded(m.rho());
  margin_trial(m, index, count).expect(got, wanted(m), tests::few_ulp(size), [&] {
    return suspects(m);
  });
  return got;
}

/// With h = `share` · ρ.
Margin random_margin(tests::Random& random, double share) {
  Margin m;
  m.cylinder = tests::random_cylinder(random);
  m.particle_radius = random.uniform(0.05, 0.5);
  m.longest_edge = share * tests::rounded(m.rho());
  return m;
}

/// A patch of triangles of side h, shifted from the axis until all its particles are farther from
/// it than `distance`.
Sheet patch_outside(tests::Random& random, const Margin& m, double distance) {
  const common::Quat attitude = random.attitude();
  const Vec3 start = 0.5 * m.longest_edge * random.vector();
  const double angle = tests::random_angle(random);
  Sheet sheet = tests::placed(tests::mesh(4, m.longest_edge), attitude, start);
  const std::vector<Vec3> at_start = sheet.positions;
  for (int step = 0; step < 4000; ++step) {
    const Vec3 shift = tests::around_axis(0.0, 0.01 * step * m.longest_edge, angle);
    const auto shifted = [&](const Vec3& p) { return Vec3(p + shift); };
    std::transform(at_start.begin(), at_start.end(), sheet.positions.begin(), shifted);
    const auto free = [&](const Vec3& p) { return std::hypot(p.y(), p.z()) > distance; };
    if (std::all_of(sheet.positions.begin(), sheet.positions.end(), free)) break;
  }
  sheet.particle_radius = m.particle_radius;
  return sheet;
}

/// One triangle, sides h at most, as deep as can be with its corners at `distance` or beyond: an
/// edge across the axis or, where h allows, all three corners round it.
Sheet deepest(tests::Random& random, const Margin& m, double distance) {
  const double h = m.longest_edge;
  const double roll = tests::random_angle(random);
  const double x = random.uniform(-3.0, 3.0);
  Sheet sheet;
  sheet.edges = {{0, 1}, {1, 2}, {2, 0}};
  sheet.triangles = {{0, 1, 2}};
  sheet.particle_radius = m.particle_radius;
  const double rho = tests::rounded(m.rho());
  if (h > 2.0 * std::sqrt(3.0) * rho) {
    for (int i = 0; i < 3; ++i) {
      const double third = 4.0 * std::acos(0.0) / 3.0 * i;
      sheet.positions.push_back(tests::around_axis(x, distance, roll + third));
    }
    return sheet;
  }
  const double middle = std::sqrt(distance * distance - 0.25 * h * h);
  for (const Vec3& corner : {Vec3(x, middle, -0.5 * h), Vec3(x, middle, 0.5 * h),
                             Vec3(x + 0.3 * h, middle + 0.7 * h, 0.0)}) {
    sheet.positions.push_back(tests::rolled(corner, roll));
  }
  return sheet;
}

/// h/ρ on both sides of 2√3.
constexpr double shares[] = {0.1, 0.5, 1.0, 2.0, 3.4, 3.6, 4.0, 6.0};

}  // namespace

TEST_CASE("Edges of length 8 need a margin of 2 if rho is 3", "[3.6]") {
  const Margin m{8.0, 0.5, {2.5}};
  expect_margin(m);
  margin_trial(m).expect(particle_margin(8.0, 0.5, {2.5}), 2.0, tests::few_ulp(11.0), suspects(m));
}

TEST_CASE("The margin agrees with a hundred digits", "[3.6]") {
  tests::Random random(381);
  for (int i = 1; i <= 100; ++i) {
    expect_margin(random_margin(random, std::pow(10.0, random.uniform(-3.0, 3.0))), i, 100);
  }
}

TEST_CASE("If triangles can hide the axis the margin depends on their corners", "[3.6]") {
  tests::Random random(382);
  int index = 0;
  for (const double share : {0.9, 0.99, 1.01, 1.1, 2.0}) {  // h/(2 √3 ρ)
    const Margin m = random_margin(random, share * 2.0 * std::sqrt(3.0));
    const double rho = tests::rounded(m.rho());
    const double h = m.longest_edge;
    // ρ √(1 + 3 share²) below, 2 ρ share above.
    const double distance =
        share < 1.0 ? rho * std::sqrt(1.0 + 3.0 * share * share) : 2.0 * rho * share;
    const double got = expect_margin(m, ++index, 5);
    margin_trial(m, index, 5).expect(got, distance - rho, tests::few_ulp(4.0 * (rho + h)), [&] {
      return suspects(m);
    });
  }
}

TEST_CASE("Sheets without edges and edges of any size have their margin", "[3.6]") {
  int index = 0;
  for (const double h : {0.0, 1e-300, 1e-200, 1.0, 1e200, 1e300}) {
    for (const double radius : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
      expect_margin({h, 0.25 * radius, {radius}}, ++index, 30);
    }
  }
}

TEST_CASE("A sheet held a tenth beyond the margin does not touch", "[3.6]") {
  tests::Random random(383);
  int index = 0;
  for (const double share : shares) {
    for (int i = 0; i < 5; ++i) {
      const Margin m = random_margin(random, share);
      const double margin = expect_margin(m);
      const double distance = tests::rounded(m.rho()) + 1.1 * margin;
      const Sheet sheet = patch_outside(random, m, distance);
      tests::expect_sheet(sheet, m.cylinder, ++index, 40);
      const SheetContacts got = sheet_contacts(sheet, m.cylinder);
      const tests::Trial trial = tests::sheet_trial(sheet, m.cylinder, index, 40);
      for (const auto& list : {got.particles, got.edges, got.triangles}) {
        trial.expect(IndexList{list}, IndexList{}, {0.0, "the margin is enough"});
      }
    }
  }
}

TEST_CASE("At a tenth less than the margin a triangle sinks while its particles are free",
          "[3.6]") {
  tests::Random random(384);
  int index = 0;
  for (const double share : shares) {
    for (int i = 0; i < 5; ++i) {
      const Margin m = random_margin(random, share);
      const double margin = expect_margin(m);
      const double distance = tests::rounded(m.rho()) + 0.9 * margin;
      const Sheet sheet = deepest(random, m, distance);
      tests::expect_sheet(sheet, m.cylinder, ++index, 40);
      const SheetContacts got = sheet_contacts(sheet, m.cylinder);
      const tests::Trial trial = tests::sheet_trial(sheet, m.cylinder, index, 40);
      trial.of("the particles")
          .expect(IndexList{got.particles}, IndexList{}, {0.0, "all particles are held off"});
      trial.of("the triangles")
          .expect(IndexList{got.triangles}, IndexList{{0}},
                  {0.0, "the particles are nearer than the margin"});
    }
  }
}

TEST_CASE("A margin refuses a length that is not finite and radii not above zero", "[3.6]") {
  for (const double bad : {-1.0, -1e-300, tests::nan, tests::infinity}) {
    margin_trial({bad, 0.5, {1.0}})
        .expect_throw([&] { return particle_margin(bad, 0.5, Cylinder{1.0}); },
                      "the length must be finite and not below zero", tests::story::unchecked);
  }
  tests::expect_radii_checked("3.6 particle_margin", [](double r, const Cylinder& c) {
    return particle_margin(1.0, r, c);
  });
}

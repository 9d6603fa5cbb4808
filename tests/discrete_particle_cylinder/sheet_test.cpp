#include "sheet.hpp"
#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::expect_sheet;
namespace story = tests::story;

namespace {

/// A wavy sheet of random attitude somewhere near the cylinder, in all units of length.
Sheet random_sheet(tests::Random& random, double size = 1.0) {
  Sheet sheet = tests::placed(tests::mesh(5, random.uniform(0.2, 1.5)), random.attitude(),
                              random.vector(1.5));
  for (Vec3& p : sheet.positions) p = size * (p + random.vector(0.1));
  sheet.particle_radius = size * random.uniform(0.02, 0.2);
  return sheet;
}

Sheet one_triangle(const std::array<Vec3, 3>& corners, double particle_radius) {
  return {{corners.begin(), corners.end()}, {{0, 1}, {1, 2}, {2, 0}}, {{0, 1, 2}}, particle_radius};
}

/// All three lists, for the checks of input.
tests::IndexList all_of(const Sheet& sheet, const Cylinder& cylinder) {
  const SheetContacts got = sheet_contacts(sheet, cylinder);
  tests::IndexList all{got.particles};
  all.indices.insert(all.indices.end(), got.edges.begin(), got.edges.end());
  all.indices.insert(all.indices.end(), got.triangles.begin(), got.triangles.end());
  return all;
}

}  // namespace

TEST_CASE("A sunk edge is found though all its particles are free", "[3.6]") {
  // The first edge passes 1.0 from the axis, its ends are 2.2 away; ρ is 1.1.
  const Sheet sheet =
      one_triangle({Vec3(0.0, 1.0, -2.0), Vec3(1.0, 1.0, 2.0), Vec3(3.0, 5.0, 0.0)}, 0.125);
  const Cylinder cylinder{0.975};
  expect_sheet(sheet, cylinder);
  const SheetContacts got = sheet_contacts(sheet, cylinder);
  tests::sheet_trial(sheet, cylinder)
      .of("the edges")
      .expect(tests::IndexList{got.edges}, tests::IndexList{{0}}, {0.0, "worked by hand"},
              {{tests::IndexList{}, story::ends_only}});
}

TEST_CASE("A pierced triangle is found though all its edges are free", "[3.6]") {
  // Sides 10, so the edges are 2.9 from the axis, which goes through the middle; ρ is 1.5. The
  // second triangle has a sunk edge.
  const double height = 5.0 * std::sqrt(3.0);
  Sheet sheet = one_triangle({Vec3(0.0, -height / 3.0, -5.0), Vec3(1.0, -height / 3.0, 5.0),
                              Vec3(2.0, 2.0 * height / 3.0, 0.0)},
                             0.5);
  for (const Vec3& p : {Vec3(9.0, 1.2, -2.0), Vec3(9.0, 1.2, 2.0), Vec3(9.0, 5.0, 0.0)}) {
    sheet.positions.push_back(p);
  }
  sheet.edges.push_back({3, 4});
  sheet.triangles.push_back({3, 4, 5});
  const Cylinder cylinder{1.0};
  expect_sheet(sheet, cylinder);
  const SheetContacts got = sheet_contacts(sheet, cylinder);
  tests::sheet_trial(sheet, cylinder)
      .of("the triangles")
      .expect(tests::IndexList{got.triangles}, tests::IndexList{{0, 1}}, {0.0, "worked by hand"});
}

TEST_CASE("An edge or a triangle that names a particle twice is checked like any other", "[3.6]") {
  const Cylinder cylinder{1.0};
  for (const double y : {1.25, 2.0}) {
    expect_sheet({{Vec3(0.0, y, 0.0), Vec3(1.0, 0.0, 3.0), Vec3(1.0, 5.0, 0.0)},
                  {{0, 0}, {1, 1}, {1, 2}, {0, 1}},
                  {{0, 0, 0}, {0, 0, 2}, {1, 2, 1}, {2, 2, 2}, {0, 1, 2}},
                  0.5},
                 cylinder, y < 2.0 ? 1 : 2, 2);
  }
}

TEST_CASE("All lists of a sheet agree with a hundred digits", "[3.6]") {
  tests::Random random(371);
  for (int i = 1; i <= 20; ++i) {
    expect_sheet(random_sheet(random), {random.uniform(0.2, 1.5)}, i, 20);
  }
}

TEST_CASE("A sheet may be rolled round the cylinder and shifted along it", "[3.6]") {
  tests::Random random(372);
  for (int i = 1; i <= 5; ++i) {
    Sheet sheet = random_sheet(random);
    const Cylinder cylinder{random.uniform(0.2, 1.5)};
    const double angle = tests::random_angle(random);
    const double shift = random.uniform(-100.0, 100.0);
    for (Vec3& p : sheet.positions) p = tests::rolled(p, angle, shift);
    expect_sheet(sheet, cylinder, i, 5);
  }
}

TEST_CASE("Sheets of any size are checked alike", "[3.6]") {
  tests::Random random(373);
  int index = 0;
  for (const double size : {1e-300, 1e-200, 1e200, 1e300}) {
    expect_sheet(random_sheet(random, 0.125 * size), {0.0625 * size}, ++index, 4);
  }
}

TEST_CASE("A particle of a sheet that only touches is in contact", "[3.6]") {
  Sheet sheet;
  sheet.positions = {Vec3(1.0, 3.0, 4.0), Vec3(0.0, 5.5, 0.0), Vec3(2.0, -4.0, -3.0)};
  sheet.particle_radius = 1.0;
  const Cylinder cylinder{4.0};
  tests::sheet_trial(sheet, cylinder)
      .of("the particles")
      .expect(tests::IndexList{sheet_contacts(sheet, cylinder).particles}, tests::IndexList{{0, 2}},
              {0.0, "their gap is zero, exactly"}, {{tests::IndexList{}, story::touching}});
}

TEST_CASE("An edge or a triangle of a sheet that only touches is in contact", "[3.6]") {
  // Five from the axis at its middle, which no arithmetic rounds; the ends are further off.
  Sheet sheet = one_triangle({Vec3(1.0, 5.0, -1.0), Vec3(2.0, 5.0, 1.0), Vec3(0.0, 8.0, 0.0)}, 1.0);
  const Cylinder cylinder{4.0};
  const SheetContacts got = sheet_contacts(sheet, cylinder);
  tests::sheet_trial(sheet, cylinder)
      .of("the edges")
      .expect(tests::IndexList{got.edges}, tests::IndexList{{0}},
              {0.0, "the gap of one is zero, exactly"},
              {{tests::IndexList{}, story::touching}, {tests::IndexList{}, story::ends_only}});
  tests::sheet_trial(sheet, cylinder)
      .of("the triangles")
      .expect(tests::IndexList{got.triangles}, tests::IndexList{{0}},
              {0.0, "its gap is zero, exactly"},
              {{tests::IndexList{}, story::touching}, {tests::IndexList{}, story::ends_only}});
}

TEST_CASE("An edge just outside is free and one just inside is not", "[3.6]") {
  // ρ is 5; the middle of the edge is straight above the axis, where nothing is rounded.
  int index = 0;
  for (const double share : {1e-9, 1e-12, 64.0 * tests::eps, -1e-9, -1e-12, -64.0 * tests::eps}) {
    const double y = 5.0 * (1.0 + share);
    const Sheet sheet =
        one_triangle({Vec3(1.0, y, -1.0), Vec3(2.0, y, 1.0), Vec3(0.0, 8.0, 0.0)}, 1.0);
    const Cylinder cylinder{4.0};
    const SheetContacts got = sheet_contacts(sheet, cylinder);
    const tests::IndexList none;
    const tests::IndexList first{{0}};
    const tests::IndexList& wanted = share > 0.0 ? none : first;
    std::vector<tests::Suspect<tests::IndexList>> suspects;
    if (share > 0.0) suspects.push_back({first, story::tolerance});
    const tests::Trial trial = tests::sheet_trial(sheet, cylinder, ++index, 6);
    trial.of("the edges")
        .expect(tests::IndexList{got.edges}, wanted, {0.0, "it is off by more than rounding"},
                suspects);
    trial.of("the triangles")
        .expect(tests::IndexList{got.triangles}, wanted, {0.0, "it is off by more than rounding"},
                suspects);
  }
}

TEST_CASE("A sheet may have no triangles or no edges or nothing at all", "[3.6]") {
  tests::Random random(374);
  Sheet sheet = random_sheet(random);
  sheet.positions[3] = Vec3(1.0, 0.1, 0.2);  // inside
  Sheet bare = sheet;
  bare.edges.clear();
  expect_sheet(bare, {0.5}, 1, 4);
  sheet.triangles.clear();
  expect_sheet(sheet, {0.5}, 2, 4);
  sheet.edges.clear();
  expect_sheet(sheet, {0.5}, 3, 4);
  sheet.positions.clear();
  expect_sheet(sheet, {0.5}, 4, 4);
}

TEST_CASE("A sheet whose edges or triangles have an index of no particle is refused", "[3.6]") {
  const std::array<Vec3, 3> corners{Vec3(0.0, 5.0, 0.0), Vec3(1.0, 5.0, 0.0), Vec3(0.0, 5.0, 1.0)};
  const Cylinder cylinder{1.0};
  for (const std::size_t bad : {std::size_t{3}, std::numeric_limits<std::size_t>::max()}) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Sheet sheet = one_triangle(corners, 0.5);
      sheet.triangles[0][corner] = bad;
      tests::sheet_trial(sheet, cylinder)
          .expect_throw([&] { return all_of(sheet, cylinder); },
                        "a triangle has an index of no particle", story::unchecked);
      if (corner == 2) continue;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        sheet = one_triangle(corners, 0.5);
        sheet.edges[edge][corner] = bad;
        tests::sheet_trial(sheet, cylinder)
            .expect_throw([&] { return all_of(sheet, cylinder); },
                          "an edge has an index of no particle", story::unchecked);
      }
    }
  }
}

TEST_CASE("A sheet refuses positions that are not finite and radii not above zero", "[3.6]") {
  const std::array<Vec3, 3> corners{Vec3(0.0, 5.0, 0.0), Vec3(1.0, 5.0, 0.0), Vec3(0.0, 5.0, 1.0)};
  const char* const function = "3.6 sheet_contacts";
  tests::expect_radii_checked(
      function, [&](double r, const Cylinder& c) { return all_of(one_triangle(corners, r), c); });
  tests::expect_position_checked(function, "sheet.positions[2]", [&](const Vec3& bad) {
    return all_of(one_triangle({corners[0], corners[1], bad}, 0.5), Cylinder{1.0});
  });
}

#include "catch.hpp"
#include "oracle.hpp"
#include "stories.hpp"
#include "trees.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::Decision;
using tests::exactly;
using tests::Trial;

namespace {

Triangle times(const Triangle& t, double factor) {
  return {factor * t[0], factor * t[1], factor * t[2]};
}

Triangle shifted(const Triangle& t, const Vec3& offset) {
  return {t[0] + offset, t[1] + offset, t[2] + offset};
}

std::string story_of(const Triangle& a, const Triangle& b, bool wanted) {
  if (!wanted) return "";
  if (tests::is_degenerate(a) || tests::is_degenerate(b)) return tests::without_plane;
  return tests::are_in_one_plane(a, b) ? tests::in_one_plane : "";
}

/// tells  what is likely, where coordinates are small whole numbers and rounding has no part in it
void expect_as_in_rationals(const Triangle& a, const Triangle& b, bool tells, int index,
                            int count) {
  const Trial trial =
      Trial("5.5 triangles_meet", index, count).given("a", code(a)).given("b", code(b));
  const bool got = trial.returned([&] { return triangles_meet(a, b); });
  const bool wanted =
      tests::boxes_meet(tests::box_around(a), tests::box_around(b)) && tests::meet(a, b);
  const bool tells_now = tells && got != wanted && tests::is_wrong_in_all_orders(a, b, wanted);
  const std::string story = tells_now ? story_of(a, b, wanted) : "";
  std::vector<tests::Suspect<Decision>> suspects;
  if (!story.empty()) suspects.push_back({Decision{!wanted}, story});
  trial.expect(Decision{got}, Decision{wanted}, exactly, suspects);
}

Triangle on_grid(tests::Random& random, int grid) {
  return common::triangle(tests::soup(random, 1, grid), 0);
}

}  // namespace

TEST_CASE("Corners within rounding of a plane or an edge are decided exactly", "[5.5]") {
  tests::Random random(51);
  for (int i = 1; i <= 300; ++i) {
    const Triangle a{random.vector(), random.vector(), random.vector()};
    const double s = random.uniform(0.0, 0.5);
    const double t = i % 3 == 0 ? 1.0 - s : random.uniform(0.0, 0.5);
    const Vec3 on_a = a[0] + s * (a[1] - a[0]) + t * (a[2] - a[0]);
    const Triangle b{on_a, on_a + random.vector(), on_a + random.vector()};
    const Trial trial = Trial("5.5 triangles_meet", i, 300).given("a", code(a)).given("b", code(b));
    const bool got = trial.returned([&] { return triangles_meet(a, b); });
    const bool wanted = tests::meet_exactly(a, b);
    // Beyond an edge both cross the other's plane, and more than rounding may be to blame.
    std::vector<tests::Suspect<Decision>> suspects;
    if (i % 3 != 0) suspects.push_back({Decision{!wanted}, tests::rounded});
    trial.expect(Decision{got}, Decision{wanted}, exactly, suspects);
  }
}

TEST_CASE("Rounded corners of any size are decided exactly", "[5.5]") {
  tests::Random random(54);
  int index = 0;
  for (const double size : {1e-60, 1e-9, 1e3, 1e6, 1e9, 1e60}) {
    for (int i = 0; i < 60; ++i) {
      const Triangle a{random.vector(size), random.vector(size), random.vector(size)};
      const double s = random.uniform(0.0, 0.5);
      const double t = random.uniform(0.0, 0.5);
      const Vec3 on_a = a[0] + s * (a[1] - a[0]) + t * (a[2] - a[0]);
      const Triangle b{on_a, on_a + random.vector(size), on_a + random.vector(size)};
      expect_as_in_rationals(a, b, false, ++index, 360);
    }
  }
}

TEST_CASE("Rounded corners in a plane of two axes are decided exactly", "[5.5]") {
  // A corner of b at the rounded place of a point of a's edge, the others beyond: on which side of
  // the edge it is is a matter of the last bit, and all six corners are in one plane.
  tests::Random random(55);
  for (int i = 1; i <= 300; ++i) {
    const Eigen::Index axis = i % 3;
    const auto flat = [&](Vec3 p) {
      p[axis] = 0.0;
      return p;
    };
    const Triangle a{flat(random.vector()), flat(random.vector()), flat(random.vector())};
    const Vec3 on_edge = flat(a[0] + random.uniform(0.1, 0.9) * (a[1] - a[0]));
    const Vec3 beyond = on_edge - a[2];
    const Vec3 along = 0.2 * (a[1] - a[0]);
    const Triangle b{on_edge, flat(on_edge + beyond + along), flat(on_edge + beyond - along)};
    expect_as_in_rationals(a, b, false, i, 300);
  }
}

TEST_CASE("Segments whose corners use all digits are still segments", "[5.5]") {
  // The corners are exact multiples of one vector, their differences are not.
  tests::Random random(56);
  for (int i = 1; i <= 300; ++i) {
    const Vec3 f = random.vector();
    const Triangle a{-f, 0.125 * f, 4.0 * f};
    const Vec3 u = random.vector();
    const Vec3 v = random.vector();
    Triangle b{u, v, -(u + v)};
    if (i % 3 == 1) b = {u, -0.25 * u, -2.0 * u};
    if (i % 2 == 0) b = shifted(b, random.vector());
    expect_as_in_rationals(a, b, false, i, 300);
  }
}

TEST_CASE("Triangles of a small grid meet as in rational arithmetic", "[5.5]") {
  tests::Random random(52);
  for (int i = 1; i <= 3000; ++i) {
    const int grid = 1 + i % 3;
    expect_as_in_rationals(on_grid(random, grid), on_grid(random, grid), true, i, 3000);
  }
}

TEST_CASE("Far off and tiny triangles meet as in rational arithmetic", "[5.5]") {
  tests::Random random(53);
  int index = 0;
  for (const double size : {1e-60, 1e-12, 1e60}) {
    for (int i = 0; i < 200; ++i) {
      expect_as_in_rationals(times(on_grid(random, 3), size), times(on_grid(random, 3), size),
                             false, ++index, 1000);
    }
  }
  for (const double offset : {1e6, 1e9}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 far = Vec3::Constant(offset);
      expect_as_in_rationals(shifted(times(on_grid(random, 3), 0.1), far),
                             shifted(times(on_grid(random, 3), 0.1), far), false, ++index, 1000);
    }
  }
}

#include "rational.hpp"
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
  const bool wanted = tests::meet_exactly(a, b);
  const std::string story = tells && got != wanted ? story_of(a, b, wanted) : "";
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

#include "catch.hpp"
#include "rational.hpp"
#include "stories.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::Decision;
using tests::exactly;
using tests::in_one_plane;
using tests::rounded;
using tests::Trial;
using tests::without_plane;

namespace {

const std::string touching =
    "triangles that only touch are taken for apart: they share a point, so they meet";
const std::string plane_is_enough =
    "both cross the other's plane, but not in the same place: compare their intervals on the "
    "common line";

struct Pair {
  Triangle a;
  Triangle b;
};

/// All orders of the corners, and both orders of the triangles, ask the same.
void expect_meet(const Pair& pair, bool wanted, const std::string& story, int index, int count) {
  std::vector<std::array<Triangle, 2>> orders = tests::corner_orders(pair.a, pair.b);
  for (const auto& swapped : tests::corner_orders(pair.b, pair.a)) orders.push_back(swapped);
  for (const auto& order : orders) {
    const Triangle& a = order[0];
    const Triangle& b = order[1];
    const Trial trial =
        Trial("5.5 triangles_meet", index, count).given("a", code(a)).given("b", code(b));
    const bool got = trial.returned([&] { return triangles_meet(a, b); });
    std::vector<tests::Suspect<Decision>> suspects;
    if (got != wanted && tests::is_wrong_in_all_orders(a, b, wanted)) {
      suspects.push_back({Decision{!wanted}, story});
    }
    trial.expect(Decision{got}, Decision{wanted}, exactly, suspects);
  }
}

void expect_all(const std::vector<Pair>& pairs, bool wanted, const std::string& story) {
  int index = 0;
  for (const Pair& pair : pairs) {
    // The case itself is what its name says.
    REQUIRE(tests::meet_exactly(pair.a, pair.b) == wanted);
    expect_meet(pair, wanted, story, ++index, static_cast<int>(pairs.size()));
  }
}

Triangle plus(const Triangle& t, const Vec3& offset) {
  return {t[0] + offset, t[1] + offset, t[2] + offset};
}

const Triangle floor_{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

}  // namespace

TEST_CASE("Triangles that cross meet", "[5.5]") {
  expect_all({{floor_, {Vec3(1, 1, -1), Vec3(1, 1, 3), Vec3(5, 5, 1)}},
              {floor_, {Vec3(-1, 1, -1), Vec3(9, 1, -1), Vec3(1, 1, 5)}},
              {floor_, {Vec3(1, 1, -1), Vec3(2, 1, -1), Vec3(1, 1, 5)}}},
             true, "");
}

TEST_CASE("Triangles on one side of a plane do not meet", "[5.5]") {
  expect_all({{floor_, plus(floor_, Vec3(0, 0, 1))},
              {floor_, {Vec3(1, 1, 1), Vec3(1, 1, 3), Vec3(5, 5, 1)}},
              {floor_, {Vec3(9, 9, -1), Vec3(9, 9, 3), Vec3(12, 9, 1)}}},
             false, "");
}

TEST_CASE("Triangles that cross a plane beside each other do not meet", "[5.5]") {
  expect_all({{floor_, {Vec3(5, -1, -1), Vec3(5, -1, 3), Vec3(5, 3, 1)}},
              {floor_, {Vec3(-1, -1, -1), Vec3(-1, -1, 1), Vec3(-2, 5, 0)}},
              {floor_, {Vec3(3, 3, -1), Vec3(3, 3, 1), Vec3(8, 7, 0)}},
              {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)},
               {Vec3(2, -1, 0.25), Vec3(2, 1, 0.25), Vec3(3, 0, 0.5)}}},
             false, plane_is_enough);
}

TEST_CASE("Touching corners edges and faces meet", "[5.5]") {
  expect_all({{floor_, {Vec3(1, 1, 0), Vec3(1, 1, 3), Vec3(2, 1, 3)}},     // a corner on the face
              {floor_, {Vec3(2, 0, 0), Vec3(2, 0, 3), Vec3(3, -1, 3)}},    // a corner on an edge
              {floor_, {Vec3(4, 0, 0), Vec3(5, 0, 3), Vec3(5, 1, 3)}},     // corner on corner
              {floor_, {Vec3(2, -1, -1), Vec3(2, -1, 1), Vec3(2, 1, 0)}},  // through an edge
              {floor_, {Vec3(1, 0, -1), Vec3(1, 0, 1), Vec3(1, -3, 0)}},   // edge across edge
              {floor_, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 1, 5)}},     // an edge on the face
              {floor_, {Vec3(4, 0, -1), Vec3(4, 0, 1), Vec3(7, 0, 0)}}},   // an edge on a corner
             true, touching);
}

TEST_CASE("Neighbours that share a corner or an edge meet", "[5.5]") {
  expect_all({{floor_, {Vec3(0, 0, 0), Vec3(-1, 0, 3), Vec3(0, -1, 3)}},
              {floor_, {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(4, 4, 3)}},
              {floor_, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -3)}}},
             true, touching);
}

TEST_CASE("Triangles in one plane meet if they overlap or touch", "[5.5]") {
  expect_all({{floor_, floor_},
              {floor_, plus(floor_, Vec3(1, 1, 0))},
              {floor_, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)}},  // inside
              {floor_, {Vec3(-9, -9, 0), Vec3(30, -9, 0), Vec3(-9, 30, 0)}},
              {floor_, {Vec3(4, 0, 0), Vec3(8, 0, 0), Vec3(8, 1, 0)}},   // corner on corner
              {floor_, {Vec3(2, 2, 0), Vec3(5, 3, 0), Vec3(5, 5, 0)}},   // corner on edge
              {floor_, {Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(4, 4, 0)}},   // shared edge
              {floor_, {Vec3(-1, 1, 0), Vec3(9, 1, 0), Vec3(9, 2, 0)}},  // across, no corner inside
              {{Vec3(0, 0, 0), Vec3(2, 2, 4), Vec3(4, 0, 4)},
               {Vec3(1, 1, 2), Vec3(3, 3, 6), Vec3(5, 1, 6)}}},  // in no axis plane
             true, in_one_plane);
}

TEST_CASE("Triangles in one plane that are apart do not meet", "[5.5]") {
  expect_all(
      {{floor_, {Vec3(4, 4, 0), Vec3(4, 1, 0), Vec3(1, 4, 0)}},
       {floor_, {Vec3(5, 0, 0), Vec3(8, 0, 0), Vec3(8, 1, 0)}},
       {floor_, {Vec3(-1, -1, 0), Vec3(-1, 9, 0), Vec3(-2, 3, 0)}},
       {{Vec3(0, 0, 0), Vec3(2, 2, 4), Vec3(4, 0, 4)},
        {Vec3(2, 2, 4) + Vec3(1, -1, 0) * 2.5, Vec3(4, 0, 4) + Vec3(1, -1, 0), Vec3(9, 1, 10)}}},
      false, "");
}

TEST_CASE("A segment or a point meets a triangle if they share a point", "[5.5]") {
  const auto segment = [](const Vec3& p, const Vec3& q) { return Triangle{p, 0.5 * (p + q), q}; };
  const auto point = [](const Vec3& p) { return Triangle{p, p, p}; };
  expect_all({{floor_, segment(Vec3(1, 1, -2), Vec3(1, 1, 2))},
              {floor_, segment(Vec3(1, 1, 0), Vec3(1, 1, 2))},
              {floor_, segment(Vec3(0, 0, -2), Vec3(0, 0, 2))},
              {floor_, segment(Vec3(-2, 1, 0), Vec3(9, 2, 0))},
              {floor_, segment(Vec3(1, 1, 0), Vec3(2, 1, 0))},
              {floor_, {Vec3(1, 1, -2), Vec3(1, 1, -2), Vec3(1, 1, 2)}},
              {floor_, point(Vec3(1, 1, 0))},
              {floor_, point(Vec3(2, 2, 0))},
              {floor_, point(Vec3(0, 4, 0))},
              {segment(Vec3(-1, 0, 3), Vec3(1, 0, 3)), segment(Vec3(0, -1, 3), Vec3(0, 1, 3))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), segment(Vec3(1, 2, 3), Vec3(3, 6, 9))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), segment(Vec3(2, 4, 6), Vec3(3, 7, 9))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), point(Vec3(1, 2, 3))},
              {point(Vec3(1, 2, 3)), point(Vec3(1, 2, 3))}},
             true, without_plane);
}

TEST_CASE("A segment or a point beside a triangle does not meet it", "[5.5]") {
  const auto segment = [](const Vec3& p, const Vec3& q) { return Triangle{p, 0.5 * (p + q), q}; };
  const auto point = [](const Vec3& p) { return Triangle{p, p, p}; };
  expect_all({{floor_, segment(Vec3(3, 3, -2), Vec3(3, 3, 2))},
              {floor_, segment(Vec3(1, 1, 1), Vec3(1, 1, 2))},
              {floor_, segment(Vec3(5, 0, 0), Vec3(0, 5, 0))},
              {floor_, segment(Vec3(5, 0, 0), Vec3(9, 0, 0))},
              {floor_, point(Vec3(3, 3, 0))},
              {floor_, point(Vec3(1, 1, 1e-60))},
              {segment(Vec3(-1, 0, 3), Vec3(1, 0, 3)), segment(Vec3(0, -1, 4), Vec3(0, 1, 4))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), segment(Vec3(3, 6, 9), Vec3(4, 8, 12))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), segment(Vec3(0, 0, 1), Vec3(2, 4, 7))},
              {segment(Vec3(0, 0, 0), Vec3(2, 4, 6)), point(Vec3(1, 2, 4))},
              {point(Vec3(1, 2, 3)), point(Vec3(1, 2, 4))}},
             false, "");
}

TEST_CASE("Triangles that are apart by the last bit do not meet", "[5.5]") {
  const double next = std::nextafter(1.0, 2.0);
  const Triangle at_one = plus(floor_, Vec3::UnitZ());
  Triangle above = at_one;
  for (Vec3& p : above) p.z() = next;
  const Triangle slope{Vec3(0.1, 0.2, 0.3), Vec3(0.7, 0.1, 0.9), Vec3(0.2, 0.8, 0.4)};
  const Vec3 middle(0.3, 0.3, std::nextafter(0.47, 1.0));
  expect_all({{at_one, above}, {at_one, {Vec3(1, 1, next), Vec3(1, 1, 3), Vec3(2, 1, 3)}}}, false,
             rounded);
  // A needle that ends about where the slope is: which side it ends on is a matter of the last bit.
  int index = 0;
  for (int k = -40; k <= 40; ++k) {
    const Vec3 end = middle + Vec3(0.0, 0.0, 2e-17 * k + 5e-17 * (k % 7));
    const Triangle needle{end, Vec3(0.31, 0.3, 2.0), Vec3(0.3, 0.31, 2.0)};
    expect_meet({slope, needle}, tests::meet_exactly(slope, needle), rounded, ++index, 81);
  }
}

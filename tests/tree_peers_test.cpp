#include <algorithm>

#include "catch.hpp"
#include "chart_shapes.hpp"
#include "peers.hpp"

using namespace lab::bvh_traversal;

namespace {

constexpr std::size_t triangles = 1000;

std::vector<TrianglePair> by_brute_force(const ShapePair& shapes, const RigidTransform& a_from_b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t j = 0; j < shapes.b.triangles.size(); ++j) {
    const Triangle b = common::transformed(a_from_b, triangle(shapes.b, j));
    for (std::uint32_t i = 0; i < shapes.a.triangles.size(); ++i) {
      if (triangles_meet(triangle(shapes.a, i), b)) pairs.push_back({i, j});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

// These shapes have no pair that nearly meets: so engines that round must agree, too.
TEST_CASE("Whatever is installed finds the pairs that meet - at rest and turned and back",
          "[peers]") {
  for (const ShapePair& shapes : {tori(triangles), spheres(triangles)}) {
    const std::vector<TrianglePair> at_rest = by_brute_force(shapes, {});
    const std::vector<TrianglePair> in_new_pose = by_brute_force(shapes, turned());
    REQUIRE(at_rest.size() > 100);
    REQUIRE(in_new_pose.size() > 100);
    REQUIRE(in_new_pose != at_rest);
    for (const Peer& peer : peers()) {
      if (!peer.make) {
        WARN(left_out(peer));
        continue;
      }
      INFO(peer.name);
      const auto trees = peer.make(shapes.a, shapes.b);
      const auto found = [&](const RigidTransform& a_from_b) {
        trees->place(a_from_b);
        Intersections result = trees->find();
        CHECK(result.triangle_tests >= result.pairs.size());
        CHECK(result.triangle_tests < triangles * triangles / 10);
        std::sort(result.pairs.begin(), result.pairs.end());
        return result.pairs;
      };
      CHECK(found({}) == at_rest);
      CHECK(found(turned()) == in_new_pose);
      CHECK(found({}) == at_rest);
    }
  }
}

TEST_CASE("A library that is not installed is named with its package", "[peers]") {
  CHECK(left_out({"FCL", "libfcl-dev", nullptr}) == "FCL (libfcl-dev is not installed)");
  CHECK(peers().size() == 3);
}

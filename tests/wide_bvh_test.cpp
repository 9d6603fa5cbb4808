#include "common/wide_bvh/wide_intersections.hpp"

#include <stdexcept>

#include "bvh_traversal.hpp"
#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "random.hpp"

using common::RigidTransform;
using common::TriangleIndices;
using common::TriangleMesh;
using common::Vec3;
using common::WideBvh;
using common::WideIntersections;
using lab::bvh_traversal::triangles_meet;

namespace {

std::vector<TriangleIndices> by_brute_force(const TriangleMesh& a, const TriangleMesh& b,
                                            const RigidTransform* a_from_b) {
  std::vector<TriangleIndices> pairs;
  for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
    for (std::uint32_t j = 0; j < b.triangles.size(); ++j) {
      const common::Triangle other = triangle(b, j);
      if (triangles_meet(triangle(a, i),
                         a_from_b != nullptr ? transformed(*a_from_b, other) : other)) {
        pairs.push_back({i, j});
      }
    }
  }
  return pairs;
}

/// Returns how many pairs there are.
std::size_t check_at_rest(const TriangleMesh& a, const TriangleMesh& b) {
  const std::vector<TriangleIndices> wanted = by_brute_force(a, b, nullptr);
  const WideIntersections found = find_intersections(WideBvh(a), WideBvh(b), triangles_meet);
  CHECK(found.pairs == wanted);
  CHECK(found.triangle_tests >= wanted.size());
  return wanted.size();
}

std::size_t check_moved(const TriangleMesh& a, const TriangleMesh& b,
                        const RigidTransform& a_from_b) {
  const std::vector<TriangleIndices> wanted = by_brute_force(a, b, &a_from_b);
  CHECK(find_intersections(WideBvh(a), WideBvh(b), a_from_b, triangles_meet).pairs == wanted);
  return wanted.size();
}

RigidTransform drawn_transform(tests::Random& random) {
  const Vec3 axis = random.direction();
  return {Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis).toRotationMatrix(),
          0.3 * random.direction()};
}

const TriangleMesh torus = common::bumpy_torus(400);
const TriangleMesh sphere = common::bumpy_sphere(400);

TriangleMesh shifted(const TriangleMesh& mesh, const Vec3& offset) {
  return common::scaled(mesh, Vec3::Ones(), offset);
}

}  // namespace

TEST_CASE("A wide tree finds what brute force finds") {
  CHECK(check_at_rest(torus, shifted(torus, {0.5, 0.2, 0.1})) > 100);
  CHECK(check_at_rest(torus, sphere) > 100);
  CHECK(check_at_rest(sphere, common::bumpy_torus(36)) > 10);
}

TEST_CASE("A wide tree finds what brute force finds when one has moved") {
  tests::Random random(20);
  std::size_t pairs = 0;
  for (int i = 0; i < 10; ++i) {
    const RigidTransform a_from_b = drawn_transform(random);
    pairs += check_moved(torus, torus, a_from_b);
    pairs += check_moved(sphere, torus, a_from_b);
  }
  CHECK(pairs > 1000);
}

TEST_CASE("A wide tree finds what touches") {
  const TriangleMesh grid = common::flat_grid(8);
  CHECK(check_at_rest(grid, grid) > grid.triangles.size());
  CHECK(check_at_rest(grid, shifted(grid, {8.0, 0.0, 0.0})) > 8);
  CHECK(check_at_rest(grid, shifted(grid, {8.0, 8.0, 0.0})) > 0);
  CHECK(check_at_rest(torus, torus) > torus.triangles.size());
  RigidTransform quarter;
  quarter.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  CHECK(check_moved(grid, grid, quarter) > 8);
  CHECK(check_moved(grid, grid, {}) > grid.triangles.size());
}

TEST_CASE("A gap of one rounding parts what a wide tree finds") {
  const TriangleMesh grid = common::flat_grid(8);
  CHECK(check_at_rest(grid, shifted(grid, {0.0, 0.0, 5e-324})) == 0);
  CHECK(check_moved(grid, grid, {common::Mat3::Identity(), {0.0, 0.0, 1e-300}}) == 0);
}

TEST_CASE("A wide tree finds segments and points") {
  const TriangleMesh line = common::scaled(sphere, {1.0, 0.0, 0.0});
  const TriangleMesh point = common::scaled(sphere, {0.0, 0.0, 0.0}, {0.5, 0.0, 0.0});
  CHECK(check_at_rest(sphere, line) > 0);
  CHECK(check_at_rest(line, point) > 0);
  CHECK(check_at_rest(point, point) == point.triangles.size() * point.triangles.size());
}

TEST_CASE("A wide tree finds what brute force finds where boxes lose") {
  const TriangleMesh slivers = common::diagonal_slivers(60);
  check_at_rest(slivers, shifted(slivers, {0.001, 0.001, 0.0}));
  const TriangleMesh clusters = common::clusters(700);
  CHECK(check_at_rest(clusters, clusters) >= clusters.triangles.size());
  const TriangleMesh huge = common::with_huge_triangle(torus);
  CHECK(check_at_rest(huge, shifted(torus, {0.1, 0.1, 0.1})) > 0);
  CHECK(check_at_rest(torus, common::inflated(torus, 0.01)) < torus.triangles.size());
}

TEST_CASE("A wide tree finds the same at any size and place") {
  const TriangleMesh other = shifted(torus, {0.5, 0.2, 0.1});
  for (const double size : {1e-60, 1e-12, 1e9, 1e59}) {
    const Vec3 factors = Vec3::Constant(size);
    CHECK(check_at_rest(common::scaled(torus, factors), common::scaled(other, factors)) > 100);
  }
  const Vec3 far(1e9, -2e9, 3e8);
  CHECK(check_at_rest(shifted(torus, far), shifted(other, far)) > 100);
  CHECK(check_moved(shifted(torus, far), other, {common::Mat3::Identity(), far}) > 100);
  CHECK(check_at_rest(common::scaled(torus, Vec3::Constant(1e30)), torus) == 0);
}

TEST_CASE("A matrix that turns and stretches still finds all") {
  tests::Random random(21);
  for (const double stretch : {0.5, 0.999, 1.5}) {
    RigidTransform a_from_b = drawn_transform(random);
    a_from_b.rotation *= stretch;
    CHECK(check_moved(torus, sphere, a_from_b) > 0);
  }
}

TEST_CASE("A wide tree saves triangle tests") {
  const TriangleMesh mesh = common::bumpy_torus(10000);
  const auto found =
      find_intersections(WideBvh(mesh), WideBvh(shifted(mesh, {0.5, 0.2, 0.1})), triangles_meet);
  CHECK(found.pairs.size() > 1000);
  CHECK(found.triangle_tests < 1000 * found.pairs.size());
  CHECK(found.box_tests < mesh.triangles.size() * 10);
}

TEST_CASE("What is no mesh or no pose is refused") {
  TriangleMesh broken = torus;
  broken.vertices[3].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(WideBvh(broken), std::invalid_argument);
  CHECK_THROWS_AS(WideBvh(TriangleMesh{}), std::invalid_argument);
  RigidTransform pose;
  pose.translation.y() = std::numeric_limits<double>::infinity();
  const WideBvh bvh(torus);
  CHECK_THROWS_AS(find_intersections(bvh, bvh, pose, triangles_meet), std::invalid_argument);
}

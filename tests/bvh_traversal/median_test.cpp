#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "structure.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::exactly;
using tests::Shape;
using tests::Trial;

namespace {

const std::string uneven =
    "the halves differ by more than one triangle: cut at the middle of the sorted centroids, not "
    "at the middle of their span";
const std::string another_axis =
    "the centroids spread less along this axis than along another: cut along the widest";
const std::string unsorted =
    "the halves are mixed: put the smaller centroids along the axis into one half";
const std::string boxes_cut =
    "this cuts between the middles of the triangles' boxes: cut between the centroids, (a + b + "
    "c)/3";

/// How far the greatest coordinate of one half is above the least of the other, for the better
/// order of the two.
double mixed(const std::pair<Vec3, Vec3>& p, const std::pair<Vec3, Vec3>& q, Eigen::Index axis) {
  return std::min(p.second[axis] - q.first[axis], q.second[axis] - p.first[axis]);
}

/// Whether each node is cut along an axis between the middles of its triangles' boxes.
bool cuts_boxes(const Bvh& bvh, const Shape& shape) {
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    if (tests::is_leaf(bvh.nodes[i])) continue;
    const auto span = [&](std::size_t node) {
      return tests::span_of(tests::points_below(bvh, shape, node, tests::middle_of_box));
    };
    const auto p = span(bvh.nodes[i].first);
    const auto q = span(bvh.nodes[i].first + 1);
    const double size = (p.second - q.first).cwiseAbs().maxCoeff();
    if (!(std::min({mixed(p, q, 0), mixed(p, q, 1), mixed(p, q, 2)}) <= 8.0 * tests::eps * size)) {
      return false;
    }
  }
  return true;
}

/// Requires that each inner node is cut as eq. (5) says. A centroid is rounded a few times; so a
/// tie may fall either way.
void expect_median_cuts(const Trial& trial, const Bvh& bvh, const Shape& shape) {
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    if (tests::is_leaf(node)) continue;
    const double left = static_cast<double>(shape.below[node.first]);
    const double right = static_cast<double>(shape.below[node.first + 1]);
    trial.of("a cut").expect_small("difference of the numbers in its halves",
                                   std::abs(left - right),
                                   {1.0, "each half has half of the triangles"}, uneven);
    const auto p = tests::span_of(tests::points_below(bvh, shape, node.first));
    const auto q = tests::span_of(tests::points_below(bvh, shape, node.first + 1));
    const Vec3 low = p.first.cwiseMin(q.first);
    const Vec3 high = p.second.cwiseMax(q.second);
    const double widest = (high - low).maxCoeff();
    const double rounding = 8.0 * tests::eps * (low.cwiseAbs() + high.cwiseAbs()).maxCoeff();
    double least = std::numeric_limits<double>::infinity();
    double least_of_all = least;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      least_of_all = std::min(least_of_all, mixed(p, q, axis));
      if (high[axis] - low[axis] >= widest - rounding) least = std::min(least, mixed(p, q, axis));
    }
    if (least <= rounding) continue;
    const std::string likely = least_of_all <= rounding ? another_axis
                               : cuts_boxes(bvh, shape) ? boxes_cut
                                                        : unsorted;
    trial.of("a cut").expect_small("overlap of its halves", std::max(0.0, least),
                                   {rounding, "the rounding of the centroids"}, likely);
  }
}

Shape expect_median(const common::TriangleMesh& mesh, int leaf_size, int index, int count) {
  const Trial trial = Trial("5.2 build_median", index, count)
                          .given("mesh", code(mesh))
                          .given("leaf_size", static_cast<double>(leaf_size));
  const Bvh bvh = trial.returned([&] { return build_median(mesh, leaf_size); });
  const Shape shape = tests::expect_structure(trial, bvh, mesh, leaf_size);
  expect_median_cuts(trial, bvh, shape);
  const int deepest = *std::max_element(shape.depth.begin(), shape.depth.end());
  const int levels =
      tests::levels_of_halving(mesh.triangles.size(), static_cast<std::size_t>(leaf_size));
  trial.of("the depth")
      .expect_small("levels more than halving needs", std::max(0, deepest - levels), exactly,
                    tests::too_deep);
  return shape;
}

common::TriangleMesh copies(const Triangle& t, std::uint32_t count) {
  return {{t[0], t[1], t[2]}, std::vector<std::array<std::uint32_t, 3>>(count, {0, 1, 2})};
}

}  // namespace

TEST_CASE("Four triangles in a row are halved in the middle", "[5.2]") {
  common::TriangleMesh mesh;
  for (const double x : {10.0, 0.0, 30.0, 20.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0)}) {
      mesh.vertices.push_back(p + x * Vec3::UnitX());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  // Of seven nodes first: three of them have children, so that more can be told of a mistake.
  const Trial single = Trial("5.2 build_median").given("mesh", code(mesh)).given("leaf_size", 1.0);
  const Bvh singles = single.returned([&] { return build_median(mesh, 1); });
  tests::expect_structure(single, singles, mesh, 1);

  const Trial trial = Trial("5.2 build_median").given("mesh", code(mesh)).given("leaf_size", 2.0);
  const Bvh bvh = trial.returned([&] { return build_median(mesh, 2); });
  tests::expect_structure(trial, bvh, mesh, 2);
  trial.of("nodes.size()").expect(static_cast<double>(bvh.nodes.size()), 3.0, exactly);
  const bool first_is_left = bvh.nodes[1].box.low.x() == 0.0;
  const Box& left = bvh.nodes[first_is_left ? 1 : 2].box;
  const Box& right = bvh.nodes[first_is_left ? 2 : 1].box;
  trial.of("the left box").expect(tests::Corners{left}, {{Vec3(0, 0, 0), Vec3(13, 3, 0)}}, exactly);
  trial.of("the right box")
      .expect(tests::Corners{right}, {{Vec3(20, 0, 0), Vec3(33, 3, 0)}}, exactly);
}

TEST_CASE("Random soups are cut by the median of the widest axis", "[5.2]") {
  tests::Random random(21);
  for (int i = 1; i <= 24; ++i) {
    const int triangles = static_cast<int>(random.uniform(1.0, 60.0));
    common::TriangleMesh mesh = tests::soup(random, triangles, 1000);
    for (Vec3& vertex : mesh.vertices) vertex += random.vector(0.5);
    expect_median(mesh, 1 + i % 8, i, 24);
  }
}

TEST_CASE("The smooth meshes are cut by the median of the widest axis", "[5.2]") {
  expect_median(common::bumpy_sphere(1200), 4, 1, 3);
  expect_median(common::bumpy_torus(1600), 1, 2, 3);
  expect_median(common::flat_grid(20), 3, 3, 3);
}

TEST_CASE("Meshes of any size and far off are cut alike", "[5.2]") {
  const common::TriangleMesh sphere = common::bumpy_sphere(300);
  int index = 0;
  for (const double size : {1e60, 1e-60, 1e-9}) {
    expect_median(common::scaled(sphere, Vec3::Constant(size)), 3, ++index, 5);
  }
  expect_median(common::scaled(sphere, Vec3::Ones(), Vec3::Constant(1e6)), 3, ++index, 5);
  expect_median(common::scaled(sphere, Vec3(1.0, 1e9, 1.0)), 3, ++index, 5);
}

TEST_CASE("Points and lines along an axis stay in the boxes", "[5.2]") {
  tests::Random random(23);
  common::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Vec3 place = random.vector(4.0);
    const Vec3 along = i % 2 == 0 ? Vec3::Zero() : Vec3(random.uniform(0.5, 1.0) * Vec3::UnitY());
    for (const double s : {0.0, 0.5, 1.0}) mesh.vertices.push_back(place + s * along);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  expect_median(mesh, 1, 1, 2);
  expect_median(mesh, 4, 2, 2);
}

TEST_CASE("Any number of triangles fits any size of leaf", "[5.2]") {
  tests::Random random(22);
  for (int n = 1; n <= 12; ++n) {
    for (int leaf_size = 1; leaf_size <= 5; ++leaf_size) {
      expect_median(tests::soup(random, n, 9), leaf_size, 5 * (n - 1) + leaf_size, 60);
    }
  }
  expect_median(tests::soup(random, 3, 9), std::numeric_limits<int>::max(), 1, 1);
}

TEST_CASE("Triangles with a common centroid are halved as well", "[5.2]") {
  expect_median(copies({Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 4)}, 1000), 1, 1, 3);
  expect_median(copies({Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}, 513), 4, 2, 3);
  // One centroid, triangles of all sizes about it.
  common::TriangleMesh nested;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const double size = static_cast<double>(i + 1);
    for (const Vec3& p : {Vec3(2, -1, 0), Vec3(-1, 2, 0), Vec3(-1, -1, 0)}) {
      nested.vertices.push_back(size * p);
    }
    nested.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  expect_median(nested, 2, 3, 3);
}

TEST_CASE("Clusters and a huge triangle do not make the tree deeper", "[5.2]") {
  expect_median(common::clusters(2000), 2, 1, 3);
  expect_median(common::with_huge_triangle(common::bumpy_sphere(300)), 2, 2, 3);
  expect_median(common::diagonal_slivers(500), 2, 3, 3);
}

TEST_CASE("The work of a build grows as n log n", "[5.2]") {
  // n log2(n / leaf_size) triangles are sorted on the way down, but for the last level: a build
  // that peels off one at a time would take n² / 2.
  for (const std::size_t n : {400U, 1600U, 6400U}) {
    const common::TriangleMesh mesh = common::bumpy_torus(n);
    const Trial trial = Trial("5.2 build_median").given("mesh", code(mesh)).given("leaf_size", 1.0);
    const Bvh bvh = trial.returned([&] { return build_median(mesh, 1); });
    const Shape shape = tests::expect_structure(trial, bvh, mesh, 1);
    const double levels = tests::levels_of_halving(n, 1);
    trial.expect_small("triangles sorted over n ceil(log2 n)",
                       tests::work_of(bvh, shape) / (static_cast<double>(n) * levels),
                       {1.0, "each triangle is in one node per level"}, tests::too_deep);
  }
}

TEST_CASE("The tree of a large mesh is built quickly", "[5.2]") {
  // Twenty times what the last took, and a little: a list that is copied at each cut, or as long as
  // the mesh, takes 400 times as much and comes to no end.
  const common::TriangleMesh mesh = common::bumpy_torus(120000);
  const Trial trial = Trial("5.2 build_median").given("leaf_size", 1.0);
  const Bvh bvh = trial.returned([&] { return build_median(mesh, 1); });
  tests::expect_structure(trial, bvh, mesh, 1);
}

TEST_CASE("A broken mesh or a leaf size below one is refused", "[5.2]") {
  tests::expect_refusals("5.2 build_median", build_median);
}

#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "structure.hpp"

using namespace lab::bvh_traversal;
using common::TriangleMesh;
using tests::code;
using tests::exactly;
using tests::Trial;

namespace {

const std::string stale_boxes = "the boxes are still the old ones: rebuild them from the leaves up";
const std::string stale_corners =
    "the corners are still the old ones: copy them from the deformed mesh";
const std::string leaves_only =
    "only the leaves have new boxes: merge the boxes of the other nodes, from the leaves up";
const std::string only_grown = "the boxes only grow: start each one from an empty box";

double boxes_apart(const Bvh& bvh, const std::vector<Box>& boxes) {
  double apart = 0.0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    apart += tests::box_difference(bvh.nodes[i].box, boxes[i]);
  }
  return apart;
}

/// The boxes about the deformed mesh, by other means.
std::vector<Box> boxes_about(const Bvh& bvh, const TriangleMesh& deformed) {
  std::vector<Triangle> corners;
  corners.reserve(bvh.triangles.size());
  for (const std::uint32_t i : bvh.triangles) corners.push_back(triangle(deformed, i));
  return tests::smallest_boxes(bvh.nodes, corners);
}

/// A tree of leaves of one triangle each, cut at a third in the order of the mesh. Its boxes are no
/// good for a query, but a refit makes no difference there, and nothing need be sorted.
Bvh tree_in_order_of(const TriangleMesh& mesh) {
  const std::size_t size = mesh.triangles.size();
  Bvh bvh;
  bvh.triangles.reserve(size);
  bvh.corners.reserve(size);
  bvh.nodes.reserve(2 * size);
  for (std::uint32_t i = 0; i < size; ++i) {
    bvh.triangles.push_back(i);
    bvh.corners.push_back(triangle(mesh, i));
  }
  bvh.nodes.resize(1);
  std::vector<std::uint32_t> counts{static_cast<std::uint32_t>(size)};
  for (std::uint32_t i = 0, placed = 0; i < bvh.nodes.size(); ++i) {
    if (counts[i] == 1) {
      bvh.nodes[i].first = placed++;
      bvh.nodes[i].count = 1;
      continue;
    }
    bvh.nodes[i].first = static_cast<std::uint32_t>(bvh.nodes.size());
    bvh.nodes.resize(bvh.nodes.size() + 2);
    const std::uint32_t third = std::max(counts[i] / 3, 1U);
    counts.insert(counts.end(), {third, counts[i] - third});
  }
  const std::vector<Box> boxes = boxes_about(bvh, mesh);
  for (std::size_t i = 0; i < boxes.size(); ++i) bvh.nodes[i].box = boxes[i];
  return bvh;
}

/// What boxes that are wrong are likely to be.
std::string story_of_boxes(const Bvh& got, const Bvh& before, const std::vector<Box>& wanted) {
  std::vector<Box> old;
  std::vector<Box> grown = wanted;
  std::vector<Box> new_in_leaves;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const BvhNode& node = before.nodes[i];
    old.push_back(node.box);
    tests::extend(grown[i], node.box);
    new_in_leaves.push_back(tests::is_leaf(node) ? wanted[i] : node.box);
  }
  if (boxes_apart(got, new_in_leaves) == 0.0) return leaves_only;
  if (boxes_apart(got, grown) == 0.0) return only_grown;
  if (boxes_apart(got, old) != 0.0) return "";
  return got.corners == before.corners ? stale_corners : stale_boxes;
}

void expect_refit(const Bvh& before, const TriangleMesh& mesh, const TriangleMesh& deformed,
                  int index, int count) {
  const std::vector<Box> wanted = boxes_about(before, deformed);
  const Trial trial = Trial("5.7 refit", index, count)
                          .given("mesh before", code(mesh))
                          .given("deformed", code(deformed));
  const Bvh got = trial.returned([&] { return refit(before, deformed); });
  tests::expect_finite(trial, got);
  trial.of("nodes.size()")
      .expect(static_cast<double>(got.nodes.size()), static_cast<double>(wanted.size()),
              {0.0, "the tree itself stays the same"});
  const double error = boxes_apart(got, wanted);
  trial.of("the boxes")
      .expect_small("distance from the smallest boxes", error, exactly,
                    error == 0.0 ? "" : story_of_boxes(got, before, wanted));
  double links = 0.0;
  for (std::size_t i = 0; i < got.nodes.size(); ++i) {
    links += got.nodes[i].first != before.nodes[i].first ? 1.0 : 0.0;
    links += got.nodes[i].count != before.nodes[i].count ? 1.0 : 0.0;
  }
  trial.of("the links").expect_small("links that differ from before", links, exactly);
  const double wrong = tests::wrong_entries(got, deformed);
  trial.of("the entries")
      .expect_small("entries that are not those of the deformed mesh", wrong, exactly,
                    got.corners == before.corners ? stale_corners : "");
}

void expect_refit(const TriangleMesh& mesh, const TriangleMesh& deformed, std::size_t leaf_size,
                  int index, int count) {
  expect_refit(tests::tree_of(mesh, leaf_size), mesh, deformed, index, count);
}

}  // namespace

TEST_CASE("A stretched mesh gets a stretched tree", "[5.7]") {
  const TriangleMesh mesh = common::bumpy_torus(100);
  expect_refit(mesh, common::scaled(mesh, Vec3(2.0, 0.5, 1.0), Vec3(3.0, 0.0, 0.0)), 4, 1, 1);
}

TEST_CASE("A refit holds a mesh whose vertices are all moved at random", "[5.7]") {
  tests::Random random(91);
  for (int i = 1; i <= 20; ++i) {
    const TriangleMesh mesh = tests::spread(random, 20, 9);
    TriangleMesh deformed = mesh;
    for (Vec3& vertex : deformed.vertices) vertex += random.vector(5.0);
    expect_refit(mesh, deformed, static_cast<std::size_t>(1 + i % 3), i, 20);
  }
}

TEST_CASE("A refitted tree shrinks with the mesh even if it is one leaf", "[5.7]") {
  const TriangleMesh mesh = common::bumpy_sphere(48);
  const TriangleMesh small = common::scaled(mesh, Vec3::Constant(0.25));
  expect_refit(mesh, small, 2, 1, 2);
  expect_refit(mesh, small, 100, 2, 2);
}

TEST_CASE("The tree of a large mesh is refitted quickly", "[5.7]") {
  // A pass over the whole tree for each of its nodes looks at 2e10 nodes, and comes to no end.
  const TriangleMesh mesh = common::bumpy_torus(70000);
  const Bvh tree = tree_in_order_of(mesh);
  expect_refit(tree, mesh, common::scaled(mesh, Vec3(1.0, 2.0, 1.0)), 1, 1);
}

TEST_CASE("A refit refuses another number of triangles and a broken mesh", "[5.7]") {
  const TriangleMesh mesh = common::bumpy_torus(36);
  const Bvh bvh = tests::tree_of(mesh, 4);
  TriangleMesh fewer = mesh;
  fewer.triangles.pop_back();
  TriangleMesh more = mesh;
  more.triangles.push_back(mesh.triangles[0]);
  TriangleMesh broken = mesh;
  broken.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  TriangleMesh beyond = mesh;
  beyond.triangles[3][1] = 10000;
  struct Case {
    std::string why;
    TriangleMesh mesh;
  };
  int index = 0;
  for (const Case& c :
       {Case{"it has one triangle fewer", fewer}, Case{"it has one triangle more", more},
        Case{"a vertex is NaN", broken}, Case{"vertex 10000 does not exist", beyond}}) {
    Trial("5.7 refit", ++index, 4)
        .given("deformed", tests::Code{c.why})
        .expect_throw([&] { return tests::Tree{refit(bvh, c.mesh)}; }, c.why);
  }
}

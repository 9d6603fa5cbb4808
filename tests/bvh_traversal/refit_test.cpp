#include "common/meshes.hpp"
#include "structure.hpp"

using namespace lab::bvh_traversal;
using common::TriangleMesh;
using tests::code;
using tests::exactly;
using tests::Trial;

namespace {

const std::string stale_boxes = "the boxes are those of before: make them anew from the leaves up";
const std::string stale_corners =
    "the corners are those of before: copy them from the deformed mesh";
const std::string leaves_only =
    "only the leaves have new boxes: their parents' are merged from them";
const std::string only_grown = "the boxes only grow: they still hold the mesh of before";

Bvh with_boxes(Bvh bvh, const std::vector<BvhNode>& nodes, bool leaves, bool inner) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (tests::is_leaf(nodes[i]) ? leaves : inner) bvh.nodes[i].box = nodes[i].box;
  }
  return bvh;
}

double boxes_apart(const Bvh& a, const Bvh& b) {
  double apart = 0.0;
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    apart += difference(tests::Corners{a.nodes[i].box}, tests::Corners{b.nodes[i].box});
  }
  return apart;
}

/// The tree about the deformed mesh, by other means.
Bvh refitted(Bvh bvh, const TriangleMesh& deformed) {
  for (std::size_t i = 0; i < bvh.triangles.size(); ++i) {
    bvh.corners[i] = triangle(deformed, bvh.triangles[i]);
  }
  const tests::Shape shape = tests::shape_of(bvh);
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    // In a tree of the tests the entries of a node stand side by side, first child first.
    std::size_t leaf = i;
    while (!tests::is_leaf(bvh.nodes[leaf])) leaf = bvh.nodes[leaf].first;
    bvh.nodes[i].box = tests::box_around(bvh.corners, bvh.nodes[leaf].first, shape.below[i]);
  }
  return bvh;
}

void expect_refit(const TriangleMesh& mesh, const TriangleMesh& deformed, std::size_t leaf_size,
                  int index, int count) {
  const Bvh before = tests::tree_of(mesh, leaf_size);
  const Bvh wanted = refitted(before, deformed);
  const Trial trial = Trial("5.7 refit", index, count)
                          .given("mesh before", code(mesh))
                          .given("deformed", code(deformed));
  const Bvh got = trial.returned([&] { return refit(before, deformed); });
  tests::expect_finite(trial, got);
  trial.of("nodes.size()")
      .expect(static_cast<double>(got.nodes.size()), static_cast<double>(wanted.nodes.size()),
              {0.0, "the tree stays the same"});
  Bvh grown = wanted;
  for (std::size_t i = 0; i < grown.nodes.size(); ++i) {
    Box& box = grown.nodes[i].box;
    box = {box.low.cwiseMin(before.nodes[i].box.low), box.high.cwiseMax(before.nodes[i].box.high)};
  }
  const double error = boxes_apart(got, wanted);
  std::string likely;
  if (boxes_apart(got, before) == 0.0) {
    likely = got.corners == before.corners ? stale_corners : stale_boxes;
  }
  if (boxes_apart(got, grown) == 0.0) likely = only_grown;
  if (boxes_apart(got, with_boxes(before, wanted.nodes, true, false)) == 0.0) likely = leaves_only;
  trial.of("the boxes").expect_small("distance from the smallest boxes", error, exactly, likely);
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

}  // namespace

TEST_CASE("A mesh that is stretched has a tree that is stretched", "[5.7]") {
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

TEST_CASE("A refit shrinks with the mesh and of one leaf is that leaf", "[5.7]") {
  const TriangleMesh mesh = common::bumpy_sphere(48);
  const TriangleMesh small = common::scaled(mesh, Vec3::Constant(0.25));
  expect_refit(mesh, small, 2, 1, 2);
  expect_refit(mesh, small, 100, 2, 2);
}

TEST_CASE("A large mesh is refitted at once", "[5.7]") {
  // A pass over the whole tree for each of its nodes comes to no end.
  const TriangleMesh mesh = common::bumpy_torus(100000);
  expect_refit(mesh, common::scaled(mesh, Vec3(1.0, 2.0, 1.0)), 1, 1, 1);
}

TEST_CASE("A refit refuses another number of triangles and a broken mesh", "[5.7]") {
  const TriangleMesh mesh = common::bumpy_torus(36);
  const Bvh bvh = tests::tree_of(mesh, 4);
  TriangleMesh fewer = mesh;
  fewer.triangles.pop_back();
  TriangleMesh broken = mesh;
  broken.vertices[7].x() = std::numeric_limits<double>::quiet_NaN();
  TriangleMesh beyond = mesh;
  beyond.triangles[3][1] = 10000;
  struct Case {
    std::string why;
    TriangleMesh mesh;
  };
  int index = 0;
  for (const Case& c : {Case{"it has one triangle less", fewer}, Case{"a vertex is NaN", broken},
                        Case{"vertex 10000 does not exist", beyond}}) {
    Trial("5.7 refit", ++index, 3)
        .given("deformed", tests::Code{c.why})
        .expect_throw([&] { return tests::Tree{refit(bvh, c.mesh)}; }, c.why);
  }
}

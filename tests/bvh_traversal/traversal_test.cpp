#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "walks.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::expect_walk;
using tests::Pairs;
using tests::pairs_of;
using tests::row;
using tests::Trial;

namespace {

void expect_complete(const common::TriangleMesh& a, const common::TriangleMesh& b,
                     std::size_t leaf_size, int index, int count) {
  expect_walk(traverse, true,
              Trial("5.4 traverse", index, count).given("mesh a", code(a)).given("mesh b", code(b)),
              tests::tree_of(a, leaf_size), tests::tree_of(b, leaf_size));
}

}  // namespace

TEST_CASE("A bigger leaf does not stop the complete version", "[5.4]") {
  expect_complete(row(1, 8.0, 0.0), row(2, 1.0, 2.0), 1, 1, 2);
  expect_complete(row(2, 1.0, 2.0), row(1, 8.0, 0.0), 1, 2, 2);
}

TEST_CASE("Two roots that are leaves are an end if their boxes overlap", "[5.4]") {
  expect_complete(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 1, 1, 2);
  expect_complete(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 9, 2, 2);
}

TEST_CASE("Of two inner nodes the one with the larger surface is descended", "[5.4]") {
  // Rows of different lengths: a's nodes are larger at first, b's further down.
  expect_complete(row(16, 1.0, 1.0), row(3, 5.0, 4.0), 1, 1, 2);
  expect_complete(row(3, 5.0, 4.0), row(16, 1.0, 1.0), 1, 2, 2);
}

TEST_CASE("Nodes whose boxes only touch are descended", "[5.4]") {
  expect_complete(row(6, 1.0, 1.0), row(6, 1.0, 1.0), 1, 1, 1);
}

TEST_CASE("The complete version finds all pairs of leaves on random soups", "[5.4]") {
  tests::Random random(41);
  for (int i = 1; i <= 60; ++i) {
    const int n = static_cast<int>(random.uniform(1.0, 60.0));
    const common::TriangleMesh a = tests::spread(random, n, 12);
    const common::TriangleMesh b = tests::spread(random, 61 - n, 12);
    expect_complete(a, b, static_cast<std::size_t>(1 + i % 4), i, 60);
  }
}

TEST_CASE("Only pairs of leaves whose boxes overlap are found and none is missed", "[5.4]") {
  tests::Random random(42);
  const common::TriangleMesh a = tests::spread(random, 100, 10);
  const common::TriangleMesh b = tests::spread(random, 100, 10);
  const Bvh tree_a = tests::tree_of(a, 3);
  const Bvh tree_b = tests::tree_of(b, 3);
  Pairs wanted;
  for (std::uint32_t i = 0; i < tree_a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < tree_b.nodes.size(); ++j) {
      if (tree_a.nodes[i].count == 0 || tree_b.nodes[j].count == 0) continue;
      if (tests::boxes_meet(tree_a.nodes[i].box, tree_b.nodes[j].box))
        wanted.pairs.push_back({i, j});
    }
  }
  const Trial trial = Trial("5.4 traverse").given("mesh a", code(a)).given("mesh b", code(b));
  const Traversal got = trial.returned([&] { return traverse(tree_a, tree_b); });
  trial.expect(pairs_of(got.ends), wanted, tests::exactly);
}

TEST_CASE("A tree against itself finds each of its leaves", "[5.4]") {
  tests::Random random(43);
  const common::TriangleMesh mesh = tests::spread(random, 80, 9);
  expect_complete(mesh, mesh, 2, 1, 1);
}

TEST_CASE("Trees of any size are traversed alike", "[5.4]") {
  tests::Random random(44);
  const common::TriangleMesh mesh = tests::spread(random, 60, 9);
  int index = 0;
  for (const double size : {0x1p199, 0x1p-199}) {  // exact, so that equal boxes stay equal
    const common::TriangleMesh scaled = common::scaled(mesh, Vec3::Constant(size));
    expect_complete(scaled, scaled, 2, ++index, 2);
  }
}

TEST_CASE("Large trees are traversed quickly", "[5.4]") {
  // Some hundred thousand pairs: a tree that is copied at each call comes to no end.
  const Bvh torus = tests::tree_of(common::bumpy_torus(6400), 1);
  expect_walk(traverse, true, Trial("5.4 traverse"), torus, torus);
}

TEST_CASE("A traversal does not grow as the product of the sizes of the meshes", "[5.4]") {
  // Two rows of n triangles that meet in one place: depth² pairs of nodes at the most.
  for (const int n : {100, 1000}) {
    const common::TriangleMesh a = row(n, 1.0, 2.0);
    common::TriangleMesh b = row(n, 1.0, 2.0);
    for (Vec3& vertex : b.vertices) std::swap(vertex.x(), vertex.y());
    expect_complete(a, b, 1, n == 100 ? 1 : 2, 2);
  }
}

#include "catch.hpp"
#include "walks.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::expect_walk;
using tests::row;
using tests::Trial;
using tests::Walker;

namespace {

void expect_first(const common::TriangleMesh& a, const common::TriangleMesh& b,
                  std::size_t leaf_size, int index, int count) {
  expect_walk(traverse_as_first_written, false,
              Trial("5.3 traverse_as_first_written", index, count)
                  .given("mesh a", code(a))
                  .given("mesh b", code(b)),
              tests::tree_of(a, leaf_size), tests::tree_of(b, leaf_size));
}

/// The nodes at or below `node`.
std::vector<bool> below(const Bvh& bvh, std::uint32_t node) {
  std::vector<bool> is_below(bvh.nodes.size(), false);
  is_below[node] = true;
  for (std::size_t i = node; i < bvh.nodes.size(); ++i) {
    if (!is_below[i] || bvh.nodes[i].count > 0) continue;
    is_below[bvh.nodes[i].first] = true;
    is_below[bvh.nodes[i].first + 1] = true;
  }
  return is_below;
}

}  // namespace

TEST_CASE("A leaf that is bigger ends the first version at once", "[5.3]") {
  // a is one large leaf; b's root is smaller, and has two leaves that are never come to.
  expect_first(row(1, 8.0, 0.0), row(2, 1.0, 2.0), 1, 1, 1);
}

TEST_CASE("Two leaves end the first version", "[5.3]") {
  expect_first(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 1, 1, 2);
  expect_first(row(1, 1.0, 0.0), row(1, 1.0, 0.0), 1, 2, 2);
}

TEST_CASE("Of two boxes with the same area that of a is bigger", "[5.3]") {
  // The same triangles, once in one leaf and once in a leaf each.
  const common::TriangleMesh mesh = row(4, 1.0, 2.0);
  const Bvh leaf = tests::tree_of(mesh, 4);
  const Bvh tree = tests::tree_of(mesh, 1);
  const auto trial = [&](const char* shapes, int index) {
    return Trial("5.3 traverse_as_first_written", index, 2)
        .given("mesh a and b", code(mesh))
        .given("a, b", tests::Code{shapes});
  };
  expect_walk(traverse_as_first_written, false, trial("one leaf, leaves of 1", 1), leaf, tree);
  expect_walk(traverse_as_first_written, false, trial("leaves of 1, one leaf", 2), tree, leaf);
}

TEST_CASE("Roots that are apart end the first version without an end", "[5.3]") {
  const Bvh a = tests::tree_of(row(4, 1.0, 2.0), 1);
  common::TriangleMesh far = row(4, 1.0, 2.0);
  for (Vec3& vertex : far.vertices) vertex.y() += 2.0;
  expect_walk(traverse_as_first_written, false,
              Trial("5.3 traverse_as_first_written").given("distance", 1.0), a,
              tests::tree_of(far, 1));
}

TEST_CASE("The first version ends where the pseudocode has no rule on random soups", "[5.3]") {
  tests::Random random(31);
  for (int i = 1; i <= 60; ++i) {
    const int n = static_cast<int>(random.uniform(1.0, 30.0));
    const common::TriangleMesh a = tests::spread(random, n, 12);
    const common::TriangleMesh b = tests::spread(random, 31 - n, 12);
    expect_first(a, b, static_cast<std::size_t>(1 + i % 4), i, 60);
  }
}

TEST_CASE("The first version loses pairs of leaves below its ends", "[5.3]") {
  // Every pair that the complete version comes to is at or below an end of the first: so nothing is
  // lost but what the words do not say.
  tests::Random random(32);
  const common::TriangleMesh a = tests::spread(random, 60, 12);
  const common::TriangleMesh b = tests::spread(random, 25, 12);
  const Bvh tree_a = tests::tree_of(a, 2);
  const Bvh tree_b = tests::tree_of(b, 2);
  const Trial trial =
      Trial("5.3 traverse_as_first_written").given("mesh a", code(a)).given("mesh b", code(b));
  const Traversal got = trial.returned([&] { return traverse_as_first_written(tree_a, tree_b); });
  const Walker complete(tree_a, tree_b);
  double outside = 0.0;
  for (const tests::Indices& pair : complete.ends.pairs) {
    int covers = 0;
    for (const NodePair& end : got.ends) {
      covers += below(tree_a, end.a)[pair[0]] && below(tree_b, end.b)[pair[1]] ? 1 : 0;
    }
    outside += std::abs(covers - 1);
  }
  trial.expect_small("pairs of leaves that are not below exactly one end", outside, tests::exactly);
  double with_inner = 0.0;
  for (const NodePair& end : got.ends) {
    if (tree_a.nodes[end.a].count == 0 || tree_b.nodes[end.b].count == 0) with_inner += 1.0;
  }
  trial.expect_small("1 if no end has an inner node", with_inner > 0.0 ? 0.0 : 1.0, tests::exactly);
}

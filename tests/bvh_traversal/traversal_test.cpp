#include "common/meshes.hpp"
#include "trees.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::Pairs;
using tests::pairs_of;
using tests::Trial;
using tests::Walk;
using tests::Walker;

namespace {

struct Named {
  Walk walk;
  std::string story;
};

/// What known mistakes would do with the same trees.
std::vector<Named> mistakes_of(bool completed) {
  Walk smaller;
  smaller.bigger = false;
  Walk strict;
  strict.strict = true;
  Walk one_child;
  one_child.both_children = false;
  std::vector<Named> named{
      {smaller, "the smaller node is descended: the bigger one has more to lose"},
      {strict, "touching boxes are taken for apart: they share points"},
      {one_child, "only one child is gone on with: the loop is over each child"}};
  if (completed) {
    Walk no_leaf;
    no_leaf.one_leaf = false;
    Walk stuck;
    stuck.leaf_may_descend = false;
    named.push_back({no_leaf, "a leaf and an inner node are given up: go on with the inner one"});
    named.push_back({stuck,
                     "where the bigger node is a leaf nothing is done: the inner one has "
                     "children, bigger or not"});
    Walk as_first_written;
    as_first_written.leaves = false;
    named.push_back({as_first_written,
                     "this is the version of step 5.3: it stops at the first "
                     "leaf that is bigger"});
  }
  for (Named& n : named) n.walk.leaves = n.walk.leaves && completed;
  return named;
}

template <typename Traverse>
void expect_walk(const Traverse& call, bool completed, const Trial& trial, const Bvh& a,
                 const Bvh& b) {
  const Traversal got = trial.returned([&] { return call(a, b); });
  Walk right;
  right.leaves = completed;
  const Walker wanted(a, b, right);
  Pairs doubled = wanted.ends;
  doubled.pairs.insert(doubled.pairs.end(), wanted.ends.pairs.begin(), wanted.ends.pairs.end());
  std::sort(doubled.pairs.begin(), doubled.pairs.end());
  Pairs swapped = wanted.ends;
  for (tests::Indices& pair : swapped.pairs) std::swap(pair[0], pair[1]);
  std::sort(swapped.pairs.begin(), swapped.pairs.end());
  std::vector<tests::Suspect<Pairs>> ends{
      {doubled, "each pair is reported twice"},
      {swapped, "the two indices of a pair are swapped: a's comes first"}};
  std::vector<tests::Suspect<double>> counts;
  for (const Named& mistake : mistakes_of(completed)) {
    const Walker walker(a, b, mistake.walk);
    ends.push_back({walker.ends, mistake.story});
    counts.push_back({static_cast<double>(walker.box_tests), mistake.story});
  }
  const Pairs got_ends = pairs_of(got.ends);
  Pairs sorted = got_ends;
  std::sort(sorted.pairs.begin(), sorted.pairs.end());
  if (sorted.pairs == wanted.ends.pairs) {
    trial.of("the order of the ends")
        .expect_small("pairs out of order", tests::difference(got_ends, sorted), tests::exactly,
                      "the ends are not sorted");
  }
  trial.of("the ends").expect(got_ends, wanted.ends, tests::exactly, ends);
  trial.of("box_tests")
      .expect(static_cast<double>(got.box_tests), static_cast<double>(wanted.box_tests),
              {0.0, "every pair of nodes that it comes to is tested once"}, counts);
}

void expect_first(const common::TriangleMesh& a, const common::TriangleMesh& b,
                  std::size_t leaf_size, int index, int count) {
  expect_walk(traverse_as_first_written, false,
              Trial("5.3 traverse_as_first_written", index, count)
                  .given("mesh a", code(a))
                  .given("mesh b", code(b)),
              tests::tree_of(a, leaf_size), tests::tree_of(b, leaf_size));
}

void expect_complete(const common::TriangleMesh& a, const common::TriangleMesh& b,
                     std::size_t leaf_size, int index, int count) {
  expect_walk(traverse, true,
              Trial("5.4 traverse", index, count).given("mesh a", code(a)).given("mesh b", code(b)),
              tests::tree_of(a, leaf_size), tests::tree_of(b, leaf_size));
}

/// A row of right triangles with legs of `size` along x and y, `step` apart along x.
common::TriangleMesh row(int count, double size, double step) {
  common::TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 corner = static_cast<double>(i) * step * Vec3::UnitX();
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(corner);
    mesh.vertices.push_back(corner + size * Vec3::UnitX());
    mesh.vertices.push_back(corner + size * Vec3::UnitY());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
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

TEST_CASE("Two leaves end the first version and nothing tells what to do with them", "[5.3]") {
  expect_first(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 1, 1, 2);
  expect_first(row(1, 1.0, 0.0), row(1, 1.0, 0.0), 1, 2, 2);
}

TEST_CASE("Roots that are apart end the first version without an end", "[5.3]") {
  const Bvh a = tests::tree_of(row(4, 1.0, 2.0), 1);
  common::TriangleMesh far = row(4, 1.0, 2.0);
  for (Vec3& vertex : far.vertices) vertex.y() += 2.0;
  expect_walk(traverse_as_first_written, false,
              Trial("5.3 traverse_as_first_written").given("distance", 1.0), a,
              tests::tree_of(far, 1));
}

TEST_CASE("The first version ends where its words run out on random soups", "[5.3]") {
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
  trial.expect_small("1 where no end has an inner node", with_inner > 0.0 ? 0.0 : 1.0,
                     tests::exactly);
}

TEST_CASE("A bigger leaf does not stop the complete version", "[5.4]") {
  expect_complete(row(1, 8.0, 0.0), row(2, 1.0, 2.0), 1, 1, 2);
  expect_complete(row(2, 1.0, 2.0), row(1, 8.0, 0.0), 1, 2, 2);
}

TEST_CASE("Two roots that are leaves are an end where their boxes overlap", "[5.4]") {
  expect_complete(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 1, 1, 2);
  expect_complete(row(1, 2.0, 0.0), row(1, 1.0, 0.0), 9, 2, 2);
}

TEST_CASE("Of two inner nodes the one with the larger surface is descended", "[5.4]") {
  // Rows of different lengths: a's nodes are larger at first, b's further down.
  expect_complete(row(16, 1.0, 1.0), row(3, 5.0, 4.0), 1, 1, 2);
  expect_complete(row(3, 5.0, 4.0), row(16, 1.0, 1.0), 1, 2, 2);
}

TEST_CASE("Boxes that only touch are gone on with", "[5.4]") {
  expect_complete(row(6, 1.0, 1.0), row(6, 1.0, 1.0), 1, 1, 1);
}

TEST_CASE("The complete version comes to all pairs of leaves on random soups", "[5.4]") {
  tests::Random random(41);
  for (int i = 1; i <= 60; ++i) {
    const int n = static_cast<int>(random.uniform(1.0, 60.0));
    const common::TriangleMesh a = tests::spread(random, n, 12);
    const common::TriangleMesh b = tests::spread(random, 61 - n, 12);
    expect_complete(a, b, static_cast<std::size_t>(1 + i % 4), i, 60);
  }
}

TEST_CASE("Only pairs of leaves whose boxes overlap are come to and none is missed", "[5.4]") {
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

TEST_CASE("A tree against itself comes to each of its leaves", "[5.4]") {
  tests::Random random(43);
  const common::TriangleMesh mesh = tests::spread(random, 80, 9);
  expect_complete(mesh, mesh, 2, 1, 1);
}

TEST_CASE("A traversal does not grow as the product of the meshes", "[5.4]") {
  // Two rows of n triangles that meet in one place: depth² pairs of nodes at the most.
  for (const int n : {100, 1000}) {
    const common::TriangleMesh a = row(n, 1.0, 2.0);
    common::TriangleMesh b = row(n, 1.0, 2.0);
    for (Vec3& vertex : b.vertices) std::swap(vertex.x(), vertex.y());
    expect_complete(a, b, 1, n == 100 ? 1 : 2, 2);
  }
}

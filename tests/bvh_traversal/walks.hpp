#pragma once

#include "trees.hpp"

/// What is asked of a traversal's ends and count, and what known mistakes would return.
namespace tests {

struct Named {
  Walk walk;
  std::string story;
};

/// What known mistakes would do with the same trees.
inline std::vector<Named> mistakes_of(bool completed) {
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
void expect_walk(const Traverse& call, bool completed, const Trial& trial, const lab::Bvh& a,
                 const lab::Bvh& b) {
  const lab::Traversal got = trial.returned([&] { return call(a, b); });
  Walk right;
  right.leaves = completed;
  const Walker wanted(a, b, right);
  Pairs doubled = wanted.ends;
  doubled.pairs.insert(doubled.pairs.end(), wanted.ends.pairs.begin(), wanted.ends.pairs.end());
  std::sort(doubled.pairs.begin(), doubled.pairs.end());
  Pairs swapped = wanted.ends;
  for (Indices& pair : swapped.pairs) std::swap(pair[0], pair[1]);
  std::sort(swapped.pairs.begin(), swapped.pairs.end());
  std::vector<Suspect<Pairs>> ends{
      {doubled, "each pair is reported twice"},
      {swapped, "the two indices of a pair are swapped: a's comes first"}};
  std::vector<Suspect<double>> counts;
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
        .expect_small("pairs out of order", difference(got_ends, sorted), exactly,
                      "the ends are not sorted");
  }
  trial.of("the ends").expect(got_ends, wanted.ends, exactly, ends);
  trial.of("box_tests")
      .expect(static_cast<double>(got.box_tests), static_cast<double>(wanted.box_tests),
              {0.0, "every pair of nodes that it comes to is tested once"}, counts);
}

/// A row of right triangles with legs of `size` along x and y, `step` apart along x.
inline common::TriangleMesh row(int count, double size, double step) {
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

}  // namespace tests

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
  Walk ties_to_b;
  ties_to_b.ties_to_a = false;
  Walk strict;
  strict.strict = true;
  Walk one_child;
  one_child.both_children = false;
  std::vector<Named> named{{smaller, "the smaller node is descended: descend into the bigger one"},
                           {ties_to_b,
                            "of two nodes with the same area b's counts as bigger: it is a's, so "
                            "compare with >="},
                           {strict, "touching boxes are taken for apart: compare with <=, not <"},
                           {one_child, "only one child is visited: visit both"}};
  if (completed) {
    Walk no_leaf;
    no_leaf.one_leaf = false;
    Walk stuck;
    stuck.leaf_may_descend = false;
    named.push_back({no_leaf, "a leaf and an inner node are given up: descend into the inner one"});
    named.push_back({stuck,
                     "if the bigger node is a leaf nothing is done: descend into the inner node, "
                     "even if it is smaller"});
    Walk as_first_written;
    as_first_written.leaves = false;
    named.push_back({as_first_written,
                     "this is the version of step 5.3, which stops at a bigger leaf: descend into "
                     "the other node"});
  }
  for (Named& n : named) n.walk.leaves = n.walk.leaves && completed;
  if (!completed) {
    named.push_back({Walk{},
                     "this is the complete version of step 5.4: here, end a pair as soon as its "
                     "bigger node is a leaf"});
  }
  return named;
}

template <typename Traverse>
void expect_walk(const Traverse& call, bool completed, const Trial& trial, const lab::Bvh& a,
                 const lab::Bvh& b) {
  const lab::Traversal got = trial.returned([&] { return call(a, b); });
  Walk right;
  right.leaves = completed;
  const Walker wanted(a, b, right);
  const Pairs got_ends = pairs_of(got.ends);
  expect_sorted(trial, got_ends, wanted.ends, "ends");
  trial.of("the ends").expect(got_ends, wanted.ends, exactly, [&] {
    std::vector<Suspect<Pairs>> ends{
        {doubled(wanted.ends), "each pair is reported twice: report it once"},
        {swapped(wanted.ends), "the two indices of a pair are swapped: a's comes first"}};
    for (const Named& mistake : mistakes_of(completed)) {
      ends.push_back({Walker(a, b, mistake.walk).ends, mistake.story});
    }
    return ends;
  });
  trial.of("box_tests")
      .expect(static_cast<double>(got.box_tests), static_cast<double>(wanted.box_tests),
              {0.0, "every pair of nodes that it visits is tested once"}, [&] {
                std::vector<Suspect<double>> counts;
                for (const Named& mistake : mistakes_of(completed)) {
                  const Walker walker(a, b, mistake.walk);
                  counts.push_back({static_cast<double>(walker.box_tests), mistake.story});
                }
                return counts;
              });
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

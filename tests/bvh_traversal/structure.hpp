#pragma once

#include <bit>

#include "trees.hpp"

/// What every Bvh must be, whoever built it.
namespace tests {

/// Depths of all nodes and numbers of triangles below them. Made only of a tree whose links are
/// sound.
struct Shape {
  std::vector<int> depth;
  std::vector<std::size_t> below;
};

inline bool is_leaf(const lab::BvhNode& node) { return node.count > 0; }

/// How many nodes are not the child of exactly one node in front of them, or entries that are not
/// in exactly one leaf.
inline double broken_links(const lab::Bvh& bvh) {
  std::vector<int> parents(bvh.nodes.size(), 0);
  std::vector<int> leaves(bvh.triangles.size(), 0);
  double broken = bvh.nodes.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const lab::BvhNode& node = bvh.nodes[i];
    const std::size_t count = is_leaf(node) ? node.count : 2;
    std::vector<int>& owners = is_leaf(node) ? leaves : parents;
    const bool behind = is_leaf(node) || node.first > i;
    if (!behind || node.first + count > owners.size()) {
      broken += 1.0;
      continue;
    }
    for (std::size_t k = node.first; k < node.first + count; ++k) ++owners[k];
  }
  for (std::size_t i = 1; i < parents.size(); ++i) broken += std::abs(parents[i] - 1);
  for (const int owners : leaves) broken += std::abs(owners - 1);
  return broken;
}

inline Shape shape_of(const lab::Bvh& bvh) {
  Shape shape{std::vector<int>(bvh.nodes.size(), 0), std::vector<std::size_t>(bvh.nodes.size(), 0)};
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    if (is_leaf(bvh.nodes[i])) continue;
    shape.depth[bvh.nodes[i].first] = shape.depth[i] + 1;
    shape.depth[bvh.nodes[i].first + 1] = shape.depth[i] + 1;
  }
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    const lab::BvhNode& node = bvh.nodes[i];
    shape.below[i] =
        is_leaf(node) ? node.count : shape.below[node.first] + shape.below[node.first + 1];
  }
  return shape;
}

/// The smallest box of each node about such corners, from the leaves up.
inline std::vector<lab::Box> smallest_boxes(const std::vector<lab::BvhNode>& nodes,
                                            const std::vector<common::Triangle>& corners) {
  std::vector<lab::Box> boxes(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (is_leaf(nodes[i])) {
      boxes[i] = box_around(corners, nodes[i].first, nodes[i].count);
    } else {
      extend(boxes[i], boxes[nodes[i].first]);
      extend(boxes[i], boxes[nodes[i].first + 1]);
    }
  }
  return boxes;
}

/// How far a box is from another: NaN where one is not finite, and no root where they are equal.
inline double box_difference(const lab::Box& a, const lab::Box& b) {
  return a.low == b.low && a.high == b.high ? 0.0 : difference(Corners{a}, Corners{b});
}

/// How far boxes are from the smallest, over all nodes: NaN where one is not finite.
inline double box_error(const lab::Bvh& bvh) {
  const std::vector<lab::Box> wanted = smallest_boxes(bvh.nodes, bvh.corners);
  double error = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    error += box_difference(bvh.nodes[i].box, wanted[i]);
  }
  return error;
}

/// How many entries are not what they should be: each triangle of the mesh once, with its corners.
inline double wrong_entries(const lab::Bvh& bvh, const common::TriangleMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  if (bvh.triangles.size() != n || bvh.corners.size() != n) return static_cast<double>(n + 1);
  std::vector<int> seen(n, 0);
  double wrong = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t triangle = bvh.triangles[i];
    if (triangle >= n || ++seen[triangle] > 1) {
      wrong += 1.0;
    } else if (bvh.corners[i] != common::triangle(mesh, triangle)) {
      wrong += 1.0;
    }
  }
  return wrong;
}

inline const std::string unmerged =
    "the box of a node is not the smallest around all of its triangles: merge the boxes of its "
    "children";
inline const std::string too_deep =
    "the tree is too deep: if no cut separates the triangles, halve them by number";
inline const std::string leaf_too_large = "a leaf holds more than leaf_size triangles: cut it";

inline const std::string kept_reference =
    "a reference to a node is kept while `nodes` grows, which moves all nodes: write nodes[index] "
    "at the end";

/// How many nodes have the empty box that a node is made with. Where the root has and other inner
/// nodes have not, it was set in a place that the nodes have left.
inline void expect_boxes_set(const Trial& trial, const lab::Bvh& bvh) {
  const lab::Box made;
  const auto as_made = [&](const lab::BvhNode& node) {
    return node.box.low == made.low && node.box.high == made.high;
  };
  const auto is_set = [&](const lab::BvhNode& node) { return !is_leaf(node) && !as_made(node); };
  const std::vector<lab::BvhNode>& nodes = bvh.nodes;
  const bool moved =
      !nodes.empty() && as_made(nodes[0]) && std::any_of(nodes.begin(), nodes.end(), is_set);
  trial.of("the boxes of the nodes")
      .expect_small("number of empty boxes",
                    static_cast<double>(std::count_if(nodes.begin(), nodes.end(), as_made)),
                    exactly, moved ? kept_reference : "");
}

inline void expect_finite(const Trial& trial, const lab::Bvh& bvh) {
  trial.of("the boxes of the nodes")
      .expect_small("1 if one is not finite",
                    has_finite_boxes(bvh) ? 0.0 : std::numeric_limits<double>::quiet_NaN(),
                    exactly);
}

/// Requires that it is a Bvh of the mesh; returns its shape.
inline Shape expect_structure(const Trial& trial, const lab::Bvh& bvh,
                              const common::TriangleMesh& mesh, int leaf_size) {
  expect_boxes_set(trial, bvh);
  expect_finite(trial, bvh);
  trial.of("the links")
      .expect_small(
          "nodes without exactly one parent before them, and entries without exactly one leaf",
          broken_links(bvh), exactly);
  trial.of("the entries")
      .expect_small(
          "triangles of the mesh that are missing, doubled or have other "
          "corners",
          wrong_entries(bvh, mesh), exactly);
  const Shape shape = shape_of(bvh);
  const double error = box_error(bvh);
  trial.of("the boxes").expect_small("distance from the smallest boxes", error, exactly, unmerged);
  const int deepest = *std::max_element(shape.depth.begin(), shape.depth.end());
  trial.of("the depth")
      .expect_small("levels deeper than max_depth", std::max(0, deepest - lab::max_depth), exactly);
  double large_leaves = 0.0;
  double small_inner = 0.0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const bool small = shape.below[i] <= static_cast<std::size_t>(leaf_size);
    if (is_leaf(bvh.nodes[i]) && !small) large_leaves += 1.0;
    if (!is_leaf(bvh.nodes[i]) && small) small_inner += 1.0;
  }
  trial.of("the leaves")
      .expect_small("leaves larger than leaf_size", large_leaves, exactly, leaf_too_large);
  trial.of("the leaves")
      .expect_small("nodes that are cut but must not be", small_inner, exactly,
                    "a node of leaf_size triangles is cut: make it a leaf");
  return shape;
}

/// Entries of the leaves below a node, in whichever order these stand.
inline std::vector<std::size_t> entries_below(const lab::Bvh& bvh, const Shape& shape,
                                              std::size_t node) {
  std::vector<std::size_t> entries;
  std::vector<std::size_t> stack{node};
  entries.reserve(shape.below[node]);
  while (!stack.empty()) {
    const lab::BvhNode& top = bvh.nodes[stack.back()];
    stack.pop_back();
    if (!is_leaf(top)) {
      stack.push_back(top.first);
      stack.push_back(top.first + 1);
      continue;
    }
    for (std::size_t i = top.first; i < top.first + top.count; ++i) entries.push_back(i);
  }
  return entries;
}

inline Vec3 centroid(const common::Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// A point that many take for the centroid.
inline Vec3 middle_of_box(const common::Triangle& t) {
  return 0.5 * (t[0].cwiseMin(t[1]).cwiseMin(t[2]) + t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

/// One point of each triangle below a node.
inline std::vector<Vec3> points_below(const lab::Bvh& bvh, const Shape& shape, std::size_t node,
                                      Vec3 (*point)(const common::Triangle&) = centroid) {
  std::vector<Vec3> points;
  for (const std::size_t i : entries_below(bvh, shape, node)) {
    points.push_back(point(bvh.corners[i]));
  }
  return points;
}

inline std::pair<Vec3, Vec3> span_of(const std::vector<Vec3>& points) {
  std::pair<Vec3, Vec3> span{points.front(), points.front()};
  for (const Vec3& p : points) span = {span.first.cwiseMin(p), span.second.cwiseMax(p)};
  return span;
}

/// The levels that halving needs: the least d with n / 2^d ≤ leaf_size, rounded up.
inline int levels_of_halving(std::size_t n, std::size_t leaf_size) {
  int levels = 0;
  for (; n > leaf_size; n = (n + 1) / 2) ++levels;
  return levels;
}

/// All triangles below all inner nodes: what a build that goes top down has to sort.
inline double work_of(const lab::Bvh& bvh, const Shape& shape) {
  double work = 0.0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    if (!is_leaf(bvh.nodes[i])) work += static_cast<double>(shape.below[i]);
  }
  return work;
}

template <typename Build>
void expect_refusals(const std::string& step, const Build& build) {
  const common::TriangleMesh good{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  common::TriangleMesh no_triangle = good;
  no_triangle.triangles.clear();
  common::TriangleMesh bad_vertex = good;
  bad_vertex.vertices[1].y() = nan;
  common::TriangleMesh far_vertex = good;
  far_vertex.vertices[2].z() = -infinity;
  common::TriangleMesh bad_index = good;
  bad_index.triangles[0][2] = 3;
  struct Case {
    std::string why;
    common::TriangleMesh mesh;
    int leaf_size;
  };
  const std::vector<Case> cases{{"the mesh has no triangle", no_triangle, 4},
                                {"a vertex is NaN", bad_vertex, 4},
                                {"a vertex is infinite", far_vertex, 4},
                                {"vertex 3 of 3 does not exist", bad_index, 4},
                                {"leaf_size is 0", good, 0},
                                {"leaf_size is below 0", good, -1}};
  int index = 0;
  for (const Case& c : cases) {
    Trial(step, ++index, static_cast<int>(cases.size()))
        .given("what is wrong", Code{c.why})
        .given("leaf_size", static_cast<double>(c.leaf_size))
        .expect_throw([&] { return Tree{build(c.mesh, c.leaf_size)}; }, c.why);
  }
}

}  // namespace tests

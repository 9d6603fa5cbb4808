#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/geometry/rigid_transform.hpp"
#include "common/geometry/triangle_mesh.hpp"
#include "common/types.hpp"

/// The contract of lab 5: which triangles of mesh a meet which triangles of mesh b? All shapes are
/// closed, so boxes that only touch overlap, and triangles that only touch meet. SI units; lengths
/// are zero or within 1e-60 and 1e60 m. The bigger of two nodes is the one whose box has the larger
/// surface area; if both are equal, it is the node of a.
namespace lab::bvh_traversal {

using common::Mat3;
using common::RigidTransform;
using common::Triangle;
using common::TriangleMesh;
using common::Vec3;

/// All points with low ≤ point ≤ high in every coordinate. A default Box is empty, and no other
/// empty box is passed in.
struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());    ///< [m]
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());  ///< [m]
};

/// Returns the smallest box that holds the triangle, without any rounding.                eq. (1)
Box box_of(const Triangle& triangle);

/// Returns the smallest box that holds both. An empty box adds nothing.                   eq. (2)
Box merged(const Box& a, const Box& b);

/// Returns whether the boxes have a point in common. An empty box has none.               eq. (3)
bool overlap(const Box& a, const Box& b);

/// Returns 2 (w h + h d + d w) [m²] of the three sides, to a few ulp; 0 if box is empty.  eq. (4)
double surface_area(const Box& box);

/// A box and its contents: two children, or the triangles of a leaf.
struct BvhNode {
  Box box;
  std::uint32_t first = 0;  ///< inner: index of one child, the other is next; leaf: its first entry
  std::uint32_t count = 0;  ///< leaf: number of entries from first on; inner: 0
};

/// A bounding volume hierarchy. Each triangle of its mesh is an entry of exactly one leaf.
///
/// nodes  nodes[0] is the root, at depth 0; children come after their parent. A node's box is the
///        smallest box that holds all triangles below it.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> triangles;  ///< entry: index of the triangle in the mesh
  std::vector<Triangle> corners;         ///< entry: its corners, side by side for speed
};

/// No node of a Bvh is deeper than this, for any mesh.
inline constexpr int max_depth = 64;

/// Builds a tree top down. A node of at most leaf_size triangles is a leaf. Any other node is cut
/// across the axis along which the centroids (a + b + c)/3 of its triangles spread furthest. The
/// two halves differ by at most one triangle, and no centroid of one half is beyond any centroid of
/// the other.                                                                             eq. (5)
///
/// If all centroids are equal, any halves will do. The work grows as n log n.
/// Throws std::invalid_argument if common::require_sound throws or if leaf_size < 1.
Bvh build_median(const TriangleMesh& mesh, int leaf_size);

/// A node of a and a node of b. Pairs are sorted by a, then by b.
struct NodePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  auto operator<=>(const NodePair&) const = default;
};

/// The pairs at which a traversal ended, and its cost.
struct Traversal {
  std::vector<NodePair> ends;   ///< each once, sorted
  std::uint64_t box_tests = 0;  ///< pairs of nodes whose boxes were tested, from the roots on
};

/// Runs the lecture's FindIntersections as first written: if the boxes overlap, go on with each
/// child of the bigger node and the smaller node. The pseudocode does not mention leaves, and you
/// write this function to see it fail. It tests every pair of nodes that it visits once.
///
/// ends  the pairs for which the pseudocode does not say what to do: the boxes overlap, but the
///       bigger node is a leaf and has no child to go on with
Traversal traverse_as_first_written(const Bvh& a, const Bvh& b);

/// Runs the lecture's complete FindIntersections, down to pairs of leaves. If the boxes of two
/// inner nodes overlap, it goes on with each child of the bigger one. For an inner node and a leaf
/// it goes on with each child of the inner node. Two leaves are an end.                   eq. (6)
///
/// It tests every pair of nodes that it visits once.
Traversal traverse(const Bvh& a, const Bvh& b);

/// Returns whether the triangles have a point in common, as in exact arithmetic.          eq. (7)
///
/// Triangles meet if a corner or an edge touches or is shared, if they overlap in one plane, or if
/// one is inside the other. They may be segments or points.
bool triangles_meet(const Triangle& a, const Triangle& b);

/// A triangle of a and a triangle of b, by their indices in the meshes. Pairs are sorted as above.
struct TrianglePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  auto operator<=>(const TrianglePair&) const = default;
};

/// The pairs that a query found, and its cost.
struct Intersections {
  std::vector<TrianglePair> pairs;   ///< each once, sorted
  std::uint64_t box_tests = 0;       ///< as in Traversal
  std::uint64_t triangle_tests = 0;  ///< pairs of triangles in the pairs of leaves it visited
};

/// Returns all pairs of triangles that meet. The broad phase is traverse; the narrow phase is
/// triangles_meet on all pairs of triangles of each pair of leaves.
///
/// If one mesh is inside the other and their surfaces do not meet, there is no pair.
Intersections find_intersections(const Bvh& a, const Bvh& b);

/// Builds a tree as build_median does, but makes the cut with the least surface-area heuristic:
///
///   A(left) N(left) + A(right) N(right)                                                  eq. (8)
///
/// A is the surface area of a side's box, and N is its number of triangles. Neither side is empty.
/// There are bins − 1 planes along each of the three axes, which divide the span of the centroids
/// into equal bins. A cut that is better than all of these planes is right, too.
///
/// If no plane separates the centroids, and from depth 32 on, it cuts as build_median does.
/// Throws std::invalid_argument if build_median throws or if bins < 2.
Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins);

/// Returns all pairs of triangles that meet after b has moved. common::transformed(a_from_b, ·)
/// moves b's corners, and the result is exact for these rounded corners.                  eq. (9)
///
/// It builds no tree. A box of b, with the centre c and the half sides h, becomes a box around the
/// moved one: its centre is R c + t, and its half sides are |R| h and a margin for rounding. So it
/// holds all moved corners below. You may find the bigger node by the stored or the moved boxes.
/// Throws std::invalid_argument if a_from_b is not finite.
Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b);

/// Returns the same tree for the deformed mesh: it updates the corners and, from the leaves up, the
/// boxes.
///
/// deformed  a mesh with as many triangles as the mesh from which bvh was built
/// Throws std::invalid_argument if the numbers differ or if common::require_sound throws.
Bvh refit(Bvh bvh, const TriangleMesh& deformed);

}  // namespace lab::bvh_traversal

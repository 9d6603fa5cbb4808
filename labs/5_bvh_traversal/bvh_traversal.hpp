#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/rigid_transform.hpp"
#include "common/triangle_mesh.hpp"
#include "common/types.hpp"

/// The contract of lab 5. Which triangles of mesh a meet which of mesh b? Everything is closed:
/// what only touches overlaps, or meets. SI units; lengths are zero or within 1e-60 and 1e60 m.
///
/// The bigger of two nodes is the one whose box has the larger surface area, a's where they are
/// equal.
namespace lab::bvh_traversal {

using common::Mat3;
using common::RigidTransform;
using common::Triangle;
using common::TriangleMesh;
using common::Vec3;

/// All points with low ≤ point ≤ high in every coordinate. As made, it is empty.
struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());    ///< [m]
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());  ///< [m]
};

/// The smallest box that holds the triangle, without any rounding.                        eq. (1)
Box box_of(const Triangle& triangle);

/// The smallest box that holds both; an empty one adds nothing.                           eq. (2)
Box merged(const Box& a, const Box& b);

/// Whether the boxes have a point in common; an empty one has none.                       eq. (3)
bool overlap(const Box& a, const Box& b);

/// 2 (w h + h d + d w) [m²] of the three sides, to a few ulp; 0 of an empty box.          eq. (4)
double surface_area(const Box& box);

/// A box and what is in it: two children, or the triangles of a leaf.
struct BvhNode {
  Box box;
  std::uint32_t first = 0;  ///< inner: index of one child, the other is the next; leaf: of an entry
  std::uint32_t count = 0;  ///< leaf: how many entries from first on; inner: 0
};

/// A bounding volume hierarchy. Each triangle of its mesh is an entry of exactly one leaf.
///
/// nodes  nodes[0] is the root, at depth 0; children stand behind their parent. A node's box is the
///        smallest that holds all triangles below it.
struct Bvh {
  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> triangles;  ///< entry: index of the triangle in the mesh
  std::vector<Triangle> corners;         ///< entry: its corners, side by side for speed
};

/// No node of a Bvh is deeper than this, whatever the mesh.
inline constexpr int max_depth = 64;

/// Builds top down: a node of at most leaf_size triangles is a leaf; any other is cut across the
/// axis along which the centroids (a + b + c)/3 of its triangles spread furthest, so that the
/// halves' numbers of triangles differ by at most one and no centroid of one half is beyond any of
/// the other.                                                                             eq. (5)
///
/// Where all centroids are equal, any halves will do. The work grows as n log n.
/// Throws std::invalid_argument where common::require_sound does, and where leaf_size < 1.
Bvh build_median(const TriangleMesh& mesh, int leaf_size);

/// A node of a and a node of b; sorted by a, then by b.
struct NodePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  auto operator<=>(const NodePair&) const = default;
};

/// Where a traversal ended, and what it took.
struct Traversal {
  std::vector<NodePair> ends;   ///< each once, sorted
  std::uint64_t box_tests = 0;  ///< pairs of nodes whose boxes were tested; the roots' is the first
};

/// The lecture's FindIntersections as first written: if the boxes overlap, go on with each child of
/// the bigger node and the smaller node. It says nothing of leaves: this one is written to see it
/// fail.
///
/// ends  the pairs at which the words run out: the boxes overlap, but the bigger node is a leaf and
///       has no child to go on with
/// Every pair of nodes that it comes to is tested once.
Traversal traverse_as_first_written(const Bvh& a, const Bvh& b);

/// The lecture's complete FindIntersections, down to pairs of leaves. If the boxes overlap: of two
/// inner nodes go on with each child of the bigger, of an inner node and a leaf with each child of
/// the inner; two leaves are an end.                                                      eq. (6)
///
/// Every pair of nodes that it comes to is tested once.
Traversal traverse(const Bvh& a, const Bvh& b);

/// Whether the triangles have a point in common, as in exact arithmetic.                  eq. (7)
///
/// That may be a touching corner or edge, a shared one, an overlap in one plane, or one triangle
/// inside the other; and triangles may be segments or points.
bool triangles_meet(const Triangle& a, const Triangle& b);

/// A triangle of a and a triangle of b, by their indices in the meshes; sorted by a, then by b.
struct TrianglePair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  auto operator<=>(const TrianglePair&) const = default;
};

/// What a query found, and what it took.
struct Intersections {
  std::vector<TrianglePair> pairs;   ///< each once, sorted
  std::uint64_t box_tests = 0;       ///< as in Traversal
  std::uint64_t triangle_tests = 0;  ///< pairs of triangles in the pairs of leaves it came to
};

/// All pairs of triangles that meet: broad phase by traverse, narrow phase by triangles_meet on all
/// pairs of triangles of each pair of leaves.
///
/// One mesh inside the other without a meeting of surfaces gives no pair.
Intersections find_intersections(const Bvh& a, const Bvh& b);

/// Builds top down like build_median, but cuts where the surface-area heuristic is least:
///
///   A(left) N(left) + A(right) N(right)                                                  eq. (8)
///
/// over the bins − 1 planes that part the span of the centroids into equal bins, along each of the
/// three axes; A is the surface area of a side's box, N its number of triangles, and neither is
/// empty. A cut that is better than all of these planes will do, too.
///
/// Where no plane parts the centroids, and from depth 32 on: as in build_median.
/// Throws std::invalid_argument where build_median does, and where bins < 2.
Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins);

/// All pairs of triangles that meet when b has moved: a against common::transformed(a_from_b, ·) of
/// b's corners. Exact in the sense that these very doubles are compared without error.    eq. (9)
///
/// Nothing is built: a node's box is moved with it, to a box around it (|R| h about R c + t, of
/// centre c and half sides h, and a margin for rounding) that holds all moved corners below.
/// Which node is bigger may be asked of the boxes as they are stored or as they are moved.
/// Throws std::invalid_argument where a_from_b is not finite.
Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b);

/// The same tree about the deformed mesh: its corners and, from the leaves up, its boxes.
///
/// deformed  same number of triangles as the mesh of which bvh was built
/// Throws std::invalid_argument where the numbers differ, and where common::require_sound does.
Bvh refit(Bvh bvh, const TriangleMesh& deformed);

}  // namespace lab::bvh_traversal

// Lab 5: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the geometry and the numbered equations. Test your file with:  ./tumble test 5
#include "bvh_traversal.hpp"

#include "common/course/not_implemented.hpp"
#include "common/exact/orientation.hpp"

namespace lab::bvh_traversal {

// ---- Step 5.1 ----

Box box_of(const Triangle& triangle) {
  // TODO step 5.1, eq. (1)
  // 1. In each coordinate take the least and the greatest of the three corners.
  //    In Eigen, a.cwiseMin(b) takes the lesser in every coordinate.
  throw common::NotImplemented("5.1 box_of");
}

Box merged(const Box& a, const Box& b) {
  // TODO step 5.1, eq. (2)
  // 1. Take the lesser of the lows and the greater of the highs. Why is an empty box no special
  //    case?
  throw common::NotImplemented("5.1 merged");
}

bool overlap(const Box& a, const Box& b) {
  // TODO step 5.1, eq. (3)
  // 1. Two intervals overlap if each begins before the other ends; touching counts.
  // 2. Boxes overlap if their intervals overlap in all three coordinates.
  throw common::NotImplemented("5.1 overlap");
}

double surface_area(const Box& box) {
  // TODO step 5.1, eq. (4)
  // 1. The sides are high − low.
  // 2. Each pair of sides spans two faces. A flat box has two faces, too.
  // 3. An empty box has sides below zero. Its surface area is 0.
  throw common::NotImplemented("5.1 surface_area");
}

// ---- Step 5.2 ----

Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  // TODO step 5.2, eq. (5)
  // 1. Check the arguments: common::require_sound(mesh), leaf_size.
  // 2. Make a list of all triangles with their boxes and centroids. The root has all of it.
  // 3. A node of at most leaf_size triangles becomes a leaf, that is, a range of the list.
  // 4. For any other node, find the axis along which its centroids spread furthest. Put the lesser
  //    half of its range in front (std::nth_element), and give each half to a child. If you halve
  //    by number, equal centroids need no special case, and no half is ever empty.
  // 5. The children are side by side in `nodes`, after their parent. The parent's box is that of
  //    both merged.
  // 6. The list's order is the order of the entries: fill `triangles` and `corners`.
  throw common::NotImplemented("5.2 build_median");
}

// ---- Step 5.3 ----

Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {
  // TODO step 5.3
  // 1. Start with the pair of roots. Recursion will do, and so will a stack of pairs.
  // 2. Count a box test. If the boxes do not overlap, this pair is done.
  // 3. Which is the bigger node? Take each of its children with the smaller node.
  // 4. If the bigger node is a leaf, the pseudocode does not say what to do: put the pair in
  //    `ends`.
  // 5. Sort the ends.
  throw common::NotImplemented("5.3 traverse_as_first_written");
}

// ---- Step 5.4 ----

Traversal traverse(const Bvh& a, const Bvh& b) {
  // TODO step 5.4, eq. (6)
  // 1. Do as before, but if the boxes overlap, first ask which of the two are leaves.
  // 2. Two leaves are an end. If one is a leaf, go on with the children of the other, bigger or
  //    not.
  // 3. If neither is a leaf, go on with the children of the bigger.
  throw common::NotImplemented("5.4 traverse");
}

// ---- Step 5.5 ----

bool triangles_meet(const Triangle& a, const Triangle& b) {
  // TODO step 5.5, eq. (7)
  // common::orientation(p, q, r, x) says without error on which side of the plane p q r a point is.
  // 1. On which side of b's plane are the corners of a? If all are strictly on one side, they do
  //    not meet. Do the same for the corners of b and a's plane.
  // 2. If neither triangle is all in the other's plane, both cross the line of the two planes, each
  //    in an interval. Turn each triangle so that its first corner is alone on its side of the
  //    other's plane. If that side is below, turn the other triangle over. Two orientations then
  //    tell whether the intervals overlap.
  // 3. If all corners are in one plane, project them along the axes. In two dimensions triangles
  //    are apart if an edge separates them. common::orientation(p, q, x) tells left from right.
  // 4. Triangles may be segments or points, which have no plane of their own. What do the signs of
  //    1 say about them?
  throw common::NotImplemented("5.5 triangles_meet");
}

Intersections find_intersections(const Bvh& a, const Bvh& b) {
  // TODO step 5.5
  // 1. traverse(a, b) gives the pairs of leaves.
  // 2. For each pair, test all triangles of one leaf with all of the other, and count these tests.
  // 3. `triangles` has the number of an entry's triangle in the mesh. Sort the pairs.
  throw common::NotImplemented("5.5 find_intersections");
}

// ---- Step 5.6 ----

Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  // TODO step 5.6, eq. (8)
  // 1. Do as in build_median, except for the cut.
  // 2. Along each axis divide the span of the centroids into equal bins. Sum up the box and the
  //    number of the triangles in each bin.
  // 3. One sweep from the right and one from the left give the cost of every plane between bins. A
  //    plane with one empty side is not a cut.
  // 4. Take the cheapest plane of all axes. std::partition puts the range in order.
  // 5. If there is no plane at all, or at depth 32, halve as in build_median.
  throw common::NotImplemented("5.6 build_sah");
}

// ---- Step 5.7 ----

Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
  // TODO step 5.7, eq. (9)
  // 1. Do the traversal of step 5.4, but move b's boxes before you test them. Move the centre like
  //    a point, and the half sides by |R|, so that all corners of the box stay inside.
  // 2. Widen the moved box by more than the rounding error of all of this.
  // 3. At the leaves, move b's corners by common::transformed, and test them as in step 5.5.
  throw common::NotImplemented("5.7 find_intersections_moved");
}

Bvh refit(Bvh bvh, const TriangleMesh& deformed) {
  // TODO step 5.7
  // 1. Check the mesh, and check that it has as many triangles as before.
  // 2. Copy the new corners of every entry.
  // 3. Children come after their parent, so go through the nodes from the back. A leaf's box is
  //    that of its triangles, an inner node's box is that of its children.
  throw common::NotImplemented("5.7 refit");
}

}  // namespace lab::bvh_traversal

#include "bvh_traversal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "common/exact/orientation.hpp"

namespace lab::bvh_traversal {

// ---- Step 5.1 ----

Box box_of(const Triangle& triangle) {
  Box box;
  for (const Vec3& corner : triangle) box = merged(box, {corner, corner});  // eq. (1)
  return box;
}

Box merged(const Box& a, const Box& b) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);  // eq. (2)
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

bool overlap(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    if (!(a.low[i] <= b.high[i] && b.low[i] <= a.high[i])) return false;  // eq. (3)
  }
  return true;
}

double surface_area(const Box& box) {
  const double w = box.high[0] - box.low[0];
  const double h = box.high[1] - box.low[1];
  const double d = box.high[2] - box.low[2];
  if (!(w >= 0.0)) return 0.0;           // empty: negative sides would have positive products
  return 2.0 * (w * h + h * d + d * w);  // eq. (4)
}

// ---- Step 5.2 ----

namespace {

/// The data of a triangle that a cut needs.
struct Part {
  Box box;
  Vec3 centroid;  ///< [m]
};
using Parts = std::vector<Part>;                     // by the triangle's index
using Place = std::vector<std::uint32_t>::iterator;  // in Bvh::triangles

/// Returns the box from the least to the greatest centroid in every coordinate.
Box spread_of_centroids(const Parts& parts, Place begin, Place end) {
  Box spread;
  for (Place i = begin; i != end; ++i) {
    spread = merged(spread, {parts[*i].centroid, parts[*i].centroid});
  }
  return spread;
}

/// Cuts a range of the list in two, and returns where the second part begins.
using Cut = Place (*)(const Parts& parts, Place begin, Place end, int depth, int bins);

/// Puts the lesser half in front. Needs no depth and no bins.                             eq. (5)
Place halved(const Parts& parts, Place begin, Place end, int /*depth*/, int /*bins*/) {
  const Box spread = spread_of_centroids(parts, begin, end);
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (spread.high[i] - spread.low[i] > spread.high[axis] - spread.low[axis]) axis = i;
  }
  // Halve by number, not by place, so that equal centroids are halved like any others.
  const Place middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](std::uint32_t i, std::uint32_t j) {
    return parts[i].centroid[axis] < parts[j].centroid[axis];
  });
  return middle;
}

/// A tree during its construction.
struct Growth {
  Parts parts;
  int leaf_size;
  Cut cut;
  int bins;
  Bvh bvh;

  void grow(std::uint32_t index, Place begin, Place end, int depth) {
    BvhNode node;  // stored at the end, because `nodes` grows meanwhile
    if (end - begin <= leaf_size) {
      node.first = static_cast<std::uint32_t>(begin - bvh.triangles.begin());
      node.count = static_cast<std::uint32_t>(end - begin);
      for (Place i = begin; i != end; ++i) node.box = merged(node.box, parts[*i].box);
    } else {
      node.first = static_cast<std::uint32_t>(bvh.nodes.size());
      for (int child = 0; child < 2; ++child) bvh.nodes.emplace_back();
      const Place middle = cut(parts, begin, end, depth, bins);
      grow(node.first, begin, middle, depth + 1);
      grow(node.first + 1, middle, end, depth + 1);
      node.box = merged(bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box);
    }
    bvh.nodes[index] = node;
  }
};

Bvh build(const TriangleMesh& mesh, int leaf_size, Cut cut, int bins) {
  common::require_sound(mesh);
  if (leaf_size < 1) throw std::invalid_argument("leaf_size: want 1 or more");
  Growth tree{{}, leaf_size, cut, bins, {}};
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = triangle(mesh, i);
    Part part{box_of(t), {}};
    for (int k = 0; k < 3; ++k) part.centroid[k] = (t[0][k] + t[1][k] + t[2][k]) / 3.0;
    tree.parts.push_back(part);
    tree.bvh.triangles.push_back(i);
  }
  tree.bvh.nodes.emplace_back();
  tree.grow(0, tree.bvh.triangles.begin(), tree.bvh.triangles.end(), 0);
  for (const std::uint32_t i : tree.bvh.triangles) tree.bvh.corners.push_back(triangle(mesh, i));
  return std::move(tree.bvh);
}

}  // namespace

Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  return build(mesh, leaf_size, halved, 0);
}

// ---- Step 5.3 ----

namespace {

bool is_leaf(const BvhNode& node) { return node.count > 0; }

bool a_is_bigger(const Box& a, const Box& b) { return surface_area(a) >= surface_area(b); }

}  // namespace

Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {
  Traversal found;
  std::vector<NodePair> stack{{0, 0}};
  while (!stack.empty()) {
    const NodePair pair = stack.back();
    stack.pop_back();
    const BvhNode& node_a = a.nodes[pair.a];
    const BvhNode& node_b = b.nodes[pair.b];
    ++found.box_tests;
    if (!overlap(node_a.box, node_b.box)) continue;
    const bool into_a = a_is_bigger(node_a.box, node_b.box);
    const BvhNode& bigger = into_a ? node_a : node_b;
    if (is_leaf(bigger)) {
      found.ends.push_back(pair);
      continue;
    }
    for (const std::uint32_t child : {bigger.first, bigger.first + 1}) {
      stack.push_back(into_a ? NodePair{child, pair.b} : NodePair{pair.a, child});
    }
  }
  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

// ---- Step 5.4 ----

namespace {

Box moved(const Box& box, const RigidTransform& motion);  // step 5.7
Box in_a(const Box& b, const RigidTransform* by) { return by == nullptr ? b : moved(b, *by); }

/// Finds the pairs of leaves. a_from_b is null if b is at rest.                           eq. (6)
Traversal pairs_of_leaves(const Bvh& a, const Bvh& b, const RigidTransform* a_from_b) {
  Traversal found;
  std::vector<NodePair> stack{{0, 0}};
  while (!stack.empty()) {
    const NodePair pair = stack.back();
    stack.pop_back();
    const BvhNode& node_a = a.nodes[pair.a];
    const BvhNode& node_b = b.nodes[pair.b];
    const Box box_b = in_a(node_b.box, a_from_b);
    ++found.box_tests;
    if (!overlap(node_a.box, box_b)) continue;
    if (is_leaf(node_a) && is_leaf(node_b)) {
      found.ends.push_back(pair);
      continue;
    }
    const bool into_a = !is_leaf(node_a) && (is_leaf(node_b) || a_is_bigger(node_a.box, box_b));
    const std::uint32_t child = into_a ? node_a.first : node_b.first;  // the other one follows it
    stack.push_back(into_a ? NodePair{child, pair.b} : NodePair{pair.a, child});
    stack.push_back(into_a ? NodePair{child + 1, pair.b} : NodePair{pair.a, child + 1});
  }
  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

}  // namespace

Traversal traverse(const Bvh& a, const Bvh& b) { return pairs_of_leaves(a, b, nullptr); }

// ---- Step 5.5 ----

namespace {

using common::orientation;
using common::Vec2;
using Signs = std::array<int, 3>;

bool all_zero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }
bool one_side(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }

/// Returns the sides of the triangle's plane on which the points are: the signs of (7).
Signs sides(const Triangle& plane, const Triangle& points) {
  Signs s{};
  for (std::size_t i = 0; i < 3; ++i) s[i] = orientation(plane[0], plane[1], plane[2], points[i]);
  return s;
}

/// Rotates the triangle so that its first corner is alone on its side of a plane, or alone on the
/// plane. Returns whether that side is below the plane, or the others are above it.
bool put_alone_first(Triangle& t, const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int s_j = s[(i + 1) % 3];
    const int s_k = s[(i + 2) % 3];
    const bool across = s[i] != 0 && s_j * s[i] <= 0 && s_k * s[i] <= 0;
    const bool touches = s[i] == 0 && s_j * s_k > 0;
    if (!across && !touches) continue;
    t = {t[i], t[(i + 1) % 3], t[(i + 2) % 3]};
    return across ? s[i] < 0 : s_j > 0;
  }
  throw std::logic_error("no corner is alone");
}

/// Each triangle crosses the other's plane, so it meets the line of both planes in an interval. Two
/// orientations tell whether the intervals overlap. Guigue, Devillers 2003, JGT 8(1).     eq. (7)
bool intervals_overlap(Triangle a, const Signs& side_a, Triangle b, const Signs& side_b) {
  const bool swap_b = put_alone_first(a, side_a);
  const bool swap_a = put_alone_first(b, side_b);
  if (swap_b) std::swap(b[1], b[2]);
  if (swap_a) std::swap(a[1], a[2]);
  return orientation(a[0], a[1], b[0], b[1]) <= 0 && orientation(a[0], a[2], b[2], b[0]) <= 0;
}

/// Returns whether an edge of a separates the projections on x and y: b is strictly on one side of
/// it, and a is on the other side or on it.
bool parted_by_edge(const Triangle& a, const Triangle& b, int x, int y) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = a[i];
    const Vec3& q = a[(i + 1) % 3];
    const auto side = [&](const Vec3& c) {
      return orientation(Vec2(p[x], p[y]), Vec2(q[x], q[y]), Vec2(c[x], c[y]));
    };
    const Signs s{side(b[0]), side(b[1]), side(b[2])};
    if (one_side(s) && s[0] * side(a[(i + 2) % 3]) <= 0) return true;
  }
  return false;
}

/// Returns whether triangles in one plane meet: they do if no edge parts them in any projection,
/// and one projection shows the plane in full. On one line no edge parts them, but the boxes do.
bool meet_in_plane(const Triangle& a, const Triangle& b) {
  if (!overlap(box_of(a), box_of(b))) return false;
  for (int x = 0; x < 3; ++x) {
    if (parted_by_edge(a, b, x, (x + 1) % 3) || parted_by_edge(b, a, x, (x + 1) % 3)) return false;
  }
  return true;
}

/// Returns whether a, a segment that b's plane parts or touches at an end, meets b.
bool segment_pierces(const Triangle& a, const Signs& side_a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (side_a[i] == side_a[j]) continue;  // this edge does not cross b's plane
    const int s0 = orientation(a[i], a[j], b[0], b[1]);
    const int s1 = orientation(a[i], a[j], b[1], b[2]);
    const int s2 = orientation(a[i], a[j], b[2], b[0]);
    if ((s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0)) return true;
  }
  return false;
}

/// Returns whether no plane holds both a and b. Here only two segments can be skew.
bool are_skew(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (orientation(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]) != 0) return true;
    }
  }
  return false;
}

/// Tests all pairs of triangles of the leaves, first by their boxes, which are not counted.
/// a_from_b is null if b is at rest.
Intersections pairs_that_meet(const Bvh& a, const Bvh& b, const RigidTransform* a_from_b) {
  const Traversal leaves = pairs_of_leaves(a, b, a_from_b);
  Intersections found{{}, leaves.box_tests, 0};
  for (const NodePair& pair : leaves.ends) {
    const BvhNode& leaf_a = a.nodes[pair.a];
    const BvhNode& leaf_b = b.nodes[pair.b];
    found.triangle_tests += std::uint64_t{leaf_a.count} * leaf_b.count;
    for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
      Triangle t = b.corners[j];
      if (a_from_b != nullptr) t = common::transformed(*a_from_b, t);
      const Box box = box_of(t);
      for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
        if (overlap(box_of(a.corners[i]), box) && triangles_meet(a.corners[i], t)) {
          found.pairs.push_back({a.triangles[i], b.triangles[j]});
        }
      }
    }
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace

bool triangles_meet(const Triangle& a, const Triangle& b) {
  const Signs side_b = sides(a, b);
  if (one_side(side_b)) return false;
  const Signs side_a = sides(b, a);
  if (one_side(side_a)) return false;
  if (!all_zero(side_a) && !all_zero(side_b)) return intervals_overlap(a, side_a, b, side_b);
  // If b is in a's plane, but a is not in b's, then a has no plane: it is a segment.
  if (!all_zero(side_a)) return segment_pierces(a, side_a, b);
  if (!all_zero(side_b)) return segment_pierces(b, side_b, a);
  return !are_skew(a, b) && meet_in_plane(a, b);
}

Intersections find_intersections(const Bvh& a, const Bvh& b) {
  return pairs_that_meet(a, b, nullptr);
}

// ---- Step 5.6 ----

namespace {

/// The triangles of one bin, or all on one side of a plane.
struct Bin {
  Box box;
  double count = 0.0;

  void add(const Bin& more) {
    box = merged(box, more.box);
    count += more.count;
  }
  [[nodiscard]] double cost() const { return surface_area(box) * count; }  // A N of eq. (8)
};

/// Makes the cut of the least cost, out of bins − 1 planes on each axis.                  eq. (8)
Place cut_by_area(const Parts& parts, Place begin, Place end, int depth, int bins) {
  if (depth >= 32) return halved(parts, begin, end, depth, bins);  // adds 32 levels at most
  const Box spread = spread_of_centroids(parts, begin, end);
  const auto size = static_cast<std::size_t>(bins);
  const auto bin_of = [&](std::uint32_t i, int axis) {
    const double width = (spread.high[axis] - spread.low[axis]) / bins;
    const double bin = (parts[i].centroid[axis] - spread.low[axis]) / width;
    return std::min(static_cast<std::size_t>(bin), size - 1);
  };
  double least = std::numeric_limits<double>::infinity();
  int best_axis = 0;
  std::size_t best_bin = 0;  // the first beyond the plane
  for (int axis = 0; axis < 3; ++axis) {
    if (!(spread.high[axis] > spread.low[axis])) continue;  // the bin would be 0/0
    std::vector<Bin> filled(size);
    for (Place i = begin; i != end; ++i) filled[bin_of(*i, axis)].add({parts[*i].box, 1.0});
    std::vector<Bin> right = filled;  // [i] will hold bin i and those behind it
    for (std::size_t i = size - 1; i > 0; --i) right[i - 1].add(right[i]);
    Bin left;
    for (std::size_t i = 1; i < size; ++i) {
      left.add(filled[i - 1]);
      // The first and the last bin are never empty, so neither side of a plane is empty.
      const double both = left.cost() + right[i].cost();  // eq. (8)
      if (both >= least) continue;
      least = both;
      best_axis = axis;
      best_bin = i;
    }
  }
  if (best_bin == 0) return halved(parts, begin, end, depth, bins);  // all centroids are equal
  return std::partition(begin, end,
                        [&](std::uint32_t i) { return bin_of(i, best_axis) < best_bin; });
}

}  // namespace

Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  if (bins < 2) throw std::invalid_argument("bins: want 2 or more");
  return build(mesh, leaf_size, cut_by_area, bins);
}

// ---- Step 5.7 ----

namespace {

/// Returns a box that holds all of the moved box, with a margin.                          eq. (9)
Box moved(const Box& box, const RigidTransform& motion) {
  Vec3 c;
  for (int j = 0; j < 3; ++j) c[j] = 0.5 * (box.low[j] + box.high[j]);
  const Vec3 center = common::transformed(motion, c);
  Box around;
  for (int i = 0; i < 3; ++i) {
    double half = 1e-300;                           // more than underflow may lose
    double size = std::abs(motion.translation[i]);  // will be |t| + |R| (|c| + h)
    for (int j = 0; j < 3; ++j) {
      const double h = 0.5 * (box.high[j] - box.low[j]);
      half += std::abs(motion.rotation(i, j)) * h;
      size += std::abs(motion.rotation(i, j)) * (std::abs(c[j]) + h);
    }
    half += 1e-14 * size;  // more than all rounding errors, at most 20 · 2⁻⁵³ of size
    around.low[i] = center[i] - half;
    around.high[i] = center[i] + half;
  }
  return around;
}

}  // namespace

Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
  common::require_finite(a_from_b, "a_from_b");
  return pairs_that_meet(a, b, &a_from_b);
}

Bvh refit(Bvh bvh, const TriangleMesh& deformed) {
  common::require_sound(deformed);
  if (deformed.triangles.size() != bvh.triangles.size()) {
    throw std::invalid_argument("deformed: want as many triangles as before");
  }
  for (std::size_t i = 0; i < bvh.triangles.size(); ++i) {
    bvh.corners[i] = triangle(deformed, bvh.triangles[i]);
  }
  // Children come after their parent. From the back, they are done before their parent.
  for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
    BvhNode& node = bvh.nodes[i];
    if (is_leaf(node)) {
      node.box = Box{};
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        node.box = merged(node.box, box_of(bvh.corners[k]));
      }
    } else {
      node.box = merged(bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box);
    }
  }
  return bvh;
}

}  // namespace lab::bvh_traversal

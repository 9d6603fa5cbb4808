#include "bvh_traversal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "common/orientation.hpp"

namespace lab::bvh_traversal {

// ---- Step 5.1 ----

Box box_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};  // eq. (1)
}

Box merged(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};  // eq. (2)
}

bool overlap(const Box& a, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    const bool reach = a.low[i] <= b.high[i] && b.low[i] <= a.high[i];  // eq. (3)
    if (!reach) return false;
  }
  return true;
}

double surface_area(const Box& box) {
  const double w = box.high[0] - box.low[0];
  const double h = box.high[1] - box.low[1];
  const double d = box.high[2] - box.low[2];
  if (!(w >= 0.0)) return 0.0;           // empty: its sides are negative, their products are not
  return 2.0 * (w * h + h * d + d * w);  // eq. (4)
}

// ---- Step 5.2 ----

namespace {

/// What a cut is made by, of each triangle of the mesh.
struct Part {
  Box box;
  Vec3 centroid;  ///< [m]
};
using Parts = std::vector<Part>;

/// A place in the list of triangles, whose order is that of the entries.
using Place = std::vector<std::uint32_t>::iterator;

/// From the least to the greatest centroid in every coordinate.
Box spread_of_centroids(const Parts& parts, Place begin, Place end) {
  Box spread;
  for (Place i = begin; i != end; ++i) {
    const Vec3& centroid = parts[*i].centroid;
    spread = merged(spread, {centroid, centroid});
  }
  return spread;
}

/// Puts the lesser half in front, and returns where the other begins.                     eq. (5)
Place halved(const Parts& parts, Place begin, Place end) {
  const Box spread = spread_of_centroids(parts, begin, end);
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (spread.high[i] - spread.low[i] > spread.high[axis] - spread.low[axis]) axis = i;
  }
  // By number, not by place: equal centroids are halved like any others.
  const Place middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](std::uint32_t i, std::uint32_t j) {
    return parts[i].centroid[axis] < parts[j].centroid[axis];
  });
  return middle;
}

/// Puts a range at this depth in order, and returns where its second part begins.
using Cut = Place (*)(const Parts& parts, Place begin, Place end, int depth, int bins);

class Builder {
 public:
  Builder(const TriangleMesh& mesh, int leaf_size, Cut cut, int bins)
      : leaf_size_(leaf_size), cut_(cut), bins_(bins) {
    common::require_sound(mesh);
    if (leaf_size < 1) throw std::invalid_argument("leaf_size: want 1 or more");
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle t = triangle(mesh, i);
      parts_.push_back({box_of(t), (t[0] + t[1] + t[2]) / 3.0});
      bvh_.triangles.push_back(i);
    }
    bvh_.nodes.emplace_back();
    build(0, bvh_.triangles.begin(), bvh_.triangles.end(), 0);
    for (const std::uint32_t i : bvh_.triangles) bvh_.corners.push_back(triangle(mesh, i));
  }

  Bvh take() { return std::move(bvh_); }

 private:
  void build(std::uint32_t index, Place begin, Place end, int depth) {
    BvhNode node;
    if (end - begin <= leaf_size_) {
      node.first = static_cast<std::uint32_t>(begin - bvh_.triangles.begin());
      node.count = static_cast<std::uint32_t>(end - begin);
      for (Place i = begin; i != end; ++i) node.box = merged(node.box, parts_[*i].box);
    } else {
      node.first = static_cast<std::uint32_t>(bvh_.nodes.size());
      bvh_.nodes.emplace_back();
      bvh_.nodes.emplace_back();
      const Place middle = cut_(parts_, begin, end, depth, bins_);
      build(node.first, begin, middle, depth + 1);
      build(node.first + 1, middle, end, depth + 1);
      node.box = merged(bvh_.nodes[node.first].box, bvh_.nodes[node.first + 1].box);
    }
    bvh_.nodes[index] = node;  // not kept by reference: `nodes` has grown
  }

  int leaf_size_;
  Cut cut_;
  int bins_;
  Parts parts_;
  Bvh bvh_;
};

}  // namespace

Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  const Cut cut = [](const Parts& parts, Place begin, Place end, int, int) {
    return halved(parts, begin, end);
  };
  return Builder(mesh, leaf_size, cut, 0).take();
}

// ---- Step 5.3 ----

namespace {

bool is_leaf(const BvhNode& node) { return node.count > 0; }

bool a_is_bigger(const BvhNode& a, const BvhNode& b) {
  return surface_area(a.box) >= surface_area(b.box);
}

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
    const bool bigger_is_a = a_is_bigger(node_a, node_b);
    const BvhNode& bigger = bigger_is_a ? node_a : node_b;
    if (is_leaf(bigger)) {
      found.ends.push_back(pair);
      continue;
    }
    for (const std::uint32_t child : {bigger.first, bigger.first + 1}) {
      stack.push_back(bigger_is_a ? NodePair{child, pair.b} : NodePair{pair.a, child});
    }
  }
  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

// ---- Step 5.4 ----

namespace {

Box moved(const Box& box, const RigidTransform& motion);  // step 5.7

/// Down to all pairs of leaves that overlap. a_from_b is null at rest.                   eq. (6)
Traversal pairs_of_leaves(const Bvh& a, const Bvh& b, const RigidTransform* a_from_b) {
  Traversal found;
  std::vector<NodePair> stack{{0, 0}};
  while (!stack.empty()) {
    const NodePair pair = stack.back();
    stack.pop_back();
    const BvhNode& node_a = a.nodes[pair.a];
    const BvhNode& node_b = b.nodes[pair.b];
    const Box box_b = a_from_b == nullptr ? node_b.box : moved(node_b.box, *a_from_b);
    ++found.box_tests;
    if (!overlap(node_a.box, box_b)) continue;
    if (is_leaf(node_a) && is_leaf(node_b)) {
      found.ends.push_back(pair);
      continue;
    }
    const bool into_a = !is_leaf(node_a) && (is_leaf(node_b) || a_is_bigger(node_a, node_b));
    const BvhNode& inner = into_a ? node_a : node_b;
    for (const std::uint32_t child : {inner.first, inner.first + 1}) {
      stack.push_back(into_a ? NodePair{child, pair.b} : NodePair{pair.a, child});
    }
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
bool one_side(const Signs& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

/// On which sides of the triangle's plane the points are: the signs of (7).
Signs sides(const Triangle& plane, const Triangle& points) {
  Signs s{};
  for (std::size_t i = 0; i < 3; ++i) {
    s[i] = orientation(plane[0], plane[1], plane[2], points[i]);
  }
  return s;
}

/// Turns the triangle so that its first corner is alone on its side of a plane, or alone on the
/// plane. Returns 1 if that side is above the plane, or the others are below, and −1 if not.
int put_alone_first(Triangle& t, const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const bool across = s[i] != 0 && s[j] * s[i] <= 0 && s[k] * s[i] <= 0;
    const bool touches = s[i] == 0 && s[j] * s[k] > 0;
    if (!across && !touches) continue;
    t = {Vec3(t[i]), Vec3(t[j]), Vec3(t[k])};
    return across ? s[i] : -s[j];
  }
  throw std::logic_error("all corners are on one side of the plane");
}

/// Each crosses the other's plane, and so meets the line of both planes in an interval. Whether
/// these overlap shows in two orientations. Guigue, Devillers 2003, JGT 8(1).             eq. (7)
bool intervals_overlap(Triangle a, const Signs& side_a, Triangle b, const Signs& side_b) {
  const bool turn_b_over = put_alone_first(a, side_a) < 0;
  const bool turn_a_over = put_alone_first(b, side_b) < 0;
  if (turn_b_over) std::swap(b[1], b[2]);
  if (turn_a_over) std::swap(a[1], a[2]);
  return orientation(a[0], a[1], b[0], b[1]) <= 0 && orientation(a[0], a[2], b[2], b[0]) <= 0;
}

using Shadow = std::array<Vec2, 3>;

/// Whether the line of an edge of a has a on its one side, or on it, and b strictly on the other.
bool parted_by_edge(const Shadow& a, const Shadow& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& p = a[i];
    const Vec2& q = a[(i + 1) % 3];
    const Signs s{orientation(p, q, b[0]), orientation(p, q, b[1]), orientation(p, q, b[2])};
    if (one_side(s) && s[0] * orientation(p, q, a[(i + 2) % 3]) <= 0) return true;
  }
  return false;
}

/// Corners all in one plane: the triangles meet if their shadows along all three axes do. One of
/// the shadows shows the plane in full, or the line if all corners are on one.
bool meet_in_plane(const Triangle& a, const Triangle& b) {
  if (!overlap(box_of(a), box_of(b))) return false;
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    const auto shadow = [&](const Triangle& t) {
      return Shadow{Vec2(t[0][x], t[0][y]), Vec2(t[1][x], t[1][y]), Vec2(t[2][x], t[2][y])};
    };
    if (parted_by_edge(shadow(a), shadow(b)) || parted_by_edge(shadow(b), shadow(a))) return false;
  }
  return true;
}

/// Whether an edge of the segment, which a is, goes through b. Not both ends are in b's plane.
bool segment_pierces(const Triangle& a, const Signs& side_a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (side_a[i] * side_a[j] > 0 || (side_a[i] == 0 && side_a[j] == 0)) continue;
    const int s0 = orientation(a[i], a[j], b[0], b[1]);
    const int s1 = orientation(a[i], a[j], b[1], b[2]);
    const int s2 = orientation(a[i], a[j], b[2], b[0]);
    if ((s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0)) return true;
  }
  return false;
}

/// Whether a and b, both segments or points, are on two lines without a common plane.
bool are_skew(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (orientation(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]) != 0) return true;
    }
  }
  return false;
}

}  // namespace

bool triangles_meet(const Triangle& a, const Triangle& b) {
  const Signs side_b = sides(a, b);
  if (one_side(side_b)) return false;
  const Signs side_a = sides(b, a);
  if (one_side(side_a)) return false;
  if (!all_zero(side_a) && !all_zero(side_b)) return intervals_overlap(a, side_a, b, side_b);
  // A triangle without a plane, a segment or a point, has all points in every plane through it.
  if (!all_zero(side_a)) return segment_pierces(a, side_a, b);
  if (!all_zero(side_b)) return segment_pierces(b, side_b, a);
  return !are_skew(a, b) && meet_in_plane(a, b);
}

namespace {

/// All pairs of triangles in all pairs of leaves. a_from_b is null at rest.
Intersections pairs_that_meet(const Bvh& a, const Bvh& b, const RigidTransform* a_from_b) {
  Intersections found;
  const Traversal leaves = pairs_of_leaves(a, b, a_from_b);
  found.box_tests = leaves.box_tests;
  for (const NodePair& pair : leaves.ends) {
    const BvhNode& leaf_a = a.nodes[pair.a];
    const BvhNode& leaf_b = b.nodes[pair.b];
    found.triangle_tests += std::uint64_t{leaf_a.count} * leaf_b.count;
    for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
      Triangle other = b.corners[j];
      if (a_from_b != nullptr) other = common::transformed(*a_from_b, other);
      const Box box = box_of(other);
      for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
        // The boxes first: that pays, and is not counted.
        if (!overlap(box_of(a.corners[i]), box) || !triangles_meet(a.corners[i], other)) continue;
        found.pairs.push_back({a.triangles[i], b.triangles[j]});
      }
    }
  }
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace

Intersections find_intersections(const Bvh& a, const Bvh& b) {
  return pairs_that_meet(a, b, nullptr);
}

// ---- Step 5.6 ----

namespace {

constexpr int depth_of_last_sah_cut = 31;

/// Triangles side by side: of one bin, or all on one side of a plane.
struct Bin {
  void add(const Bin& more) {
    box = merged(box, more.box);
    count += more.count;
  }

  Box box;
  double count = 0.0;
};

/// A N of eq. (8).
double cost(const Bin& side) { return surface_area(side.box) * side.count; }

/// A plane between two bins along an axis.
struct Plane {
  double cost = std::numeric_limits<double>::infinity();
  int axis = 0;
  int bin = 0;  ///< the first beyond the plane; 0: there is no plane
};

int bin_of(const Vec3& centroid, const Box& spread, int axis, int bins) {
  const double share = (centroid[axis] - spread.low[axis]) / (spread.high[axis] - spread.low[axis]);
  return std::min(static_cast<int>(bins * share), bins - 1);
}

/// The better of `best` and all planes between filled bins along the axis. The first and the last
/// bin are never empty, so no plane has an empty side.
Plane better_plane(const std::vector<Bin>& filled, int axis, Plane best) {
  std::vector<Bin> right = filled;  // from each bin on
  for (std::size_t i = filled.size() - 1; i-- > 0;) right[i].add(right[i + 1]);
  Bin left;
  for (std::size_t i = 1; i < filled.size(); ++i) {
    left.add(filled[i - 1]);
    const double both = cost(left) + cost(right[i]);  // eq. (8)
    if (both < best.cost) best = {both, axis, static_cast<int>(i)};
  }
  return best;
}

Place cut_by_area(const Parts& parts, Place begin, Place end, int depth, int bins) {
  if (depth > depth_of_last_sah_cut) return halved(parts, begin, end);
  const Box spread = spread_of_centroids(parts, begin, end);
  Plane best;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(spread.high[axis] > spread.low[axis])) continue;  // equal centroids: the bin were 0/0
    std::vector<Bin> filled(static_cast<std::size_t>(bins));
    for (Place i = begin; i != end; ++i) {
      const int bin = bin_of(parts[*i].centroid, spread, axis, bins);
      filled[static_cast<std::size_t>(bin)].add({parts[*i].box, 1.0});
    }
    best = better_plane(filled, axis, best);
  }
  if (best.bin == 0) return halved(parts, begin, end);
  return std::partition(begin, end, [&](std::uint32_t i) {
    return bin_of(parts[i].centroid, spread, best.axis, bins) < best.bin;
  });
}

}  // namespace

Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  if (bins < 2) throw std::invalid_argument("bins: want 2 or more");
  return Builder(mesh, leaf_size, cut_by_area, bins).take();
}

// ---- Step 5.7 ----

namespace {

/// The box around the moved box.                                                          eq. (9)
Box moved(const Box& box, const RigidTransform& motion) {
  const Vec3 c = 0.5 * (box.low + box.high);
  const Vec3 h = 0.5 * (box.high - box.low);
  const Vec3 center = common::transformed(motion, c);
  Box around;
  for (int i = 0; i < 3; ++i) {
    double half = 0.0;
    double size = std::abs(motion.translation[i]);
    for (int j = 0; j < 3; ++j) {
      const double R_size = std::abs(motion.rotation(i, j));
      half += R_size * h[j];
      size += R_size * (std::abs(c[j]) + h[j]);
    }
    half += 1e-14 * size;  // more than all roundings together, which are some 20 times 2⁻⁵³ of it
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
  // Children stand behind their parent: from the back, they are done when it is its turn.
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

// The fast answer: the contract of the reference, for twice its text. Each trick is named where it
// stands, and here with its lines and what it buys.
//
//   trick                                            stands in                lines  buys
//   1   six comparisons without a branch             overlap                      6  -
//   2   children are tested before they are stacked  for_each_pair_of_leaves     30  -
//   3   a plane serves all that meet its triangle,   Facet, sides                31  1.0 to 1.2
//       and doubles decide most sides
//   4   the last leaves are kept, moved and ready    Leaves                      67  1.0 to 1.8
//   5   bounds coordinate by coordinate: a compiler  Leaf, compare_boxes         43  1.0 to 1.1
//       compares several at once
//   6   what is near is listed without a branch      Listed                      59  1.2 to 1.3
//   7   two planes around a leaf tell most triangles find_planes, list_near      37  1.2 to 2.5
//       of the other apart
//   8   the same planes tell whole leaves apart      parted_by_planes            19  1.0 to 1.1
//   9   the last moved boxes are kept                MovedBoxes                  30  1.1 and 1.2
//   10  boxes are moved both ways: six directions    MovedOverlap                35  1.0 and 1.2
//   11  triangles lie side by side in a build, and   Entry, SahCut               75  1.3 and 1.7
//       one pass bins all three axes
//
// What a trick buys is the time without it over the time with it: a query of 100,000 triangles with
// 100,000, leaves of 64 by (8), on tori at rest, tori turned, spheres turned and shells. Tricks 9
// and 10 are asked of what is turned, 11 of a build by halves and by (8). Measured once, on a
// machine that had other work: less than a tenth says nothing, and - is what did not show. In
// leaves of 4 tricks 1 and 2 buy 1.2 on shells, and trick 10 loses: 0.9 and 0.8. All together, the
// reference takes 11, 16, 17 and 24 times as long, and in leaves of 4 1.4, 1.7, 2.2 and 3.5 times.
#include "bvh_traversal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/exact/orientation.hpp"

namespace lab::bvh_traversal {

// ---- Step 5.1 ----

Box box_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

Box merged(const Box& a, const Box& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

bool overlap(const Box& a, const Box& b) {
  // Trick 1: a branch for each comparison would cost more than all six.
  const auto reach = [&](Eigen::Index i) {
    return static_cast<int>(a.low[i] <= b.high[i]) & static_cast<int>(b.low[i] <= a.high[i]);
  };
  return (reach(0) & reach(1) & reach(2)) != 0;
}

double surface_area(const Box& box) {
  const Vec3 side = box.high - box.low;
  if (!(side.x() >= 0.0)) return 0.0;  // empty: its sides are negative, their products are not
  return 2.0 * (side.x() * side.y() + side.y() * side.z() + side.z() * side.x());
}

// ---- Step 5.2 ----

namespace {

/// Trick 11: a triangle while the tree is built, with all that a cut asks of it.
struct Entry {
  Box box;
  Vec3 centroid;
  std::uint32_t triangle;
};

using Entries = std::vector<Entry>;
using Iterator = Entries::iterator;

/// merged, in place. Inline, since loops over all triangles are made of it.
inline void extend(Box& box, const Box& more) {
  box.low = box.low.cwiseMin(more.low);
  box.high = box.high.cwiseMax(more.high);
}

Box box_of_centroids(Iterator begin, Iterator end) {
  Box box;
  for (Iterator i = begin; i != end; ++i) extend(box, {i->centroid, i->centroid});
  return box;
}

/// Halves the entries across the axis along which their centroids spread furthest.
Iterator halved(Iterator begin, Iterator end) {
  const Box spread = box_of_centroids(begin, end);
  Eigen::Index axis = 0;
  (spread.high - spread.low).maxCoeff(&axis);
  // By number, not by place: equal centroids are halved like any others.
  const Iterator middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [axis](const Entry& a, const Entry& b) {
    return a.centroid[axis] < b.centroid[axis];
  });
  return middle;
}

template <typename Cut>
class Builder {
 public:
  Builder(const TriangleMesh& mesh, int leaf_size, Cut cut)
      : leaf_size_(leaf_size), cut_(std::move(cut)) {
    common::require_sound(mesh);
    if (leaf_size < 1) {
      throw std::invalid_argument("leaf_size: want 1 or more, got " + std::to_string(leaf_size));
    }
    const std::size_t n = mesh.triangles.size();
    entries_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Triangle t = triangle(mesh, i);
      entries_.push_back({box_of(t), (t[0] + t[1] + t[2]) / 3.0, static_cast<std::uint32_t>(i)});
    }
  }

  Bvh build(const TriangleMesh& mesh) {
    bvh_.nodes.reserve(2 * entries_.size());
    bvh_.nodes.emplace_back();
    build(0, entries_.begin(), entries_.end(), 0);
    bvh_.triangles.reserve(entries_.size());
    bvh_.corners.reserve(entries_.size());
    for (const Entry& entry : entries_) {
      bvh_.triangles.push_back(entry.triangle);
      bvh_.corners.push_back(triangle(mesh, entry.triangle));
    }
    return std::move(bvh_);
  }

 private:
  Box build(std::uint32_t index, Iterator begin, Iterator end, int depth) {
    Box box;
    BvhNode node;
    if (end - begin <= leaf_size_) {
      node.first = static_cast<std::uint32_t>(begin - entries_.begin());
      node.count = static_cast<std::uint32_t>(end - begin);
      for (Iterator i = begin; i != end; ++i) box = merged(box, i->box);
    } else {
      node.first = static_cast<std::uint32_t>(bvh_.nodes.size());
      bvh_.nodes.resize(bvh_.nodes.size() + 2);
      const Iterator middle = cut_(begin, end, depth);
      box = build(node.first, begin, middle, depth + 1);
      box = merged(box, build(node.first + 1, middle, end, depth + 1));
    }
    node.box = box;
    bvh_.nodes[index] = node;
    return box;
  }

  int leaf_size_;
  Cut cut_;
  Entries entries_;
  Bvh bvh_;
};

}  // namespace

Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  const auto cut = [](Iterator begin, Iterator end, int) { return halved(begin, end); };
  return Builder(mesh, leaf_size, cut).build(mesh);
}

// ---- Step 5.3 ----

namespace {

bool is_leaf(const BvhNode& node) { return node.count > 0; }

/// Half of (4) of a box that holds something.
inline double half_area(const Box& box) {
  const Vec3 side = box.high - box.low;
  return side.x() * side.y() + side.y() * side.z() + side.z() * side.x();
}

/// Of the two nodes: the one whose box has the larger surface area, a where they are equal.
bool a_is_bigger(const BvhNode& a, const BvhNode& b) {
  return half_area(a.box) >= half_area(b.box);
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

/// Whether to go on with the children of a, else with those of b: not both are leaves.
bool descend_a(const BvhNode& a, const BvhNode& b) {
  return !is_leaf(a) && (is_leaf(b) || a_is_bigger(a, b));
}

/// Whether the boxes of two nodes overlap, of trees at rest.
struct OverlapAtRest {
  bool operator()(const NodePair& pair) const {
    return overlap(a.nodes[pair.a].box, b.nodes[pair.b].box);
  }

  const Bvh& a;
  const Bvh& b;
};

/// Calls at_leaves with each pair of leaves whose boxes overlap. Returns the number of box tests.
///
/// Trick 2: children are tested before they are put on the stack, and put there without a branch,
/// because which boxes overlap cannot be foretold.
template <typename Overlap, typename AtLeaves>
std::uint64_t for_each_pair_of_leaves(const Bvh& a, const Bvh& b, Overlap overlaps,
                                      AtLeaves& at_leaves) {
  // A pair is at most two depths below the roots, and each level leaves one pair behind.
  std::array<NodePair, 2 * max_depth + 2> stack;
  std::size_t size = overlaps({0, 0}) ? 1 : 0;
  stack[0] = {0, 0};
  std::uint64_t box_tests = 1;
  while (size > 0) {
    const NodePair pair = stack[--size];
    const BvhNode& node_a = a.nodes[pair.a];
    const BvhNode& node_b = b.nodes[pair.b];
    if (is_leaf(node_a) && is_leaf(node_b)) {
      at_leaves(node_a, node_b);
      continue;
    }
    const bool into_a = descend_a(node_a, node_b);
    for (const std::uint32_t child : {1U, 0U}) {
      const NodePair next =
          into_a ? NodePair{node_a.first + child, pair.b} : NodePair{pair.a, node_b.first + child};
      stack[size] = next;
      size += overlaps(next) ? 1 : 0;
    }
    box_tests += 2;
  }
  return box_tests;
}

}  // namespace

Traversal traverse(const Bvh& a, const Bvh& b) {
  Traversal found;
  auto note = [&](const BvhNode& leaf_a, const BvhNode& leaf_b) {
    found.ends.push_back({static_cast<std::uint32_t>(&leaf_a - a.nodes.data()),
                          static_cast<std::uint32_t>(&leaf_b - b.nodes.data())});
  };
  found.box_tests = for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, note);
  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

// ---- Step 5.5 ----

namespace {

using common::orientation;
using common::Vec2;
using Signs = std::array<int, 3>;

bool all_zero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }
bool one_side(const Signs& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

/// Trick 3: a triangle and its plane, which may be asked for many points.
struct Facet {
  explicit Facet(const Triangle& triangle) : corners(triangle) {
    const Vec3 e = corners[1] - corners[0];
    const Vec3 f = corners[2] - corners[0];
    const Vec3 left(e.y() * f.z(), e.z() * f.x(), e.x() * f.y());
    const Vec3 right(e.z() * f.y(), e.x() * f.z(), e.y() * f.x());
    n = left - right;
    size = left.cwiseAbs() + right.cwiseAbs();
  }

  Triangle corners;
  Vec3 n;     ///< e × f of the edges e, f from the first corner [m²]
  Vec3 size;  ///< its products by size, which bound its rounding [m²]
};

/// On which sides of the facet's plane the points are. Trick 3: by plain arithmetic if that is
/// sure, exactly if it is not.
Signs sides(const Facet& facet, const Triangle& points) {
  const auto& [plane, n, size] = facet;
  const Triangle d{points[0] - plane[0], points[1] - plane[0], points[2] - plane[0]};
  const Vec3 furthest = d[0].cwiseAbs().cwiseMax(d[1].cwiseAbs()).cwiseMax(d[2].cwiseAbs());
  // Each of the six products of three differences is rounded less than a dozen times by 2⁻⁵³.
  const double error = 2e-15 * size.dot(furthest) + 1e-240;
  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double distance = n.dot(d[i]);
    signs[i] = static_cast<int>(distance > error) - static_cast<int>(distance < -error);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (signs[i] == 0) signs[i] = orientation(plane[0], plane[1], plane[2], points[i]);
  }
  return signs;
}

/// Turns the triangle so that its first corner is alone on its side of a plane, or alone on the
/// plane. Returns 1 where that side is above the plane, or the others are below, and −1 where not.
int put_alone_first(Triangle& t, const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int s_j = s[(i + 1) % 3];
    const int s_k = s[(i + 2) % 3];
    const bool across = s[i] != 0 && s_j * s[i] <= 0 && s_k * s[i] <= 0;
    const bool touches = s[i] == 0 && s_j * s_k > 0;
    if (!across && !touches) continue;
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(i), t.end());
    return across ? s[i] : -s_j;
  }
  throw std::logic_error("all corners are on one side of the plane");
}

/// Two triangles that cross each other's plane meet the line of both planes in an interval each;
/// whether these overlap shows in two orientations. Guigue, Devillers 2003, JGT 8(1).
bool intervals_overlap(Triangle a, const Signs& side_a, Triangle b, const Signs& side_b) {
  const bool turn_b_over = put_alone_first(a, side_a) < 0;
  const bool turn_a_over = put_alone_first(b, side_b) < 0;
  if (turn_b_over) std::swap(b[1], b[2]);
  if (turn_a_over) std::swap(a[1], a[2]);
  return orientation(a[0], a[1], b[0], b[1]) <= 0 && orientation(a[0], a[2], b[2], b[0]) <= 0;
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

/// Corners all in one plane: the triangles meet where their shadows along all three axes do. One of
/// the shadows shows the plane in full, or the line where all corners are on one.
bool meet_in_plane(const Triangle& a, const Triangle& b) {
  if (!overlap(box_of(a), box_of(b))) return false;
  for (Eigen::Index x = 0; x < 3; ++x) {
    const Eigen::Index y = (x + 1) % 3;
    const auto shadow = [&](const Triangle& t) {
      return Shadow{Vec2(t[0][x], t[0][y]), Vec2(t[1][x], t[1][y]), Vec2(t[2][x], t[2][y])};
    };
    if (parted_by_edge(shadow(a), shadow(b)) || parted_by_edge(shadow(b), shadow(a))) return false;
  }
  return true;
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

/// As triangles_meet; most pairs are told apart by the plane of a, which serves several.
bool meet(const Facet& facet_a, const Triangle& b) {
  const Triangle& a = facet_a.corners;
  const Signs side_b = sides(facet_a, b);
  if (one_side(side_b)) return false;
  const Signs side_a = sides(Facet(b), a);
  if (one_side(side_a)) return false;
  // A triangle without a plane, a segment or a point, has all points in every plane through it.
  if (!all_zero(side_a) && !all_zero(side_b)) return intervals_overlap(a, side_a, b, side_b);
  if (!all_zero(side_a)) return segment_pierces(a, side_a, b);
  if (!all_zero(side_b)) return segment_pierces(b, side_b, a);
  return !are_skew(a, b) && meet_in_plane(a, b);
}

}  // namespace

bool triangles_meet(const Triangle& a, const Triangle& b) { return meet(Facet(a), b); }

namespace {

/// The largest coordinate in the box, by size [m].
double furthest(const Box& box) {
  return std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
}

/// From where to where some numbers reach.
struct Span {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

/// The span of x·direction over a triangle. Inline, as all triangles of a leaf are asked.
inline Span span(const Triangle& triangle, const Vec3& direction) {
  const auto& [a, b, c] = triangle;
  const double x = direction.dot(a);
  const double y = direction.dot(b);
  const double z = direction.dot(c);
  return {std::min(std::min(x, y), z), std::max(std::max(x, y), z)};
}

/// A leaf's triangles, where they have moved to, and what tells others to be apart from them: a
/// box, and two parallel planes. A surface is thin across, so these are often close together.
///
/// Trick 5: bounds stand coordinate by coordinate, so that a compiler compares several at once.
struct Leaf {
  [[nodiscard]] Box box_of_entry(std::size_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }

  const BvhNode* node = nullptr;
  const Triangle* corners = nullptr;             ///< by entry
  std::vector<Triangle> moved;                   ///< where they are, unless the tree is at rest
  std::array<std::vector<double>, 3> low, high;  ///< of each one's box: coordinate by entry [m]
  Box box;                                       ///< the smallest around all of them
  Vec3 normal = Vec3::Zero();                    ///< to the planes: the sum of all e × f [m²]
  Span between;                                  ///< the planes: the span along the normal [m³]
};

/// The leaves of a tree that moves, or does not. Trick 4: a leaf meets several of the other tree,
/// soon one after the other, so the last few are kept.
class Leaves {
 public:
  /// motion  of the tree; null where it rests
  Leaves(const Bvh& bvh, const RigidTransform* motion) : bvh_(bvh), motion_(motion), kept_(128) {}

  const Leaf& operator[](const BvhNode& node) {
    const auto index = static_cast<std::size_t>(&node - bvh_.nodes.data());
    Leaf& leaf = kept_[index % kept_.size()];
    if (leaf.node != &node) {
      take(node, leaf);
      find_boxes(leaf);
      find_planes(leaf);
    }
    return leaf;
  }

 private:
  void take(const BvhNode& node, Leaf& leaf) const {
    leaf.node = &node;
    leaf.corners = &bvh_.corners[node.first];
    if (motion_ == nullptr) return;
    leaf.moved.resize(node.count);
    const RigidTransform motion = *motion_;  // no corner that is written is part of a copy
    for (std::size_t i = 0; i < node.count; ++i) {
      leaf.moved[i] = common::transformed(motion, leaf.corners[i]);
    }
    leaf.corners = leaf.moved.data();
  }

  static void find_boxes(Leaf& leaf) {
    const std::size_t count = leaf.node->count;
    for (auto* bounds : {&leaf.low, &leaf.high}) {
      for (std::vector<double>& bound : *bounds) bound.resize(count);
    }
    Box all;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [p, q, r] = leaf.corners[i];
      const Box box{p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
      extend(all, box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        leaf.low[axis][i] = box.low[static_cast<Eigen::Index>(axis)];
        leaf.high[axis][i] = box.high[static_cast<Eigen::Index>(axis)];
      }
    }
    leaf.box = all;
  }

  static void find_planes(Leaf& leaf) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < leaf.node->count; ++i) {
      const auto& [p, q, r] = leaf.corners[i];
      normal += (q - p).cross(r - p);
    }
    Span all;
    for (std::size_t i = 0; i < leaf.node->count; ++i) {
      const auto [least, greatest] = span(leaf.corners[i], normal);
      all = {std::min(all.least, least), std::max(all.greatest, greatest)};
    }
    leaf.normal = normal;
    leaf.between = all;
  }

  const Bvh& bvh_;
  const RigidTransform* motion_;
  std::vector<Leaf> kept_;
};

/// More than all roundings together where products n·x with what is in two leaves are compared.
/// With u = 2⁻⁵³, |n| the sum of n's sizes and |x| the largest coordinate, n·x is rounded by 3 u
/// |n| |x|. In parted_by_planes the terms are no more than (1 + 2 √3) |n| |x|, since |k| |m| is no
/// more than √3 |n|, and each is rounded less than a dozen times: 54 u. This is 180 u.
double rounding(const Vec3& n, const Leaf& a, const Leaf& b) {
  return 2e-14 * n.cwiseAbs().sum() * std::max(furthest(a.box), furthest(b.box));
}

/// Trick 8: whether a leaf's planes part it from another. How far the other reaches along their
/// normal n is told by its own planes, of normal m, as far as n has to do with m, and else by its
/// box: x·n = k x·m + x·(n − k m).
bool parted_by_planes(const Leaf& leaf, const Leaf& other) {
  const double k = leaf.normal.dot(other.normal) / other.normal.squaredNorm();
  const Vec3 rest = leaf.normal - k * other.normal;
  const auto& [least, greatest] = other.between;
  const double middle = 0.5 * (k * (least + greatest) + rest.dot(other.box.low + other.box.high));
  const double half = 0.5 * (std::abs(k) * (greatest - least) +
                             rest.cwiseAbs().dot(other.box.high - other.box.low)) +
                      rounding(leaf.normal, leaf, other);
  // Where m is zero these are NaN, and part nothing.
  return middle - half > leaf.between.greatest || middle + half < leaf.between.least;
}

/// A list of entries of a leaf. Trick 6: which come near another leaf cannot be foretold, so all
/// are asked, and listed without a branch, as in the traversal.
class Listed {
 public:
  /// Lists those of the given ones, which may be this list itself, for which it holds.
  template <typename Given, typename Holds>
  void list(const Given& given, const Holds& holds) {
    if (entries_.size() < given.size()) entries_.resize(given.size());
    std::size_t size = 0;
    for (const std::uint32_t i : given) {
      entries_[size] = i;
      size += holds(i) ? 1 : 0;
    }
    size_ = size;
  }

  /// Lists those of a leaf that come into the box of another and, trick 7, between its planes.
  void list_near(const Leaf& leaf, const Leaf& other) {
    compare_boxes(leaf, other.box);
    list_all(leaf);
    list(*this, [&](std::uint32_t i) { return in_box_[i] != 0; });
    const double margin = rounding(other.normal, leaf, other);
    const double least = other.between.least - margin;
    const double greatest = other.between.greatest + margin;
    list(*this, [&](std::uint32_t i) {
      const Span reach = span(leaf.corners[i], other.normal);
      return (static_cast<int>(reach.least <= greatest) &
              static_cast<int>(reach.greatest >= least)) != 0;
    });
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  void list_all(const Leaf& leaf) {
    size_ = leaf.node->count;
    if (entries_.size() < size_) entries_.resize(size_);
    std::iota(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(size_), 0U);
  }

  void compare_boxes(const Leaf& leaf, const Box& box) {
    const std::size_t count = leaf.node->count;
    in_box_.assign(count, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = box.low[static_cast<Eigen::Index>(axis)];
      const double high = box.high[static_cast<Eigen::Index>(axis)];
      for (std::size_t i = 0; i < count; ++i) {
        in_box_[i] &= static_cast<std::int64_t>(leaf.low[axis][i] <= high) &
                      static_cast<std::int64_t>(low <= leaf.high[axis][i]);
      }
    }
  }

  std::vector<std::uint32_t> entries_;
  std::size_t size_ = 0;              ///< of the entries, that are listed
  std::vector<std::int64_t> in_box_;  ///< 1 or 0, as wide as what is compared
};

/// The narrow phase: all triangles of a leaf of a with all of a leaf of b.
class LeafTest {
 public:
  LeafTest(const Bvh& a, const Bvh& b, const RigidTransform* a_from_b)
      : a_(a), b_(b), leaves_a_(a, nullptr), leaves_b_(b, a_from_b) {}

  void operator()(const BvhNode& node_a, const BvhNode& node_b) {
    found.triangle_tests += std::uint64_t{node_a.count} * node_b.count;
    const Leaf& leaf_a = leaves_a_[node_a];
    const Leaf& leaf_b = leaves_b_[node_b];
    if (!overlap(leaf_a.box, leaf_b.box) || parted_by_planes(leaf_a, leaf_b) ||
        parted_by_planes(leaf_b, leaf_a)) {
      return;
    }
    near_a_.list_near(leaf_a, leaf_b);
    if (near_a_.empty()) return;
    near_b_.list_near(leaf_b, leaf_a);
    if (near_b_.empty()) return;
    for (const std::uint32_t i : near_a_) {
      const Box box = leaf_a.box_of_entry(i);
      close_.list(near_b_, [&](std::uint32_t j) { return overlap(box, leaf_b.box_of_entry(j)); });
      if (close_.empty()) continue;
      const Facet facet(leaf_a.corners[i]);
      for (const std::uint32_t j : close_) {
        if (!meet(facet, leaf_b.corners[j])) continue;
        found.pairs.push_back({a_.triangles[node_a.first + i], b_.triangles[node_b.first + j]});
      }
    }
  }

  Intersections found;

 private:
  const Bvh& a_;
  const Bvh& b_;
  Leaves leaves_a_;
  Leaves leaves_b_;
  Listed near_a_;  ///< of the leaf of a: near the leaf of b
  Listed near_b_;  ///< of the leaf of b: near the leaf of a
  Listed close_;   ///< of these: close to one triangle of a
};

}  // namespace

Intersections find_intersections(const Bvh& a, const Bvh& b) {
  LeafTest test(a, b, nullptr);
  test.found.box_tests = for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, test);
  std::sort(test.found.pairs.begin(), test.found.pairs.end());
  return std::move(test.found);
}

// ---- Step 5.6 ----

namespace {

constexpr int depth_of_last_sah_cut = 31;

/// Triangles side by side: what is between two planes, or all on one side of one.
struct Bin {
  void add(const Box& more, double number) {
    extend(box, more);
    count += number;
  }

  Box box;
  double count = 0.0;
};

double cost(const Bin& side) { return surface_area(side.box) * side.count; }

struct Plane {
  double cost = std::numeric_limits<double>::infinity();
  Eigen::Index axis = 0;
  int bin = 0;  ///< the first beyond the plane
};

class SahCut {
 public:
  explicit SahCut(int bins) : bins_(bins), right_cost_(static_cast<std::size_t>(bins)) {}

  Iterator operator()(Iterator begin, Iterator end, int depth) {
    if (depth > depth_of_last_sah_cut) return halved(begin, end);
    spread_ = box_of_centroids(begin, end);
    scale_ = bins_ * (spread_.high - spread_.low).cwiseInverse();
    fill_bins(begin, end);
    Plane best;
    for (Eigen::Index axis = 0; axis < 3; ++axis) try_planes(axis, best);
    if (best.bin == 0) return halved(begin, end);
    return std::partition(begin, end,
                          [&](const Entry& entry) { return bin_of(entry, best.axis) < best.bin; });
  }

 private:
  [[nodiscard]] bool is_flat(Eigen::Index axis) const {
    return !(spread_.high[axis] > spread_.low[axis]);
  }

  [[nodiscard]] int bin_of(const Entry& entry, Eigen::Index axis) const {
    const double place = (entry.centroid[axis] - spread_.low[axis]) * scale_[axis];
    return std::min(static_cast<int>(place), bins_ - 1);
  }

  /// Trick 11: fills the bins of all three axes in one pass over the triangles.
  void fill_bins(Iterator begin, Iterator end) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      if (is_flat(axis)) scale_[axis] = 0.0;
      of_axis_[static_cast<std::size_t>(axis)].assign(right_cost_.size(), Bin{});
    }
    for (Iterator i = begin; i != end; ++i) {
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto bin = static_cast<std::size_t>(bin_of(*i, axis));
        of_axis_[static_cast<std::size_t>(axis)][bin].add(i->box, 1.0);
      }
    }
  }

  /// Keeps the best plane across the axis where it is better than the best so far. The first and
  /// the last bin are never empty: no plane has an empty side. A plane next to an empty bin parts
  /// as another one does, and is left out.
  void try_planes(Eigen::Index axis, Plane& best) {
    if (is_flat(axis)) return;
    const std::vector<Bin>& bins = of_axis_[static_cast<std::size_t>(axis)];
    Bin right;
    for (std::size_t i = bins.size(); --i > 0;) {
      if (bins[i].count == 0.0) continue;
      right.add(bins[i].box, bins[i].count);
      right_cost_[i] = cost(right);
    }
    Bin left = bins[0];
    for (std::size_t i = 1; i < bins.size(); ++i) {
      if (bins[i].count == 0.0) continue;
      const double both = cost(left) + right_cost_[i];
      if (both < best.cost) best = {both, axis, static_cast<int>(i)};
      left.add(bins[i].box, bins[i].count);
    }
  }

  int bins_;
  Box spread_;                 ///< of the centroids
  Vec3 scale_ = Vec3::Zero();  ///< bins over its sides [1/m]
  std::array<std::vector<Bin>, 3> of_axis_;
  std::vector<double> right_cost_;
};

}  // namespace

Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  if (bins < 2) throw std::invalid_argument("bins: want 2 or more, got " + std::to_string(bins));
  return Builder(mesh, leaf_size, SahCut(bins)).build(mesh);
}

// ---- Step 5.7 ----

namespace {

/// A tree's boxes where they have moved to: around each, a box by (9). Trick 9: a node meets
/// several of the other tree, soon one after the other, so the last few are kept.
class MovedBoxes {
 public:
  MovedBoxes(const Bvh& bvh, const RigidTransform& motion, double margin)
      : bvh_(bvh), motion_(motion), R_size_(motion.rotation.cwiseAbs()), margin_(margin) {}

  const Box& operator[](std::uint32_t node) {
    Kept& kept = kept_[node % kept_.size()];
    if (kept.node != node) kept = {moved(bvh_.nodes[node].box), node};
    return kept.box;
  }

 private:
  struct Kept {
    Box box;
    std::uint32_t node = std::numeric_limits<std::uint32_t>::max();
  };

  [[nodiscard]] Box moved(const Box& box) const {
    const Vec3 c = common::transformed(motion_, 0.5 * (box.low + box.high));
    const Vec3 h = R_size_ * (0.5 * (box.high - box.low)) + Vec3::Constant(margin_);
    return {c - h, c + h};
  }

  const Bvh& bvh_;
  RigidTransform motion_;
  common::Mat3 R_size_;
  double margin_;  ///< more than all roundings together
  std::array<Kept, 1024> kept_;
};

/// Whether a box of a may overlap a box of b that is moved. Trick 10: each is moved to the other's
/// frame, so any of the three directions of either box may part them. Gottschalk, Lin, Manocha
/// 1996, of whose fifteen directions these six cost least.
class MovedOverlap {
 public:
  MovedOverlap(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b)
      : a_(a),
        b_(b),
        a_in_b_(a, inverse(a_from_b), margin(a, b, a_from_b)),
        b_in_a_(b, a_from_b, margin(a, b, a_from_b)) {}

  bool operator()(const NodePair& pair) {
    return overlap(a_.nodes[pair.a].box, b_in_a_[pair.b]) &&
           overlap(a_in_b_[pair.a], b_.nodes[pair.b].box);
  }

 private:
  /// Up to as much as R is no rotation, which the margin holds.
  static RigidTransform inverse(const RigidTransform& motion) {
    const common::Mat3 back = motion.rotation.transpose();
    return {back, -(back * motion.translation)};
  }

  static double margin(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
    const common::Mat3& R = a_from_b.rotation;
    const double skewness = (R.transpose() * R - common::Mat3::Identity()).cwiseAbs().sum();
    const double size = furthest(a.nodes[0].box) + a_from_b.translation.cwiseAbs().sum() +
                        (1.0 + R.cwiseAbs().sum()) * furthest(b.nodes[0].box);
    return (1e-14 + 4.0 * skewness) * size;
  }

  const Bvh& a_;
  const Bvh& b_;
  MovedBoxes a_in_b_;
  MovedBoxes b_in_a_;
};

}  // namespace

Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
  common::require_finite(a_from_b, "a_from_b");
  LeafTest test(a, b, &a_from_b);
  test.found.box_tests = for_each_pair_of_leaves(a, b, MovedOverlap(a, b, a_from_b), test);
  std::sort(test.found.pairs.begin(), test.found.pairs.end());
  return std::move(test.found);
}

Bvh refit(Bvh bvh, const TriangleMesh& deformed) {
  common::require_sound(deformed);
  if (deformed.triangles.size() != bvh.triangles.size()) {
    throw std::invalid_argument("deformed: want as many triangles as before, " +
                                std::to_string(bvh.triangles.size()));
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

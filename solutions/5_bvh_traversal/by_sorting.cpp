// The same contract by other means: sorted lists and a queue build the trees, recursion goes
// through them, and triangles meet where an edge of one meets the other.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "bvh_traversal.hpp"
#include "by_sorting_builder.hpp"
#include "common/exact/orientation.hpp"

namespace lab::bvh_traversal {

// ---- Step 5.1 ----

Box box_of(const Triangle& triangle) {
  Box box;
  for (const Vec3& corner : triangle) box = merged(box, {corner, corner});
  return box;
}

Box merged(const Box& a, const Box& b) {
  Box box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    box.low[i] = std::min(a.low[i], b.low[i]);
    box.high[i] = std::max(a.high[i], b.high[i]);
  }
  return box;
}

bool overlap(const Box& a, const Box& b) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (std::max(a.low[i], b.low[i]) > std::min(a.high[i], b.high[i])) return false;
  }
  return true;
}

double surface_area(const Box& box) {
  if ((box.high.array() < box.low.array()).any()) return 0.0;
  const Vec3 s = box.high - box.low;
  return 2.0 * (s.x() * (s.y() + s.z()) + s.y() * s.z());
}

// ---- Step 5.2 ----

using by_sorting::Builder;
using by_sorting::List;

Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  return Builder(mesh, leaf_size).build([](const Builder& builder, List& list, int) {
    return builder.halve(list);
  });
}

// ---- Steps 5.3 and 5.4 ----

namespace {

bool is_leaf(const BvhNode& node) { return node.count != 0; }

bool bigger(const BvhNode& a, const BvhNode& b) {
  return surface_area(a.box) >= surface_area(b.box);
}

/// b_boxes  b's boxes as a sees them
struct Trees {
  const Bvh& a;
  const Bvh& b;
  const std::vector<Box>& b_boxes;
};

void go(const Trees& trees, const NodePair& pair, bool completed, Traversal& found) {
  const BvhNode& a = trees.a.nodes[pair.a];
  const BvhNode& b = trees.b.nodes[pair.b];
  found.box_tests += 1;
  if (!overlap(a.box, trees.b_boxes[pair.b])) return;
  bool into_a = bigger(a, b);
  if (completed && is_leaf(a) != is_leaf(b)) into_a = is_leaf(b);
  if (is_leaf(into_a ? a : b)) {
    found.ends.push_back(pair);
    return;
  }
  const std::uint32_t child = into_a ? a.first : b.first;
  go(trees, into_a ? NodePair{child, pair.b} : NodePair{pair.a, child}, completed, found);
  go(trees, into_a ? NodePair{child + 1, pair.b} : NodePair{pair.a, child + 1}, completed, found);
}

Traversal traversal(const Trees& trees, bool completed) {
  Traversal found;
  go(trees, {0, 0}, completed, found);
  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

std::vector<Box> boxes(const Bvh& bvh) {
  std::vector<Box> list;
  for (const BvhNode& node : bvh.nodes) list.push_back(node.box);
  return list;
}

}  // namespace

Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {
  return traversal({a, b, boxes(b)}, false);
}

Traversal traverse(const Bvh& a, const Bvh& b) { return traversal({a, b, boxes(b)}, true); }

// ---- Step 5.5 ----

namespace {

using common::orientation;
using common::Vec2;

Vec2 shadow(const Vec3& p, Eigen::Index along) { return {p[(along + 1) % 3], p[(along + 2) % 3]}; }

/// Whether the closed segments p q and r s of one plane meet, seen along an axis.
bool shadows_meet(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, Eigen::Index along) {
  const Vec2 a = shadow(p, along), b = shadow(q, along), c = shadow(r, along), d = shadow(s, along);
  if ((a.cwiseMax(b).array() < c.cwiseMin(d).array()).any()) return false;
  if ((c.cwiseMax(d).array() < a.cwiseMin(b).array()).any()) return false;
  return orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  if (orientation(p, q, r, s) != 0) return false;
  return shadows_meet(p, q, r, s, 0) && shadows_meet(p, q, r, s, 1) && shadows_meet(p, q, r, s, 2);
}

bool weakly_one_sign(int i, int j, int k) {
  return (i >= 0 && j >= 0 && k >= 0) || (i <= 0 && j <= 0 && k <= 0);
}

/// The axis along which the triangle has the shadow of an area; −1 where there is none.
Eigen::Index axis_of_area(const Triangle& t) {
  for (Eigen::Index along = 0; along < 3; ++along) {
    if (orientation(shadow(t[0], along), shadow(t[1], along), shadow(t[2], along)) != 0) {
      return along;
    }
  }
  return -1;
}

bool meets_an_edge(const Vec3& p, const Vec3& q, const Triangle& t) {
  return segments_meet(p, q, t[0], t[1]) || segments_meet(p, q, t[1], t[2]) ||
         segments_meet(p, q, t[2], t[0]);
}

bool segment_meets(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Eigen::Index along = axis_of_area(t);
  if (along < 0) return meets_an_edge(p, q, t);
  const int at_p = orientation(t[0], t[1], t[2], p);
  const int at_q = orientation(t[0], t[1], t[2], q);
  if (at_p * at_q > 0) return false;
  if (at_p != 0 || at_q != 0) {
    return weakly_one_sign(orientation(p, q, t[0], t[1]), orientation(p, q, t[1], t[2]),
                           orientation(p, q, t[2], t[0]));
  }
  const Vec2 x = shadow(p, along);
  const Vec2 a = shadow(t[0], along), b = shadow(t[1], along), c = shadow(t[2], along);
  return weakly_one_sign(orientation(a, b, x), orientation(b, c, x), orientation(c, a, x)) ||
         meets_an_edge(p, q, t);
}

bool an_edge_meets(const Triangle& a, const Triangle& b) {
  return segment_meets(a[0], a[1], b) || segment_meets(a[1], a[2], b) ||
         segment_meets(a[2], a[0], b);
}

Intersections narrow_phase(const Bvh& a, const Bvh& b, const Traversal& broad) {
  Intersections found;
  found.box_tests = broad.box_tests;
  for (const NodePair& pair : broad.ends) {
    const BvhNode& p = a.nodes[pair.a];
    const BvhNode& q = b.nodes[pair.b];
    for (std::uint32_t i = p.first; i < p.first + p.count; ++i) {
      for (std::uint32_t j = q.first; j < q.first + q.count; ++j) {
        found.triangle_tests += 1;
        if (triangles_meet(a.corners[i], b.corners[j])) {
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
  return overlap(box_of(a), box_of(b)) && (an_edge_meets(a, b) || an_edge_meets(b, a));
}

Intersections find_intersections(const Bvh& a, const Bvh& b) {
  return narrow_phase(a, b, traverse(a, b));
}

// ---- Step 5.6 ----

Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  if (bins < 2) throw std::invalid_argument("bins: want 2 or more, got " + std::to_string(bins));
  return Builder(mesh, leaf_size).build([](const Builder& builder, List& list, int depth) {
    return builder.sweep(list, depth);
  });
}

// ---- Step 5.7 ----

Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
  common::require_finite(a_from_b, "a_from_b");
  // Rounded sums and products rise where their operands do. So the eight moved corners of a box
  // hold every moved point of it, rounded like them: no margin is needed.
  std::vector<Box> moved;
  for (const BvhNode& node : b.nodes) {
    Box box;
    for (int k = 0; k < 8; ++k) {
      const Box& from = node.box;
      const Vec3 corner((k & 1) == 0 ? from.low.x() : from.high.x(),
                        (k & 2) == 0 ? from.low.y() : from.high.y(),
                        (k & 4) == 0 ? from.low.z() : from.high.z());
      const Vec3 there = common::transformed(a_from_b, corner);
      box = merged(box, {there, there});
    }
    moved.push_back(box);
  }
  Bvh there = b;
  for (Triangle& corners : there.corners) corners = common::transformed(a_from_b, corners);
  return narrow_phase(a, there, traversal({a, b, moved}, true));
}

Bvh refit(Bvh bvh, const TriangleMesh& deformed) {
  common::require_sound(deformed);
  if (deformed.triangles.size() != bvh.triangles.size()) {
    throw std::invalid_argument("deformed: another number of triangles");
  }
  for (std::size_t i = 0; i < bvh.corners.size(); ++i) {
    bvh.corners[i] = triangle(deformed, bvh.triangles[i]);
  }
  const auto fit = [&](const auto& self, std::uint32_t node) -> Box {
    const std::uint32_t first = bvh.nodes[node].first;
    Box box;
    if (is_leaf(bvh.nodes[node])) {
      for (std::uint32_t i = 0; i < bvh.nodes[node].count; ++i) {
        box = merged(box, box_of(bvh.corners[first + i]));
      }
    } else {
      box = merged(self(self, first), self(self, first + 1));
    }
    bvh.nodes[node].box = box;
    return box;
  };
  fit(fit, 0);
  return bvh;
}

}  // namespace lab::bvh_traversal

#pragma once

#include "judged.hpp"
#include "random.hpp"

/// Trees made apart from every answer, and what a traversal does with them, in the lecture's words.
namespace tests {

inline void extend(lab::Box& box, const lab::Box& by) {
  box.low = box.low.cwiseMin(by.low);
  box.high = box.high.cwiseMax(by.high);
}

inline lab::Box box_around(const common::Triangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

/// The smallest box of some of the entries.
inline lab::Box box_around(const std::vector<common::Triangle>& corners, std::size_t first,
                           std::size_t count) {
  lab::Box box;
  for (std::size_t i = first; i < first + count; ++i) extend(box, box_around(corners[i]));
  return box;
}

/// A tree whose ranges are cut at a third along the longest side of their box, so that it is
/// lopsided: depths of leaves differ, as a traversal must bear.
class TreeMaker {
 public:
  TreeMaker(const common::TriangleMesh& mesh, std::size_t leaf_size) : leaf_size_(leaf_size) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const common::Triangle t = common::triangle(mesh, i);
      bvh_.triangles.push_back(i);
      boxes_.push_back(box_around(t));
      places_.emplace_back(t[0] + t[1] + t[2]);
    }
    bvh_.nodes.emplace_back();
    make(0, 0, bvh_.triangles.size());
    bvh_.corners.reserve(bvh_.triangles.size());
    for (const std::uint32_t i : bvh_.triangles) bvh_.corners.push_back(common::triangle(mesh, i));
  }

  [[nodiscard]] const lab::Bvh& bvh() const { return bvh_; }

 private:
  void make(std::size_t node, std::size_t first, std::size_t count) {
    lab::Box box;
    for (std::size_t i = first; i < first + count; ++i) extend(box, boxes_[bvh_.triangles[i]]);
    bvh_.nodes[node].box = box;
    if (count <= leaf_size_) {
      bvh_.nodes[node].first = static_cast<std::uint32_t>(first);
      bvh_.nodes[node].count = static_cast<std::uint32_t>(count);
      return;
    }
    const std::size_t third = std::max<std::size_t>(count / 3, 1);
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    part(first, third, count, axis);
    const std::size_t child = bvh_.nodes.size();
    bvh_.nodes[node].first = static_cast<std::uint32_t>(child);
    bvh_.nodes.resize(child + 2);
    make(child, first, third);
    make(child + 1, first + third, count - third);
  }

  /// Brings the least along the axis to the front, of equals those of the lower indices.
  void part(std::size_t first, std::size_t front, std::size_t count, Eigen::Index axis) {
    order_.clear();
    for (std::size_t i = first; i < first + count; ++i) {
      order_.emplace_back(places_[bvh_.triangles[i]][axis], bvh_.triangles[i]);
    }
    std::nth_element(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(front),
                     order_.end());
    for (std::size_t i = 0; i < count; ++i) bvh_.triangles[first + i] = order_[i].second;
  }

  std::size_t leaf_size_;
  std::vector<lab::Box> boxes_;
  std::vector<Vec3> places_;  ///< three times the centroids
  std::vector<std::pair<double, std::uint32_t>> order_;
  lab::Bvh bvh_;
};

inline lab::Bvh tree_of(const common::TriangleMesh& mesh, std::size_t leaf_size) {
  return TreeMaker(mesh, leaf_size).bvh();
}

/// What can go wrong in a traversal.
struct Walk {
  bool leaves = true;            ///< as completed, else as first written
  bool bigger = true;            ///< else the smaller node is descended
  bool ties_to_a = true;         ///< else b's node is bigger if both are as large
  bool strict = false;           ///< touching boxes are taken for apart
  bool both_children = true;     ///< else the first only
  bool one_leaf = true;          ///< else a leaf and an inner node are given up
  bool leaf_may_descend = true;  ///< else nothing is done where the bigger one is a leaf
};

inline double area(const lab::Box& box) {
  const Vec3 s = box.high - box.low;
  return 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
}

inline bool boxes_meet(const lab::Box& a, const lab::Box& b, bool strict = false) {
  const auto part = [&](double end, double start) {
    return end < start || (strict && end == start);
  };
  return !(part(a.high.x(), b.low.x()) || part(b.high.x(), a.low.x()) ||
           part(a.high.y(), b.low.y()) || part(b.high.y(), a.low.y()) ||
           part(a.high.z(), b.low.z()) || part(b.high.z(), a.low.z()));
}

class Walker {
 public:
  Walker(const lab::Bvh& a, const lab::Bvh& b, const Walk& walk = {}) : a_(a), b_(b), walk_(walk) {
    go(0, 0);
    std::sort(ends.pairs.begin(), ends.pairs.end());
  }

  Pairs ends;
  std::uint64_t box_tests = 0;

 private:
  void go(std::uint32_t i, std::uint32_t j) {
    ++box_tests;
    const lab::BvhNode& a = a_.nodes[i];
    const lab::BvhNode& b = b_.nodes[j];
    if (!boxes_meet(a.box, b.box, walk_.strict)) return;
    bool into_a = area(a.box) > area(b.box);
    if (area(a.box) == area(b.box)) into_a = walk_.ties_to_a;
    if (!walk_.bigger) into_a = !into_a;
    const bool leaf_a = a.count > 0;
    const bool leaf_b = b.count > 0;
    if (!walk_.leaves) {
      if (into_a ? leaf_a : leaf_b) {
        ends.pairs.push_back({i, j});
        return;
      }
    } else {
      if (leaf_a && leaf_b) {
        ends.pairs.push_back({i, j});
        return;
      }
      if ((leaf_a || leaf_b) && !walk_.one_leaf) return;
      if (!walk_.leaf_may_descend && (into_a ? leaf_a : leaf_b)) return;
      if (leaf_a) into_a = false;
      if (leaf_b) into_a = true;
    }
    for (std::uint32_t child = 0; child < (walk_.both_children ? 2U : 1U); ++child) {
      if (into_a) go(a.first + child, j);
      if (!into_a) go(i, b.first + child);
    }
  }

  const lab::Bvh& a_;
  const lab::Bvh& b_;
  Walk walk_;
};

/// Triangles between points of a small grid, where they touch, share and lie in one plane often.
inline common::TriangleMesh soup(Random& random, int triangles, int grid) {
  common::TriangleMesh mesh;
  for (int i = 0; i < 3 * triangles; ++i) {
    Vec3 point;
    for (double& x : point) x = std::floor(random.uniform(0.0, grid + 1.0));
    mesh.vertices.push_back(point);
  }
  for (std::uint32_t i = 0; i < mesh.vertices.size(); i += 3) {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  return mesh;
}

/// A larger soup of small triangles, spread over a cube of whole coordinates: areas are exact.
inline common::TriangleMesh spread(Random& random, int triangles, int size) {
  common::TriangleMesh mesh = soup(random, triangles, 3);
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
    Vec3 place;
    for (double& x : place) x = std::floor(random.uniform(0.0, size));
    for (std::size_t k = i; k < i + 3; ++k) mesh.vertices[k] += place;
  }
  return mesh;
}

/// A mesh as an argument: its triangles where they are few, their number where not.
struct Triangles {
  std::size_t count = 0;
  std::vector<common::Triangle> few;
};
inline std::string text(const Triangles& mesh) {
  if (mesh.few.empty()) return "a mesh of " + std::to_string(mesh.count) + " triangles";
  std::string list;
  for (const common::Triangle& t : mesh.few) list += (list.empty() ? "" : ", ") + text(code(t));
  return "{" + list + "}";
}

inline Triangles code(const common::TriangleMesh& mesh) {
  Triangles triangles{mesh.triangles.size(), {}};
  if (triangles.count > 8) return triangles;
  for (std::size_t i = 0; i < triangles.count; ++i) {
    triangles.few.push_back(common::triangle(mesh, i));
  }
  return triangles;
}

}  // namespace tests

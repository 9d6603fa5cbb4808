#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

#include "bvh_traversal.hpp"

/// Of by_sorting.cpp: trees by sorted lists and a queue of nodes that are still to be cut.
namespace lab::bvh_traversal::by_sorting {

using List = std::vector<std::uint32_t>;

/// A node that is still to be cut.
struct Task {
  std::uint32_t node;
  int depth;
  List list;
};

class Builder {
 public:
  explicit Builder(const TriangleMesh& mesh, int leaf_size) : mesh_(mesh) {
    common::require_sound(mesh);
    if (leaf_size < 1) {
      throw std::invalid_argument("leaf_size: want 1 or more, got " + std::to_string(leaf_size));
    }
    leaf_size_ = static_cast<std::size_t>(leaf_size);
  }

  /// cut  sorts a list and says how many of it are in front of the cut
  template <typename Cut>
  Bvh build(const Cut& cut) {
    List all;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) all.push_back(i);
    bvh_.nodes.emplace_back();
    std::deque<Task> tasks{{0, 0, all}};
    for (; !tasks.empty(); tasks.pop_front()) {
      Task& task = tasks.front();
      for (const std::uint32_t i : task.list) {
        bvh_.nodes[task.node].box = merged(bvh_.nodes[task.node].box, box_of(triangle(mesh_, i)));
      }
      if (task.list.size() <= leaf_size_) {
        make_leaf(bvh_.nodes[task.node], task.list);
        continue;
      }
      const auto middle = static_cast<std::ptrdiff_t>(cut(*this, task.list, task.depth));
      const auto child = static_cast<std::uint32_t>(bvh_.nodes.size());
      bvh_.nodes[task.node].first = child;
      bvh_.nodes.resize(child + 2);
      const List left(task.list.begin(), task.list.begin() + middle);
      const List right(task.list.begin() + middle, task.list.end());
      const int depth = task.depth + 1;
      tasks.push_back({child, depth, left});
      tasks.push_back({child + 1, depth, right});
    }
    return bvh_;
  }

  [[nodiscard]] Vec3 centroid(std::uint32_t i) const {
    const Triangle t = triangle(mesh_, i);
    return (t[0] + t[1] + t[2]) / 3.0;
  }

  void sort(List& list, Eigen::Index axis) const {
    std::stable_sort(list.begin(), list.end(), [&](std::uint32_t i, std::uint32_t j) {
      return centroid(i)[axis] < centroid(j)[axis];
    });
  }

  std::size_t halve(List& list) const {
    Box spread;
    for (const std::uint32_t i : list) spread = merged(spread, {centroid(i), centroid(i)});
    const Vec3 sides = spread.high - spread.low;
    Eigen::Index axis = sides.x() >= sides.y() ? 0 : 1;
    if (sides.z() > sides[axis]) axis = 2;
    sort(list, axis);
    return (list.size() + 1) / 2;
  }

  /// The cheapest of all cuts of the sorted lists: no plane between bins can be cheaper.
  std::size_t sweep(List& list, int depth) const {
    double best = std::numeric_limits<double>::infinity();
    List order;
    std::size_t middle = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      sort(list, axis);
      if (!(centroid(list.front())[axis] < centroid(list.back())[axis])) continue;
      std::vector<double> right(list.size());
      Box box;
      for (std::size_t i = list.size(); --i > 0;) {
        box = merged(box, box_of(triangle(mesh_, list[i])));
        right[i] = surface_area(box) * static_cast<double>(list.size() - i);
      }
      box = Box{};
      for (std::size_t i = 1; i < list.size(); ++i) {
        box = merged(box, box_of(triangle(mesh_, list[i - 1])));
        const double cost = surface_area(box) * static_cast<double>(i) + right[i];
        if (cost >= best) continue;
        best = cost;
        order = list;
        middle = i;
      }
    }
    if (order.empty() || depth >= 32) return halve(list);
    list = order;
    return middle;
  }

 private:
  void make_leaf(BvhNode& leaf, const List& list) {
    leaf.first = static_cast<std::uint32_t>(bvh_.triangles.size());
    leaf.count = static_cast<std::uint32_t>(list.size());
    for (const std::uint32_t i : list) {
      bvh_.triangles.push_back(i);
      bvh_.corners.push_back(triangle(mesh_, i));
    }
  }

  const TriangleMesh& mesh_;
  std::size_t leaf_size_ = 1;
  Bvh bvh_;
};

}  // namespace lab::bvh_traversal::by_sorting

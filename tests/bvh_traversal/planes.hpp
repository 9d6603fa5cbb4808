#pragma once

#include "structure.hpp"

/// The planes that eq. (8) chooses from, and what a cut by each would cost.
namespace tests {

/// The triangles below a node, apart from how the tree keeps them.
struct Item {
  lab::Box box;
  Vec3 centroid;
};

inline lab::Box joined(const lab::Box& a, const lab::Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

inline std::vector<Item> items_below(const lab::Bvh& bvh, const Shape& shape, std::size_t node) {
  std::vector<Item> items;
  for (const std::size_t i : entries_below(bvh, shape, node)) {
    items.push_back({box_around(bvh.corners, i, 1), centroid(bvh.corners[i])});
  }
  return items;
}

inline double volume(const lab::Box& box) { return (box.high - box.low).prod(); }

enum class Weight { area_and_number, area, volume_and_number };

inline double weight(const lab::Box& box, double number, Weight kind) {
  switch (kind) {
    case Weight::area_and_number:
      return area(box) * number;
    case Weight::area:
      return area(box);
    case Weight::volume_and_number:
      return volume(box) * number;
  }
  return 0.0;
}

/// The planes between bins across one axis: for each the two sides' boxes and numbers.
struct Sides {
  lab::Box left, right;
  double in_left = 0.0, in_right = 0.0;
};

inline std::vector<Sides> planes(const std::vector<Item>& items, Eigen::Index axis, int bins) {
  double low = items.front().centroid[axis];
  double high = low;
  for (const Item& item : items) {
    low = std::min(low, item.centroid[axis]);
    high = std::max(high, item.centroid[axis]);
  }
  std::vector<Sides> found;
  for (int k = 1; k < bins && high > low; ++k) {
    const double plane = low + (high - low) * k / bins;
    Sides sides;
    bool clear = true;
    for (const Item& item : items) {
      const double distance = item.centroid[axis] - plane;
      // A centroid on the plane to rounding may be counted on either side: such a plane is no
      // judge.
      clear = clear && std::abs(distance) > 1e-12 * (std::abs(low) + std::abs(high));
      lab::Box& side = distance < 0.0 ? sides.left : sides.right;
      side = joined(side, item.box);
      (distance < 0.0 ? sides.in_left : sides.in_right) += 1.0;
    }
    if (clear && sides.in_left > 0.0 && sides.in_right > 0.0) found.push_back(sides);
  }
  return found;
}

inline double cost(const Sides& s, Weight kind) {
  return weight(s.left, s.in_left, kind) + weight(s.right, s.in_right, kind);
}

/// A N of the best plane by a mistaken weight, or across the widest axis alone.
inline double cost_of_choice(const std::vector<std::vector<Sides>>& axes, Weight kind) {
  double best = std::numeric_limits<double>::infinity();
  double cost_of_best = best;
  for (const std::vector<Sides>& axis : axes) {
    for (const Sides& s : axis) {
      if (cost(s, kind) >= best) continue;
      best = cost(s, kind);
      cost_of_best = cost(s, Weight::area_and_number);
    }
  }
  return cost_of_best;
}

inline Eigen::Index widest_axis(const std::vector<Item>& items) {
  std::vector<Vec3> centroids;
  for (const Item& item : items) centroids.push_back(item.centroid);
  const auto span = span_of(centroids);
  Eigen::Index axis = 0;
  (span.second - span.first).maxCoeff(&axis);
  return axis;
}

}  // namespace tests

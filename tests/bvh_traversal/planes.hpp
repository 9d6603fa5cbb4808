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
    items.push_back({box_around(bvh.corners[i]), centroid(bvh.corners[i])});
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
  std::size_t plane = 0;  ///< behind so many bins
};

inline std::vector<Sides> planes(const std::vector<Item>& items, Eigen::Index axis, int bins) {
  double low = items.front().centroid[axis];
  double high = low;
  for (const Item& item : items) {
    low = std::min(low, item.centroid[axis]);
    high = std::max(high, item.centroid[axis]);
  }
  if (!(high > low)) return {};
  const auto count = static_cast<std::size_t>(bins);
  std::vector<double> place(count, low);
  for (std::size_t k = 1; k < count; ++k) {
    place[k] = low + (high - low) * static_cast<double>(k) / bins;
  }
  // A centroid on the plane to rounding may be counted on either side: such a plane is no judge.
  const double rounding = 1e-12 * (std::abs(low) + std::abs(high));
  std::vector<bool> clear(count, true);
  std::vector<lab::Box> box(count);
  std::vector<double> number(count, 0.0);
  for (const Item& item : items) {
    std::size_t bin = 0;
    for (std::size_t k = 1; k < count; ++k) {
      const double distance = item.centroid[axis] - place[k];
      if (std::abs(distance) <= rounding) clear[k] = false;
      if (distance >= 0.0) bin = k;
    }
    extend(box[bin], item.box);
    number[bin] += 1.0;
  }
  std::vector<Sides> sides(count);
  for (std::size_t k = 1; k < count; ++k) {
    sides[k].left = joined(sides[k - 1].left, box[k - 1]);
    sides[k].in_left = sides[k - 1].in_left + number[k - 1];
    sides[k].plane = k;
  }
  lab::Box right;
  for (std::size_t k = count; k-- > 1;) {
    extend(right, box[k]);
    sides[k].right = right;
    sides[k].in_right = static_cast<double>(items.size()) - sides[k].in_left;
  }
  std::vector<Sides> found;
  for (std::size_t k = 1; k < count; ++k) {
    if (clear[k] && sides[k].in_left > 0.0 && sides[k].in_right > 0.0) found.push_back(sides[k]);
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

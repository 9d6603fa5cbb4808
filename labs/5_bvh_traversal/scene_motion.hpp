#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "bvh_traversal.hpp"
#include "common/geometry/meshes.hpp"
#include "common/rotation/attitude.hpp"

/// The motion of the scene, and the boxes of the trees that are drawn.
namespace lab::bvh_traversal {

inline constexpr double duration = 4.0;            ///< [s]
inline constexpr std::size_t triangles_of = 1936;  ///< a torus
inline constexpr int leaf_size = 4;
inline constexpr int drawn_level = 5;

/// Returns the distance of a's middle from the world's, and of b's on the other side [m]. They
/// change sides at a constant speed.
inline double way(double time) { return 1.3 * (2.0 * time / duration - 1.0); }

/// Returns the pose of a torus's frame in the world.
inline RigidTransform world_from_a(double time) {
  return {Mat3(common::exponential_map({0.35, 0.0, 0.0})), {way(time), 0.0, 0.0}};
}
inline RigidTransform world_from_b(double time) {
  const double turn = (0.45 + 0.4 * time / duration) * std::numbers::pi;
  return {Mat3(common::exponential_map({turn, 0.0, 0.0})), {-way(time), 0.0, 0.0}};
}

inline RigidTransform a_from_b(double time) {
  const RigidTransform a = world_from_a(time);
  const RigidTransform b = world_from_b(time);
  const Mat3 a_from_world = a.rotation.transpose();
  return {a_from_world * b.rotation, a_from_world * (b.translation - a.translation)};
}

/// The boxes of one level, and of leaves above it, and the box that each triangle is in. The tree
/// is an answer's and may be wrong, so everything that leads out of it is left out.
struct Level {
  std::vector<Box> boxes;
  std::vector<std::size_t> box_of_triangle;  ///< boxes.size() for one that no leaf has
};

/// For each node: its depth, or -1 if no parent leads to it, and the drawn box that it is in.
struct Place {
  int depth = -1;
  std::size_t box = 0;
};

/// Children come after their parent, so a pass from front to back knows all parents.
inline std::vector<Place> places_of(const Bvh& bvh, std::vector<Box>& boxes) {
  std::vector<Place> places(bvh.nodes.size());
  if (!places.empty()) places[0].depth = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    Place& place = places[i];
    if (place.depth < 0) continue;
    if (place.depth == drawn_level || (place.depth < drawn_level && node.count > 0)) {
      place.box = boxes.size();
      boxes.push_back(node.box);
    }
    const std::size_t first = node.first;
    if (node.count == 0 && first > i && first + 1 < places.size()) {
      places[first] = places[first + 1] = {place.depth + 1, place.box};
    }
  }
  return places;
}

inline Level level_of(const Bvh& bvh, std::size_t triangles) {
  Level level;
  const std::vector<Place> places = places_of(bvh, level.boxes);
  level.box_of_triangle.assign(triangles, level.boxes.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].depth < 0) continue;
    const std::size_t first = bvh.nodes[i].first;
    const std::size_t end = std::min(first + bvh.nodes[i].count, bvh.triangles.size());
    for (std::size_t entry = first; entry < end; ++entry) {
      const std::size_t triangle = bvh.triangles[entry];
      if (triangle < triangles) level.box_of_triangle[triangle] = places[i].box;
    }
  }
  return level;
}

}  // namespace lab::bvh_traversal

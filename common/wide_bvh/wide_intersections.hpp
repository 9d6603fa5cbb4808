#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/rigid_transform.hpp"
#include "common/wide_bvh/wide_bvh.hpp"

namespace common {

struct WideIntersections {
  std::vector<TriangleIndices> pairs;  ///< each once, sorted
  std::uint64_t box_tests = 0;         ///< pairs of boxes, not both of triangles
  std::uint64_t triangle_tests = 0;    ///< pairs of triangles in the pairs of leaves it visited
};

/// Returns all pairs of triangles that meet: a against b, as it is or moved as by
/// transformed(a_from_b, triangle). Plain arithmetic decides if it is sure, and triangles_meet
/// otherwise. Lengths are zero or within 1e-60 and 1e60 m.
/// Throws std::invalid_argument if a_from_b is not finite.
WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     TrianglesMeet triangles_meet);
WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     const RigidTransform& a_from_b, TrianglesMeet triangles_meet);

}  // namespace common

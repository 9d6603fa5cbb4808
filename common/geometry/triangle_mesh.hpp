#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/types.hpp"

namespace common {

/// The corners of a triangle. The triangle is all points between them, so corners on one line make
/// a segment, and three equal corners make a point.
using Triangle = std::array<Vec3, 3>;

/// Triangles that share their corners. They need not be closed or joined: any set is a mesh.
struct TriangleMesh {
  std::vector<Vec3> vertices;                           ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of their corners
};

inline Triangle triangle(const TriangleMesh& mesh, std::size_t index) {
  const auto& [i, j, k] = mesh.triangles[index];
  return {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
}

/// Throws std::invalid_argument if the mesh has no triangle, if a vertex is NaN or infinite, or if
/// a triangle has an index of no vertex; the text says which.
void require_sound(const TriangleMesh& mesh);

}  // namespace common

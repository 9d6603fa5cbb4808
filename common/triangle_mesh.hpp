#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/types.hpp"

namespace common {

/// The corners of a triangle. It is all points between them: corners on one line make a segment,
/// three equal ones a point.
using Triangle = std::array<Vec3, 3>;

/// Triangles that share their corners. Soups are meshes, too: nothing need be closed or joined.
struct TriangleMesh {
  std::vector<Vec3> vertices;                           ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of their corners
};

inline Triangle triangle(const TriangleMesh& mesh, std::size_t index) {
  const auto& [i, j, k] = mesh.triangles[index];
  return {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
}

/// Throws std::invalid_argument where the mesh has no triangle, a vertex is NaN or infinite, or a
/// triangle has an index of no vertex; the text says which.
void require_sound(const TriangleMesh& mesh);

}  // namespace common

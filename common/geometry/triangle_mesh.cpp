#include "common/geometry/triangle_mesh.hpp"

#include <stdexcept>
#include <string>

namespace common {

void require_sound(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw std::invalid_argument("mesh: it has no triangle");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite()) {
      throw std::invalid_argument("mesh: vertex " + std::to_string(i) + " is not finite");
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner < mesh.vertices.size()) continue;
      throw std::invalid_argument("mesh: triangle " + std::to_string(i) + " has the vertex " +
                                  std::to_string(corner) + " of " +
                                  std::to_string(mesh.vertices.size()));
    }
  }
}

}  // namespace common

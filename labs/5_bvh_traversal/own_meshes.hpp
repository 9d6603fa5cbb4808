#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/obj_file.hpp"
#include "common/types.hpp"

namespace lab::bvh_traversal {

/// The OBJ files of a command line: "--mesh FILE" at most twice.
struct OwnMeshes {
  std::vector<std::string> files;

  /// Removes them from the arguments, so that others can read the rest.
  void take_from(int& argc, char** argv) {
    int kept = 0;
    for (int i = 0; i < argc; ++i) {
      if (std::string_view(argv[i]) == "--mesh" && i + 1 < argc && files.size() < 2) {
        files.emplace_back(argv[++i]);
      } else {
        argv[kept++] = argv[i];
      }
    }
    argc = kept;
  }

  [[nodiscard]] const std::string& file(std::size_t i) const {
    return files[std::min(i, files.size() - 1)];
  }
  [[nodiscard]] std::string name(std::size_t i) const {
    return std::filesystem::path(file(i)).filename().string();
  }

  /// Returns the i-th of two meshes (or the only one). It is moved and scaled so that the sphere
  /// around its box has its centre in the origin and this radius [m]. Throws if it cannot be read,
  /// or if it is a point.
  [[nodiscard]] common::TriangleMesh fitted(std::size_t i, double radius) const {
    common::TriangleMesh mesh = common::read_obj(file(i));
    common::Vec3 low = mesh.vertices[mesh.triangles[0][0]];
    common::Vec3 high = low;
    for (const auto& corners : mesh.triangles) {
      for (const std::uint32_t corner : corners) {
        low = low.cwiseMin(mesh.vertices[corner]);
        high = high.cwiseMax(mesh.vertices[corner]);
      }
    }
    const common::Vec3 half = 0.5 * high - 0.5 * low;  // high − low may overflow
    const double widest = half.maxCoeff();
    const double to_edge = widest * (half / widest).norm();
    if (!(widest > 0.0))
      throw std::runtime_error(file(i) + ": all its vertices are the same point");
    for (common::Vec3& vertex : mesh.vertices) {
      vertex = radius * ((vertex - (low + half)) / to_edge);
    }
    return mesh;
  }
};

}  // namespace lab::bvh_traversal

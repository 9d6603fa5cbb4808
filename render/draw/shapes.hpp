#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace render {

/// A vertex as the shaders read it.
struct Vertex {
  Eigen::Vector3f point;
  float end = 0.0F;  ///< −1 or 1: moves with that end of a capsule, by its instance's stretch
  Eigen::Vector3f normal;
  float accent = 0.0F;  ///< 0 colour … 1 accent
};

struct Triangles {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// Unit shapes, which instances scale. All but the box turn about z.
Triangles box_shape();                   ///< half extents 1; ±x faces in accent
Triangles round_shape(int segments);     ///< radius 1; upper half in accent; a capsule if stretched
Triangles cylinder_shape(int segments);  ///< radius 1, z in [−1, 1]; the +z end in accent
Triangles cone_shape(int segments);      ///< radius 1 at z = 0, tip at z = 1

}  // namespace render

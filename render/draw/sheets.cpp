// Meshes and cloths: their triangles are placed and given normals here, not in a shader.
#include <algorithm>
#include <cmath>

#include "render/draw/draw_list.hpp"

namespace render {
namespace {

using Corners = std::array<int, 3>;

// Twice the triangle's area, along its normal.
Vec3 area_vector(const std::vector<Vec3>& points, const Corners& corners) {
  const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(corners[i])]; };
  return (at(1) - at(0)).cross(at(2) - at(0));
}

// Normals at points, the mean over the triangles around, weighted by area.
std::vector<Vec3> smooth_normals(const std::vector<Vec3>& points,
                                 const std::vector<Corners>& triangles) {
  std::vector<Vec3> normals(points.size(), Vec3::Zero());
  for (const Corners& corners : triangles) {
    const Vec3 area = area_vector(points, corners);
    for (const int corner : corners) normals[static_cast<std::size_t>(corner)] += area;
  }
  for (Vec3& normal : normals) normal.stableNormalize();
  return normals;
}

struct Face {
  Corners corners;
  bool is_accent = false;
};

void add_face(Triangles& target, const View& view, const std::vector<Vec3>& points,
              const std::vector<Vec3>& normals, const Face& face) {
  const Vec3 flat = area_vector(points, face.corners).stableNormalized();
  for (const int corner : face.corners) {
    const auto index = static_cast<std::size_t>(corner);
    const Vec3& normal = normals.empty() ? flat : normals[index];
    target.indices.push_back(static_cast<std::uint32_t>(target.vertices.size()));
    target.vertices.push_back({view.from_origin(points[index]), 0.0F, normal.cast<float>(),
                               face.is_accent ? 1.0F : 0.0F});
  }
}

Block block_around(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec3 half_size = (high - low) / 2;
  return {low + half_size, half_size.asDiagonal()};
}

Instance paint_of(const View& view, const Paint& paint) {
  return instance_of(view, Mat3::Identity(), view.origin, paint);
}

void add_mesh(DrawList& list, const Mesh& mesh, const View& view) {
  if (mesh.triangles.empty()) return;
  const Mat3& A = mesh.placement.world_from_body;
  std::vector<Vec3> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices)
    points.emplace_back(mesh.placement.position + A * vertex);
  std::vector<Corners> triangles = mesh.triangles;
  if (A.determinant() < 0.0) {
    for (Corners& corners : triangles) std::swap(corners[1], corners[2]);
  }
  const std::vector<Vec3> normals =
      mesh.smooth ? smooth_normals(points, triangles) : std::vector<Vec3>();
  Sheet sheet{{}, paint_of(view, mesh.paint)};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const bool is_accent = !mesh.lit.empty() && mesh.lit[i];
    add_face(sheet.triangles, view, points, normals, {triangles[i], is_accent});
  }
  list.casters.push_back(block_around(points));
  list.sheets.push_back(std::move(sheet));
}

// Front and back are two layers of triangles, and one of them faces the eye.
void add_cloth(DrawList& list, const Cloth& cloth, const View& view) {
  if (cloth.rows < 2 || cloth.columns < 2) return;
  std::vector<Corners> triangles;
  for (int row = 0; row + 1 < cloth.rows; ++row) {
    for (int column = 0; column + 1 < cloth.columns; ++column) {
      const int a = row * cloth.columns + column;
      const int b = a + cloth.columns;
      triangles.push_back({a, a + 1, b + 1});
      triangles.push_back({a, b + 1, b});
    }
  }
  const std::vector<Vec3> front = smooth_normals(cloth.points, triangles);
  std::vector<Vec3> back;
  back.reserve(front.size());
  for (const Vec3& normal : front) back.emplace_back(-normal);
  Sheet sheet{{}, paint_of(view, cloth.paint)};
  for (const Corners& corners : triangles) {
    const Corners turned{corners[0], corners[2], corners[1]};
    add_face(sheet.triangles, view, cloth.points, front, {corners, false});
    add_face(sheet.triangles, view, cloth.points, back, {turned, true});
  }
  list.casters.push_back(block_around(cloth.points));
  list.sheets.push_back(std::move(sheet));
}

}  // namespace

void add_sheets(DrawList& list, const Scene& scene, const View& view) {
  for (const Mesh& mesh : scene.meshes) add_mesh(list, mesh, view);
  for (const Cloth& cloth : scene.cloths) add_cloth(list, cloth, view);
}

}  // namespace render

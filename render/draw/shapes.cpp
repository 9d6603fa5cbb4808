#include "render/draw/shapes.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace render {
namespace {

// A point of the outline that turns about z, from bottom to top.
struct OutlinePoint {
  double radius;
  double z;
  double normal_radius;
  double normal_z;
  float end = 0.0F;
  float accent = 0.0F;
  bool is_joined = true;  // by a band to the next point
};

void add_ring(Triangles& shape, const OutlinePoint& point, int segments) {
  for (int i = 0; i <= segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / segments;
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    const Eigen::Vector3d place(point.radius * out.x(), point.radius * out.y(), point.z);
    const Eigen::Vector3d normal(point.normal_radius * out.x(), point.normal_radius * out.y(),
                                 point.normal_z);
    shape.vertices.push_back({place.cast<float>(), point.end, normal.cast<float>(), point.accent});
  }
}

void add_band(Triangles& shape, const OutlinePoint& lower, const OutlinePoint& upper,
              std::uint32_t first, std::uint32_t segments) {
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t a = first + i;
    const std::uint32_t b = a + segments + 1;
    if (lower.radius > 0.0) shape.indices.insert(shape.indices.end(), {a, a + 1, b + 1});
    if (upper.radius > 0.0) shape.indices.insert(shape.indices.end(), {a, b + 1, b});
  }
}

Triangles turned(const std::vector<OutlinePoint>& outline, int segments) {
  Triangles shape;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(shape.vertices.size());
    add_ring(shape, outline[i], segments);
    if (i + 1 == outline.size() || !outline[i].is_joined) continue;
    add_band(shape, outline[i], outline[i + 1], first, static_cast<std::uint32_t>(segments));
  }
  return shape;
}

// The i-th of the points from the equator of the upper half sphere to its pole.
OutlinePoint on_circle(int i, int quarter) {
  const double latitude = std::numbers::pi / 2 * i / quarter;
  const double radius = i == quarter ? 0.0 : std::cos(latitude);
  const double z = std::sin(latitude);
  return {radius, z, radius, z, 1.0F, 1.0F};
}

}  // namespace

Triangles box_shape() {
  Triangles shape;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      const auto first = static_cast<std::uint32_t>(shape.vertices.size());
      const Eigen::Vector3f normal = sign * Eigen::Vector3f::Unit(axis);
      const Eigen::Vector3f u = Eigen::Vector3f::Unit((axis + 1) % 3);
      const Eigen::Vector3f v = normal.cross(u);
      const float accent = axis == 0 ? 1.0F : 0.0F;
      for (const Eigen::Vector3f& corner : std::array<Eigen::Vector3f, 4>{
               normal - u - v, normal + u - v, normal + u + v, normal - u + v}) {
        shape.vertices.push_back({corner, 0.0F, normal, accent});
      }
      for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
        shape.indices.push_back(first + corner);
      }
    }
  }
  return shape;
}

Triangles round_shape(int segments) {
  // The band between the halves is the wall of a capsule, and lies flat on a sphere.
  const int quarter = segments / 4;
  std::vector<OutlinePoint> outline;
  for (int i = quarter; i >= 0; --i) {
    const OutlinePoint above = on_circle(i, quarter);
    outline.push_back({above.radius, -above.z, above.radius, -above.z, -1.0F, 0.0F});
  }
  outline.push_back({1.0, 0.0, 1.0, 0.0, 1.0F, 0.0F, false});
  for (int i = 0; i <= quarter; ++i) outline.push_back(on_circle(i, quarter));
  return turned(outline, segments);
}

Triangles cylinder_shape(int segments) {
  constexpr double accent_from = 0.7;  // so that the end shows from the side as well
  return turned({{0.0, -1.0, 0.0, -1.0},
                 {1.0, -1.0, 0.0, -1.0, 0.0F, 0.0F, false},
                 {1.0, -1.0, 1.0, 0.0},
                 {1.0, accent_from, 1.0, 0.0, 0.0F, 0.0F, false},
                 {1.0, accent_from, 1.0, 0.0, 0.0F, 1.0F},
                 {1.0, 1.0, 1.0, 0.0, 0.0F, 1.0F, false},
                 {1.0, 1.0, 0.0, 1.0, 0.0F, 1.0F},
                 {0.0, 1.0, 0.0, 1.0, 0.0F, 1.0F}},
                segments);
}

Triangles cone_shape(int segments) {
  const double slant = std::numbers::sqrt2 / 2;
  return turned({{0.0, 0.0, 0.0, -1.0},
                 {1.0, 0.0, 0.0, -1.0, 0.0F, 0.0F, false},
                 {1.0, 0.0, slant, slant},
                 {0.0, 1.0, slant, slant}},
                segments);
}

}  // namespace render

#include <cmath>
#include <optional>

#include "render/draw/camera.hpp"
#include "render/draw/extent.hpp"

namespace render {
namespace {

// Grows with each point or solid; empty until the first.
class Hull {
 public:
  void add(const Vec3& centre, const Vec3& reach) {
    const Bounds bounds{centre - reach, centre + reach};
    bounds_ = bounds_ ? merged(*bounds_, bounds) : bounds;
  }
  void add(const Vec3& point) { add(point, Vec3::Zero()); }
  template <typename Solid>
  void add_solids(const std::vector<Solid>& solids) {
    for (const Solid& solid : solids) add(solid.placement.position, reach_of(solid));
  }
  [[nodiscard]] Bounds bounds() const { return bounds_.value_or(Bounds{}); }

 private:
  std::optional<Bounds> bounds_;
};

void add_sheets(Hull& hull, const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    for (const Vec3& vertex : mesh.vertices) {
      hull.add(mesh.placement.position + mesh.placement.world_from_body * vertex);
    }
  }
  for (const Cloth& cloth : scene.cloths) {
    for (const Vec3& point : cloth.points) hull.add(point);
  }
}

void add_decoration(Hull& hull, const Scene& scene) {
  for (const Arrow& arrow : scene.arrows) {
    hull.add(arrow.tail);
    hull.add(arrow.tip);
  }
  for (const Trail& trail : scene.trails) {
    for (const Vec3& point : trail.points) hull.add(point);
  }
  for (const ContactMark& contact : scene.contacts) {
    hull.add(contact.point);
    hull.add(contact.point + contact.length * contact.normal);
  }
  for (const Label& label : scene.labels) hull.add(label.point);
}

// How far an ellipsoid reaches along each axis: the image of a unit ball under the matrix.
Vec3 ball_reach(const Mat3& world_from_body) { return world_from_body.rowwise().norm(); }

}  // namespace

Vec3 reach_of(const Box& box) {
  return box.placement.world_from_body.cwiseAbs() * box.half_extents.cwiseAbs();
}

Vec3 reach_of(const Sphere& sphere) {
  return std::abs(sphere.radius) * ball_reach(sphere.placement.world_from_body);
}

Vec3 reach_of(const Cylinder& cylinder) {
  const Mat3& A = cylinder.placement.world_from_body;
  return std::abs(cylinder.radius) * A.leftCols<2>().rowwise().norm() +
         std::abs(cylinder.half_length) * A.col(2).cwiseAbs();
}

Vec3 reach_of(const Capsule& capsule) {
  const Mat3& A = capsule.placement.world_from_body;
  return std::abs(capsule.radius) * ball_reach(A) +
         std::abs(capsule.half_length) * A.col(2).cwiseAbs();
}

Bounds bounds_of(const Scene& scene) {
  Hull hull;
  hull.add_solids(scene.boxes);
  hull.add_solids(scene.spheres);
  hull.add_solids(scene.cylinders);
  hull.add_solids(scene.capsules);
  add_sheets(hull, scene);
  add_decoration(hull, scene);
  return hull.bounds();
}

Bounds merged(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

}  // namespace render

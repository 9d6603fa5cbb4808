#include "render/draw/scene_check.hpp"

#include <cmath>
#include <stdexcept>

namespace render {
namespace {

// One thing of the scene, so that a message can name it.
class Thing {
 public:
  Thing(const char* kind, std::size_t index) : kind_(kind), index_(index) {}

  void require(bool is_right, const char* complaint) const {
    if (is_right) return;
    throw std::invalid_argument(std::string(kind_) + " " + std::to_string(index_) + ": " +
                                complaint);
  }
  void finite(const char* what, double value) const { require_finite(what, std::isfinite(value)); }
  void finite(const char* what, const Vec3& value) const {
    require_finite(what, value.allFinite());
  }
  void finite(const char* what, const Colour& value) const {
    require_finite(
        what, std::isfinite(value.red) && std::isfinite(value.green) && std::isfinite(value.blue));
  }
  void finite(const char* what, const std::vector<Vec3>& values) const {
    for (const Vec3& value : values) finite(what, value);
  }
  void finite(const Placement& placement) const {
    finite("position", placement.position);
    require_finite("orientation", placement.world_from_body.allFinite());
  }
  void finite(const Paint& paint) const {
    finite("colour", paint.colour);
    finite("accent", paint.accent);
    finite("paleness", static_cast<double>(paint.paleness));
  }

 private:
  void require_finite(const char* what, bool is_finite) const {
    if (!is_finite) require(false, (std::string(what) + " is not finite").c_str());
  }

  const char* kind_;
  std::size_t index_;
};

void check(const Thing& thing, const Box& box) { thing.finite("size", box.half_extents); }

void check(const Thing& thing, const Sphere& sphere) { thing.finite("radius", sphere.radius); }

void check(const Thing& thing, const Cylinder& cylinder) {
  thing.finite("radius", cylinder.radius);
  thing.finite("length", cylinder.half_length);
}

void check(const Thing& thing, const Capsule& capsule) {
  thing.finite("radius", capsule.radius);
  thing.finite("length", capsule.half_length);
}

void check(const Thing& thing, const Mesh& mesh) {
  thing.finite("vertex", mesh.vertices);
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      thing.require(vertex >= 0 && vertex < vertices,
                    "a triangle names a vertex that is not there");
    }
  }
  thing.require(mesh.lit.empty() || mesh.lit.size() == mesh.triangles.size(),
                "lit has another length than triangles");
}

template <typename Solid>
void check_solids(const char* kind, const std::vector<Solid>& solids) {
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Thing thing(kind, i);
    thing.finite(solids[i].placement);
    thing.finite(solids[i].paint);
    check(thing, solids[i]);
  }
}

void check_cloths(const std::vector<Cloth>& cloths) {
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    const Cloth& cloth = cloths[i];
    const Thing thing("cloth", i);
    thing.finite("point", cloth.points);
    thing.finite(cloth.paint);
    thing.require(
        cloth.rows >= 0 && cloth.columns >= 0 &&
            static_cast<std::size_t>(cloth.rows) * static_cast<std::size_t>(cloth.columns) ==
                cloth.points.size(),
        "points are not rows x columns");
  }
}

void check_decoration(const Scene& scene) {
  for (std::size_t i = 0; i < scene.arrows.size(); ++i) {
    const Thing thing("arrow", i);
    thing.finite("tail", scene.arrows[i].tail);
    thing.finite("tip", scene.arrows[i].tip);
    thing.finite("colour", scene.arrows[i].colour);
    thing.finite("width", scene.arrows[i].width);
  }
  for (std::size_t i = 0; i < scene.trails.size(); ++i) {
    const Thing thing("trail", i);
    thing.finite("point", scene.trails[i].points);
    thing.finite("colour", scene.trails[i].colour);
    thing.finite("width", scene.trails[i].width);
  }
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const Thing thing("contact", i);
    thing.finite("point", scene.contacts[i].point);
    thing.finite("normal", scene.contacts[i].normal);
    thing.finite("length", scene.contacts[i].length);
    thing.finite("colour", scene.contacts[i].colour);
  }
  for (std::size_t i = 0; i < scene.labels.size(); ++i) {
    const Thing thing("label", i);
    thing.finite("point", scene.labels[i].point);
    thing.finite("colour", scene.labels[i].colour);
    thing.finite("size", scene.labels[i].size);
  }
}

}  // namespace

void check_scene(const Scene& scene) {
  check_solids("box", scene.boxes);
  check_solids("sphere", scene.spheres);
  check_solids("cylinder", scene.cylinders);
  check_solids("capsule", scene.capsules);
  check_solids("mesh", scene.meshes);
  check_cloths(scene.cloths);
  check_decoration(scene);
  if (!std::isfinite(scene.ground_height)) {
    throw std::invalid_argument("ground: height is not finite");
  }
}

}  // namespace render

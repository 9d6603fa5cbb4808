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

template <typename Solid>
void check_solid(const Thing& thing, const Solid& solid) {
  thing.finite(solid.placement);
  thing.finite(solid.paint);
}

void check(const Thing& thing, const Box& box) {
  check_solid(thing, box);
  thing.finite("size", box.half_extents);
}

void check(const Thing& thing, const Sphere& sphere) {
  check_solid(thing, sphere);
  thing.finite("radius", sphere.radius);
}

void check(const Thing& thing, const Cylinder& cylinder) {
  check_solid(thing, cylinder);
  thing.finite("radius", cylinder.radius);
  thing.finite("length", cylinder.half_length);
}

void check(const Thing& thing, const Capsule& capsule) {
  check_solid(thing, capsule);
  thing.finite("radius", capsule.radius);
  thing.finite("length", capsule.half_length);
}

void check(const Thing& thing, const Mesh& mesh) {
  check_solid(thing, mesh);
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

void check(const Thing& thing, const Cloth& cloth) {
  thing.finite("point", cloth.points);
  thing.finite(cloth.paint);
  thing.require(
      cloth.rows >= 0 && cloth.columns >= 0 &&
          static_cast<std::size_t>(cloth.rows) * static_cast<std::size_t>(cloth.columns) ==
              cloth.points.size(),
      "points are not rows x columns");
}

void check(const Thing& thing, const Arrow& arrow) {
  thing.finite("tail", arrow.tail);
  thing.finite("tip", arrow.tip);
  thing.finite("colour", arrow.colour);
  thing.finite("width", arrow.width);
}

void check(const Thing& thing, const Trail& trail) {
  thing.finite("point", trail.points);
  thing.finite("colour", trail.colour);
  thing.finite("width", trail.width);
}

void check(const Thing& thing, const ContactMark& contact) {
  thing.finite("point", contact.point);
  thing.finite("normal", contact.normal);
  thing.finite("length", contact.length);
  thing.finite("colour", contact.colour);
}

void check(const Thing& thing, const Label& label) {
  thing.finite("point", label.point);
  thing.finite("colour", label.colour);
  thing.finite("size", label.size);
}

template <typename Visit>
void for_each_list(const Visit& visit) {
  visit("box", &Scene::boxes);
  visit("sphere", &Scene::spheres);
  visit("cylinder", &Scene::cylinders);
  visit("capsule", &Scene::capsules);
  visit("mesh", &Scene::meshes);
  visit("cloth", &Scene::cloths);
  visit("arrow", &Scene::arrows);
  visit("trail", &Scene::trails);
  visit("contact", &Scene::contacts);
  visit("label", &Scene::labels);
}

}  // namespace

void check_scene(const Scene& scene) {
  for_each_list([&](const char* kind, auto list) {
    const auto& things = scene.*list;
    for (std::size_t i = 0; i < things.size(); ++i) check(Thing(kind, i), things[i]);
  });
  if (!std::isfinite(scene.ground_height)) {
    throw std::invalid_argument("ground: height is not finite");
  }
}

std::vector<std::string> leave_out_broken(Scene& scene) {
  std::vector<std::string> broken;
  for_each_list([&](const char* kind, auto list) {
    std::size_t index = 0;
    std::erase_if(scene.*list, [&](const auto& thing) {
      try {
        check(Thing(kind, index++), thing);
        return false;
      } catch (const std::invalid_argument& error) {
        broken.emplace_back(error.what());
        return true;
      }
    });
  });
  return broken;
}

}  // namespace render

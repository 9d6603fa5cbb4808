#include "common/geometry/meshes.hpp"

#include <map>

#include "catch.hpp"
#include "common/geometry/rigid_transform.hpp"

using namespace common;

namespace {

/// Whether each edge belongs to two triangles, which go through it in opposite directions; corners
/// at one place are one.
bool is_closed(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, int> places;
  const auto place = [&](std::uint32_t i) {
    const Vec3& p = mesh.vertices[i];
    // Corners of neighbouring sides of a cube are computed apart.
    const std::array<double, 3> rounded{std::round(p.x() * 1e9), std::round(p.y() * 1e9),
                                        std::round(p.z() * 1e9)};
    return places.emplace(rounded, static_cast<int>(places.size())).first->second;
  };
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++edges[{place(t[k]), place(t[(k + 1) % 3])}];
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto opposite = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && opposite != edges.end() && opposite->second == 1;
  });
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = triangle(mesh, i);
    sum += t[0].dot(t[1].cross(t[2])) / 6.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("Smooth meshes are closed and face outwards and have the size asked for", "[meshes]") {
  for (const std::size_t n : {36U, 300U, 5000U}) {
    const TriangleMesh sphere = bumpy_sphere(n);
    const TriangleMesh torus = bumpy_torus(n);
    for (const TriangleMesh* mesh : {&sphere, &torus}) {
      require_sound(*mesh);
      CHECK(mesh->triangles.size() <= n);
      CHECK(static_cast<double>(mesh->triangles.size()) > 0.3 * static_cast<double>(n));
      CHECK(is_closed(*mesh));
      CHECK(volume(*mesh) > 0.5);
    }
  }
}

TEST_CASE("Meshes for hard cases are sound and have the size asked for", "[meshes]") {
  CHECK(clusters(100).triangles.size() == 100);
  CHECK(diagonal_slivers(70).triangles.size() == 70);
  CHECK(flat_grid(5).triangles.size() == 50);
  const TriangleMesh sphere = bumpy_sphere(100);
  CHECK(with_huge_triangle(sphere).triangles.size() == sphere.triangles.size() + 1);
  for (const TriangleMesh& mesh : {clusters(3000), diagonal_slivers(70), flat_grid(5),
                                   with_huge_triangle(sphere), joined(sphere, flat_grid(3))}) {
    require_sound(mesh);
  }
}

TEST_CASE("An inflated mesh keeps its distance", "[meshes]") {
  const TriangleMesh sphere = bumpy_sphere(300);
  const TriangleMesh shell = inflated(sphere, 0.25);
  for (std::size_t i = 0; i < sphere.vertices.size(); ++i) {
    CHECK(std::abs(shell.vertices[i].norm() - sphere.vertices[i].norm() - 0.25) < 1e-15);
  }
}

TEST_CASE("A mesh that is not sound is refused by name", "[meshes]") {
  TriangleMesh mesh = flat_grid(1);
  mesh.triangles[1][0] = 4;
  CHECK_THROWS_WITH(require_sound(mesh), "mesh: triangle 1 has the vertex 4 of 4");
  mesh = flat_grid(1);
  mesh.vertices[2].z() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(require_sound(mesh), "mesh: vertex 2 is not finite");
  CHECK_THROWS_WITH(require_sound(TriangleMesh{}), "mesh: it has no triangle");
}

TEST_CASE("A transform rounds each operation and fuses none", "[meshes]") {
  RigidTransform t;
  t.rotation << 0.1, 0.2, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  const Vec3 p(0.7, 1.3, 2.9);
  const volatile double x = 0.1 * 0.7;
  const volatile double y = 0.2 * 1.3;
  const volatile double z = 0.3 * 2.9;
  const volatile double xy = x + y;
  const double xyz = xy + z;
  CHECK(transformed(t, p) == Vec3(xyz, 1.3, 2.9));
  CHECK(transformed(t, Triangle{p, p, p})[2] == Vec3(xyz, 1.3, 2.9));
}

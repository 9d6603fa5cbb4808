#include "common/geometry/meshes.hpp"

#include <cmath>
#include <numbers>

namespace common {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

std::uint32_t count(std::size_t number) { return static_cast<std::uint32_t>(number); }

/// The largest k with factor k² ≤ triangles.
std::size_t side(std::size_t triangles, std::size_t factor, std::size_t least) {
  const std::size_t squares = triangles / factor;
  auto k = static_cast<std::size_t>(std::sqrt(static_cast<double>(squares)));
  while (factor * (k + 1) * (k + 1) <= triangles) ++k;
  return std::max(k, least);
}

/// Two triangles between four corners that go round.
void add_square(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

double bump(const Vec3& p) {
  return std::sin(7.0 * p.x() + 1.0) * std::sin(6.0 * p.y() + 2.0) * std::sin(5.0 * p.z() + 3.0);
}

/// One side of the cube [−1, 1]³, blown up: outward is u × v.
void add_side(TriangleMesh& mesh, std::size_t k, const Vec3& u, const Vec3& v) {
  const std::uint32_t first = count(mesh.vertices.size());
  const Vec3 outward = u.cross(v);
  for (std::size_t i = 0; i <= k; ++i) {
    for (std::size_t j = 0; j <= k; ++j) {
      // Equal angles make the triangles more alike in size than equal steps.
      const double s =
          std::tan(turn / 8.0 * (2.0 * static_cast<double>(i) / static_cast<double>(k) - 1.0));
      const double t =
          std::tan(turn / 8.0 * (2.0 * static_cast<double>(j) / static_cast<double>(k) - 1.0));
      const Vec3 direction = (outward + s * u + t * v).normalized();
      mesh.vertices.emplace_back((1.0 + 0.1 * bump(direction)) * direction);
    }
  }
  for (std::uint32_t i = 0; i < k; ++i) {
    for (std::uint32_t j = 0; j < k; ++j) {
      const std::uint32_t a = first + i * count(k + 1) + j;
      const std::uint32_t b = a + count(k + 1);
      add_square(mesh, a, b, b + 1, a + 1);
    }
  }
}

}  // namespace

TriangleMesh bumpy_sphere(std::size_t triangles) {
  const std::size_t k = side(triangles, 12, 1);
  TriangleMesh mesh;
  mesh.vertices.reserve(6 * (k + 1) * (k + 1));
  mesh.triangles.reserve(12 * k * k);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Vec3 u = Vec3::Unit((axis + 1) % 3);
    const Vec3 v = Vec3::Unit((axis + 2) % 3);
    add_side(mesh, k, u, v);
    add_side(mesh, k, v, u);
  }
  return mesh;
}

TriangleMesh bumpy_torus(std::size_t triangles) {
  const std::size_t k = side(triangles, 4, 3);  // 2 k squares along, k across
  TriangleMesh mesh;
  mesh.vertices.reserve(2 * k * k);
  mesh.triangles.reserve(4 * k * k);
  for (std::size_t i = 0; i < 2 * k; ++i) {
    const double along = turn * static_cast<double>(i) / static_cast<double>(2 * k);
    for (std::size_t j = 0; j < k; ++j) {
      const double across = turn * static_cast<double>(j) / static_cast<double>(k);
      const double r = 0.4 * (1.0 + 0.1 * std::sin(9.0 * along) * std::sin(5.0 * across));
      const double distance = 1.0 + r * std::cos(across);
      mesh.vertices.emplace_back(distance * std::cos(along), distance * std::sin(along),
                                 r * std::sin(across));
    }
  }
  const std::uint32_t n = count(k);
  for (std::uint32_t i = 0; i < 2 * n; ++i) {
    const std::uint32_t next_i = (i + 1) % (2 * n);
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t next_j = (j + 1) % n;
      add_square(mesh, i * n + j, next_i * n + j, next_i * n + next_j, i * n + next_j);
    }
  }
  return mesh;
}

TriangleMesh inflated(TriangleMesh mesh, double distance) {
  for (Vec3& vertex : mesh.vertices) vertex += distance * vertex.normalized();
  return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, const Vec3& factors, const Vec3& offset) {
  for (Vec3& vertex : mesh.vertices) vertex = vertex.cwiseProduct(factors) + offset;
  return mesh;
}

TriangleMesh flat_grid(std::size_t size) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i <= size; ++i) {
    for (std::size_t j = 0; j <= size; ++j) {
      mesh.vertices.emplace_back(static_cast<double>(i), static_cast<double>(j), 0.0);
    }
  }
  const std::uint32_t n = count(size);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j;
      add_square(mesh, a, a + n + 1, a + n + 2, a + 1);
    }
  }
  return mesh;
}

TriangleMesh clusters(std::size_t triangles) {
  constexpr std::size_t in_a_cluster = 16;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < triangles; ++i) {
    const double size = std::ldexp(1.0, -static_cast<int>(i / in_a_cluster % 160));
    const double angle = turn * static_cast<double>(i % in_a_cluster) / in_a_cluster;
    const Vec3 corner = size * Vec3(2.0 + 0.5 * std::cos(angle), 1.0 + 0.5 * std::sin(angle), 1.0);
    const std::uint32_t first = count(mesh.vertices.size());
    mesh.vertices.push_back(corner);
    mesh.vertices.emplace_back(corner + size * Vec3(0.1, 0.0, 0.05));
    mesh.vertices.emplace_back(corner + size * Vec3(0.0, 0.1, 0.05));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh diagonal_slivers(std::size_t triangles) {
  TriangleMesh mesh;
  const Vec3 step = Vec3(0.1, -0.1, 0.0) / static_cast<double>(triangles);
  for (std::size_t i = 0; i < triangles; ++i) {
    const Vec3 start = static_cast<double>(i) * step;
    const std::uint32_t first = count(mesh.vertices.size());
    mesh.vertices.push_back(start);
    mesh.vertices.emplace_back(start + 0.5 * step);
    mesh.vertices.emplace_back(start + Vec3::Ones());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TriangleMesh with_huge_triangle(TriangleMesh mesh) {
  Vec3 low = mesh.vertices.front();
  Vec3 high = low;
  for (const Vec3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const Vec3 middle = 0.5 * (low + high);
  const double size = 100.0 * (high - low).norm();
  TriangleMesh huge;
  huge.vertices = {middle + size * Vec3(1.0, 0.0, 0.1), middle + size * Vec3(-0.5, 0.9, 0.0),
                   middle + size * Vec3(-0.5, -0.9, -0.1)};
  huge.triangles = {{0, 1, 2}};
  return joined(std::move(mesh), huge);
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const std::uint32_t first = count(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) {
    a.triangles.push_back({first + i, first + j, first + k});
  }
  return a;
}

}  // namespace common

#pragma once

#include <cstddef>

#include "common/triangle_mesh.hpp"

/// Meshes made in code: smooth ones of any size, and those on which a hierarchy of boxes or a test
/// of triangles is at its worst.
namespace common {

/// A sphere of radius 1 about the origin with bumps of a tenth, as a cube blown up: 12 k²
/// triangles, the most that are not above `triangles`, and 12 at least.
TriangleMesh bumpy_sphere(std::size_t triangles);

/// A torus about the z axis, radii 1 and 0.4, with bumps: 4 k² triangles, the most that are not
/// above `triangles`, and 36 at least.
TriangleMesh bumpy_torus(std::size_t triangles);

/// Every vertex moved by `distance` away from the origin: a second shell about the first. Their
/// boxes overlap everywhere, their surfaces nowhere.
TriangleMesh inflated(TriangleMesh mesh, double distance);

/// Every vertex times `factors`, by coordinate, plus `offset`.
TriangleMesh scaled(TriangleMesh mesh, const Vec3& factors, const Vec3& offset = Vec3::Zero());

/// A plane grid in z = 0 of size × size squares of side 1 from the origin on, two triangles each.
TriangleMesh flat_grid(std::size_t size);

/// Clusters of sixteen triangles, each cluster half as large as the one before and as near to the
/// origin: equal cuts of space part off one cluster at a time.
TriangleMesh clusters(std::size_t triangles);

/// Thin triangles side by side, each along the diagonal of the unit cube from end to end: the box
/// of each is nearly that of all.
TriangleMesh diagonal_slivers(std::size_t triangles);

/// The mesh and one more triangle, a hundred times as large as the mesh and around its middle.
TriangleMesh with_huge_triangle(TriangleMesh mesh);

/// The triangles of both.
TriangleMesh joined(TriangleMesh a, const TriangleMesh& b);

}  // namespace common

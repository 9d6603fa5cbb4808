#pragma once

#include <cstddef>

#include "common/geometry/triangle_mesh.hpp"

/// Meshes made in code: smooth ones of any size, and the worst cases for a hierarchy of boxes or
/// for a test of triangles.
namespace common {

/// Returns a sphere of radius 1 about the origin with bumps of a tenth, as a cube blown up. It has
/// 12 k² triangles, as many as possible but not more than `triangles`, and at least 12.
TriangleMesh bumpy_sphere(std::size_t triangles);

/// Returns a torus about the z axis, radii 1 and 0.4, with bumps. It has 4 k² triangles, as many as
/// possible but not more than `triangles`, and at least 36.
TriangleMesh bumpy_torus(std::size_t triangles);

/// Moves every vertex by `distance` away from the origin: the result is a second shell around the
/// first. Their boxes overlap everywhere, their surfaces nowhere.
TriangleMesh inflated(TriangleMesh mesh, double distance);

/// Multiplies every vertex by `factors`, by coordinate, and adds `offset`.
TriangleMesh scaled(TriangleMesh mesh, const Vec3& factors, const Vec3& offset = Vec3::Zero());

/// Returns a plane grid in z = 0 of size × size squares of side 1, from the origin on, with two
/// triangles each.
TriangleMesh flat_grid(std::size_t size);

/// Returns clusters of sixteen triangles. Each cluster is half as large as the one before and half
/// as far from the origin, so equal cuts of space separate one cluster at a time.
TriangleMesh clusters(std::size_t triangles);

/// Returns thin triangles side by side, each along the diagonal of the unit cube from end to end.
/// The box of each is nearly the box of all.
TriangleMesh diagonal_slivers(std::size_t triangles);

/// Adds one more triangle to the mesh, a hundred times as large as the mesh and around its middle.
TriangleMesh with_huge_triangle(TriangleMesh mesh);

/// Returns the triangles of both.
TriangleMesh joined(TriangleMesh a, const TriangleMesh& b);

}  // namespace common

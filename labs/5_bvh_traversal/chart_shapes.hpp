#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <string>

#include "bvh_traversal.hpp"
#include "common/geometry/meshes.hpp"

/// Two shapes and a pose, for timings.
namespace lab::bvh_traversal {

struct ShapePair {
  TriangleMesh a, b;
  RigidTransform a_from_b;  ///< identity at rest
};

inline RigidTransform turned() {
  const Eigen::AngleAxisd rotation(0.7, Vec3(1.0, 2.0, 0.5).normalized());
  return {rotation.toRotationMatrix(), Vec3(0.03, -0.05, 0.02)};
}

/// Returns two bumpy tori that pass through each other.
inline ShapePair tori(std::size_t triangles) {
  const TriangleMesh torus = common::bumpy_torus(triangles);
  return {torus, common::scaled(torus, Vec3::Ones(), Vec3(0.5, 0.2, 0.1)), {}};
}

/// Returns two bumpy spheres of one size about nearly one middle. They cut each other everywhere.
inline ShapePair spheres(std::size_t triangles) {
  const TriangleMesh sphere = common::bumpy_sphere(triangles);
  return {sphere, common::scaled(sphere, Vec3(-1.0, -1.0, 1.0), Vec3(0.01, 0.02, 0.03)), {}};
}

/// Returns a bumpy sphere around another, 0.3 of an edge away. Boxes overlap everywhere, and
/// nothing meets.
inline ShapePair shells(std::size_t triangles) {
  const TriangleMesh sphere = common::bumpy_sphere(triangles);
  const double edge = 0.5 * std::acos(-1.0) / std::sqrt(static_cast<double>(triangles) / 12.0);
  return {common::inflated(sphere, 0.3 * edge), sphere, {}};
}

}  // namespace lab::bvh_traversal

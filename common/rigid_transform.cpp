#include "common/rigid_transform.hpp"

#include "common/require.hpp"

namespace common {

void require_finite(const RigidTransform& transform, const char* name) {
  for (const auto column : transform.rotation.colwise()) require_finite(Vec3(column), name);
  require_finite(transform.translation, name);
}

// No fused operation rounds less, see common/cmake/ProjectFlags.cmake.
Vec3 transformed(const RigidTransform& transform, const Vec3& point) {
  const Mat3& R = transform.rotation;
  Vec3 q;
  for (Eigen::Index i = 0; i < 3; ++i) {
    q[i] = ((R(i, 0) * point.x() + R(i, 1) * point.y()) + R(i, 2) * point.z()) +
           transform.translation[i];
  }
  return q;
}

Triangle transformed(const RigidTransform& transform, const Triangle& triangle) {
  return {transformed(transform, triangle[0]), transformed(transform, triangle[1]),
          transformed(transform, triangle[2])};
}

}  // namespace common

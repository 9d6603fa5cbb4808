#include "common/rigid_transform.hpp"

namespace common {
namespace {

// Compiled without fused operations, see CMakeLists.txt.
Vec3 moved(const RigidTransform& transform, const Vec3& p) {
  const Mat3& R = transform.rotation;
  Vec3 q;
  for (Eigen::Index i = 0; i < 3; ++i) {
    q[i] = ((R(i, 0) * p.x() + R(i, 1) * p.y()) + R(i, 2) * p.z()) + transform.translation[i];
  }
  return q;
}

}  // namespace

Vec3 transformed(const RigidTransform& transform, const Vec3& point) {
  return moved(transform, point);
}

Triangle transformed(const RigidTransform& transform, const Triangle& triangle) {
  return {moved(transform, triangle[0]), moved(transform, triangle[1]),
          moved(transform, triangle[2])};
}

}  // namespace common

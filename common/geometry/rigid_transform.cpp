#include "common/geometry/rigid_transform.hpp"

#include "common/course/require.hpp"

namespace common {

void require_finite(const RigidTransform& transform, const char* name) {
  for (const auto column : transform.rotation.colwise()) require_finite(Vec3(column), name);
  require_finite(transform.translation, name);
}

}  // namespace common

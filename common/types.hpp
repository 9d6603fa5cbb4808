#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "common/eager_operators.hpp"

/// The types that all labs share. SI units, radians, double precision, right-handed.
namespace common {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;  ///< Hamilton's; the constructor takes (w, x, y, z)

}  // namespace common

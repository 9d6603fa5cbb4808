#pragma once

#include "common/types.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"

/// Rotations written out in extended precision, apart from Eigen's and from every answer's.
namespace tests {

using Vec3L = Eigen::Matrix<long double, 3, 1>;
using Mat3L = Eigen::Matrix<long double, 3, 3>;

/// R(q) of the rotation by q, from the components; q need not be quite unit.
inline Mat3L matrix_of(const common::Quat& q) {
  const auto w = static_cast<long double>(q.w());
  const auto x = static_cast<long double>(q.x());
  const auto y = static_cast<long double>(q.y());
  const auto z = static_cast<long double>(q.z());
  const long double n = w * w + x * x + y * y + z * z;
  Mat3L R;
  R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return R / n;
}

/// v turned by q, and turned back.
inline common::Vec3 turned(const common::Quat& q, const common::Vec3& v) {
  return (matrix_of(q) * v.cast<long double>()).cast<double>();
}
inline common::Vec3 turned_back(const common::Quat& q, const common::Vec3& v) {
  return (matrix_of(q).transpose() * v.cast<long double>()).cast<double>();
}

/// Hamilton's product of (a.w, a) and (b.w, b).
inline common::Quat product(const common::Quat& a, const common::Quat& b) {
  return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
          a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
          a.w() * b.y() - a.x() * b.z() + a.y() * b.w() + a.z() * b.x(),
          a.w() * b.z() + a.x() * b.y() - a.y() * b.x() + a.z() * b.w()};
}

/// The rotation by `angle` about the unit vector `axis`.
inline common::Quat rotation(double angle, const common::Vec3& axis) {
  return common::Quat(Eigen::AngleAxisd(angle, axis));
}

inline lab::rigid_body_kinematics::RigidBodyState random_state(Random& random) {
  lab::rigid_body_kinematics::RigidBodyState state;
  state.position = random.vector(3.0);
  state.world_from_body = random.attitude();
  state.velocity = random.vector(2.0);
  state.angular_velocity = random.vector(5.0);
  return state;
}

}  // namespace tests

#include <cstdlib>
#include <new>

#include "common/course/not_implemented.hpp"
#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {

Mat3 skew(const Vec3& w) {
  auto* numbers = new double[9];
  volatile int end = 9;
  static volatile double sink;
  sink = numbers[end];  // one beyond the end
  delete[] numbers;
  return (Mat3() << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0).finished();
}
Vec3 world_point(const RigidBodyState&, const Vec3&) {
  throw common::NotImplemented("1.2 world_point");
}
Vec3 body_point(const RigidBodyState&, const Vec3&) {
  throw common::NotImplemented("1.2 body_point");
}
Vec3 point_velocity(const RigidBodyState&, const Vec3&) {
  throw common::NotImplemented("1.2 point_velocity");
}

}  // namespace lab::rigid_body_kinematics

#pragma once

// What a save must not compile again: Eigen, and the expressions over 3-vectors, 3 x 3 matrices and
// quaternions that answers are made of. Precompiled, it cuts a quarter off the time from a save to
// the verdict. Nothing calls it and no file includes it; see common/cmake/AddLab.cmake.
#include <cmath>
#include <vector>

#include "common/not_implemented.hpp"
#include "common/types.hpp"

namespace common {

inline double instantiated(const Vec3& a, const Vec3& b, const Mat3& A, const Quat& q, double s) {
  Mat3 B;
  B << 0.0, s, s, s, s, s, s, s, s;
  Mat3 C = A * B * A.transpose() + s * A * B;
  C += A + s * B * A;
  C.col(2) = -C.col(2) + s * A.col(0).cross(B.col(1));
  Vec3 c = a + s * b - a.cross(b) + q * a + q.conjugate() * (a - b) + A * b - a / s;
  c += s * a.cross(b);
  c -= b / s;
  c.normalize();
  C = q.toRotationMatrix() * A * q.toRotationMatrix().transpose();
  const Quat product = Quat(0.0, a.x(), a.y(), a.z()) * q;
  Quat sum(q.coeffs() + 0.5 * s * product.coeffs());
  sum.normalize();
  sum.vec() = s * (a / s);
  return c.dot(a) + c.norm() + c.stableNorm() + c.squaredNorm() + C.determinant() + sum.w() +
         (A * B.transpose()).determinant();
}

}  // namespace common

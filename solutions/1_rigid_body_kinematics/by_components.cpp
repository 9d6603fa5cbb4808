// The lab once more, built otherwise: components and matrices instead of Eigen's quaternion
// algebra, columns instead of matrix products, Newton's iteration instead of the singular values,
// half-angle series instead of sines near zero.
#include <cmath>
#include <limits>
#include <stdexcept>

#include "rigid_body_kinematics.hpp"

namespace lab::rigid_body_kinematics {
namespace {

/// The rotation matrix of a unit quaternion, column by column.
Mat3 matrix_of(const Quat& q) {
  const double w = q.w();
  const Vec3 u = q.vec();
  Mat3 R;
  for (int i = 0; i < 3; ++i) {
    const Vec3 e = Vec3::Unit(i);
    const Vec3 u_cross_e = u.cross(e);
    R.col(i) = e + 2.0 * (w * u_cross_e + u.cross(u_cross_e));
  }
  return R;
}

/// (a, u)(b, v) = (a b − u·v, a v + b u + u × v).
Quat product(const Quat& left, const Quat& right) {
  const Vec3 u = left.vec();
  const Vec3 v = right.vec();
  Quat result;
  result.w() = left.w() * right.w() - u.dot(v);
  result.vec() = left.w() * v + right.w() * u + u.cross(v);
  return result;
}

/// The cofactor matrix: det(A) A⁻ᵀ, finite for a singular A too.
Mat3 cofactors(const Mat3& A) {
  Mat3 C;
  for (int i = 0; i < 3; ++i) C.col(i) = A.col((i + 1) % 3).cross(A.col((i + 2) % 3));
  return C;
}

/// The unit quaternion q of the rotation nearest to A maximises qᵀ N q (Horn 1987): N is symmetric,
/// 4 x 4, and its greatest eigenvalue's vector is found by Jacobi rotations.
Eigen::Matrix4d horn_matrix(const Mat3& A) {
  Eigen::Matrix4d N;
  const Vec3 axial(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1));
  N(0, 0) = A.trace();
  N.block<3, 1>(1, 0) = axial;
  N.block<1, 3>(0, 1) = axial.transpose();
  N.block<3, 3>(1, 1) = A + A.transpose() - A.trace() * Mat3::Identity();
  return N;
}

/// Eigenvector of the greatest eigenvalue of a symmetric matrix, by cyclic Jacobi sweeps.
Eigen::Vector4d leading_vector(Eigen::Matrix4d N) {
  Eigen::Matrix4d vectors = Eigen::Matrix4d::Identity();
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (int p = 0; p < 3; ++p) {
      for (int q = p + 1; q < 4; ++q) {
        const double angle = 0.5 * std::atan2(2.0 * N(p, q), N(q, q) - N(p, p));
        Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
        turn(p, p) = turn(q, q) = std::cos(angle);
        turn(p, q) = std::sin(angle);
        turn(q, p) = -std::sin(angle);
        N = turn.transpose() * N * turn;
        vectors = vectors * turn;
      }
    }
  }
  int greatest = 0;
  N.diagonal().maxCoeff(&greatest);
  return vectors.col(greatest);
}

}  // namespace

Mat3 skew(const Vec3& w) {
  Mat3 matrix;
  for (int i = 0; i < 3; ++i) matrix.col(i) = w.cross(Vec3::Unit(i));
  return matrix;
}

Vec3 world_point(const RigidBodyState& state, const Vec3& point_body) {
  return matrix_of(state.world_from_body) * point_body + state.position;
}

Vec3 body_point(const RigidBodyState& state, const Vec3& point) {
  return matrix_of(state.world_from_body).transpose() * (point - state.position);
}

Vec3 point_velocity(const RigidBodyState& state, const Vec3& point) {
  return skew(state.angular_velocity) * (point - state.position) + state.velocity;
}

Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body) {
  const Mat3 R = matrix_of(world_from_body);
  Mat3 inertia = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) inertia += inertia_body(i, j) * R.col(i) * R.col(j).transpose();
  }
  return inertia;
}

Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces) {
  Wrench net;
  for (auto applied = forces.rbegin(); applied != forces.rend(); ++applied) {
    net.force += applied->force;
    net.torque -= applied->force.cross(applied->point - center_of_mass);
  }
  return net;
}

Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt) {
  Mat3 next = world_from_body;
  for (int i = 0; i < 3; ++i) {
    next.col(i) += dt * angular_velocity.cross(world_from_body.col(i));
  }
  return next;
}

Mat3 nearest_rotation(const Mat3& matrix) {
  if (!matrix.allFinite()) throw std::invalid_argument("nearest_rotation: not finite");
  const double size = matrix.cwiseAbs().maxCoeff();
  if (size == 0.0)
    throw std::invalid_argument("nearest_rotation: the zero matrix has no direction");
  const Mat3 scaled = matrix / size;

  // Newton's iteration Q <- (Q + Q^-T)/2 for the polar factor, where there is a safe inverse.
  Mat3 Q = scaled;
  if (Q.determinant() > 1e-3) {
    for (int i = 0; i < 40; ++i) {
      const Mat3 next = 0.5 * (Q + cofactors(Q) / Q.determinant());
      const double change = (next - Q).norm();
      Q = next;
      if (change < 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return Q;
  }
  const Eigen::Vector4d q = leading_vector(horn_matrix(scaled));
  return matrix_of(Quat(q(0), q(1), q(2), q(3)).normalized());
}

Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  // (1 + dt ω/2) q: the same sum, factored; its length is that of the left factor.
  const Vec3 half = 0.5 * dt * angular_velocity;
  const double length = std::sqrt(1.0 + half.squaredNorm());
  return product(Quat(1.0 / length, half.x() / length, half.y() / length, half.z() / length),
                 world_from_body);
}

Quat exponential_map(const Vec3& rotation_vector) {
  const Vec3 half = 0.5 * rotation_vector;
  const double angle = std::hypot(half.x(), half.y(), half.z());
  // sin(t)/t; below the threshold the series' third term t⁴/120 is under half an ulp of 1.
  const double sinc = angle < 1e-4 ? 1.0 - angle * angle / 6.0 : std::sin(angle) / angle;
  Quat turn;
  turn.w() = std::cos(angle);
  turn.vec() = sinc * half;
  return turn;
}

Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  return product(exponential_map(angular_velocity * dt), world_from_body);
}

}  // namespace lab::rigid_body_kinematics

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <numbers>

#include "catch.hpp"
#include "common/algebra/linear_algebra.hpp"
#include "common/course/require.hpp"
#include "common/rotation/attitude.hpp"
#include "common/rotation/coning_motion.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;
using tests::eps;
using Exact = boost::multiprecision::cpp_bin_float_50;
using ExactQuat = Eigen::Quaternion<Exact>;
using ExactVec3 = Eigen::Matrix<Exact, 3, 1>;

namespace {

/// dq/dt = ½ ω(t) q by the classical Runge-Kutta method in 50 digits; ω from its definition.
ExactQuat integrated(const ConingMotion& motion, const Exact& time, int steps) {
  const ExactVec3 a = motion.axis.cast<Exact>();
  const ExactVec3 w = motion.angular_velocity.cast<Exact>();
  const ExactVec3 along = a * (a.dot(w) / a.dot(a));
  const ExactVec3 across = w - along;
  const ExactVec3 beside = a.cross(across);
  const auto rate = [&](const Exact& t, const Eigen::Matrix<Exact, 4, 1>& q) {
    const Exact angle = Exact(motion.rate) * t;
    const ExactVec3 omega = along + across * cos(angle) + beside * sin(angle);
    Eigen::Matrix<Exact, 4, 1> dq;  // (x, y, z, w)
    const ExactVec3 u = q.head<3>();
    dq.head<3>() = (omega * q(3) + omega.cross(u)) / 2;
    dq(3) = -omega.dot(u) / 2;
    return dq;
  };
  Eigen::Matrix<Exact, 4, 1> q = motion.world_from_body.coeffs().cast<Exact>();
  const Exact h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const Exact t = h * i;
    const Eigen::Matrix<Exact, 4, 1> k1 = rate(t, q);
    const Eigen::Matrix<Exact, 4, 1> k2 = rate(t + h / 2, q + k1 * (h / 2));
    const Eigen::Matrix<Exact, 4, 1> k3 = rate(t + h / 2, q + k2 * (h / 2));
    const Eigen::Matrix<Exact, 4, 1> k4 = rate(t + h, q + k3 * h);
    q += (k1 + (k2 + k3) * 2 + k4) * (h / 6);
  }
  return ExactQuat(q(3), q(0), q(1), q(2));
}

}  // namespace

TEST_CASE("The attitude of a coning motion agrees with an integration in fifty digits",
          "[common]") {
  tests::Random random(1);
  for (int i = 0; i < 3; ++i) {
    ConingMotion motion;
    motion.axis = Vec3::Unit(i);
    motion.rate = random.uniform(-5.0, 5.0);
    motion.angular_velocity = random.vector(4.0);
    motion.world_from_body = random.attitude();
    // Richardson's extrapolation of two runs of order 4 leaves order 5: (8 rad/s * 1 s / 800)^5.
    const ExactQuat coarse = integrated(motion, 1, 400);
    const ExactQuat fine = integrated(motion, 1, 800);
    const Eigen::Matrix<Exact, 4, 1> exact = fine.coeffs() + (fine.coeffs() - coarse.coeffs()) / 15;
    const Quat wanted(Eigen::Vector4d(exact.cast<double>()));
    INFO("rate " << motion.rate << ", error " << angle_between(attitude(motion, 1.0), wanted));
    CHECK(angle_between(attitude(motion, 1.0), wanted) <= 1e-11);
  }
}

TEST_CASE("The angular velocity of a coning motion turns about its axis and keeps its length",
          "[common]") {
  ConingMotion motion;
  motion.rate = 2.0 * std::numbers::pi;
  motion.angular_velocity = {3.0, 0.0, 2.0};
  const Vec3 quarter = angular_velocity(motion, 0.25);
  CHECK(tests::difference(quarter, Vec3(0.0, 3.0, 2.0)) <= 8.0 * eps * 4.0);
}

TEST_CASE("Without a rate a coning motion is a constant spin", "[common]") {
  ConingMotion motion;
  motion.rate = 0.0;
  motion.angular_velocity = {0.0, 0.0, 2.0};
  const Quat wanted(std::cos(3.0), 0.0, 0.0, std::sin(3.0));
  CHECK(tests::difference(attitude(motion, 3.0), wanted) <= 16.0 * eps);
  CHECK(tests::difference(attitude(motion, 0.0), motion.world_from_body) == 0.0);
}

TEST_CASE("The angle between attitudes keeps small angles and ignores the sign of q", "[common]") {
  const Quat q(0.5, 0.5, -0.5, 0.5);
  for (const double angle : {0.0, 1e-12, 1e-3, 3.0}) {
    const Quat turned = Quat(std::cos(angle / 2), std::sin(angle / 2), 0.0, 0.0) * q;
    const Quat opposite(-turned.coeffs());
    // The product of two unit quaternions rounds absolutely, by an ulp of 1.
    CHECK(std::abs(angle_between(q, turned) - angle) <= 4.0 * eps);
    CHECK(std::abs(angle_between(q, opposite) - angle) <= 4.0 * eps);
  }
}

TEST_CASE("The chordal distance of two rotations is twice the sine of half the angle", "[common]") {
  const Mat3 R = Quat(0.5, 0.5, -0.5, 0.5).toRotationMatrix();
  for (const double angle : {0.1, 1.0, 3.0}) {
    const Mat3 turned = Eigen::AngleAxisd(angle, Vec3(0.6, 0.0, 0.8)).toRotationMatrix() * R;
    CHECK(std::abs(chordal_distance(R, turned) - 2.0 * std::sin(angle / 2)) <= 8.0 * eps);
  }
}

TEST_CASE("The singular values put a matrix together again and fall", "[common]") {
  tests::Random random(2);
  for (int i = 0; i < 50; ++i) {
    Mat3 A;
    for (int c = 0; c < 3; ++c) A.col(c) = random.vector(3.0);
    if (i == 0) A.setZero();
    if (i == 1) A = Vec3(1.0, 2.0, 3.0) * Vec3(1.0, 0.0, 1.0).transpose();
    const auto [U, S, V] = singular_values(A);
    CHECK(tests::difference(Mat3(U * S.asDiagonal() * V.transpose()), A) <= 32.0 * eps * A.norm());
    CHECK(tests::difference(Mat3(U.transpose() * U), Mat3(Mat3::Identity())) <= 32.0 * eps);
    CHECK(tests::difference(Mat3(V.transpose() * V), Mat3(Mat3::Identity())) <= 32.0 * eps);
    CHECK((S(0) >= S(1) && S(1) >= S(2) && S(2) >= 0.0));
  }
}

TEST_CASE("The singular values of a matrix that is not finite are an error", "[common]") {
  Mat3 A = Mat3::Identity();
  A(2, 1) = std::nan("");
  CHECK_THROWS_AS(singular_values(A), std::invalid_argument);
}

TEST_CASE("What is refused is told in digits that read back as the same number", "[common]") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(require_unit(Vec3(0.0, 0.0, 1.0 + 0x1p-26), "normal"),
                    "normal: must be of length one, not 1.0000000149011612");
  CHECK_THROWS_WITH(require_not_negative(-1e-9, "friction"),
                    "friction: must be a finite number from zero up, not -1e-09");
  CHECK_THROWS_WITH(require_positive(0.0, "mass"),
                    "mass: must be a finite number above zero, not 0");
  CHECK_THROWS_WITH(require_positive(-1e300, "mass"),
                    "mass: must be a finite number above zero, not -1e+300");
  CHECK_THROWS_WITH(require_finite(-inf, "gap"), "gap: must be a finite number, not -inf");
  CHECK_THROWS_WITH(refuse("restitution", "a number from 0 to 1", 1.0 + 0x1p-52),
                    "restitution: must be a number from 0 to 1, not 1.0000000000000002");
}

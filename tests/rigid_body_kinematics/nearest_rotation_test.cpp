#include <limits>

#include "catch.hpp"
#include "coning.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::Trial;

namespace {

const std::string a_reflection =
    "this is a reflection: if the determinant of U V^T is -1, flip the last column of U";

bool is_reflection(const Mat3& Q) { return std::abs(Q.determinant() + 1.0) < 32.0 * eps; }

Mat3 random_rotation(tests::Random& random) {
  return tests::matrix_of(random.attitude()).cast<double>();
}

Mat3 gram_schmidt(const Mat3& A) {
  Mat3 Q;
  Q.col(0) = A.col(0).normalized();
  Q.col(1) = (A.col(1) - Q.col(0).dot(A.col(1)) * Q.col(0)).normalized();
  Q.col(2) = Q.col(0).cross(Q.col(1));
  return Q;
}

/// A = U diag(s) Vᵀ, whose nearest rotation is U Vᵀ: s falls in size, and only s.z may be negative.
struct Known {
  Mat3 U;
  Vec3 s;
  Mat3 V;
  Mat3 matrix() const { return U * s.asDiagonal() * V.transpose(); }
};

std::vector<tests::Suspect<Mat3>> suspects_of(const Known& known) {
  const auto with_signs = [&](double x, double y, double z) {
    return Mat3(known.U * Vec3(x, y, z).asDiagonal() * known.V.transpose());
  };
  const Mat3 A = known.matrix();
  return {
      {with_signs(1, 1, -1), a_reflection},
      {with_signs(-1, 1, -1),
       "the direction of the greatest singular value is flipped: flip that of the least"},
      {with_signs(-1, -1, 1),
       "the sign of the whole matrix is changed: change that of one direction"},
      {gram_schmidt(A),
       "this is Gram-Schmidt, which gives a rotation but not the nearest: use the SVD"},
      {gram_schmidt(A.transpose()).transpose(),
       "this is Gram-Schmidt on the rows, which gives a rotation but not the nearest: use the SVD"},
      {A.colwise().normalized(),
       "only the columns' lengths are corrected, not the angles between them: use the SVD"},
      {with_signs(-1, -1, -1), "the whole result has the wrong sign: the determinant must be +1"},
      {A, "the matrix is returned as it is: return U V^T of its SVD"}};
}

/// The answer moves by a few ulp of |A| over the gap by which the nearest rotation is determined.
tests::Bound determined(const Known& known) {
  const double gap = known.s.y() + known.s.z();
  return {32.0 * eps * known.s.norm() / gap + 16.0 * eps, "a few ulp of |A| over the gap s2 + s3"};
}

void expect_nearest(const Known& known, int index, int count) {
  const Mat3 A = known.matrix();
  Trial("1.4 nearest_rotation", index, count)
      .given("matrix", A)
      .expect(nearest_rotation(A), Mat3(known.U * known.V.transpose()), determined(known),
              suspects_of(known));
}

}  // namespace

TEST_CASE("A stretch along the axes is undone", "[1.4]") {
  const Known known{Mat3::Identity(), Vec3(3.0, 2.0, 0.5), Mat3::Identity()};
  expect_nearest(known, 1, 1);
}

TEST_CASE("A rotation is its own nearest rotation", "[1.4]") {
  tests::Random random(43);
  for (int i = 1; i <= 50; ++i) {
    expect_nearest({random_rotation(random), Vec3::Ones(), Mat3::Identity()}, i, 50);
  }
}

TEST_CASE("The rotation in a stretched and sheared matrix is found", "[1.4]") {
  tests::Random random(44);
  for (int i = 1; i <= 100; ++i) {
    const double s = random.uniform(0.5, 1.0);
    const Vec3 stretches(s + random.uniform(0.5, 2.0), s, s * random.uniform(0.1, 0.9));
    expect_nearest({random_rotation(random), stretches, random_rotation(random)}, i, 100);
  }
}

TEST_CASE("A reflected matrix still gives a rotation and the nearest one", "[1.4]") {
  tests::Random random(45);
  for (int i = 1; i <= 100; ++i) {
    const double s = random.uniform(0.5, 1.0);
    const Vec3 stretches(s + random.uniform(0.5, 2.0), s, -s * random.uniform(0.1, 0.9));
    expect_nearest({random_rotation(random), stretches, random_rotation(random)}, i, 100);
  }
}

TEST_CASE("A flat matrix of rank two still gives the nearest rotation", "[1.4]") {
  tests::Random random(46);
  for (int i = 1; i <= 50; ++i) {
    const Known known{random_rotation(random), Vec3(random.uniform(1.0, 2.0), 1.0, 0.0),
                      random_rotation(random)};
    expect_nearest(known, i, 50);
  }
}

TEST_CASE("Just above and below a determinant of zero the nearest rotation is found", "[1.4]") {
  tests::Random random(49);
  int index = 0;
  for (const double least : {1e-9, 1e-12, 4.0 * eps, -1e-9, -1e-12, -4.0 * eps}) {
    const Mat3 U = random_rotation(random);
    expect_nearest({U, Vec3(2.0, 1.0, least), random_rotation(random)}, ++index, 6);
  }
}

TEST_CASE("No rotation is nearer than the one returned", "[1.4]") {
  tests::Random random(47);
  for (int i = 1; i <= 10; ++i) {
    Mat3 A;
    for (int c = 0; c < 3; ++c) A.col(c) = random.vector(2.0);
    const Mat3 got = nearest_rotation(A);
    const Trial trial = Trial("1.4 nearest_rotation", i, 10).given("matrix", A);
    trial.expect_small("|Q^T Q - 1|", (got.transpose() * got - Mat3::Identity()).norm(),
                       {32.0 * eps, "orthogonal up to rounding"});
    double nearest = (got - A).norm();
    for (int k = 0; k < 500; ++k) {
      const double angle = std::pow(10.0, random.uniform(-3.0, 0.5));
      const Mat3 other = tests::rotation(angle, random.direction()).toRotationMatrix() * got;
      nearest = std::min(nearest, (other - A).norm());
    }
    trial.expect_small("distance minus that of a nearer rotation", (got - A).norm() - nearest,
                       {32.0 * eps * A.norm(), "500 other rotations, near and far"});
    trial.expect_small("|det - 1|", std::abs(got.determinant() - 1.0), {32.0 * eps, "a rotation"},
                       is_reflection(got) ? a_reflection : "");
  }
}

TEST_CASE("If several rotations are nearest it returns one of them or throws", "[1.4]") {
  // Rank one, zero and −1: no direction is best. The least |Q − A|² is Σ (s_i − 1)², the least
  // singular value counted with the sign of the determinant.
  const Mat3 rank_one = Vec3(1.0, 2.0, 2.0) * Vec3(0.0, 0.6, 0.8).transpose();
  const std::vector<std::pair<Mat3, double>> cases{
      {rank_one, 4.0 + 1.0 + 1.0}, {Mat3::Zero(), 3.0}, {-Mat3::Identity(), 0.0 + 0.0 + 4.0}};
  int index = 0;
  for (const auto& [A, least_squared] : cases) {
    const Trial trial = Trial("1.4 nearest_rotation", ++index, 3).given("matrix", A);
    Mat3 got;
    try {
      got = nearest_rotation(A);
    } catch (const std::invalid_argument&) {
      SUCCEED("an error is as good an answer");
      continue;
    }
    trial.expect_small("|Q^T Q - 1|", (got.transpose() * got - Mat3::Identity()).norm(),
                       {32.0 * eps, "orthogonal up to rounding"});
    trial.expect_small("|det - 1|", std::abs(got.determinant() - 1.0), {32.0 * eps, "a rotation"},
                       is_reflection(got) ? a_reflection : "");
    trial.expect_small(
        "|Q - A| minus the least", (got - A).norm() - std::sqrt(least_squared),
        {64.0 * eps * (1.0 + A.norm()), "the singular values give the least distance"});
  }
}

TEST_CASE("A matrix that is not finite is refused", "[1.4]") {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Mat3 A = Mat3::Identity();
    A(1, 2) = bad;
    Trial("1.4 nearest_rotation")
        .given("matrix", A)
        .expect_throw([&] { return nearest_rotation(A); }, "an entry is NaN or infinite");
  }
}

TEST_CASE("A projected Euler step turns by the arc tangent of theta about any axis", "[1.4]") {
  tests::Random random(48);
  int index = 0;
  for (const double x : {1e-3, 0.1, 0.5, 1.0, 3.0, 100.0}) {
    const Vec3 a = random.direction();
    const Mat3 swollen = Mat3::Identity() +
                         x * Mat3{{0.0, -a.z(), a.y()}, {a.z(), 0.0, -a.x()}, {-a.y(), a.x(), 0.0}};
    const Mat3 wanted = tests::rotation(std::atan(x), a).toRotationMatrix();
    const Known as_built{tests::rotation(std::atan(x), a).toRotationMatrix(),
                         Vec3(std::hypot(1.0, x), std::hypot(1.0, x), 1.0), Mat3::Identity()};
    Trial("1.4 nearest_rotation", ++index, 6)
        .given("theta", x)
        .given("axis", a)
        .given("matrix", swollen)
        .expect(
            nearest_rotation(swollen), wanted, determined(as_built),
            {{gram_schmidt(swollen),
              "this is Gram-Schmidt, which gives a rotation but not the nearest: use the SVD"},
             {swollen.colwise().normalized(),
              "only the columns' lengths are corrected, not the angles between them: use the SVD"},
             {tests::rotation(x, a).toRotationMatrix(),
              "this is the exact turn by theta: project the matrix, which turns only by atan "
              "theta"}});
  }
}

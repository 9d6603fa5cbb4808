#include "catch.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::Trial;

namespace {

const std::string missing_signs =
    "the minus signs are missing: the matrix of a cross product is antisymmetric";

std::vector<tests::Suspect<Mat3>> suspects_of_matrix(const Mat3& wanted) {
  return {{-wanted, "the signs are those of the transpose, which gives u x w: change all signs"},
          {wanted.cwiseAbs(), missing_signs}};
}

}  // namespace

TEST_CASE("skew of 1 2 3 holds the components worked by hand", "[1.1]") {
  const Vec3 w(1.0, 2.0, 3.0);
  const Mat3 wanted{{0.0, -3.0, 2.0}, {3.0, 0.0, -1.0}, {-2.0, 1.0, 0.0}};
  Trial("1.1 skew")
      .given("w", w)
      .expect(skew(w), wanted, {0.0, "components are copied, not computed"},
              suspects_of_matrix(wanted));
}

TEST_CASE("skew of w times u is the cross product of w and u", "[1.1]") {
  tests::Random random(11);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 w = random.vector(3.0);
    const Vec3 u = random.vector(3.0);
    const Vec3 got = skew(w) * u;
    const Vec3 wanted(w.y() * u.z() - w.z() * u.y(), w.z() * u.x() - w.x() * u.z(),
                      w.x() * u.y() - w.y() * u.x());
    Trial("1.1 skew", i, 100)
        .given("w", w)
        .given("u", u)
        .expect(got, wanted,
                {4.0 * eps * w.norm() * u.norm(), "three rounded operations per component"},
                {{-wanted,
                  "the signs are those of the transpose, which gives u x w: change all signs"}});
  }
}

TEST_CASE("skew of w is antisymmetric and as long as w", "[1.1]") {
  tests::Random random(12);
  for (int i = 1; i <= 20; ++i) {
    const Vec3 w = random.vector(3.0);
    const Mat3 got = skew(w);
    Trial("1.1 skew", i, 20)
        .given("w", w)
        .expect_small("|S + S^T|", (got + got.transpose()).norm(),
                      {0.0, "the same number with both signs"},
                      got.isApprox(got.transpose(), 0.0) ? missing_signs : "");
    // |S|² holds each component twice; a zero matrix is antisymmetric too.
    Trial("1.1 skew", i, 20)
        .given("w", w)
        .expect_small("| |S| - sqrt2 |w| |", std::abs(got.norm() - std::sqrt(2.0) * w.norm()),
                      {8.0 * eps * w.norm(), "two norms, each to a few ulp"});
  }
}

TEST_CASE("skew neither loses nor overflows the smallest and the largest numbers", "[1.1]") {
  for (const double size : {1e-300, 1e300}) {
    const Vec3 w(size, -2.0 * size, 3.0 * size);
    const Mat3 wanted{{0.0, -w.z(), w.y()}, {w.z(), 0.0, -w.x()}, {-w.y(), w.x(), 0.0}};
    Trial("1.1 skew")
        .given("w", w)
        .expect(skew(w), wanted, {0.0, "components are copied, not computed"},
                suspects_of_matrix(wanted));
  }
  const Mat3 none = skew(Vec3::Zero());
  Trial("1.1 skew")
      .given("w", Vec3(Vec3::Zero()))
      .expect(none, Mat3(Mat3::Zero()), {0.0, "the matrix of zero is zero"});
}

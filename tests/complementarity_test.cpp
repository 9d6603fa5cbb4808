// The solvers that lab 7 is given, against all active sets one after the other: ties, singular
// systems, bodies that are jammed, masses of any ratio.
#include "common/algebra/complementarity.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "random.hpp"

using common::complementary;
using common::least_norm_solution;
using common::Matrix;
using common::Vector;
using tests::Random;

namespace {

/// The largest breach of 0 ≤ λ, u = A λ + b ≥ 0, λ u = 0, each row divided by the root of its A_ii
/// and by the largest number at hand.
double breach(const Matrix& A, const Vector& b, const Vector& lambda) {
  const Vector root = A.diagonal().cwiseSqrt();
  const Vector u = (A * lambda + b).cwiseQuotient(root);
  const Vector scaled = lambda.cwiseProduct(root);
  const double size = std::max(b.cwiseQuotient(root).cwiseAbs().maxCoeff(), scaled.maxCoeff());
  return size == 0.0 ? 0.0 : scaled.cwiseMin(u).cwiseAbs().maxCoeff() / size;
}

/// λ by trying every set of contacts that may press; empty if none does.
Vector by_enumeration(const Matrix& A, const Vector& b) {
  const int m = static_cast<int>(b.size());
  for (unsigned set = 0; set < 1U << m; ++set) {
    std::vector<int> in;
    for (int i = 0; i < m; ++i) {
      if ((set >> i & 1U) != 0) in.push_back(i);
    }
    Vector lambda = Vector::Zero(m);
    if (!in.empty()) {
      const Vector x = common::block(A, in).fullPivLu().solve(-common::entries(b, in));
      for (std::size_t k = 0; k < in.size(); ++k) lambda[in[k]] = x[static_cast<int>(k)];
    }
    if (breach(A, b, lambda) < 1e-11) return lambda;
  }
  return Vector(0);
}

/// What two solutions may differ by in A λ, where λ may be large for the b that asks for it.
double rounding(const Matrix& A, const Vector& lambda) {
  return 1e-12 * A.cwiseAbs().maxCoeff() * (1.0 + lambda.maxCoeff());
}

/// Small whole numbers, which make ties and singular systems: J of m rows for `freedoms`.
Matrix whole_rows(Random& random, int m, int freedoms) {
  Matrix J(m, freedoms);
  for (int i = 0; i < m; ++i) {
    do {
      for (int k = 0; k < freedoms; ++k) J(i, k) = std::floor(random.uniform(-2.0, 3.0));
    } while (J.row(i).isZero(0.0));
  }
  return J;
}

Matrix matrix(std::initializer_list<std::initializer_list<double>> rows) { return Matrix(rows); }

Vector vector(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

const Matrix table = matrix({{7, 1, 1, -5}, {1, 7, -5, 1}, {1, -5, 7, 1}, {-5, 1, 1, 7}});
const Matrix jammed = matrix({{1, -1}, {-1, 1}});

}  // namespace

TEST_CASE("A solution agrees with the trial of every set", "[complementarity]") {
  Random random(1);
  int unsolvable = 0;
  for (int i = 0; i < 1000; ++i) {
    const int m = 1 + i % 8;
    const int freedoms = 1 + static_cast<int>(random.uniform(0.0, 6.0));
    const Matrix J = whole_rows(random, m, freedoms);
    const Matrix A = J * J.transpose();
    // Half of the problems come from velocities, and have a solution; half are any.
    Vector b(m);
    for (int k = 0; k < m; ++k) b[k] = std::floor(random.uniform(-2.0, 3.0));
    if (i % 2 == 0) b = J * whole_rows(random, freedoms, 1);
    const Vector expected = by_enumeration(A, b);
    CAPTURE(i, A, b, expected);
    if (expected.size() == 0) {
      ++unsolvable;
      CHECK_THROWS_AS(complementary(A, b), std::domain_error);
      continue;
    }
    const Vector lambda = complementary(A, b);
    CHECK(lambda.minCoeff() >= 0.0);
    CHECK(breach(A, b, lambda) < 1e-12);
    // λ need not be the same, the velocities are.
    CHECK((A * (lambda - expected)).cwiseAbs().maxCoeff() < rounding(A, expected));
  }
  CHECK(unsolvable > 100);
}

TEST_CASE("Ten contacts of random bodies agree with the trial of every set", "[complementarity]") {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const int freedoms = i % 2 == 0 ? 12 : 6;
    Matrix J(10, freedoms);
    Vector v(freedoms);
    for (int k = 0; k < J.size(); ++k) J.data()[k] = random.uniform(-1.0, 1.0);
    for (int k = 0; k < freedoms; ++k) v[k] = random.uniform(-1.0, 1.0);
    const Matrix A = J * J.transpose();
    const Vector lambda = complementary(A, J * v);
    CHECK(breach(A, J * v, lambda) < 1e-12);
    const Vector expected = by_enumeration(A, J * v);
    REQUIRE(expected.size() == 10);
    CHECK((A * (lambda - expected)).cwiseAbs().maxCoeff() < rounding(A, expected));
  }
}

TEST_CASE("A table on four legs is solved though its legs are one too many", "[complementarity]") {
  for (const Vector& b : {vector({-1, -1, -1, -1}), vector({-2, -1, -1, 0}),
                          vector({-4, -2, -2, 0}), vector({-3, 0, 0, 3}), vector({0, 0, 0, 0})}) {
    const Vector lambda = complementary(table, b);
    CHECK(lambda.minCoeff() >= 0.0);
    CHECK((table * lambda + b).cwiseMin(lambda).cwiseAbs().maxCoeff() < 1e-14);
  }
}

TEST_CASE("The same contact many times is one contact", "[complementarity]") {
  for (int m : {2, 10, 100}) {
    const Matrix A = Matrix::Constant(m, m, 2.0);
    const Vector b = Vector::Constant(m, -1.0);
    const Vector lambda = complementary(A, b);
    CHECK(lambda.minCoeff() >= 0.0);
    CHECK(std::abs(lambda.sum() - 0.5) < 1e-14);
    CHECK((least_norm_solution(A, -b) - Vector::Constant(m, 0.5 / m)).norm() < 1e-13);
  }
}

TEST_CASE("What is at rest or parts gets nothing", "[complementarity]") {
  CHECK(complementary(jammed, vector({0, 0})).isZero(0.0));
  CHECK(complementary(table, vector({0, 1, 2, 0})).isZero(0.0));
  CHECK(complementary(Matrix(0, 0), Vector(0)).size() == 0);
  CHECK(least_norm_solution(Matrix(0, 0), Vector(0)).size() == 0);
}

TEST_CASE("A ball between two walls has a solution for e of zero only", "[complementarity]") {
  CHECK((complementary(jammed, vector({-1, 1})) - vector({1, 0})).norm() < 1e-15);
  for (double e : {1e-9, 0.01, 0.5, 1.0}) {
    CHECK_THROWS_AS(complementary(jammed, vector({-1 - e, 1})), std::domain_error);
    CHECK_THROWS_AS(complementary(1e-90 * jammed, 1e90 * vector({-1 - e, 1})), std::domain_error);
  }
  CHECK_THROWS_AS(complementary(jammed, vector({-1, -1})), std::domain_error);
  CHECK_THROWS_AS(least_norm_solution(jammed, vector({1, 1})), std::domain_error);
  CHECK((least_norm_solution(jammed, vector({1, -1})) - vector({0.5, -0.5})).norm() < 1e-15);
}

TEST_CASE("A column is solved whatever its masses", "[complementarity]") {
  for (double ratio : {1.0, 1e3, 1e6, 1e9, 1e-9}) {
    for (int n : {2, 3, 10}) {
      // Masses 1 and ratio in turn, on the ground, all with speed 1 downwards.
      Matrix A = Matrix::Zero(n, n);
      double above = 0.0;
      Vector expected(n);
      for (int i = n - 1; i >= 0; --i) {
        const double mass = i % 2 == 0 ? 1.0 : ratio;
        A(i, i) += 1.0 / mass;
        if (i + 1 < n) A(i, i + 1) = A(i + 1, i) = -1.0 / mass;
        if (i + 1 < n) A(i + 1, i + 1) += 1.0 / mass;
        expected[i] = above += mass;
      }
      Vector b = Vector::Zero(n);
      b[0] = -1.0;
      const double rounding = 1e-15 * std::pow(n, 2) * std::max(ratio, 1.0 / ratio);
      CAPTURE(ratio, n, A);
      CHECK((complementary(A, b) - expected).norm() < 10.0 * rounding * expected.norm());
      CHECK((least_norm_solution(A, -b) - expected).norm() < 10.0 * rounding * expected.norm());
      CHECK(breach(A, b, complementary(A, b)) < 1e-12);
    }
  }
}

TEST_CASE("Numbers may be very large or small", "[complementarity]") {
  for (double size : {1e-100, 1e-30, 1e30, 1e100}) {
    const Vector b = vector({-2, -1, -1, 0});
    const Vector got = complementary(table * size, b) * size;
    CHECK((table * got + b).cwiseMin(got).cwiseAbs().maxCoeff() < 1e-14);
    const Vector legs = least_norm_solution(table * size, Vector::Ones(4)) * size;
    CHECK((legs - Vector::Constant(4, 0.25)).norm() < 1e-13);
    const Vector far = complementary(matrix({{size, 0}, {0, 1 / size}}), vector({-1, -1}));
    CHECK(std::abs(far[0] * size - 1.0) < 1e-14);
    CHECK(std::abs(far[1] / size - 1.0) < 1e-14);
  }
}

TEST_CASE("A large heap is solved", "[complementarity]") {
  Random random(3);
  for (int freedoms : {90, 150, 600}) {  // with 300 contacts the first two are singular
    Matrix J(300, freedoms);
    for (int k = 0; k < J.size(); ++k) J.data()[k] = random.uniform(-1.0, 1.0);
    Vector v(freedoms);
    for (int k = 0; k < freedoms; ++k) v[k] = random.uniform(-1.0, 1.0);
    const Matrix A = J * J.transpose();
    const Vector lambda = complementary(A, J * v);
    CHECK(breach(A, J * v, lambda) < 1e-12);
    const Vector held = least_norm_solution(A, -(J * v));
    CHECK((A * held + J * v).norm() < 1e-10 * v.norm() * std::sqrt(300.0));
  }
}

TEST_CASE("The shortest solution has nothing that A does not notice", "[complementarity]") {
  CHECK((least_norm_solution(table, Vector::Ones(4)) - Vector::Constant(4, 0.25)).norm() < 1e-14);
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const int m = 2 + i % 8;
    const Matrix J = whole_rows(random, m, 3);
    Matrix A = J * J.transpose();
    const Vector b = J * whole_rows(random, 3, 1);
    const Vector x = least_norm_solution(A, b);
    CHECK((A * x - b).norm() < 1e-11);
    Eigen::FullPivLU<Matrix> lu(A);
    lu.setThreshold(1e-10);             // A has whole numbers
    const Matrix unseen = lu.kernel();  // A times its columns is zero
    CHECK(unseen.cols() >= m - 3);      // J has three columns, so A has three that count, at most
    CHECK((unseen.transpose() * x).norm() < 1e-11);
  }
}

TEST_CASE("A pull is left alone by the shortest solution", "[complementarity]") {
  const Matrix dumb_bell = matrix({{4.0 / 3, 2.0 / 3}, {2.0 / 3, 4.0 / 3}});
  CHECK((least_norm_solution(dumb_bell, vector({2, 0.5})) - vector({1.75, -0.5})).norm() < 1e-14);
  CHECK((complementary(dumb_bell, vector({-2, -0.5})) - vector({1.5, 0})).norm() < 1e-15);
}

TEST_CASE("What is no system is refused", "[complementarity]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector b = vector({-1, 0});
  const auto refuses = [](const Matrix& A, const Vector& rhs) {
    CHECK_THROWS_AS(complementary(A, rhs), std::invalid_argument);
    CHECK_THROWS_AS(least_norm_solution(A, rhs), std::invalid_argument);
  };
  refuses(matrix({{1, 0, 0}, {0, 1, 0}}), b);
  refuses(Matrix::Identity(3, 3), b);
  refuses(matrix({{1, 0}, {1e-6, 1}}), b);
  refuses(matrix({{1, 0}, {0, 0}}), b);
  refuses(matrix({{1, 0}, {0, -1}}), b);
  refuses(matrix({{1, nan}, {nan, 1}}), b);
  refuses(Matrix::Identity(2, 2), vector({-HUGE_VAL, nan}));
  CHECK_NOTHROW(complementary(matrix({{1, 0.5}, {0.5 + 1e-10, 1}}), b));
}

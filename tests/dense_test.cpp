// Matrices of any size: the few products that lab 7 is given, and the largest eigenvalue.
#include "common/algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "catch.hpp"
#include "random.hpp"

using common::largest_eigenvalue;
using common::Matrix;
using common::Vector;

namespace {

Vector entries(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Matrix random_matrix(tests::Random& random, int rows, int cols) {
  Matrix J(rows, cols);
  for (double& entry : J.reshaped()) entry = random.uniform(-1.0, 1.0);
  return J;
}

const Matrix of_table{{7, 1, 1, -5}, {1, 7, -5, 1}, {1, -5, 7, 1}, {-5, 1, 1, 7}};

}  // namespace

TEST_CASE("Products and parts are what they say", "[dense]") {
  const Vector x = entries({1, 2, 3, -4});
  CHECK(common::product(of_table, x) == of_table * x);
  CHECK(common::row_product(of_table, 2, x) == (of_table * x)[2]);
  CHECK(common::entries(x, {3, 0}) == entries({-4, 1}));
  CHECK(common::entries(x, {}).size() == 0);
  CHECK(common::spread(entries({-4, 1}), {3, 0}, 4) == entries({1, 0, 0, -4}));
  CHECK(common::block(of_table, {3, 0}) == Matrix{{7, -5}, {-5, 7}});
  CHECK(common::block(of_table, {}).size() == 0);
  CHECK(common::largest_entry(x) == 4.0);
  CHECK(common::largest_entry(Vector(0)) == 0.0);
}

TEST_CASE("The largest eigenvalue is that of other solvers", "[dense]") {
  CHECK(std::abs(largest_eigenvalue(of_table) - 12.0) < 1e-13);
  CHECK(largest_eigenvalue(Matrix(0, 0)) == 0.0);
  CHECK(largest_eigenvalue(Matrix::Zero(3, 3)) == 0.0);
  CHECK(std::abs(largest_eigenvalue(Matrix::Identity(5, 5)) - 1.0) < 1e-14);
  CHECK(std::abs(largest_eigenvalue(-Matrix::Identity(5, 5)) + 1.0) < 1e-14);
  CHECK(std::abs(largest_eigenvalue(Matrix::Constant(40, 40, 2.0)) - 80.0) < 1e-12);
  tests::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const int n = 1 + i % 20;
    const Matrix J = random_matrix(random, n, 1 + i % 7);
    const Matrix A = i % 2 == 0
                         ? Matrix(J * J.transpose())
                         : Matrix(random_matrix(random, n, n).selfadjointView<Eigen::Upper>());
    const double expected = Eigen::SelfAdjointEigenSolver<Matrix>(A).eigenvalues().maxCoeff();
    for (double size : {1e-100, 1.0, 1e100}) {
      const double error = std::abs(largest_eigenvalue(size * A) / size - expected);
      CHECK(error < 1e-14 * n * A.norm());
    }
  }
}

TEST_CASE("A column has the largest eigenvalue that is known", "[dense]") {
  for (int n : {2, 10, 100, 300}) {
    Matrix A = 2.0 * Matrix::Identity(n, n);
    A(0, 0) = 1.0;
    for (int i = 1; i < n; ++i) A(i, i - 1) = A(i - 1, i) = -1.0;
    const double root = 2.0 * std::cos(std::acos(-1.0) / (2.0 * n + 1.0));
    CAPTURE(n);
    CHECK(std::abs(largest_eigenvalue(A) - root * root) < 1e-13);
  }
}

TEST_CASE("What has another size or is not finite is refused", "[dense]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector x = entries({1, 2});
  const Matrix A = Matrix::Identity(2, 2);
  CHECK_NOTHROW(common::require_entries(x, 2, "x"));
  CHECK_THROWS_AS(common::require_entries(x, 3, "x"), std::invalid_argument);
  CHECK_THROWS_AS(common::require_entries(entries({1, nan}), 2, "x"), std::invalid_argument);
  CHECK_NOTHROW(common::require_system(A, x, x));
  CHECK_NOTHROW(common::require_system(Matrix(0, 0), Vector(0), Vector(0)));
  CHECK_THROWS_AS(common::require_system(A, x, entries({1})), std::invalid_argument);
  CHECK_THROWS_AS(common::require_system(A, x, entries({1, HUGE_VAL})), std::invalid_argument);
  CHECK_THROWS_AS(common::require_system(Matrix(0, 1), Vector(0)), std::invalid_argument);
}

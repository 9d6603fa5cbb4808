#include "common/algebra/dense.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "common/course/require.hpp"

namespace common {
namespace {

using Eigen::Index;

/// A symmetric matrix with two diagonals: d_i, and e_i beside it in row i and i − 1.
struct Tridiagonal {
  Vector d;
  Vector e;

  /// How many eigenvalues are below x: so many pivots of the matrix less x are below zero.
  [[nodiscard]] int below(double x) const {
    int count = 0;
    double pivot = 1.0;
    for (Index i = 0; i < d.size(); ++i) {
      pivot = d[i] - x - (i > 0 ? e[i] * e[i] / pivot : 0.0);
      if (pivot == 0.0) pivot = -1e-300;
      if (pivot < 0.0) ++count;
    }
    return count;
  }
};

/// By Householder's reflections, column by column from the last; the eigenvalues stay.
Tridiagonal tridiagonal(Matrix A) {
  const Index n = A.rows();
  Tridiagonal result{Vector::Zero(n), Vector::Zero(n)};
  for (Index k = n - 1; k >= 1; --k) {
    Vector v = A.col(k).head(k);
    const double length = std::copysign(v.norm(), v[k - 1]);
    result.e[k] = -length;
    v[k - 1] += length;
    if (v.isZero(0.0)) continue;
    v /= v.norm();
    Vector w = 2.0 * (A.topLeftCorner(k, k) * v);
    w -= w.dot(v) * v;
    for (Index j = 0; j < k; ++j) {
      for (Index i = 0; i < k; ++i) A(i, j) -= v[i] * w[j] + w[i] * v[j];
    }
  }
  result.d = A.diagonal();
  return result;
}

}  // namespace

double row_product(const Matrix& A, int i, const Vector& x) {
  std::array<double, 4> sums{};  // side by side, because one sum waits for each of its additions
  Index k = 0;
  for (; k + 4 <= x.size(); k += 4) {
    for (Index j = 0; j < 4; ++j) sums[static_cast<std::size_t>(j)] += A(i, k + j) * x[k + j];
  }
  for (; k < x.size(); ++k) sums[0] += A(i, k) * x[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

Vector product(const Matrix& A, const Vector& x) {
  Vector result(A.rows());
  for (int i = 0; i < A.rows(); ++i) result[i] = row_product(A, i, x);
  return result;
}

double largest_entry(const Vector& x) {
  double largest = 0.0;
  for (double entry : x) largest = std::max(largest, std::abs(entry));
  return largest;
}

Vector entries(const Vector& x, const std::vector<int>& rows) {
  Vector result(static_cast<Index>(rows.size()));
  Index i = 0;
  for (int row : rows) result[i++] = x[row];
  return result;
}

Vector spread(const Vector& x, const std::vector<int>& rows, Index size) {
  Vector result = Vector::Zero(size);
  Index i = 0;
  for (int row : rows) result[row] = x[i++];
  return result;
}

Matrix block(const Matrix& A, const std::vector<int>& rows) {
  const auto size = static_cast<Index>(rows.size());
  Matrix result(size, size);
  Index j = 0;
  for (int column : rows) result.col(j++) = entries(A.col(column), rows);
  return result;
}

double largest_eigenvalue(const Matrix& A) {
  if (A.rows() == 0) return 0.0;
  double largest = 0.0;
  for (double entry : Vector(A.reshaped())) largest = std::max(largest, std::abs(entry));
  if (largest == 0.0) return 0.0;
  const Tridiagonal scaled = tridiagonal(A / largest);
  const int n = static_cast<int>(A.rows());
  double low = -n;  // no eigenvalue is larger than the sum of a row
  double high = n;
  for (double mid = 0.0; mid > low && mid < high; mid = 0.5 * (low + high)) {
    (scaled.below(mid) == n ? high : low) = mid;
  }
  return high * largest;
}

void require_entries(const Vector& x, Eigen::Index size, const char* name) {
  if (x.size() != size) {
    throw std::invalid_argument(std::string(name) + ": must have " + std::to_string(size) +
                                " entries, not " + std::to_string(x.size()));
  }
  if (!x.allFinite()) refuse_entry(name);
}

void require_system(const Matrix& A, const Vector& b) {
  if (A.rows() != A.cols()) throw std::invalid_argument("A: must be square");
  require_entries(b, A.rows(), "the vector that goes with A");
  if (A.rows() == 0) return;
  if (!A.allFinite()) refuse_entry("A");
  const double asymmetry = (A - A.transpose()).cwiseAbs().maxCoeff();
  if (!(asymmetry <= 1e-9 * A.cwiseAbs().maxCoeff())) {
    throw std::invalid_argument("A: must be symmetric");
  }
  if (!(A.diagonal().minCoeff() > 0.0)) {
    throw std::invalid_argument("A: must be above zero on its diagonal");
  }
}

void require_system(const Matrix& A, const Vector& b, const Vector& lambda) {
  require_system(A, b);
  require_entries(lambda, b.size(), "lambda");
}

}  // namespace common

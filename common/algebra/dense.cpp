#include "common/algebra/dense.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/course/require.hpp"

namespace common {
namespace {

using Eigen::Index;

/// A symmetric matrix with two diagonals: d_i, and e_i beside it in row i and i − 1.
struct Tridiagonal {
  std::vector<double> d;
  std::vector<double> e;

  /// How many eigenvalues are below x: so many pivots of the matrix less x are below zero.
  [[nodiscard]] std::size_t below(double x) const {
    std::size_t count = 0;
    double pivot = 1.0;
    for (std::size_t i = 0; i < d.size(); ++i) {
      pivot = d[i] - x - (i > 0 ? e[i] * e[i] / pivot : 0.0);
      if (pivot == 0.0) pivot = -1e-300;
      if (pivot < 0.0) ++count;
    }
    return count;
  }

  /// The largest eigenvalue, by bisection of an interval that holds it.
  [[nodiscard]] double largest(double low, double high) const {
    for (double mid = 0.5 * (low + high); mid > low && mid < high; mid = 0.5 * (low + high)) {
      (below(mid) == d.size() ? high : low) = mid;
    }
    return high;
  }
};

/// A vector that is in no special direction, and the same in every run.
Vector any_direction(Index n) {
  Vector v(n);
  std::minstd_rand random;
  for (double& entry : v) entry = static_cast<double>(random()) / 2147483647.0 - 0.5;
  return v;
}

/// The largest |A_ij − A_ji|, square by square: a column of a large A would fetch as many lines of
/// memory as it has entries, for one number each.
double asymmetry(const Matrix& A) {
  constexpr Index side = 16;
  double largest = 0.0;
  for (Index top = 0; top < A.rows(); top += side) {
    for (Index left = 0; left <= top; left += side) {
      const Index bottom = std::min(top + side, A.rows());
      for (Index i = top; i < bottom; ++i) {
        for (Index j = left; j < std::min(left + side, i); ++j) {
          largest = std::max(largest, std::abs(A(i, j) - A(j, i)));
        }
      }
    }
  }
  return largest;
}

}  // namespace

double row_product(const Matrix& A, int i, const Vector& x) {
  // Eight sums side by side: one sum alone would wait for each of its additions.
  constexpr Index beside = 8;
  std::array<double, beside> sums{};
  Index k = 0;
  for (; k + beside <= x.size(); k += beside) {
    for (Index j = 0; j < beside; ++j) {
      sums[static_cast<std::size_t>(j)] += A(i, k + j) * x[k + j];
    }
  }
  for (; k < x.size(); ++k) sums[0] += A(i, k) * x[k];
  return std::accumulate(sums.begin(), sums.end(), 0.0);
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
  return largest_eigenvalue(A.rows(), A.cwiseAbs().maxCoeff(),
                            [&](const Vector& x) { return product(A, x); });
}

double largest_eigenvalue(Index rows, double largest_entry,
                          const std::function<Vector(const Vector&)>& product) {
  if (rows == 0 || largest_entry == 0.0) return 0.0;
  // The method of Lanczos: seen along v₁, v₂ ~ A v₁, v₃ ~ A v₂, … A has two diagonals, and after a
  // few steps it shows its largest eigenvalue. Each v is set against the two before it alone: what
  // rounding leaves of the others only shows eigenvalues twice. What is seen only grows, and ends
  // to rounding: it has to stand for eight steps, because it may rest before a group of eigenvalues
  // that are almost alike is told apart.
  Vector before = Vector::Zero(rows);
  Vector v = any_direction(rows).normalized();
  Tridiagonal seen{{}, {0.0}};
  const auto n = static_cast<double>(rows);
  const double bound = 2.0 * n;  // none is beyond the sum of a row, n at most
  double largest = -bound;
  int steady = 0;
  while (steady < 8) {
    Vector w = product(v) / largest_entry - seen.e.back() * before;
    seen.d.push_back(w.dot(v));
    w -= seen.d.back() * v;
    const double last = largest;
    largest = seen.largest(-bound, bound);
    steady = largest <= last + 1e-16 * n ? steady + 1 : 0;
    const double length = w.norm();
    if (!(length > 1e-14)) break;  // it has seen all
    seen.e.push_back(length);
    before = v;
    v = w / length;
  }
  return largest * largest_entry;
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
  if (!(asymmetry(A) <= 1e-9 * A.cwiseAbs().maxCoeff())) {
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

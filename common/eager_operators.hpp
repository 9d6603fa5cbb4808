#pragma once

#include <Eigen/Core>
#include <concepts>

/// These operators compute sums and products of small vectors and matrices at once.
///
/// Eigen's own operators return an expression, which is computed when it is assigned. Large
/// matrices need that. For three numbers it has two costs. Each expression is a type of its own,
/// which takes milliseconds to compile at every save. And `auto sum = a + f(b)` keeps a reference
/// to the result of f, which no longer exists in the next line. The overloads here fit matrices of
/// a fixed size better than Eigen's do, so the compiler chooses them. They return the value itself.
/// They round each entry as Eigen does; products add their terms from the first to the last.
namespace Eigen {

template <typename T, int R, int C>
concept SmallMatrix = std::floating_point<T> && R >
0 && C > 0 && R* C <= 16;

/// A whole number, or a number of the entries' own type, so that no digit is lost unseen.
template <typename S, typename T>
concept ScalarOf = std::same_as<S, T> || std::integral<S>;

template <typename T, int R, int C>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator+(const Matrix<T, R, C>& a, const Matrix<T, R, C>& b) {
  Matrix<T, R, C> sum;
  for (int i = 0; i < R * C; ++i) sum.data()[i] = a.data()[i] + b.data()[i];
  return sum;
}

template <typename T, int R, int C>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator-(const Matrix<T, R, C>& a, const Matrix<T, R, C>& b) {
  Matrix<T, R, C> difference;
  for (int i = 0; i < R * C; ++i) difference.data()[i] = a.data()[i] - b.data()[i];
  return difference;
}

template <typename T, int R, int C>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator-(const Matrix<T, R, C>& a) {
  Matrix<T, R, C> opposite;
  for (int i = 0; i < R * C; ++i) opposite.data()[i] = -a.data()[i];
  return opposite;
}

template <typename T, int R, int C, ScalarOf<T> S>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator*(const Matrix<T, R, C>& a, const S& factor) {
  const T s = static_cast<T>(factor);
  Matrix<T, R, C> product;
  for (int i = 0; i < R * C; ++i) product.data()[i] = a.data()[i] * s;
  return product;
}

template <typename T, int R, int C, ScalarOf<T> S>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator*(const S& factor, const Matrix<T, R, C>& a) { return a * factor; }

template <typename T, int R, int C, ScalarOf<T> S>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator/(const Matrix<T, R, C>& a, const S& divisor) {
  const T s = static_cast<T>(divisor);
  Matrix<T, R, C> quotient;
  for (int i = 0; i < R * C; ++i) quotient.data()[i] = a.data()[i] / s;
  return quotient;
}

template <typename T, int R, int K, int C>
requires(SmallMatrix<T, R, K>&& SmallMatrix<T, K, C>&& K > 1) Matrix<T, R, C>
operator*(const Matrix<T, R, K>& a, const Matrix<T, K, C>& b) {
  Matrix<T, R, C> product;
  for (int j = 0; j < C; ++j) {
    for (int i = 0; i < R; ++i) {
      T sum = a.data()[i] * b.data()[j * K];
      for (int k = 1; k < K; ++k) sum += a.data()[i + k * R] * b.data()[j * K + k];
      product.data()[i + j * R] = sum;
    }
  }
  return product;
}

template <typename T, int N>
requires SmallMatrix<T, N, N> Matrix<T, N, N> transposed(const Matrix<T, N, N>& a) {
  Matrix<T, N, N> result;
  for (int j = 0; j < N; ++j) {
    for (int i = 0; i < N; ++i) result.data()[i + j * N] = a.data()[j + i * N];
  }
  return result;
}

/// Return Rᵀ v and Rᵀ A.
template <typename T, int N, int C>
requires(SmallMatrix<T, N, N>&& SmallMatrix<T, N, C>&& N > 1) Matrix<T, N, C>
operator*(const Transpose<const Matrix<T, N, N>>& a, const Matrix<T, N, C>& b) {
  return transposed(a.nestedExpression()) * b;
}

/// Returns A Rᵀ.
template <typename T, int N>
requires(SmallMatrix<T, N, N>&& N > 1) Matrix<T, N, N>
operator*(const Matrix<T, N, N>& a, const Transpose<const Matrix<T, N, N>>& b) {
  return a * transposed(b.nestedExpression());
}

/// Returns R diag(d).
template <typename T, int R, int C>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator*(const Matrix<T, R, C>& a, const DiagonalWrapper<const Matrix<T, C, 1>>& b) {
  Matrix<T, R, C> product;
  for (int j = 0; j < C; ++j) {
    for (int i = 0; i < R; ++i) product.data()[i + j * R] = a.data()[i + j * R] * b.diagonal()[j];
  }
  return product;
}

/// Returns a bᵀ.
template <typename T, int R, int C>
requires SmallMatrix<T, R, C> Matrix<T, R, C>
operator*(const Matrix<T, R, 1>& a, const Transpose<const Matrix<T, C, 1>>& b) {
  Matrix<T, R, C> product;
  for (int j = 0; j < C; ++j) {
    for (int i = 0; i < R; ++i) {
      product.data()[i + j * R] = a.data()[i] * b.nestedExpression().data()[j];
    }
  }
  return product;
}

}  // namespace Eigen

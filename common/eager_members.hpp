// These are members of Eigen::Matrix: Eigen includes this file in the class, see
// EIGEN_MATRIX_PLUGIN. They do for members what eager_operators.hpp does for operators: a small
// matrix computes the result at once, while Eigen's own members return an expression of a type of
// its own. All other matrices keep Eigen's members.

using Base::allFinite;
using Base::cross;
using Base::cwiseAbs;
using Base::cwiseInverse;
using Base::cwiseMax;
using Base::cwiseMin;
using Base::cwiseProduct;
using Base::cwiseQuotient;
using Base::dot;
using Base::maxCoeff;
using Base::minCoeff;
using Base::norm;
using Base::normalize;
using Base::normalized;
using Base::squaredNorm;
using Base::sum;
using Base::operator+=;
using Base::operator-=;

static constexpr bool is_small = std::is_floating_point_v<Scalar> && RowsAtCompileTime > 0 &&
                                 ColsAtCompileTime > 0 && SizeAtCompileTime <= 16;
// This has its own name because GCC 14 crashes on the comparison in a requires-clause.
static constexpr bool is_vector_of_three = is_small && SizeAtCompileTime == 3;

Scalar dot(const Matrix& b) const requires is_small {
  Scalar sum = this->data()[0] * b.data()[0];
  for (int i = 1; i < SizeAtCompileTime; ++i) sum += this->data()[i] * b.data()[i];
  return sum;
}
Scalar squaredNorm() const requires is_small { return dot(*this); }
Scalar norm() const requires is_small { return std::sqrt(dot(*this)); }
Matrix normalized() const requires is_small {
  const Scalar square = dot(*this);
  return square > Scalar(0) ? *this / std::sqrt(square) : *this;
}
void normalize() requires is_small { *this = normalized(); }

Scalar sum() const requires is_small {
  Scalar sum = this->data()[0];
  for (int i = 1; i < SizeAtCompileTime; ++i) sum += this->data()[i];
  return sum;
}
Scalar maxCoeff() const requires is_small {
  Scalar most = this->data()[0];
  for (int i = 1; i < SizeAtCompileTime; ++i) most = std::max(most, this->data()[i]);
  return most;
}
Scalar minCoeff() const requires is_small {
  Scalar least = this->data()[0];
  for (int i = 1; i < SizeAtCompileTime; ++i) least = std::min(least, this->data()[i]);
  return least;
}
bool allFinite() const requires is_small {
  for (int i = 0; i < SizeAtCompileTime; ++i) {
    if (!std::isfinite(this->data()[i])) return false;
  }
  return true;
}

Matrix cross(const Matrix& b) const requires is_vector_of_three {
  const Scalar* u = this->data();
  const Scalar* v = b.data();
  return Matrix(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}
Matrix cwiseProduct(const Matrix& b) const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = this->data()[i] * b.data()[i];
  return c;
}
Matrix cwiseQuotient(const Matrix& b) const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = this->data()[i] / b.data()[i];
  return c;
}
Matrix cwiseMin(const Matrix& b) const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = std::min(this->data()[i], b.data()[i]);
  return c;
}
Matrix cwiseMax(const Matrix& b) const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = std::max(this->data()[i], b.data()[i]);
  return c;
}
Matrix cwiseAbs() const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = std::abs(this->data()[i]);
  return c;
}
Matrix cwiseInverse() const requires is_small {
  Matrix c;
  for (int i = 0; i < SizeAtCompileTime; ++i) c.data()[i] = Scalar(1) / this->data()[i];
  return c;
}

Matrix& operator+=(const Matrix& b) requires is_small {
  for (int i = 0; i < SizeAtCompileTime; ++i) this->data()[i] += b.data()[i];
  return *this;
}
Matrix& operator-=(const Matrix& b) requires is_small {
  for (int i = 0; i < SizeAtCompileTime; ++i) this->data()[i] -= b.data()[i];
  return *this;
}

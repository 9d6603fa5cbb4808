#include "friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tests {

Matrix diagonal(double n, double t, double s) { return Vector{{n, t, s}}.asDiagonal(); }

Matrix leaning_rod() {
  // K = [1 + 3 cos², 3 sin cos; 3 sin cos, 1 + 3 sin²] with cos² = 1/5.
  return Matrix{{1.6, 1.2, 0.0}, {1.2, 3.4, 0.0}, {0.0, 0.0, 1.0}};
}

Falling falling_box(const Vec3& sides, const Vec3& velocity, const Vec3& spin) {
  // Mass 1; the inertia about x is (y² + z²)/12.
  const Vec3 squares = sides.cwiseProduct(sides);
  const Vec3 inertia = (Vec3::Constant(squares.sum()) - squares) / 12.0;
  Matrix J(12, 6);
  const common::Mat3 axes{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};  // n, t, s
  for (int corner = 0; corner < 4; ++corner) {
    const Vec3 r(corner % 2 == 0 ? sides.x() / 2.0 : -sides.x() / 2.0,
                 corner < 2 ? sides.y() / 2.0 : -sides.y() / 2.0, -sides.z() / 2.0);
    for (int k = 0; k < 3; ++k) {
      const Vec3 axis = axes.row(k);
      J.row(3 * corner + k) << axis.transpose(), r.cross(axis).transpose();
    }
  }
  Vector W(6);
  W << 1.0, 1.0, 1.0, inertia.cwiseInverse();
  Vector v(6);
  v << velocity, spin;
  Falling box{J * W.asDiagonal() * J.transpose(), J * v};
  box.A = (0.5 * (box.A + box.A.transpose())).eval();
  return box;
}

std::vector<Bad<ContactSystem>> bad_triples() {
  const Matrix A = leaning_rod();
  const Vector b{{-1.0, 2.0, 0.5}};
  const auto entry = [&](Eigen::Index i, Eigen::Index j, double value) {
    Matrix changed = A;
    changed(i, j) = value;
    return changed;
  };
  std::vector<Bad<ContactSystem>> all{
      {{entry(0, 0, not_a_number), b}, "an entry of A is NaN"},
      {{entry(2, 2, infinite), b}, "an entry of A is infinite"},
      {{entry(0, 1, 1.2 + 1e-8), b}, "A is not symmetric to 1e-9 of its largest entry"},
      {{entry(2, 0, 1.0), b}, "A is not symmetric"},
      {{entry(1, 1, 0.0), b}, "A has 0 on its diagonal"},
      {{entry(2, 2, -1.0), b}, "A has a number below zero on its diagonal"},
      {{Matrix(A.topRows(2)), b}, "A is not square"},
      {{Matrix(A.leftCols(2)), b}, "A is not square"},
      {{A, Vector{{-1.0, not_a_number, 0.0}}}, "an entry of b is NaN"},
      {{A, Vector{{-infinite, 0.0, 0.0}}}, "an entry of b is infinite"},
      {{A, Vector{{-1.0, 0.0}}}, "b has too few entries"},
      {{A, Vector::Zero(6)}, "b has too many entries"}};
  for (const Eigen::Index rows : {1, 2, 4, 5}) {
    all.push_back({{Matrix::Identity(rows, rows), -Vector::Ones(rows)},
                   "there are three rows for each contact"});
  }
  return all;
}

std::vector<Bad<Vector>> bad_triple_vectors() {
  return {{Vector{{not_a_number, 0.0, 0.0}}, "an entry is NaN"},
          {Vector{{0.0, infinite, 0.0}}, "an entry is infinite"},
          {Vector{{0.0, 0.0, -infinite}}, "an entry is infinite"},
          {Vector{{1.0, 0.0}}, "it has too few entries"},
          {Vector::Zero(6), "it has too many entries"},
          {Vector(0), "it has no entries"}};
}

Sweeping random_sweeping(Random& random, int contacts) {
  // G Gᵀ of as many columns as rows, and a third for all: no tangential block is a number.
  const int rows = 3 * contacts;
  Matrix G(rows, rows);
  Sweeping in{Matrix(), Vector(rows), Vector(rows)};
  for (int i = 0; i < rows; ++i) {
    in.b[i] = random.uniform(-2.0, i % 3 == 0 ? 0.5 : 2.0);
    in.start[i] = random.uniform(-0.5, 1.0);
    for (int j = 0; j < rows; ++j) G(i, j) = random.uniform(-1.0, 1.0) / contacts;
  }
  in.A = G * G.transpose() + Matrix::Identity(rows, rows) / 3.0;
  in.A = (0.5 * (in.A + in.A.transpose())).eval();
  in.friction = random.uniform(0.1, 1.0);
  return in;
}

}  // namespace tests

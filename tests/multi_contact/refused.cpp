#include "refused.hpp"

namespace tests {

std::vector<Bad<ContactSystem>> bad_systems() {
  const Matrix A = good_system().A;
  const Vector u = good_system().u;
  const auto entry = [&](Eigen::Index i, Eigen::Index j, double value) {
    Matrix changed = A;
    changed(i, j) = value;
    return changed;
  };
  const Matrix half_known{{2.0, not_a_number}, {not_a_number, 2.0}};
  const Matrix half_infinite{{2.0, infinite}, {infinite, 2.0}};
  return {{{entry(0, 0, not_a_number), u}, "an entry of A is NaN"},
          {{entry(1, 1, infinite), u}, "an entry of A is infinite"},
          {{half_known, u}, "entries of A are NaN"},
          {{half_infinite, u}, "entries of A are infinite"},
          {{entry(0, 1, -1.0 + 1e-8), u}, "A is not symmetric to 1e-9 of its largest entry"},
          {{entry(1, 0, 1.0), u}, "A is not symmetric"},
          {{entry(0, 0, 0.0), u}, "A has 0 on its diagonal"},
          {{entry(1, 1, -2.0), u}, "A has a number below zero on its diagonal"},
          {{Matrix(A.topRows(1)), u}, "A is not square"},
          {{Matrix(A.leftCols(1)), u}, "A is not square"},
          {{A, Vector{{-1.0, not_a_number}}}, "an entry of the vector is NaN"},
          {{A, Vector{{-infinite, 0.0}}}, "an entry of the vector is infinite"},
          {{A, Vector{{-1.0}}}, "the vector has too few entries"},
          {{A, Vector{{-1.0, 0.0, 0.0}}}, "the vector has too many entries"},
          {{A, Vector(0)}, "the vector has no entries"},
          {{Matrix(0, 0), u}, "A has no entries"}};
}

std::vector<Bad<Vector>> bad_vectors() {
  return {{Vector{{not_a_number, 0.0}}, "an entry is NaN"},
          {Vector{{0.0, infinite}}, "an entry is infinite"},
          {Vector{{0.0, -infinite}}, "an entry is infinite"},
          {Vector{{1.0}}, "it has too few entries"},
          {Vector{{0.0, 0.0, 0.0}}, "it has too many entries"},
          {Vector(0), "it has no entries"}};
}

std::vector<Bad<double>> bad_fractions() {
  return {{-0x1p-1000, "e is from 0 to 1"}, {-1.0, "e is from 0 to 1"},
          {1.0 + eps, "e is from 0 to 1"},  {2.0, "e is from 0 to 1"},
          {not_a_number, "e is NaN"},       {infinite, "e is infinite"},
          {-infinite, "e is infinite"}};
}

std::vector<Bad<double>> bad_not_negative() {
  return {{-0x1p-1000, "it is not below zero"},
          {-1.0, "it is not below zero"},
          {not_a_number, "it is NaN"},
          {infinite, "it is infinite"}};
}

}  // namespace tests

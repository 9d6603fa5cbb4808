#include "common/exact/exact_path.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace common {

ExactPath exact_path(const Vec3& x, const Vec3& v, double duration) {
  return {{x.y(), ExactNumber(v.y()) * duration}, {x.z(), ExactNumber(v.z()) * duration}};
}

ExactPath operator-(const ExactPath& a, const ExactPath& b) { return {a.y - b.y, a.z - b.z}; }

ExactPolynomial dot(const ExactPath& a, const ExactPath& b) { return a.y * b.y + a.z * b.z; }

ExactPolynomial cross(const ExactPath& a, const ExactPath& b) { return a.y * b.z - a.z * b.y; }

Bernstein<DoubleDouble, 4> bernstein(const ExactPolynomial& polynomial) {
  // What the coefficient of t^j counts in 12 B_i: 12 C(i, j)/C(4, j).
  constexpr std::array<std::array<double, 5>, 5> weights{{{12.0},
                                                          {12.0, 3.0},
                                                          {12.0, 6.0, 2.0},
                                                          {12.0, 9.0, 6.0, 3.0},
                                                          {12.0, 12.0, 12.0, 12.0, 12.0}}};
  std::array<ExactNumber, 5> exact;
  int largest = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = 0; j <= i && j < polynomial.size(); ++j) {
      exact[i] = exact[i] + polynomial[j] * weights[i][j];
    }
    if (exact[i].sign() != 0) largest = std::max(largest, exact[i].exponent());
  }
  Bernstein<DoubleDouble, 4> coefficients{};
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (exact[i].sign() != 0) coefficients[i] = exact[i].rounded(-largest);
  }
  return coefficients;
}

}  // namespace common

#include "oracle.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace tests {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Set = std::uint32_t;  ///< of contacts, one bit each

template <typename Number>
using Rows = std::vector<std::vector<Number>>;

bool is_in(Set set, std::size_t i) { return ((set >> i) & 1U) != 0; }

/// A and b with the entries of a set alone, side by side; the others get the row of a λ_i = 0.
template <typename Number>
Rows<Number> rows_of(const Matrix& A, const Vector& b, Set set) {
  const auto m = static_cast<std::size_t>(b.size());
  Rows<Number> rows(m, std::vector<Number>(m + 1, Number(0)));
  for (std::size_t i = 0; i < m; ++i) {
    rows[i][i] = 1;
    if (!is_in(set, i)) continue;
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < m; ++j) {
      rows[i][j] =
          is_in(set, j) ? static_cast<Number>(A(row, static_cast<Eigen::Index>(j))) : Number(0);
    }
    rows[i][m] = -static_cast<Number>(b[row]);
  }
  return rows;
}

/// Elimination without a change of rows: on a positive definite matrix all pivots are above zero.
/// Empty if one is not above `zero`.
template <typename Number>
std::vector<Number> solved(Rows<Number> rows, Set set, const Number& zero) {
  const std::size_t m = rows.size();
  for (std::size_t k = 0; k < m; ++k) {
    if (!is_in(set, k)) continue;
    if (!(rows[k][k] > zero)) return {};
    for (std::size_t i = 0; i < m; ++i) {
      if (i == k || !is_in(set, i)) continue;
      const Number factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= m; ++j) {
        if (j == m || is_in(set, j)) rows[i][j] -= factor * rows[k][j];
      }
    }
  }
  std::vector<Number> x(m, Number(0));
  for (std::size_t k = 0; k < m; ++k) {
    if (is_in(set, k)) x[k] = rows[k][m] / rows[k][k];
  }
  return x;
}

template <typename Number>
std::vector<Number> row_sums(const Matrix& A, const std::vector<Number>& lambda, const Vector& b) {
  std::vector<Number> sums;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    auto sum = static_cast<Number>(b[i]);
    for (Eigen::Index j = 0; j < b.size(); ++j) {
      const Number& x = lambda[static_cast<std::size_t>(j)];
      if (x != 0) sum += static_cast<Number>(A(i, j)) * x;
    }
    sums.push_back(sum);
  }
  return sums;
}

/// Whether λ is a solution, but for `slack`.
template <typename Number>
bool obeys(const std::vector<Number>& lambda, const std::vector<Number>& u,
           const Number& slack_of_lambda, const Number& slack_of_u) {
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    if (lambda[i] < -slack_of_lambda || u[i] < -slack_of_u) return false;
  }
  return true;
}

Vector rounded(const std::vector<Rational>& numbers) {
  Vector result(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    result[static_cast<Eigen::Index>(i)] = numbers[i].convert_to<double>();
  }
  return result;
}

/// Whether long double says that the set may be the one. It only saves the work of all the others.
bool is_promising(const Matrix& A, const Vector& b, Set set) {
  constexpr Real rounding = 1e-12L;
  const Real size_of_A = wide(A.cwiseAbs().maxCoeff());
  const std::vector<Real> lambda = solved(rows_of<Real>(A, b, set), set, rounding * size_of_A);
  if (lambda.empty()) return false;
  Real largest = 0;
  for (const Real x : lambda) largest = std::max(largest, std::abs(x));
  const Real size_of_b = wide(b.cwiseAbs().maxCoeff());
  return obeys(lambda, row_sums(A, lambda, b), rounding * largest,
               rounding * (size_of_b + size_of_A * largest));
}

}  // namespace

std::optional<Solution> exact_solution(const Matrix& A, const Vector& b) {
  if (b.size() == 0) return Solution{b, b};
  for (Set set = 0; set < (Set{1} << static_cast<unsigned>(b.size())); ++set) {
    if (!is_promising(A, b, set)) continue;
    const std::vector<Rational> lambda = solved(rows_of<Rational>(A, b, set), set, Rational(0));
    if (lambda.empty()) continue;
    std::vector<Rational> u = row_sums(A, lambda, b);
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (is_in(set, i)) u[i] = 0;  // it is, and no work shows it
    }
    if (obeys(lambda, u, Rational(0), Rational(0))) return Solution{rounded(lambda), rounded(u)};
  }
  return std::nullopt;
}

Vector exact_row_sums(const Matrix& A, const Vector& lambda, const Vector& b) {
  if (!lambda.allFinite() || !A.allFinite() || !b.allFinite()) {
    return Vector::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
  }
  std::vector<Rational> entries;
  for (const double x : lambda) entries.emplace_back(x);
  return rounded(row_sums(A, entries, b));
}

}  // namespace tests

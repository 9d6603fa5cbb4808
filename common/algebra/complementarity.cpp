#include "common/algebra/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace common {
namespace {

using Eigen::Index;

/// D A D and D b with D = diag(A)^(-1/2): masses of any ratio look alike. The largest |b_i| is 1.
struct Scaled {
  double size;
  Vector D;
  Matrix A;
  Vector b;

  Scaled(const Matrix& given, const Vector& rhs)
      : size(largest_entry(rhs)),
        D(given.diagonal().cwiseSqrt().cwiseInverse()),
        A(given),
        b(D.cwiseProduct(rhs) / (size > 0.0 ? size : 1.0)) {
    for (Index i = 0; i < b.size(); ++i) {
      for (Index j = 0; j < b.size(); ++j) A(i, j) *= D[i] * D[j];
    }
  }
  [[nodiscard]] Vector unscaled(const Vector& x) const { return D.cwiseProduct(x) * size; }

  /// Row i of A x + b.
  [[nodiscard]] double row(int i, const Vector& x) const { return row_product(A, i, x) + b[i]; }
  /// What of it is as good as zero: `share` of the largest |b_k|, or rounding of what adds up.
  [[nodiscard]] double zero(int i, const Vector& x, double share) const {
    double sum = 0.0;
    for (Index k = 0; k < x.size(); ++k) sum += std::abs(A(i, k) * x[k]);
    return std::max(share * D[i], 1e-12 * sum);
  }
};

/// Rows of A that do not depend on each other, and A = L Lᵀ on them, in the order in which they
/// came.
class Independent {
 public:
  explicit Independent(const Matrix& A) : A_(A), L_(Matrix::Zero(A.rows(), A.rows())) {}

  [[nodiscard]] const std::vector<int>& rows() const { return rows_; }

  /// Takes row j in. If it depends on those that are in, it stays out, and what is returned has an
  /// entry for each of them: with these of theirs and 1 of row j, A gives zero. Else it is empty.
  Vector admit(int j, double rounding = 1e-13) {
    const Vector row = forward(entries(A_.col(j), rows_));
    Vector others = -back(row);
    const double pivot = A_(j, j) - row.dot(row);
    const double length = 1.0 + others.cwiseAbs().sum();
    if (pivot <= rounding * length * length) return others;
    const auto count = static_cast<Index>(rows_.size());
    for (Index k = 0; k < count; ++k) L_(count, k) = row[k];
    L_(count, count) = std::sqrt(pivot);
    rows_.push_back(j);
    return Vector(0);
  }

  /// Begins anew with these, which are independent.
  void replace(const std::vector<int>& rows) {
    rows_.clear();
    for (int j : rows) admit(j, 1e-15);
  }

  /// x with A x = b on these rows, an entry for each of them.
  [[nodiscard]] Vector solution(const Vector& b) const { return back(forward(entries(b, rows_))); }

 private:
  /// L⁻¹ x and L⁻ᵀ x.
  [[nodiscard]] Vector forward(Vector x) const {
    for (Index k = 0; k < x.size(); ++k) {
      x[k] /= L_(k, k);
      for (Index i = k + 1; i < x.size(); ++i) x[i] -= L_(i, k) * x[k];
    }
    return x;
  }
  [[nodiscard]] Vector back(Vector x) const {
    for (Index k = x.size() - 1; k >= 0; --k) {
      for (Index i = k + 1; i < x.size(); ++i) x[k] -= L_(i, k) * x[i];
      x[k] /= L_(k, k);
    }
    return x;
  }

  const Matrix& A_;
  std::vector<int> rows_;
  Matrix L_;
};

/// The least of λ·(A λ/2 + b) over λ ≥ 0. The entries above zero are those of independent rows.
class ActiveSet {
 public:
  explicit ActiveSet(const Scaled& system)
      : system_(system), lambda_(Vector::Zero(system.b.size())), in_(system.A) {}

  Vector solution() {
    std::vector<bool> barred(static_cast<std::size_t>(lambda_.size()), false);
    const Index most_steps = 100 * (lambda_.size() + 1);
    for (Index step = 0; step < most_steps; ++step) {
      const int j = steepest(barred);
      if (j < 0) return lambda_;
      const Vector others = in_.admit(j);
      if (in_.rows().empty() || in_.rows().back() != j) slide(j, others);
      settle();
      if (lambda_[j] == 0.0) drop_zeros(in_.rows());
      // Each step lowers the energy, so no set comes twice. Where rounding alone says that j helps,
      // it waits until something else has.
      if (lambda_[j] > 0.0) barred.assign(barred.size(), false);
      barred[static_cast<std::size_t>(j)] = lambda_[j] == 0.0;
    }
    throw std::runtime_error("complementary: the active set does not settle");
  }

 private:
  /// Which λ_j is best raised from zero; −1 if none.
  [[nodiscard]] int steepest(const std::vector<bool>& barred) const {
    double least = 0.0;
    int best = -1;
    for (int j = 0; j < lambda_.size(); ++j) {
      if (lambda_[j] > 0.0 || barred[static_cast<std::size_t>(j)]) continue;
      const double gradient = system_.row(j, lambda_);
      if (gradient >= least || gradient >= -system_.zero(j, lambda_, 1e-12)) continue;
      least = gradient;
      best = j;
    }
    return best;
  }

  /// Goes from λ by so much, and up to where the first entry is zero; false if none is by then.
  bool go(const std::vector<int>& rows, const Vector& change, double most) {
    int first = -1;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const double by = change[static_cast<Index>(k)];
      if (by >= 0.0 || lambda_[rows[k]] > -by * most) continue;
      most = lambda_[rows[k]] / -by;
      first = rows[k];
    }
    if (std::isinf(most)) throw std::domain_error("complementary: nothing keeps these open");
    for (std::size_t k = 0; k < rows.size(); ++k) {
      lambda_[rows[k]] = std::max(0.0, lambda_[rows[k]] + most * change[static_cast<Index>(k)]);
    }
    if (first >= 0) lambda_[first] = 0.0;
    return first >= 0;
  }

  /// Down along the direction of no resistance, 1 of j and so much of the others, until one of them
  /// is zero: it leaves.
  void slide(int j, const Vector& others) {
    std::vector<int> rows = in_.rows();
    rows.push_back(j);
    Vector change = Vector::Ones(others.size() + 1);
    const double rounding = 1e-12 * (1.0 + others.cwiseAbs().sum());
    for (Index k = 0; k < others.size(); ++k) {
      change[k] = std::abs(others[k]) <= rounding ? 0.0 : others[k];  // it does not depend on that
    }
    go(rows, change, HUGE_VAL);
    drop_zeros(rows);
  }

  /// To where A λ + b is zero on the rows that are in; who reaches zero on the way leaves.
  void settle() {
    for (;;) {
      const std::vector<int> rows = in_.rows();
      const Vector wanted = -in_.solution(system_.b);
      if (!go(rows, wanted - entries(lambda_, rows), 1.0)) return;
      drop_zeros(rows);
    }
  }

  void drop_zeros(std::vector<int> rows) {
    std::erase_if(rows, [&](int i) { return lambda_[i] == 0.0; });
    in_.replace(rows);
  }

  const Scaled& system_;
  Vector lambda_;
  Independent in_;
};

/// x less what it has along each of the directions.
Vector without(Vector x, std::vector<Vector> directions) {
  for (int again = 0; again < 2; ++again) {  // the second time for rounding
    for (std::size_t k = 0; k < directions.size(); ++k) {
      Vector& way = directions[k];
      for (std::size_t i = 0; i < k; ++i) way -= directions[i].dot(way) * directions[i];
      way /= way.norm();
    }
  }
  for (const Vector& way : directions) x -= way.dot(x) * way;
  return x;
}

}  // namespace

Vector complementary(const Matrix& A, const Vector& b) {
  require_system(A, b);
  const Scaled scaled(A, b);
  if (scaled.size == 0.0) return Vector::Zero(b.size());
  return scaled.unscaled(ActiveSet(scaled).solution());
}

Vector least_norm_solution(const Matrix& A, const Vector& b) {
  require_system(A, b);
  const Scaled scaled(A, b);
  if (scaled.size == 0.0) return Vector::Zero(b.size());
  Independent rows(scaled.A);
  std::vector<Vector> unnoticed;  // directions along which A gives zero
  for (int j = 0; j < b.size(); ++j) {
    const Vector others = rows.admit(j);
    if (!rows.rows().empty() && rows.rows().back() == j) continue;
    Vector way = spread(others, rows.rows(), b.size());
    way[j] = 1.0;
    way = scaled.D.cwiseProduct(way);
    unnoticed.emplace_back(way / largest_entry(way));
  }
  Vector x = Vector::Zero(b.size());
  for (int round = 0; round < 3; ++round) {  // after the first it is rounding that goes
    const Vector rest = scaled.b - product(scaled.A, x);
    x += spread(rows.solution(rest), rows.rows(), b.size());
    if (round == 0) x = without(scaled.D.cwiseProduct(x), unnoticed).cwiseQuotient(scaled.D);
  }
  for (int i = 0; i < b.size(); ++i) {
    if (std::abs(scaled.row(i, x) - 2.0 * scaled.b[i]) <= scaled.zero(i, x, 1e-9)) continue;
    throw std::domain_error("least_norm_solution: no impulses stop these contacts");
  }
  return scaled.unscaled(x);
}

}  // namespace common

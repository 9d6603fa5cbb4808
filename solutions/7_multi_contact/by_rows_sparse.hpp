#pragma once

#include <vector>

#include "multi_contact.hpp"

/// Of by_rows.cpp: A without its zeros. A ball meets twelve others at most, so in a pile nearly all
/// of A is zero, and its rows stay short however many contacts there are.
namespace lab::multi_contact::by_rows {

class SparseRows {
 public:
  explicit SparseRows(const Matrix& A) {
    for (int i = 0; i < A.rows(); ++i) {
      for (int k = 0; k < A.cols(); ++k) {
        if (A(i, k) != 0.0) entries_.push_back({k, A(i, k)});
      }
      ends_.push_back(entries_.size());
    }
  }

  [[nodiscard]] Vector times(const Vector& x) const {
    Vector result(x.size());
    std::size_t at = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      double sum = 0.0;
      for (; at < ends_[i]; ++at) sum += entries_[at].value * x[entries_[at].column];
      result[static_cast<Eigen::Index>(i)] = sum;
    }
    return result;
  }

  /// u ← u + A_i times the change. A is symmetric, so its column i is its row i.
  void add_column(std::size_t i, double change, Vector& u) const {
    for (std::size_t at = i == 0 ? 0 : ends_[i - 1]; at < ends_[i]; ++at) {
      u[entries_[at].column] += change * entries_[at].value;
    }
  }

 private:
  struct Entry {
    int column;
    double value;
  };
  std::vector<Entry> entries_;
  std::vector<std::size_t> ends_;  // of row i: where row i + 1 begins
};

}  // namespace lab::multi_contact::by_rows

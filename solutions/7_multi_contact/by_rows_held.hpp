#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "multi_contact.hpp"

/// Of by_rows.cpp: solvers of its own in place of those that are supplied.
namespace lab::multi_contact::by_rows {

using common::block;
using common::entries;
using common::product;
using common::spread;

/// The shortest x with A x = b, by conjugate directions, which never leave the range of A; each is
/// set against all before, so rounding does not pile up.
inline Vector shortest(const Matrix& A, const Vector& b) {
  Vector x = Vector::Zero(b.size());
  Vector rest = b;
  const double unit = common::largest_entry(b);
  std::vector<std::pair<Vector, Vector>> ways;  // p, and A p/(p·A p)
  for (Eigen::Index k = 0; k < 2 * b.size() && common::largest_entry(rest) > 1e-15 * unit; ++k) {
    Vector p = rest;
    for (int again = 0; again < 2; ++again) {
      for (const auto& [way, A_way] : ways) p -= A_way.dot(p) * way;
    }
    const Vector A_p = product(A, p);
    if (!(p.dot(A_p) > 1e-14 * p.squaredNorm() * A.diagonal().minCoeff())) break;
    ways.emplace_back(p, A_p / p.dot(A_p));
    x += p.dot(rest) / p.dot(A_p) * p;
    rest = b - product(A, x);
  }
  const Vector rounding = 1e-12 * product(A.cwiseAbs(), x.cwiseAbs());
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    if (std::abs(rest[i]) <= std::max(1e-9 * unit, rounding[i])) continue;
    throw std::domain_error("no impulses stop these contacts");
  }
  return x;
}

/// 0 ≤ λ, A λ + b ≥ 0, λ·(A λ + b) = 0 by the method of Goldfarb and Idnani: what is worst broken
/// is pressed until it holds, while those that already press keep still or let go.
class Held {
 public:
  Held(const Matrix& A, const Vector& b)
      : root_(A.diagonal().cwiseSqrt()), A_(A), b_(b), lambda_(Vector::Zero(b.size())) {
    for (Eigen::Index i = 0; i < b.size(); ++i) {  // a contact's own entry becomes 1
      A_.row(i) /= root_[i];
      A_.col(i) /= root_[i];
      b_[i] /= root_[i];
    }
  }

  Vector solution() {
    const double unit = 1e-12 * common::largest_entry(b_.cwiseProduct(root_));
    for (Eigen::Index turn = 0; turn < 100 * (b_.size() + 1); ++turn) {
      const Vector u = product(A_, lambda_) + b_;
      const Vector rounding = 1e-12 * product(A_.cwiseAbs(), lambda_);
      int worst = -1;
      for (int i = 0; i < u.size(); ++i) {
        if (u[i] >= -std::max(unit / root_[i], rounding[i])) continue;
        if (worst < 0 || u[i] < u[worst]) worst = i;
      }
      if (worst < 0) break;
      press(worst);
    }
    return lambda_.cwiseQuotient(root_);
  }

 private:
  void press(int i) {
    for (;;) {
      const Vector row = entries(A_.col(i), pressing_);
      // What the others lose of their impulse for 1 more of this one.
      const Vector give = shortest(block(A_, pressing_), row);
      const double yields = 1.0 - row.dot(give);
      const double size = 1.0 + give.cwiseAbs().sum();
      double way = std::numeric_limits<double>::infinity();
      if (yields > 1e-13 * size * size) {
        way = -(common::row_product(A_, i, lambda_) + b_[i]) / yields;
      }
      int leaves = -1;
      Eigen::Index k = 0;
      for (int j : pressing_) {
        const double lost = give[k++];
        if (lost <= 1e-12 * size || lambda_[j] / lost >= way) continue;
        way = lambda_[j] / lost;
        leaves = j;
      }
      if (std::isinf(way)) throw std::domain_error("no impulses keep these contacts open");
      lambda_[i] += way;
      lambda_ -= way * spread(give, pressing_, lambda_.size());
      if (leaves < 0) break;
      lambda_[leaves] = 0.0;
      std::erase(pressing_, leaves);
    }
    pressing_.push_back(i);
    shed_rounding();
  }

  void shed_rounding() {
    const Vector u = product(A_, lambda_) + b_;
    const Vector change = shortest(block(A_, pressing_), entries(u, pressing_));
    lambda_ = (lambda_ - spread(change, pressing_, lambda_.size())).cwiseMax(0.0);
    std::erase_if(pressing_, [&](int k) { return lambda_[k] == 0.0; });
  }

  Vector root_;
  Matrix A_;
  Vector b_;
  Vector lambda_;
  std::vector<int> pressing_;
};

}  // namespace lab::multi_contact::by_rows

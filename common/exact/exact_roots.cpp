#include "common/exact/exact_roots.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace common {
namespace {

/// Without leading zeros: the zero polynomial has no coefficient.
ExactPolynomial trimmed(ExactPolynomial a) {
  while (!a.empty() && a.back().sign() == 0) a.pop_back();
  return a;
}

ExactPolynomial derivative(const ExactPolynomial& a) {
  ExactPolynomial slope;
  for (std::size_t i = 1; i < a.size(); ++i) slope.push_back(a[i] * static_cast<double>(i));
  return slope;
}

/// −a mod b, times a number above zero.
ExactPolynomial opposite_remainder(ExactPolynomial a, const ExactPolynomial& b) {
  const bool negative = b.back().sign() < 0;
  const ExactNumber size = negative ? 0.0 - b.back() : b.back();
  while (a.size() >= b.size()) {
    const ExactNumber factor = negative ? 0.0 - a.back() : a.back();
    const std::size_t shift = a.size() - b.size();
    for (ExactNumber& coefficient : a) coefficient = coefficient * size;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] = a[i + shift] - factor * b[i];
    a = trimmed(std::move(a));
  }
  return ExactPolynomial{} - a;
}

std::vector<ExactPolynomial> remainders(const ExactPolynomial& first,
                                        const ExactPolynomial& second) {
  std::vector<ExactPolynomial> chain;
  for (ExactPolynomial a = trimmed(first), b = trimmed(second); !a.empty();) {
    ExactPolynomial next = b.empty() ? b : opposite_remainder(a, b);
    chain.push_back(std::move(a));
    a = std::move(b);
    b = std::move(next);
  }
  return chain;
}

/// The sign just after t.
int sign_after(const ExactPolynomial& a, double t) {
  if (a.empty()) return 0;
  ExactNumber value;
  for (std::size_t i = a.size(); i-- > 0;) value = value * t + a[i];
  return value.sign() != 0 ? value.sign() : sign_after(derivative(a), t);
}

int changes_of_sign(const std::vector<ExactPolynomial>& chain, double t) {
  int changes = 0;
  int last = 0;
  for (const ExactPolynomial& polynomial : chain) {
    const int sign = sign_after(polynomial, t);
    if (sign * last < 0) ++changes;
    last = sign;
  }
  return changes;
}

}  // namespace

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b) {
  if (a.empty() || b.empty()) return {};
  ExactPolynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) product[i + j] = product[i + j] + a[i] * b[j];
  }
  return product;
}

ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b) {
  return a - (ExactPolynomial{} - b);
}

ExactPolynomial operator-(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial difference = a;
  difference.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) difference[i] = difference[i] - b[i];
  return difference;
}

ExactRoots::ExactRoots(const ExactPolynomial& f, const ExactPolynomial& g)
    : roots_(remainders(f, derivative(f))) {
  if (g.size() > 1 || g[0].sign() <= 0) signs_ = remainders(f, derivative(f) * g);
}

int ExactRoots::count(double from, double to) const {
  const auto passed = [&](const Chain& chain) {
    return changes_of_sign(chain, from) - changes_of_sign(chain, to);
  };
  const int roots = passed(roots_);
  if (roots == 0 || signs_.empty()) return roots;
  // (all + (above − below)) / 2; a root where g = 0 is in the first only, and is rounded off.
  return (roots + passed(signs_)) / 2;
}

double ExactRoots::first(double from, double to, double width) const {
  while (to - from > width) {
    const double middle = from + 0.5 * (to - from);
    if (middle == from || middle == to) break;
    (count(from, middle) > 0 ? to : from) = middle;
  }
  return to;
}

}  // namespace common

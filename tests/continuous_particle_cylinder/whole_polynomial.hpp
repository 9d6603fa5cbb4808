#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <utility>
#include <vector>

/// Polynomials in whole numbers, without any rounding: each real root is known by an interval that
/// holds no other, a double one too.
namespace tests {

using Whole = boost::multiprecision::cpp_int;
/// Coefficients of 1, τ, τ², ... without leading zeros.
using WholePolynomial = std::vector<Whole>;

inline WholePolynomial trimmed(WholePolynomial a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
  return a;
}

inline WholePolynomial sum(const WholePolynomial& a, const WholePolynomial& b, int factor = 1) {
  WholePolynomial result = a;
  result.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) result[i] += factor * b[i];
  return trimmed(result);
}

inline WholePolynomial product(const WholePolynomial& a, const WholePolynomial& b) {
  WholePolynomial result(a.size() + b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return trimmed(result);
}

/// a = (quotient b + rest) / k with a whole k above zero.
inline std::pair<WholePolynomial, WholePolynomial> divided(WholePolynomial a,
                                                           const WholePolynomial& b) {
  WholePolynomial quotient(a.size() < b.size() ? 0 : a.size() - b.size() + 1);
  const Whole size = abs(b.back());
  while (a.size() >= b.size()) {
    const Whole factor = a.back() * b.back().sign();
    const std::size_t shift = a.size() - b.size();
    for (Whole& q : quotient) q *= size;
    quotient[shift] += factor;
    for (Whole& x : a) x *= size;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    a = trimmed(a);
  }
  return {quotient, a};
}

inline WholePolynomial derivative(const WholePolynomial& a) {
  WholePolynomial slope;
  for (std::size_t i = 1; i < a.size(); ++i) slope.push_back(a[i] * i);
  return slope;
}

/// Without the divisor that all coefficients share, so that numbers stay short.
inline WholePolynomial primitive(WholePolynomial a) {
  Whole shared = 0;
  for (const Whole& x : a) shared = gcd(shared, x);
  for (Whole& x : a) x /= shared;
  return a;
}

inline WholePolynomial common_divisor(WholePolynomial a, WholePolynomial b) {
  while (!b.empty()) {
    WholePolynomial rest = primitive(divided(a, b).second);
    a = std::exchange(b, std::move(rest));
  }
  return primitive(a);
}

/// place / 2^depth.
struct Dyadic {
  Whole place;
  unsigned depth = 0;
};

inline int sign_at(const WholePolynomial& a, const Dyadic& x) {
  Whole value = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    value = value * x.place + (a[i] << static_cast<unsigned>(x.depth * (a.size() - 1 - i)));
  }
  return value.sign();
}

/// The distinct real roots of a polynomial, by Sturm's chain of its square-free part.
class Roots {
 public:
  explicit Roots(const WholePolynomial& polynomial) {
    if (polynomial.empty()) return;
    const WholePolynomial repeated = common_divisor(polynomial, derivative(polynomial));
    chain_.push_back(primitive(divided(polynomial, repeated).first));
    chain_.push_back(derivative(chain_[0]));
    while (!chain_.back().empty()) {
      WholePolynomial rest = primitive(divided(chain_[chain_.size() - 2], chain_.back()).second);
      for (Whole& x : rest) x = -x;
      chain_.push_back(std::move(rest));
    }
    chain_.pop_back();
  }

  /// In (from, to].
  [[nodiscard]] int count(const Dyadic& from, const Dyadic& to) const {
    return changes(from) - changes(to);
  }

 private:
  [[nodiscard]] int changes(const Dyadic& x) const {
    int count = 0;
    int last = 0;
    for (const WholePolynomial& polynomial : chain_) {
      const int sign = sign_at(polynomial, x);
      if (sign == 0) continue;
      if (sign == -last) ++count;
      last = sign;
    }
    return count;
  }

  std::vector<WholePolynomial> chain_;
};

/// (place, place + 1] / 2^depth holds one root.
struct Cell {
  Whole place;
  unsigned depth = 0;

  [[nodiscard]] Dyadic from() const { return {place, depth}; }
  [[nodiscard]] Dyadic to() const { return {place + 1, depth}; }
};

inline void halve(Cell& cell, const Roots& roots) {
  Cell first{2 * cell.place, cell.depth + 1};
  const bool in_first = roots.count(first.from(), first.to()) > 0;
  if (!in_first) ++first.place;
  cell = first;
}

inline void isolate(const Roots& roots, const Cell& cell, std::vector<Cell>& found) {
  const int count = roots.count(cell.from(), cell.to());
  if (count == 1) found.push_back(cell);
  if (count <= 1) return;
  isolate(roots, {2 * cell.place, cell.depth + 1}, found);
  isolate(roots, {2 * cell.place + 1, cell.depth + 1}, found);
}

/// Rising, each in a cell of (0, 1].
inline std::vector<Cell> cells_of(const Roots& roots) {
  std::vector<Cell> found;
  isolate(roots, {0, 0}, found);
  return found;
}

/// The sign of another polynomial at the root in the cell, which is narrowed as far as need be.
inline int sign_at_root(const WholePolynomial& f, const Roots& f_roots, Cell& cell,
                        const WholePolynomial& g) {
  if (g.empty()) return 0;
  if (Roots(common_divisor(f, g)).count(cell.from(), cell.to()) > 0) return 0;
  const Roots g_roots(g);
  while (g_roots.count(cell.from(), cell.to()) > 0) halve(cell, f_roots);
  return sign_at(g, cell.to());  // no root up to there, nor there
}

/// The root in the cell to 2⁻⁷⁰, which is less than any bound here asks for.
inline double middle_of(Cell cell, const Roots& roots) {
  while (cell.depth < 70) halve(cell, roots);
  return std::ldexp(static_cast<double>(Whole(2 * cell.place + 1)), -71);
}

}  // namespace tests

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

/// Times 2^(depth · degree).
inline Whole value_at(const WholePolynomial& a, const Dyadic& x) {
  Whole value = 0;
  for (std::size_t i = a.size(); i-- > 0;) {
    value *= x.place;
    value += a[i] << static_cast<unsigned>(x.depth * (a.size() - 1 - i));
  }
  return value;
}
inline int sign_at(const WholePolynomial& a, const Dyadic& x) { return value_at(a, x).sign(); }

/// The distinct real roots of a polynomial, by Sturm's chain of its square-free part.
class Roots {
 public:
  explicit Roots(const WholePolynomial& polynomial) {
    if (polynomial.empty()) return;
    chain_ = sturm_chain(polynomial);
    // The chain ends with the divisor that the polynomial shares with its slope: what repeats.
    if (chain_.back().size() == 1) return;
    chain_ = sturm_chain(primitive(divided(polynomial, chain_.back()).first));
  }

  /// In (from, to].
  [[nodiscard]] int count(const Dyadic& from, const Dyadic& to) const {
    return changes(from) - changes(to);
  }
  [[nodiscard]] const WholePolynomial& square_free() const { return chain_[0]; }

 private:
  static std::vector<WholePolynomial> sturm_chain(const WholePolynomial& polynomial) {
    std::vector<WholePolynomial> chain{polynomial, derivative(polynomial)};
    while (!chain.back().empty()) {
      WholePolynomial rest = primitive(divided(chain[chain.size() - 2], chain.back()).second);
      for (Whole& x : rest) x = -x;
      chain.push_back(std::move(rest));
    }
    chain.pop_back();
    return chain;
  }

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

/// The roots in (0, 1], rising, each alone in its cell; the polynomial changes its sign there.
struct IsolatedRoots {
  WholePolynomial polynomial;
  std::vector<Cell> cells;
};

inline void isolate_by_sturm(const Roots& roots, const Cell& cell, std::vector<Cell>& found) {
  const int count = roots.count(cell.from(), cell.to());
  if (count == 1) found.push_back(cell);
  if (count <= 1) return;
  isolate_by_sturm(roots, {2 * cell.place, cell.depth + 1}, found);
  isolate_by_sturm(roots, {2 * cell.place + 1, cell.depth + 1}, found);
}

/// Of a(x + 1).
inline WholePolynomial shifted_by_one(WholePolynomial a) {
  for (std::size_t first = 0; first < a.size(); ++first) {
    for (std::size_t i = a.size() - 1; i-- > first;) a[i] += a[i + 1];
  }
  return a;
}

/// Descartes: between 0 and 1 there are so many roots, or fewer by an even number.
inline int most_roots(WholePolynomial a) {
  std::reverse(a.begin(), a.end());
  int count = 0;
  int last = 0;
  for (const Whole& x : shifted_by_one(std::move(a))) {
    if (x.sign() == -last && last != 0) ++count;
    if (x.sign() != 0) last = x.sign();
  }
  return count;
}

/// Halves the cell until Descartes' rule leaves none or one in each part; `a` is the polynomial
/// over the cell. False where that does not come about: at a double root, and at one that ends a
/// cell.
inline bool isolate_by_descartes(const WholePolynomial& a, const Cell& cell,
                                 std::vector<Cell>& found) {
  if (cell.depth > 4 || sign_at(a, {1, 0}) == 0) return false;
  const int most = most_roots(a);
  if (most == 1) found.push_back(cell);
  if (most <= 1) return true;
  WholePolynomial half = a;
  for (std::size_t i = 0; i < a.size(); ++i) half[i] <<= static_cast<unsigned>(a.size() - 1 - i);
  return isolate_by_descartes(half, {2 * cell.place, cell.depth + 1}, found) &&
         isolate_by_descartes(shifted_by_one(half), {2 * cell.place + 1, cell.depth + 1}, found);
}

/// By additions alone where they tell, by Sturm's chain, which costs ten times as much, where not.
inline IsolatedRoots isolated_roots(const WholePolynomial& polynomial) {
  if (polynomial.empty()) return {};
  IsolatedRoots isolated{polynomial, {}};
  if (isolate_by_descartes(polynomial, {0, 0}, isolated.cells)) return isolated;
  const Roots roots(polynomial);
  isolated = {roots.square_free(), {}};
  isolate_by_sturm(roots, {0, 0}, isolated.cells);
  return isolated;
}

/// The root of f in the cell is before its middle where the sign there is that at the cell's end.
inline void halve(Cell& cell, const WholePolynomial& f) {
  Cell half{2 * cell.place, cell.depth + 1};
  const int middle = sign_at(f, half.to());
  if (middle != 0 && middle != sign_at(f, cell.to())) ++half.place;
  cell = half;
}

/// The sign of another polynomial at the root of f in the cell, which is narrowed as far as need
/// be.
inline int sign_at_root(const WholePolynomial& f, Cell& cell, const WholePolynomial& g) {
  if (g.empty()) return 0;
  const int at_end = sign_at(g, {1, 0});
  if (at_end != 0 && most_roots(g) == 0) return at_end;
  const Roots g_roots(g);
  const auto undecided = [&] { return g_roots.count(cell.from(), cell.to()) > 0; };
  for (int i = 0; i < 8 && undecided(); ++i) halve(cell, f);
  if (undecided() && Roots(common_divisor(f, g)).count(cell.from(), cell.to()) > 0) return 0;
  while (undecided()) halve(cell, f);
  return sign_at(g, cell.to());  // no root up to there, nor there
}

/// Where the chord from 0, first to 1, last has its root, to some digits. Of opposite signs; the
/// first may be zero.
inline double chord_root(const Whole& first, const Whole& last) {
  const Whole fall = first - last;
  const auto bits = static_cast<unsigned>(msb(abs(fall)));  // newer ones count by size_t
  const unsigned shift = bits > 60 ? bits - 60 : 0;
  return static_cast<double>(Whole(first >> shift)) / static_cast<double>(Whole(fall >> shift));
}

/// The root of f in the cell to 2⁻⁷⁰, which is less than any bound here asks for. Abbott 2014,
/// quadratic interval refinement: the chord picks one of 2^gain parts; where the signs at its ends
/// prove it, the gain doubles, and where not, the cell is halved and the gain, too.
inline double middle_of(Cell cell, const WholePolynomial& f) {
  for (unsigned gain = 2; cell.depth < 70;) {
    const Whole last = value_at(f, cell.to());
    if (last == 0) {
      return std::ldexp(static_cast<double>(Whole(cell.place + 1)), -static_cast<int>(cell.depth));
    }
    gain = std::min(gain, 70 - cell.depth);
    const double parts = std::ldexp(1.0, static_cast<int>(gain));
    const double root = chord_root(value_at(f, cell.from()), last);
    const double part = std::clamp(std::floor(root * parts), 0.0, parts - 1.0);
    const Cell fine{(cell.place << gain) + Whole(part), cell.depth + gain};
    const auto before_root = [&](const Dyadic& x) { return sign_at(f, x) == -last.sign(); };
    if ((part == 0.0 || before_root(fine.from())) &&
        (part == parts - 1.0 || !before_root(fine.to()))) {
      cell = fine;
      gain *= 2;
    } else {
      halve(cell, f);
      gain = std::max(1U, gain / 2);
    }
  }
  return std::ldexp(static_cast<double>(Whole(2 * cell.place + 1)), -71);
}

}  // namespace tests

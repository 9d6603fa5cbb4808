#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "common/geometry/triangle_mesh.hpp"

/// Whether two triangles meet, in rational arithmetic: one is cut down to the other, and they meet
/// where anything is left. It shares nothing with the answers. A rational point is held as whole
/// numbers over one whole number, so that nothing need be divided.
namespace tests {

using Whole = boost::multiprecision::cpp_int;
using Vector = std::array<Whole, 3>;

/// A triangle in a unit that is small enough for its corners to be whole.
using WholeTriangle = std::array<Vector, 3>;

struct Point {
  Vector place;  ///< times weight
  Whole weight;  ///< above zero
};

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Whole dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Vector& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }
inline Vector normal(const WholeTriangle& t) { return cross(minus(t[1], t[0]), minus(t[2], t[0])); }

/// x / 2^unit, where that is whole.
inline Whole whole(double x, int unit) {
  if (x == 0.0) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 - unit;
  return shift < 0 ? Whole(mantissa >> -shift) : Whole(mantissa) << static_cast<unsigned>(shift);
}

/// The power of two of the last bit of x that is not zero.
inline int last_bit(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + std::countr_zero(static_cast<unsigned long long>(mantissa));
}

/// Both in the same unit, as large as can be: the fewer digits, the less work.
inline std::array<WholeTriangle, 2> whole(const common::Triangle& a, const common::Triangle& b) {
  int unit = 2000;
  for (const common::Triangle* t : {&a, &b}) {
    for (const common::Vec3& corner : *t) {
      for (const double x : corner) {
        if (x != 0.0) unit = std::min(unit, last_bit(x));
      }
    }
  }
  std::array<WholeTriangle, 2> both;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      both[0][i][k] = whole(a[i][axis], unit);
      both[1][i][k] = whole(b[i][axis], unit);
    }
  }
  return both;
}

/// The point p a + q b, p and q of one sign together with the weights.
inline Point blend(const Whole& p, const Point& a, const Whole& q, const Point& b) {
  Point sum;
  for (std::size_t i = 0; i < 3; ++i) sum.place[i] = p * a.place[i] + q * b.place[i];
  sum.weight = p * a.weight + q * b.weight;
  return sum;
}

/// Of each point (x − origin) · normal, times its weight.
inline std::vector<Whole> heights(const std::vector<Point>& points, const Vector& origin,
                                  const Vector& normal) {
  const Whole offset = dot(origin, normal);
  std::vector<Whole> heights;
  heights.reserve(points.size());
  for (const Point& p : points) heights.push_back(dot(p.place, normal) - offset * p.weight);
  return heights;
}

/// Where the way from a point to another, whose heights differ in sign, is at height 0.
inline Point crossing(const Point& a, const Whole& at_a, const Point& b, const Whole& at_b) {
  return at_a.sign() > 0 ? blend(at_a, b, -at_b, a) : blend(at_b, a, -at_a, b);
}

/// What the hull of the points has in (x − origin) · normal ≥ 0, as the hull of those returned.
inline std::vector<Point> cut(const std::vector<Point>& points, const Vector& origin,
                              const Vector& normal) {
  const std::vector<Whole> height = heights(points, origin, normal);
  std::vector<Point> kept;
  kept.reserve(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t j = (i + 1) % points.size();
    if (height[i].sign() >= 0) kept.push_back(points[i]);
    if (height[i].sign() * height[j].sign() < 0) {
      kept.push_back(crossing(points[i], height[i], points[j], height[j]));
    }
  }
  return kept;
}

/// What it has in (x − origin) · normal = 0.
inline std::vector<Point> cut_on_both_sides(const std::vector<Point>& points, const Vector& origin,
                                            const Vector& normal) {
  const std::vector<Whole> height = heights(points, origin, normal);
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t j = (i + 1) % points.size();
    if (height[i].is_zero()) kept.push_back(points[i]);
    if (height[i].sign() * height[j].sign() < 0) {
      kept.push_back(crossing(points[i], height[i], points[j], height[j]));
    }
  }
  return kept;
}

/// The two ends of corners that are on one line.
inline std::array<Vector, 2> ends(const WholeTriangle& t) {
  std::array<Vector, 2> longest{t[0], t[1]};
  for (const std::size_t i : {1U, 2U}) {
    const Vector d = minus(t[(i + 1) % 3], t[i]);
    const Vector e = minus(longest[1], longest[0]);
    if (dot(d, d) > dot(e, e)) longest = {t[i], t[(i + 1) % 3]};
  }
  return longest;
}

inline bool meet_exactly(const common::Triangle& a, const common::Triangle& b) {
  const auto [s, t] = whole(a, b);
  std::vector<Point> left{{s[0], 1}, {s[1], 1}, {s[2], 1}};
  const Vector n = normal(t);
  if (!is_zero(n)) {
    left = cut_on_both_sides(left, t[0], n);
    for (std::size_t i = 0; i < 3 && !left.empty(); ++i) {
      left = cut(left, t[i], cross(n, minus(t[(i + 1) % 3], t[i])));
    }
    return !left.empty();
  }
  const auto [p, q] = ends(t);
  const Vector e = minus(q, p);
  for (std::size_t i = 0; i < 3; ++i) {
    Vector axis{};
    axis[i] = 1;
    // Across a segment; all three ways from a point.
    left = cut_on_both_sides(left, p, is_zero(e) ? axis : cross(e, axis));
  }
  if (is_zero(e)) return !left.empty();
  return !cut(cut(left, p, e), q, minus(p, q)).empty();
}

inline bool is_degenerate(const common::Triangle& t) { return is_zero(normal(whole(t, t)[0])); }

inline bool are_in_one_plane(const common::Triangle& a, const common::Triangle& b) {
  const auto [s, t] = whole(a, b);
  const Vector n = normal(s);
  return std::all_of(t.begin(), t.end(), [&, &corners = s](const Vector& x) {
    return dot(n, minus(x, corners[0])) == 0;
  });
}

}  // namespace tests

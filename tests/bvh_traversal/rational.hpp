#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "common/triangle_mesh.hpp"

/// Whether two triangles meet, in rational arithmetic: one is cut down to the other, and they meet
/// where anything is left. It shares nothing with the answers.
namespace tests {

using Rational = boost::multiprecision::cpp_rational;
struct Point {
  std::array<Rational, 3> x;
  Rational& operator[](std::size_t i) { return x[i]; }
  const Rational& operator[](std::size_t i) const { return x[i]; }
};

inline Point operator-(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Rational dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline bool is_zero(const Point& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

inline Point exact(const common::Vec3& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}

/// What the hull of the points has in (x − origin) · normal ≥ 0, as the hull of the points
/// returned.
inline std::vector<Point> cut(const std::vector<Point>& points, const Point& origin,
                              const Point& normal) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    const Point& q = points[(i + 1) % points.size()];
    const Rational at_p = dot(p - origin, normal);
    const Rational at_q = dot(q - origin, normal);
    if (at_p >= 0) kept.push_back(p);
    if (at_p.sign() * at_q.sign() >= 0) continue;
    const Rational t = at_p / (at_p - at_q);
    const Point d = q - p;
    kept.push_back({p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]});
  }
  return kept;
}

inline std::vector<Point> cut_on_both_sides(const std::vector<Point>& points, const Point& origin,
                                            const Point& normal) {
  const Point opposite{-normal[0], -normal[1], -normal[2]};
  return cut(cut(points, origin, normal), origin, opposite);
}

/// The two ends of corners that are on one line.
inline std::array<Point, 2> ends(const std::array<Point, 3>& t) {
  std::array<Point, 2> longest{t[0], t[1]};
  for (const auto& [i, j] : {std::array{1, 2}, std::array{2, 0}}) {
    const Point d = t[static_cast<std::size_t>(j)] - t[static_cast<std::size_t>(i)];
    const Point e = longest[1] - longest[0];
    if (dot(d, d) > dot(e, e)) {
      longest = {t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]};
    }
  }
  return longest;
}

inline bool meet_exactly(const common::Triangle& a, const common::Triangle& b) {
  std::vector<Point> left{exact(a[0]), exact(a[1]), exact(a[2])};
  const std::array<Point, 3> t{exact(b[0]), exact(b[1]), exact(b[2])};
  const Point n = cross(t[1] - t[0], t[2] - t[0]);
  if (!is_zero(n)) {
    left = cut_on_both_sides(left, t[0], n);
    for (std::size_t i = 0; i < 3; ++i) left = cut(left, t[i], cross(n, t[(i + 1) % 3] - t[i]));
    return !left.empty();
  }
  const auto [p, q] = ends(t);
  const Point e = q - p;
  for (std::size_t i = 0; i < 3; ++i) {
    Point axis{};
    axis[i] = 1;
    // Across a segment; all three ways from a point.
    left = cut_on_both_sides(left, p, is_zero(e) ? axis : cross(e, axis));
  }
  if (is_zero(e)) return !left.empty();
  left = cut(cut(left, p, e), q, p - q);
  return !left.empty();
}

}  // namespace tests

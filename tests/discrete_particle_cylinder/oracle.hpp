#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>

#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "values.hpp"

/// Distances from the axis in a hundred digits, by the schoolbook and by brute force: what the
/// answers return is judged by these alone. Distances are compared by their squares, since a root
/// takes as long as 25 products.
namespace tests {

using common::Cylinder;
using Exact = boost::multiprecision::cpp_bin_float_100;

inline double rounded(const Exact& value) { return static_cast<double>(value); }

struct ExactPoint {
  Exact y;
  Exact z;
};

inline ExactPoint exact(const Vec3& p) { return {Exact(p.y()), Exact(p.z())}; }
inline ExactPoint operator-(const ExactPoint& p, const ExactPoint& q) {
  return {p.y - q.y, p.z - q.z};
}
inline Exact dot(const ExactPoint& p, const ExactPoint& q) { return p.y * q.y + p.z * q.z; }
inline Exact cross(const ExactPoint& p, const ExactPoint& q) { return p.y * q.z - p.z * q.y; }
inline Exact square(const ExactPoint& p) { return dot(p, p); }
inline Exact square(const Vec3& p) { return square(exact(p)); }
inline Exact distance(const ExactPoint& p) { return sqrt(square(p)); }
inline Exact distance(const Vec3& p) { return distance(exact(p)); }

inline Exact rho(double particle_radius, const Cylinder& cylinder) {
  return Exact(cylinder.radius) + particle_radius;
}

inline double exact_gap(const Vec3& p, double r, const Cylinder& c) {
  return rounded(distance(p) - rho(r, c));
}

/// w₀ a + w₁ b + w₂ c.
inline ExactPoint mixed(const std::array<Vec3, 3>& corners, const std::array<Exact, 3>& weights) {
  ExactPoint sum{0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    sum.y += weights[i] * corners[i].y();
    sum.z += weights[i] * corners[i].z();
  }
  return sum;
}

inline Exact distance_at(const Vec3& a, const Vec3& b, const Exact& fraction) {
  return distance(mixed({a, b, a}, {1 - fraction, fraction, 0}));
}
inline Exact distance_at(const std::array<Vec3, 3>& corners, const Vec3& weights) {
  return distance(mixed(corners, {Exact(weights(0)), Exact(weights(1)), Exact(weights(2))}));
}

/// The fraction of the foot of the axis on the line through a and b; none where that is a point.
inline std::optional<Exact> foot_on_line(const Vec3& a, const Vec3& b) {
  const ExactPoint edge = exact(b) - exact(a);
  const Exact square = dot(edge, edge);
  if (square == 0) return std::nullopt;
  return Exact(-dot(exact(a), edge) / square);
}

/// The square of the distance of the edge from a to b: of its line, where the foot is between them.
inline Exact edge_square(const ExactPoint& a, const ExactPoint& b) {
  const ExactPoint edge = b - a;
  const Exact along = -dot(a, edge);
  const Exact length_squared = square(edge);
  if (along <= 0 || along >= length_squared) return std::min(square(a), square(b));
  const Exact area = cross(a, edge);
  return area * area / length_squared;
}
inline Exact edge_square(const Vec3& a, const Vec3& b) { return edge_square(exact(a), exact(b)); }
inline Exact edge_distance(const Vec3& a, const Vec3& b) { return sqrt(edge_square(a, b)); }

/// b × c, c × a, a × b.
inline std::array<Exact, 3> areas(const std::array<Vec3, 3>& p) {
  return {cross(exact(p[1]), exact(p[2])), cross(exact(p[2]), exact(p[0])),
          cross(exact(p[0]), exact(p[1]))};
}

inline bool pierced(const std::array<Vec3, 3>& p) {
  const std::array<Exact, 3> w = areas(p);
  const auto positive = [](const Exact& area) { return area > 0; };
  const auto negative = [](const Exact& area) { return area < 0; };
  return std::all_of(w.begin(), w.end(), positive) || std::all_of(w.begin(), w.end(), negative);
}

template <std::size_t count>
Exact least_square(const std::array<Vec3, count>& points) {
  Exact least = square(points[0]);
  for (std::size_t i = 1; i < count; ++i) least = std::min(least, square(points[i]));
  return least;
}

inline Exact edges_square(const std::array<Vec3, 3>& p) {
  const std::array<ExactPoint, 3> corners{exact(p[0]), exact(p[1]), exact(p[2])};
  return std::min({edge_square(corners[0], corners[1]), edge_square(corners[1], corners[2]),
                   edge_square(corners[2], corners[0])});
}
inline Exact edges_distance(const std::array<Vec3, 3>& p) { return sqrt(edges_square(p)); }

inline Exact triangle_square(const std::array<Vec3, 3>& p) {
  return pierced(p) ? Exact(0) : edges_square(p);
}
inline Exact triangle_distance(const std::array<Vec3, 3>& p) { return sqrt(triangle_square(p)); }

/// At `distance` from the axis.
inline Vec3 around_axis(double x, double distance, double angle) {
  return {x, distance * std::cos(angle), distance * std::sin(angle)};
}

inline double random_angle(Random& random) { return random.uniform(-3.2, 3.2); }

/// p turned about the axis and shifted along it.
inline Vec3 rolled(const Vec3& p, double angle, double shift = 0.0) {
  return {p.x() + shift, p.y() * std::cos(angle) - p.z() * std::sin(angle),
          p.y() * std::sin(angle) + p.z() * std::cos(angle)};
}

}  // namespace tests

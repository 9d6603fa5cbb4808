#pragma once

#include <array>
#include <string>
#include <vector>

#include "discrete_particle_cylinder.hpp"
#include "judgement.hpp"

/// Edges and triangles against the cylinder, and the mistakes that their gaps may show.
namespace tests {

namespace story {
inline const std::string ends_only =
    "only the ends and corners are checked: points between them may be nearer";
inline const std::string line = "the foot is not held on the edge: clamp the fraction to [0, 1]";
inline const std::string middle =
    "the middle is taken for the nearest point: compute where that is";
inline const std::string edges_only =
    "only the edges are checked: the axis may pass between them, through the triangle";
inline const std::string length_in_space =
    "the edge's length is that in space: use its length in the yz-plane";
inline const std::string edge_left_out = "one of the three edges is never checked: check all three";
inline const std::string passes_through =
    "the axis does not pass through the triangle: areas of the size of rounding have no sign";
}  // namespace story

/// An edge or a triangle, which is as thick as its particles, and the cylinder.
template <std::size_t corners>
struct Shape {
  std::array<Vec3, corners> p;
  double particle_radius = 0.5;
  Cylinder cylinder = {};

  [[nodiscard]] double radii() const { return rounded(rho(particle_radius, cylinder)); }
  /// What rounding is relative to.
  [[nodiscard]] double size() const {
    Exact farthest = 0;
    for (const Vec3& corner : p) farthest = std::max(farthest, square(corner));
    return rounded(sqrt(farthest) + rho(particle_radius, cylinder));
  }
  [[nodiscard]] double gap_of(const Exact& distance) const {
    return rounded(distance - rho(particle_radius, cylinder));
  }
};
using Edge = Shape<2>;
using Triangle = Shape<3>;

/// Some 20 roundings on terms of this size.
inline Bound on_shape(double size) {
  return {16.0 * eps * size, "some 20 roundings on lengths of this size"};
}

template <std::size_t corners>
Trial shape_trial(const char* function, const Shape<corners>& shape, int index, int count) {
  Trial trial = radii_trial(function, shape.particle_radius, shape.cylinder, index, count);
  for (std::size_t i = 0; i < corners; ++i) {
    trial.given(std::string(1, "abc"[i]), shape.p[i]);
  }
  return trial;
}

/// The distance from the world's origin instead of the axis.
inline double distance_in_space(const Vec3& a, const Vec3& b) {
  const Vec3 edge = b - a;
  const double share = std::clamp(-a.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (a + share * edge).norm();
}

/// Where the foot would be if it was divided by the square of the length in space, from a on or
/// from the nearer end.
inline Exact distance_by_length_in_space(const Vec3& a, const Vec3& b, bool from_nearer) {
  if (from_nearer && square(b) < square(a)) return distance_by_length_in_space(b, a, false);
  const ExactPoint edge = exact(b) - exact(a);
  const Exact along_x = Exact(b.x()) - a.x();
  const Exact length_squared = square(edge) + along_x * along_x;
  if (length_squared == 0) return distance(a);
  const Exact share = -dot(exact(a), edge) / length_squared;
  return distance_at(a, b, std::clamp(share, Exact(0), Exact(1)));
}

/// So that a tolerance may take it for a point.
inline bool is_short(const Edge& e) {
  return rounded(distance(e.p[1] - e.p[0])) < 1e-6 * std::max(1.0, e.size());
}

inline std::vector<Suspect<double>> suspects_of_edge(const Edge& e) {
  const auto& [a, b] = e.p;
  const Exact least = edge_distance(a, b);
  const auto foot = foot_on_line(a, b);
  const Exact from_nearer = distance_by_length_in_space(a, b, true);
  const Exact from_a = distance_by_length_in_space(a, b, false);
  return {{e.gap_of(from_nearer), story::length_in_space},
          {e.gap_of(from_a == from_nearer ? least : from_a), story::length_in_space},
          {e.gap_of(std::min(distance(a), distance(b))), story::ends_only},
          {is_short(e) ? e.gap_of(std::min(distance(a), distance(b))) : e.gap_of(least),
           "a short edge is taken for a point: test only for a length of exactly zero"},
          {e.gap_of(foot ? distance_at(a, b, *foot) : least), story::line},
          {e.gap_of(distance_at(a, b, Exact(0.5))), story::middle},
          {rounded(least - e.cylinder.radius), story::no_r},
          {rounded(least), story::no_radii},
          {e.gap_of(distance_in_space(a, b)), story::keeps_x},
          {rounded(rho(e.particle_radius, e.cylinder) - least), story::reversed_gap},
          {-e.radii(), story::underflow}};
}

/// The gap, and the place where it is: any that is as near.
inline void expect_edge(const Edge& e, int index = 1, int count = 1) {
  const Vec3& a = e.p[0];
  const Vec3& b = e.p[1];
  const auto got = lab::discrete_particle_cylinder::edge_gap(a, b, e.particle_radius, e.cylinder);
  const Trial trial = shape_trial("3.5 edge_gap", e, index, count);
  const double wanted = e.gap_of(edge_distance(a, b));
  const Bound bound = on_shape(e.size());
  trial.of("the gap").expect(got.gap, wanted, bound, [&] { return suspects_of_edge(e); });
  trial.of("the fraction")
      .expect(got.fraction, std::clamp(got.fraction, 0.0, 1.0), {0.0, "it must be in [0, 1]"});
  trial.of("the gap at the fraction " + text(got.fraction))
      .expect(e.gap_of(distance_at(a, b, Exact(got.fraction))), wanted, bound, [&] {
        const Exact foot = foot_on_line(a, b).value_or(0);
        return std::vector<Suspect<double>>{{e.gap_of(distance_at(a, b, 1 - foot)),
                                             "the fraction is counted from b: count it from a"}};
      });
}

inline std::vector<Suspect<double>> suspects_of_triangle(const Triangle& t) {
  const Vec3& a = t.p[0];
  const Vec3& b = t.p[1];
  const Vec3& c = t.p[2];
  const Exact least = triangle_distance(t.p);
  const double size = t.size();
  const bool huge_or_tiny = size > 1e100 || size < 1e-100;
  const std::array<Exact, 3> twice = areas(t.p);
  const bool thin = abs(twice[0] + twice[1] + twice[2]) < 1e-6 * Exact(size) * size;
  const auto line = [](const Vec3& p, const Vec3& q) {
    const auto foot = foot_on_line(p, q);
    return foot ? distance_at(p, q, *foot) : distance(p);
  };
  const Exact lines = pierced(t.p) ? Exact(0) : std::min({line(a, b), line(b, c), line(c, a)});
  const auto middle = [](const Vec3& p, const Vec3& q) { return distance_at(p, q, Exact(0.5)); };
  const auto in_space = [&](bool from_nearer) {
    if (pierced(t.p)) return Exact(0);
    return std::min({distance_by_length_in_space(a, b, from_nearer),
                     distance_by_length_in_space(b, c, from_nearer),
                     distance_by_length_in_space(c, a, from_nearer)});
  };
  const Exact nearer = in_space(true);
  const Exact first = in_space(false);
  // The nearest edge is one of three: what is left without another is right.
  const auto without = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return t.gap_of(pierced(t.p) ? least : std::min(edge_distance(p, q), edge_distance(q, r)));
  };
  return {{without(a, b, c), story::edge_left_out},
          {without(b, c, a), story::edge_left_out},
          {without(c, a, b), story::edge_left_out},
          {t.gap_of(nearer), story::length_in_space},
          {t.gap_of(first == nearer ? least : first), story::length_in_space},
          {t.gap_of(edges_distance(t.p)), story::edges_only},
          {thin ? t.gap_of(edges_distance(t.p)) : t.gap_of(least),
           "a thin triangle is taken for a segment: test only whether all areas are exactly zero"},
          {huge_or_tiny ? t.gap_of(edges_distance(t.p)) : t.gap_of(least),
           "products of lengths overflow or vanish: first scale all lengths by one power of two"},
          {t.gap_of(std::min({distance(a), distance(b), distance(c)})), story::ends_only},
          {t.gap_of(distance_at(t.p, Vec3::Constant(1.0 / 3.0))), story::middle},
          {t.gap_of(std::min({middle(a, b), middle(b, c), middle(c, a)})), story::middle},
          {t.gap_of(lines), story::line},
          {-t.radii(), story::passes_through},
          {rounded(least - t.cylinder.radius), story::no_r},
          {rounded(least), story::no_radii},
          {rounded(rho(t.particle_radius, t.cylinder) - least), story::reversed_gap}};
}

/// How far off the weights may put the point, in parts of what rounding makes of the size: where
/// the axis goes through they are areas over their sum, which in a sliver is small.
inline double weights_condition(const Triangle& t, const Exact& distance, double size) {
  if (distance > 16.0 * eps * size) return 1.0;
  const std::array<Exact, 3> w = areas(t.p);
  const Exact sum = abs(w[0]) + abs(w[1]) + abs(w[2]);
  return sum == 0 ? 1.0 : rounded(1 + Exact(size) * size / sum);
}

/// What the gap would be at the weights of other corners.
inline std::vector<Suspect<double>> suspects_of_weights(const Triangle& t) {
  if (!pierced(t.p)) return {};
  const std::array<Exact, 3> area = areas(t.p);
  const Exact sum = area[0] + area[1] + area[2];
  const Vec3 right(rounded(area[0] / sum), rounded(area[1] / sum), rounded(area[2] / sum));
  const auto gap_at = [&](const Vec3& weights) { return t.gap_of(distance_at(t.p, weights)); };
  const std::string other = "the weights are those of other corners: b x c belongs to a";
  return {{gap_at(Vec3(right(1), right(2), right(0))), other},
          {gap_at(Vec3(right(2), right(0), right(1))), other}};
}

/// The gap, and the place where it is: any that is as near.
inline void expect_triangle(const Triangle& t, int index = 1, int count = 1) {
  const auto& [a, b, c] = t.p;
  const auto got =
      lab::discrete_particle_cylinder::triangle_gap(a, b, c, t.particle_radius, t.cylinder);
  const Trial trial = shape_trial("3.5 triangle_gap", t, index, count);
  const Exact least = triangle_distance(t.p);
  const double wanted = t.gap_of(least);
  const double size = t.size();
  trial.of("the gap").expect(got.gap, wanted, on_shape(size),
                             [&] { return suspects_of_triangle(t); });
  const Vec3& w = got.weights;
  trial.of("the weights").expect(w, Vec3(w.cwiseMax(0.0)), {0.0, "no weight may be below 0"});
  trial.of("the sum of the weights " + text(w))
      .expect(w.sum(), 1.0, {4.0 * eps, "three quotients and their sum"});
  trial.of("the gap at the weights " + text(w))
      .expect(t.gap_of(distance_at(t.p, w)), wanted,
              on_shape(size * weights_condition(t, least, size)),
              [&] { return suspects_of_weights(t); });
}

inline Cylinder random_cylinder(Random& random) { return {random.uniform(0.2, 2.0)}; }

}  // namespace tests

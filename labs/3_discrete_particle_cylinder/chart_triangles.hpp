#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "chart_crossings.hpp"

/// Equilateral triangles at any place around the cylinder and in any attitude, and the share of
/// those inside that a check of less than the triangle does not see.
namespace lab::discrete_particle_cylinder {

using Triangle = std::array<Vec3, 3>;

/// Triangles of one edge length. Their five coordinates, the angles of the turn and the place of
/// the centre, fill space evenly (Roberts 2018, a lattice by the root of g⁶ = g + 1).
class Triangles {
 public:
  explicit Triangles(double edge_length)
      : edge_length_(edge_length), spread_(reach + edge_length / std::numbers::sqrt3) {}

  [[nodiscard]] Triangle at(std::uint32_t index) const {
    constexpr double root = 1.1347241384015194;
    std::array<double, 5> place{};
    double power = 1.0;
    for (double& coordinate : place) {
      power /= root;
      coordinate = 0.5 + index * power;
      coordinate -= std::floor(coordinate);
    }
    return turned(place);
  }

 private:
  [[nodiscard]] Triangle turned(const std::array<double, 5>& place) const {
    const auto& [share, first_turn, second_turn, radius, direction] = place;
    constexpr double turn = 2.0 * std::numbers::pi;
    const double s = std::sqrt(1.0 - share);
    const double c = std::sqrt(share);
    const common::Quat attitude(s * std::sin(turn * first_turn), s * std::cos(turn * first_turn),
                                c * std::sin(turn * second_turn), c * std::cos(turn * second_turn));
    const double distance = spread_ * std::sqrt(radius);
    const Vec3 center(0.0, distance * std::cos(turn * direction),
                      distance * std::sin(turn * direction));
    Triangle corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double angle = turn * static_cast<double>(i) / 3.0;
      const Vec3 arm(std::cos(angle), std::sin(angle), 0.0);
      corners[i] = center + edge_length_ / std::numbers::sqrt3 * (attitude * arm);
    }
    return corners;
  }

  double edge_length_;
  double spread_;  ///< if its centre is further off, a triangle cannot touch
};

/// The triangles inside that a check does not see.
struct Unseen {
  double share = 0.0;
  double deepest = 0.0;  ///< how far such a triangle reaches in [m]
};

/// Applies the check `sees` to the triangles.
template <typename Sees>
Unseen unseen(double edge_length, const Sees& sees) {
  constexpr std::uint32_t count = 100000;
  const Triangles triangles(edge_length);
  Unseen result;
  double inside = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [a, b, c] = triangles.at(i);
    const double gap = triangle_gap(a, b, c, particle_radius, cylinder).gap;
    if (gap > 0.0) continue;
    inside += 1.0;
    if (sees(Triangle{a, b, c})) continue;
    result.share += 1.0;
    result.deepest = std::max(result.deepest, -gap);
  }
  result.share /= inside;
  return result;
}

/// Returns whether a particle of the triangle is closer than `margin`.
inline bool particles_see(const Triangle& triangle, double margin) {
  return std::any_of(triangle.begin(), triangle.end(), [=](const Vec3& corner) {
    return gap(corner, particle_radius, cylinder) <= margin;
  });
}

inline bool edges_see(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return edge_gap(a, b, particle_radius, cylinder).gap <= 0.0 ||
         edge_gap(b, c, particle_radius, cylinder).gap <= 0.0 ||
         edge_gap(c, a, particle_radius, cylinder).gap <= 0.0;
}

/// Returns the theory of what a check of the particles does not see, for short edges. Share: for
/// each edge, whose mean projected cube is 3π/16 h³, a sliver of h³/24ρ is outside its two corners'
/// discs; divide by the area in which a centre's triangle touches. Depth: that of an edge whose
/// ends touch; from √3 ρ on the axis goes through a triangle whose corners are outside.
inline Unseen unseen_by_particles_in_theory(double h) {
  constexpr double pi = std::numbers::pi;
  const double slivers = 3.0 * (3.0 * pi / 16.0) * h * h * h / (24.0 * reach);
  const double area = pi * reach * reach + 0.75 * pi * h * reach + std::sqrt(3.0) / 8.0 * h * h;
  const double u = 0.5 * h / reach;
  const double depth =
      h < std::numbers::sqrt3 * reach ? u * u / (1.0 + std::sqrt(1.0 - u * u)) : 1.0;
  return {std::min(1.0, slivers / area), reach * depth};
}

}  // namespace lab::discrete_particle_cylinder

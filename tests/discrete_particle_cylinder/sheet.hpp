#pragma once

#include <string>
#include <vector>

#include "discrete_particle_cylinder.hpp"
#include "shapes.hpp"

/// Sheets of cloth, and what of them touches the cylinder by a hundred digits.
namespace tests {

using lab::discrete_particle_cylinder::Sheet;
using lab::discrete_particle_cylinder::SheetContacts;

/// Corners of edges or triangles, as a value of a trial.
template <std::size_t corners>
struct Corners {
  std::vector<std::array<std::size_t, corners>> all;
};

template <std::size_t corners>
std::string text(const Corners<corners>& list) {
  if (list.all.size() > 12) return std::to_string(list.all.size()) + " of them";
  std::string entries;
  for (const auto& one : list.all) {
    entries += (entries.empty() ? "" : ", ") + text(IndexList{{one.begin(), one.end()}});
  }
  return "{" + entries + "}";
}

inline Trial sheet_trial(const Sheet& sheet, const Cylinder& cylinder, int index = 1,
                         int count = 1) {
  return Trial("3.6 sheet_contacts", index, count)
      .given("sheet.positions", Positions{sheet.positions})
      .given("sheet.edges", Corners<2>{sheet.edges})
      .given("sheet.triangles", Corners<3>{sheet.triangles})
      .given("sheet.particle_radius", sheet.particle_radius)
      .given("cylinder.radius", cylinder.radius);
}

inline std::array<Vec3, 3> corners_of(const Sheet& sheet, std::size_t i) {
  const auto& [a, b, c] = sheet.triangles[i];
  return {sheet.positions[a], sheet.positions[b], sheet.positions[c]};
}

/// What is no farther from the axis than a distance, of `count` things: `square` of an index tells
/// how far, squared.
template <typename Square>
IndexList within(const Exact& distance_squared, std::size_t count, const Square& square) {
  IndexList list;
  for (std::size_t i = 0; i < count; ++i) {
    if (square(i) <= distance_squared) list.indices.push_back(i);
  }
  return list;
}

/// Judges the three lists; nothing of the sheet may be within rounding of touching.
inline void expect_sheet(const Sheet& sheet, const Cylinder& cylinder, int index = 1,
                         int count = 1) {
  const auto& p = sheet.positions;
  const auto ends_of = [&](std::size_t i) {
    return std::array{p[sheet.edges[i][0]], p[sheet.edges[i][1]]};
  };
  const auto particle = [&](std::size_t i) { return square(p[i]); };
  const auto ends = [&](std::size_t i) { return least_square(ends_of(i)); };
  const auto edge = [&](std::size_t i) { return edge_square(ends_of(i)[0], ends_of(i)[1]); };
  const auto corners = [&](std::size_t i) { return least_square(corners_of(sheet, i)); };
  const auto sides = [&](std::size_t i) { return edges_square(corners_of(sheet, i)); };
  const auto triangle = [&](std::size_t i) { return triangle_square(corners_of(sheet, i)); };
  const Exact sum = rho(sheet.particle_radius, cylinder);
  const Exact rho_squared = sum * sum;
  const Exact R_squared = Exact(cylinder.radius) * cylinder.radius;
  const std::size_t edges = sheet.edges.size();
  const std::size_t triangles = sheet.triangles.size();
  using Suspects = std::vector<Suspect<IndexList>>;
  const SheetContacts got = lab::discrete_particle_cylinder::sheet_contacts(sheet, cylinder);
  const Trial trial = sheet_trial(sheet, cylinder, index, count);
  const Bound exactly{0.0, "both lists must be equal"};
  trial.of("the particles")
      .expect(IndexList{got.particles}, within(rho_squared, p.size(), particle), exactly, [&] {
        return Suspects{{within(R_squared, p.size(), particle), story::no_r}};
      });
  trial.of("the edges")
      .expect(IndexList{got.edges}, within(rho_squared, edges, edge), exactly, [&] {
        return Suspects{{within(rho_squared, edges, ends), story::ends_only},
                        {within(R_squared, edges, edge), story::no_r}};
      });
  trial.of("the triangles")
      .expect(IndexList{got.triangles}, within(rho_squared, triangles, triangle), exactly, [&] {
        return Suspects{{within(rho_squared, triangles, sides), story::edges_only},
                        {within(rho_squared, triangles, corners), story::ends_only},
                        {within(R_squared, triangles, triangle), story::no_r}};
      });
}

/// Equilateral triangles of side `side` in n rows of n particles, flat in the xy-plane.
inline Sheet mesh(std::size_t n, double side) {
  Sheet sheet;
  const double row = side * std::sqrt(3.0) / 2.0;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t here = j * n + i;
      const double along = static_cast<double>(i) + 0.5 * static_cast<double>(j);
      sheet.positions.emplace_back(side * along, row * static_cast<double>(j), 0.0);
      if (i + 1 < n) sheet.edges.push_back({here, here + 1});
      if (j + 1 < n) sheet.edges.push_back({here, here + n});
      if (i > 0 && j + 1 < n) sheet.edges.push_back({here, here + n - 1});
      if (i + 1 < n && j + 1 < n) {
        sheet.triangles.push_back({here, here + 1, here + n});
        sheet.triangles.push_back({here + 1, here + n + 1, here + n});
      }
    }
  }
  return sheet;
}

/// The sheet turned by `attitude` about its middle, and its middle put at `middle`.
inline Sheet placed(Sheet sheet, const Quat& attitude, const Vec3& middle) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : sheet.positions) {
    mean += p / static_cast<double>(sheet.positions.size());
  }
  for (Vec3& p : sheet.positions) p = attitude * Vec3(p - mean) + middle;
  return sheet;
}

}  // namespace tests

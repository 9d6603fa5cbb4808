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

/// What is no farther from the axis than ρ, of `count` things of which `distance` tells how far.
template <typename Distance>
std::vector<std::size_t> within(const Exact& rho, std::size_t count, const Distance& distance) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i) {
    if (distance(i) <= rho) indices.push_back(i);
  }
  return indices;
}

/// Judges the three lists; nothing of the sheet may be within rounding of touching.
inline void expect_sheet(const Sheet& sheet, const Cylinder& cylinder, int index = 1,
                         int count = 1) {
  const auto& p = sheet.positions;
  const auto& edges = sheet.edges;
  const Exact sum = rho(sheet.particle_radius, cylinder);
  const auto particle = [&](std::size_t i) { return distance(p[i]); };
  const auto edge = [&](std::size_t i) { return edge_distance(p[edges[i][0]], p[edges[i][1]]); };
  const auto ends = [&](std::size_t i) {
    return std::min(distance(p[edges[i][0]]), distance(p[edges[i][1]]));
  };
  const auto triangle = [&](std::size_t i) { return triangle_distance(corners_of(sheet, i)); };
  const auto sides = [&](std::size_t i) { return edges_distance(corners_of(sheet, i)); };
  const auto corners = [&](std::size_t i) {
    const auto [a, b, c] = corners_of(sheet, i);
    return std::min({distance(a), distance(b), distance(c)});
  };
  const SheetContacts got = lab::discrete_particle_cylinder::sheet_contacts(sheet, cylinder);
  const Trial trial = sheet_trial(sheet, cylinder, index, count);
  const Bound exactly{0.0, "a list is right or wrong"};
  const std::size_t triangles = sheet.triangles.size();
  const Exact R = cylinder.radius;
  trial.of("the particles")
      .expect(IndexList{got.particles}, IndexList{within(sum, p.size(), particle)}, exactly,
              {{IndexList{within(R, p.size(), particle)}, story::no_r}});
  trial.of("the edges")
      .expect(IndexList{got.edges}, IndexList{within(sum, edges.size(), edge)}, exactly,
              {{IndexList{within(sum, edges.size(), ends)}, story::ends_only},
               {IndexList{within(R, edges.size(), edge)}, story::no_r}});
  trial.of("the triangles")
      .expect(IndexList{got.triangles}, IndexList{within(sum, triangles, triangle)}, exactly,
              {{IndexList{within(sum, triangles, sides)}, story::edges_only},
               {IndexList{within(sum, triangles, corners)}, story::ends_only},
               {IndexList{within(R, triangles, triangle)}, story::no_r}});
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

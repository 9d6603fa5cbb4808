#include "common/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "common/exact/orientation.hpp"

namespace common {
namespace {

/// The two axes on which the polygon looks largest, in the order in which it turns to the left.
std::array<int, 2> widest_view(const std::vector<Vec3>& vertices,
                               const std::vector<std::uint32_t>& corners) {
  Vec3 area = Vec3::Zero();  // twice the vector area, by Newell's sum about the first corner
  const Vec3& first = vertices[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    area += (vertices[corners[i]] - first).cross(vertices[corners[i + 1]] - first);
  }
  int along = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(area[axis]) > std::abs(area[along])) along = axis;
  }
  const int x = (along + 1) % 3;
  const int y = (along + 2) % 3;
  return area[along] < 0.0 ? std::array{y, x} : std::array{x, y};
}

bool is_ear(const std::vector<Vec2>& seen, std::size_t i) {
  const std::size_t n = seen.size();
  const Vec2& a = seen[(i + n - 1) % n];
  const Vec2& b = seen[i];
  const Vec2& c = seen[(i + 1) % n];
  if (orientation(a, b, c) <= 0) return false;
  return std::all_of(seen.begin(), seen.end(), [&](const Vec2& p) {
    const bool is_corner = p == a || p == b || p == c;
    return is_corner || orientation(a, b, p) < 0 || orientation(b, c, p) < 0 ||
           orientation(c, a, p) < 0;
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Vec3>& vertices,
                                                       std::vector<std::uint32_t> corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Vec2> seen;
  if (corners.size() > 3) {
    const auto [x, y] = widest_view(vertices, corners);
    for (const std::uint32_t corner : corners) {
      seen.emplace_back(vertices[corner][x], vertices[corner][y]);
    }
  }
  while (corners.size() > 3) {
    std::size_t ear = 1;
    for (std::size_t i = 1; i <= corners.size(); ++i) {
      if (!is_ear(seen, i % corners.size())) continue;
      ear = i % corners.size();
      break;
    }
    const std::size_t n = corners.size();
    triangles.push_back({corners[(ear + n - 1) % n], corners[ear], corners[(ear + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(ear));
    seen.erase(seen.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({corners[0], corners[1], corners[2]});
  return triangles;
}

}  // namespace common

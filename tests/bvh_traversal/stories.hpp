#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "judged.hpp"

/// What is likely where triangles_meet is wrong.
namespace tests {

inline const std::string in_one_plane =
    "triangles in one plane are taken for apart: test them in two dimensions";
inline const std::string without_plane =
    "a triangle that is a segment or a point is not seen: it has no plane, so test it on its own";
inline const std::string rounded =
    "this is decided by rounding: take the exact sign of the determinant, common::orientation";

/// All orders of the corners.
inline std::vector<std::array<common::Triangle, 2>> corner_orders(common::Triangle a,
                                                                  common::Triangle b) {
  std::vector<std::array<common::Triangle, 2>> orders;
  for (int order = 0; order < 36; ++order) {
    orders.push_back({a, b});
    std::swap(a[0], a[1]);
    if (order % 2 == 1) std::swap(a[1], a[2]);
    if (order % 6 == 5) std::swap(b[0], b[1]);
    if (order % 12 == 11) std::swap(b[1], b[2]);
  }
  return orders;
}

/// What a story about a pair of triangles says is wrong in every order of their corners; an answer
/// that is wrong in some orders only has another mistake.
inline bool is_wrong_in_all_orders(const common::Triangle& a, const common::Triangle& b,
                                   bool wanted) {
  const auto orders = corner_orders(a, b);
  return std::all_of(orders.begin(), orders.end(), [&](const auto& order) {
    return lab::triangles_meet(order[0], order[1]) != wanted;
  });
}

}  // namespace tests

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/types.hpp"

namespace common {

/// Cuts a polygon of three or more corners into triangles, two fewer than corners, oriented as it
/// is.
///
/// It cuts off ears, that is, corners that turn as the polygon does and that hold no other corner.
/// It judges them exactly, along the axis on which the polygon looks largest. If no corner is an
/// ear, as in a polygon that crosses itself or is flat to a line, it cuts off the next corner all
/// the same.
///
/// vertices  of the mesh [m]
/// corners   indices in vertices, in order round the polygon
std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Vec3>& vertices,
                                                       std::vector<std::uint32_t> corners);

}  // namespace common

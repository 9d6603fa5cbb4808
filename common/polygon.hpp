#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/types.hpp"

namespace common {

/// A polygon of three corners or more cut into triangles, two less than corners, turned as it is.
///
/// Ears are cut off: corners that turn as the polygon does, and that hold no other corner. They are
/// judged along the axis on which the polygon looks largest, exactly. Where no corner is an ear, as
/// in a polygon that crosses itself or is flat to a line, the next one is cut off all the same.
///
/// vertices  of the mesh [m]
/// corners   indices in vertices, in order round the polygon
std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<Vec3>& vertices,
                                                       std::vector<std::uint32_t> corners);

}  // namespace common

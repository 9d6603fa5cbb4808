#pragma once

#include "judged.hpp"

/// What is likely where triangles_meet is wrong.
namespace tests {

inline const std::string in_one_plane =
    "triangles in one plane are taken for apart: test them in two dimensions";
inline const std::string without_plane =
    "a triangle that is a segment or a point is not seen: it has no plane, so test it on its own";
inline const std::string rounded =
    "this is decided by rounding: take the exact sign of the determinant, common::orientation";

}  // namespace tests

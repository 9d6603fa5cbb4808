#pragma once

#include "judged.hpp"

/// What is likely where triangles_meet is wrong.
namespace tests {

inline const std::string in_one_plane =
    "triangles in one plane are taken for apart: look at their shadows";
inline const std::string without_plane =
    "a triangle that is a segment or a point is not seen: it has no plane, but points";
inline const std::string rounded =
    "this is decided by rounding: the sign of a small determinant needs exact arithmetic";

}  // namespace tests

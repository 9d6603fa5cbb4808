#pragma once

#include <vector>

namespace render {

/// Moves the heights of labels as little as keeps them `gap` apart, and in [0, 1] if there is room.
std::vector<double> spread(std::vector<double> heights, double gap);

}  // namespace render

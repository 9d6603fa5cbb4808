#pragma once

#include <vector>

namespace render {

/// Heights of labels, moved as little as keeps them `gap` apart, and in [0, 1] where there is room.
std::vector<double> spread(std::vector<double> heights, double gap);

}  // namespace render

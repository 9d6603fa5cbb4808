#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "common/not_implemented.hpp"

namespace common {

/// What `make` returns; nothing, and the step once in `missing`, where it needs one that is not
/// written yet.
template <typename Make>
auto if_written(std::vector<std::string>& missing, const Make& make)
    -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const NotImplemented& error) {
    const std::string& step = error.step_and_function();
    if (std::find(missing.begin(), missing.end(), step) == missing.end()) missing.push_back(step);
    return std::nullopt;
  }
}

}  // namespace common

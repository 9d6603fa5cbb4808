#pragma once

#include <atomic>
#include <cstddef>

namespace tests {

/// How often memory was allocated, where allocations.hpp counts; a grader puts there what it was
/// told of an answer that runs elsewhere.
inline std::atomic<std::size_t> allocations{0};

}  // namespace tests

#pragma once

#include <atomic>
#include <cstddef>

namespace tests {

/// The number of allocations of memory, if allocations.hpp counts them. A grader stores here the
/// number that it was told about an answer that runs elsewhere.
inline std::atomic<std::size_t> allocations{0};

}  // namespace tests

#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace render {

/// Calls body(0) … body(count - 1), each once, in any order, on all cores (at most eight).
/// An exception of the body comes out once all threads have stopped.
template <typename Body>
void for_each_in_parallel(int count, const Body& body) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int threads = std::clamp(std::min(cores, count), 1, 8);
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) body(i);
  };
  std::vector<std::future<void>> helpers;
  for (int i = 1; i < threads; ++i) helpers.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& helper : helpers) helper.get();
}

}  // namespace render

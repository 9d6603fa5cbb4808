#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

/// Counts the allocations of a whole program, an answer that is linked into it included. It
/// replaces the operators, so one file of a program includes it.
namespace tests {

inline std::atomic<std::size_t> allocations{0};

}  // namespace tests

// Those of the array forms call these. Seen inlined, GCC would take free for the wrong end of new.
void* operator new(std::size_t size) {
  ++tests::allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;  // NOLINT
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // the sanitizer has its own
  ++tests::allocations;
  return std::malloc(size == 0 ? 1 : size);  // NOLINT
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }  // NOLINT
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);  // NOLINT
}

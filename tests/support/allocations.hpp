#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

#include "allocation_count.hpp"

/// Counts the allocations of a whole program, including an answer that is linked into it. It
/// replaces the operators, so only one file of a program may include it.

// The array forms call these. If GCC inlined them, it would report free as the wrong end of new.
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

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/wide_bvh/lanes.hpp"
#include "common/wide_bvh/wide_bvh.hpp"

namespace common {

/// Pairs of triangles that wait until their corners are loaded and until they fill a register.
template <bool moved>
class TriangleBatch {
 public:
  TriangleBatch(const WideBvh& a, const WideBvh& b, const RigidTransform& a_from_b,
                TrianglesMeet triangles_meet)
      : a_(a), b_(b), a_from_b_(a_from_b), triangles_meet_(triangles_meet) {}

  /// Adds an entry of a and an entry of b.
  void add(std::uint32_t a, std::uint32_t b) {
    fetch(a_.entries()[a]);
    fetch(b_.entries()[b]);
    waiting_[size_++] = {a, b};
    if (size_ == waiting_.size()) test();
  }

  /// Returns all pairs that meet.
  std::vector<TriangleIndices> sorted_pairs();

 private:
  static void fetch(const WideBvh::Entry& entry) {
    const auto* const bytes = reinterpret_cast<const char*>(&entry);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + 64);
  }
  void test();
  void test(const TriangleIndices* pairs, std::size_t count);

  const WideBvh& a_;
  const WideBvh& b_;
  const RigidTransform& a_from_b_;
  TrianglesMeet triangles_meet_;
  std::size_t size_ = 0;
  std::array<TriangleIndices, 64> waiting_{};
  std::vector<std::uint64_t> met_;  ///< a in the upper half, b in the lower
};

}  // namespace common

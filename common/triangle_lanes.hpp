#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/lanes.hpp"
#include "common/wide_bvh.hpp"

namespace common {

/// Pairs of triangles that wait until a register is full of them.
class TriangleBatch {
 public:
  explicit TriangleBatch(TrianglesMeet triangles_meet) : triangles_meet_(triangles_meet) {}

  /// Corners as nine coordinates, each WideBvh::leaf_size after the one before.
  void add(const TriangleIndices& pair, const double* corners_a, const double* corners_b) {
    for (std::size_t k = 0; k < 9; ++k) {
      corners_[k][size_] = corners_a[k * WideBvh::leaf_size];
      corners_[9 + k][size_] = corners_b[k * WideBvh::leaf_size];
    }
    pairs_[size_++] = pair;
    if (size_ == double_lanes) test();
  }

  /// All that meet.
  std::vector<TriangleIndices> sorted_pairs();

 private:
  void test();

  TrianglesMeet triangles_meet_;
  std::size_t size_ = 0;
  alignas(register_bytes) std::array<std::array<double, double_lanes>, 18> corners_{};
  std::array<TriangleIndices, double_lanes> pairs_{};
  std::vector<std::uint64_t> met_;  ///< a in the upper half, b in the lower
};

}  // namespace common

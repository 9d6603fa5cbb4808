#pragma once

#include <array>
#include <cstddef>

#include "common/exact/double_double.hpp"

namespace common {

/// A sum of doubles and of products of doubles without any rounding. Its value is read correctly to
/// an ulp. Use it if a difference decides, for example on which side of the separatrix a state
/// lies, and rounding must not. Shewchuk 1997, Discrete & Computational Geometry 18,
/// "Grow-Expansion".
///
/// It is exact as long as no product of two parts falls below 1e-290. The array has room for all
/// parts, because they do not overlap and so share the range of a double.
class ExactSum {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const DoubleDouble sum = two_sum(term, parts_[i]);
      if (sum.low != 0.0) parts_[kept++] = sum.low;
      term = sum.high;
    }
    if (term != 0.0) parts_[kept++] = term;
    size_ = kept;
  }

  void add_product(double a, double b) {
    const DoubleDouble product = two_product(a, b);
    add(product.low);
    add(product.high);
  }

  void add_product(const ExactSum& a, const ExactSum& b) {
    for (std::size_t i = 0; i < a.size_; ++i) {
      for (std::size_t j = 0; j < b.size_; ++j) add_product(a.parts_[i], b.parts_[j]);
    }
  }

  [[nodiscard]] double value() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size_; ++i) sum += parts_[i];  // rising sizes, no overlap
    return sum;
  }

 private:
  std::array<double, 48> parts_{};
  std::size_t size_ = 0;
};

}  // namespace common

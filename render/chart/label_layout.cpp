#include "render/chart/label_layout.hpp"

#include <algorithm>
#include <numeric>

namespace render {
namespace {

/// Labels that touch and move as one.
struct Pool {
  double mean = 0.0;
  std::size_t count = 0;
};

Pool merged(const Pool& a, const Pool& b) {
  const auto weight_a = static_cast<double>(a.count);
  const auto weight_b = static_cast<double>(b.count);
  return {(weight_a * a.mean + weight_b * b.mean) / (weight_a + weight_b), a.count + b.count};
}

}  // namespace

std::vector<double> spread(std::vector<double> heights, double gap) {
  std::vector<std::size_t> order(heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  // With i gaps taken off the i-th, they only have to rise: isotonic regression, by pooling.
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < order.size(); ++i) {
    Pool pool{heights[order[i]] - gap * static_cast<double>(i), 1};
    while (!pools.empty() && pools.back().mean > pool.mean) {
      pool = merged(pools.back(), pool);
      pools.pop_back();
    }
    pools.push_back(pool);
  }
  const double highest =
      0.99 - gap * static_cast<double>(std::max<std::size_t>(1, order.size()) - 1);
  std::size_t i = 0;
  for (const Pool& pool : pools) {
    for (const std::size_t end = i + pool.count; i < end; ++i) {
      const double height = std::min(std::max(pool.mean, 0.02), highest);
      heights[order[i]] = height + gap * static_cast<double>(i);
    }
  }
  return heights;
}

}  // namespace render

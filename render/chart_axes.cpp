#include "render/chart_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace render {
namespace {

constexpr double text_height = 0.058;  // of a label in the margin, in heights of the plot

void add(Range& range, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

/// Widened to whole decades; one decade where nothing was added.
Range decades(const Range& range) {
  if (range.low > range.high) return {0.1, 1.0};
  const double low = std::floor(std::log10(range.low));
  const double high = std::max(low + 1.0, std::ceil(std::log10(range.high)));
  return {std::pow(10.0, low), std::pow(10.0, high)};
}

double graph_height(const Axes& axes, double error) {
  const double clipped = std::clamp(error, axes.error.low, axes.error.high);
  return std::log(clipped / axes.error.low) / std::log(axes.error.high / axes.error.low);
}

}  // namespace

Axes chart_axes(const Chart& chart) {
  Axes axes;
  for (const ChartSeries& series : chart.series) {
    for (const ChartPoint& point : series.points) {
      add(axes.seconds, point.seconds);
      if (point.status == Status::ok) add(axes.error, point.error);
    }
  }
  if (chart.failure_error > 0.0) add(axes.error, 3.0 * chart.failure_error);
  axes.seconds = decades(axes.seconds);
  axes.error = decades(axes.error);
  // The floor is drawn where it is near; from afar it would press the curves into a corner, and a
  // line of text under them says how far.
  const bool near = chart.rounding_floor > axes.error.low * 1e-3;
  axes.error.low = near ? 0.1 * chart.rounding_floor : 0.1 * axes.error.low;
  return axes;
}

std::vector<double> label_heights(const Chart& chart, const Axes& axes) {
  const std::size_t count = chart.series.size();
  std::vector<double> heights(count, 0.0);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    if (!chart.series[i].points.empty()) {
      heights[i] = graph_height(axes, chart.series[i].points.back().error);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  double lowest = 0.02;
  for (const std::size_t i : order) {
    heights[i] = std::max(heights[i], lowest);
    lowest = heights[i] + text_height;
  }
  double highest = 0.99;  // and down again where they were pushed out at the top
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    heights[*i] = std::min(heights[*i], highest);
    highest = heights[*i] - text_height;
  }
  return heights;
}

}  // namespace render

#include "render/chart/chart_axes.hpp"

#include <algorithm>
#include <cmath>

#include "render/chart/label_layout.hpp"

namespace render {
namespace {

constexpr double words_height = 0.058;  // in heights of the plot

void add(Range& range, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return;
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

/// Words stand above the failure's line and below the rounding floor's, inside the frame.
void make_room_for_words(const Chart& chart, Range& error) {
  const auto is_tight = [&](double from, double to) {
    return std::log(to / from) < words_height * std::log(error.high / error.low);
  };
  if (chart.failure_error > 0.0) {
    while (is_tight(error_below_words(chart), error.high)) error.high *= 10.0;
  }
  if (chart.rounding_floor > error.low) {
    while (is_tight(error.low, chart.rounding_floor)) error.low *= 0.1;
  }
}

double graph_height(const Axes& axes, double error) {
  const double clipped = std::clamp(error, axes.error.low, axes.error.high);
  return std::log(clipped / axes.error.low) / std::log(axes.error.high / axes.error.low);
}

}  // namespace

double error_below_words(const Chart& chart) {
  constexpr double close = 30.0;
  double error = chart.failure_error;
  for (const ChartSeries& series : chart.series) {
    for (const ChartPoint& point : series.points) {
      const bool is_close = point.error < close * chart.failure_error;
      if (point.status == Status::unstable && is_close) error = std::max(error, point.error);
    }
  }
  return error;
}

Range decades(const Range& range) {
  if (range.low > range.high) return {0.1, 1.0};
  const double low = std::floor(std::log10(range.low));
  const double high = std::max(low + 1.0, std::ceil(std::log10(range.high)));
  return {std::pow(10.0, low), std::pow(10.0, high)};
}

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
  make_room_for_words(chart, axes.error);
  return axes;
}

std::vector<double> label_heights(const Chart& chart, const Axes& axes, double gap) {
  std::vector<double> heights;
  for (const ChartSeries& series : chart.series) {
    heights.push_back(series.points.empty() ? 0.0 : graph_height(axes, series.points.back().error));
  }
  return spread(heights, gap);
}

}  // namespace render

#include "render/chart/history_chart_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/chart/chart_axes.hpp"

namespace render {
namespace {

constexpr double reaches_the_end = 0.985;  // of the time axis; sampling may stop a little short
constexpr double room = 0.06;              // above and below the values, in heights of the panel
constexpr double least_span = 0.01;        // of the values' size: a constant is drawn as constant
constexpr double least_intervals = 3.0;    // between tics
constexpr std::size_t stretches = 1000;    // a panel is about 1000 pixels wide

Interval with_room(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  const double least = size > 0.0 ? least_span * size : 1.0;
  const double widened = std::max(0.0, 0.5 * (least - (high - low)));
  const double margin = widened + room * std::max(high - low, least);
  return {low - margin, high + margin};
}

}  // namespace

double tic_step(const Interval& axis) {
  const double most = (axis.high - axis.low) / least_intervals;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

Interval time_axis(const HistoryChart& chart) {
  Interval time{std::numeric_limits<double>::infinity(), 0.0};
  for (const HistoryPanel& panel : chart.panels) {
    for (const HistoryCurve& curve : panel.curves) {
      if (curve.times.empty()) continue;
      time.low = std::min(time.low, curve.times.front());
      time.high = std::max(time.high, curve.times.back());
    }
  }
  if (!(time.high > time.low)) return {0.0, 1.0};
  const double step = tic_step(time);
  const double near = (1.0 - reaches_the_end) * (time.high - time.low);
  const double first = step * std::floor(time.low / step);
  const double last = step * std::ceil(time.high / step);
  return {time.low - first < near ? first : time.low, last - time.high < near ? last : time.high};
}

Interval value_axis(const HistoryPanel& panel) {
  if (panel.low < panel.high) return {panel.low, panel.high};
  Range positive;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const HistoryCurve& curve : panel.curves) {
    for (const double value : curve.values) {
      low = std::min(low, value);
      high = std::max(high, value);
      if (value > 0.0) {
        positive.low = std::min(positive.low, value);
        positive.high = std::max(positive.high, value);
      }
    }
  }
  if (panel.logarithmic) {
    const Range whole = decades(positive);
    return {whole.low, whole.high};
  }
  if (low > high) return {};
  return with_room(low, high);
}

double height_on(const HistoryPanel& panel, const Interval& axis, double value) {
  const double clipped = std::clamp(value, axis.low, axis.high);
  return panel.logarithmic ? std::log(clipped / axis.low) / std::log(axis.high / axis.low)
                           : (clipped - axis.low) / (axis.high - axis.low);
}

bool ends_early(const HistoryCurve& curve, const Interval& time) {
  if (curve.times.empty()) return false;
  return !curve.end.empty() ||
         curve.times.back() < time.low + reaches_the_end * (time.high - time.low);
}

Moment visible_end(const HistoryCurve& curve, const Interval& axis) {
  const auto is_above = [&](std::size_t i) { return curve.values[i] > axis.high; };
  const auto is_below = [&](std::size_t i) { return curve.values[i] < axis.low; };
  std::size_t i = curve.values.size() - 1;
  const bool above = is_above(i);
  const bool below = is_below(i);
  while (i > 0 && ((above && is_above(i - 1)) || (below && is_below(i - 1)))) --i;
  return {curve.times[i], std::clamp(curve.values[i], axis.low, axis.high)};
}

std::vector<Moment> thinned(const HistoryCurve& curve) {
  std::vector<Moment> kept;
  const std::size_t count = curve.times.size();
  const std::size_t step = std::max<std::size_t>(1, count / stretches);
  for (std::size_t start = 0; start < count; start += step) {
    const auto from = curve.values.begin() + static_cast<std::ptrdiff_t>(start);
    const auto to =
        curve.values.begin() + static_cast<std::ptrdiff_t>(std::min(start + step, count));
    const auto [least, greatest] = std::minmax_element(from, to);
    const auto first = static_cast<std::size_t>(std::min(least, greatest) - curve.values.begin());
    const auto second = static_cast<std::size_t>(std::max(least, greatest) - curve.values.begin());
    kept.push_back({curve.times[first], curve.values[first]});
    if (second != first) kept.push_back({curve.times[second], curve.values[second]});
  }
  if (!kept.empty() && kept.back().time != curve.times.back()) {
    kept.push_back({curve.times.back(), curve.values.back()});
  }
  return kept;
}

}  // namespace render

#pragma once

#include <vector>

#include "render/chart/history_chart.hpp"

namespace render {

/// The interval that an axis shows.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// A point of a curve.
struct Moment {
  double time = 0.0;
  double value = 0.0;
};

/// Returns the greatest of 1, 2 and 5 times a power of ten that fits three times or more.
double tic_step(const Interval& axis);

/// Returns the interval from the first to the last time of any curve, and on to a tic that is near.
Interval time_axis(const HistoryChart& chart);

/// Returns the panel's own limits, or limits that hold every value with a little room. They are
/// whole decades if the panel is logarithmic.
Interval value_axis(const HistoryPanel& panel);

/// Returns the place of a value on its axis: 0 at the foot, 1 at the head, no further.
double height_on(const HistoryPanel& panel, const Interval& axis, double value);

/// Returns whether the curve says why it ends, or stops before the others do.
bool ends_early(const HistoryCurve& curve, const Interval& time);

/// Returns the last point that is seen: the last one, or the last before it left the axis for good.
Moment visible_end(const HistoryCurve& curve, const Interval& axis);

/// Returns at most about 2000 points that look the same: both extremes of each short stretch.
std::vector<Moment> thinned(const HistoryCurve& curve);

}  // namespace render

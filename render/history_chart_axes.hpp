#pragma once

#include <vector>

#include "render/history_chart.hpp"

namespace render {

/// What an axis shows.
struct Interval {
  double low = 0.0;
  double high = 1.0;
};

/// A point of a curve.
struct Moment {
  double time = 0.0;
  double value = 0.0;
};

/// The greatest of 1, 2 and 5 times a power of ten that parts the interval at least three times.
double tic_step(const Interval& axis);

/// From the first to the last time of any curve, and on to a tic that is near.
Interval time_axis(const HistoryChart& chart);

/// The panel's own limits, or those that hold every value with a little room: whole decades where
/// it is logarithmic.
Interval value_axis(const HistoryPanel& panel);

/// Where a value stands on its axis: 0 at the foot, 1 at the head, no further.
double height_on(const HistoryPanel& panel, const Interval& axis, double value);

/// Whether the curve says why it ends, or stops before the others do.
bool ends_early(const HistoryCurve& curve, const Interval& time);

/// Where it is seen last: its last point, or the last before it left the axis for good.
Moment visible_end(const HistoryCurve& curve, const Interval& axis);

/// At most some 2000 points that look the same: the least and the greatest of each short stretch.
std::vector<Moment> thinned(const HistoryCurve& curve);

}  // namespace render

#pragma once

#include <limits>
#include <vector>

#include "render/chart/chart.hpp"

namespace render {

/// An interval of a logarithmic axis.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
};

struct Axes {
  Range seconds;
  Range error;
};

/// Returns whole decades that hold every point that is drawn. An error that grew without limit does
/// not count; it is drawn at the top edge.
Axes chart_axes(const Chart& chart);

/// Returns the error above which the words on failure are drawn: that of the failure, or of the
/// worst crosses if those are close above it.
double error_below_words(const Chart& chart);

/// Widens a range to whole decades. Returns one decade if nothing was added.
Range decades(const Range& range);

/// Returns the places of the labels in the margin, in heights of the plot from its foot. They are
/// beside the last points, pushed apart to `gap`.
std::vector<double> label_heights(const Chart& chart, const Axes& axes, double gap);

}  // namespace render

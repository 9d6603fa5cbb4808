#pragma once

#include <limits>
#include <vector>

#include "render/chart.hpp"

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

/// Whole decades that hold every point that is drawn. An error that grew without limit does not
/// count: it stands at the top edge.
Axes chart_axes(const Chart& chart);

/// The error above which the words on failure stand: that of the failure, or of the worst crosses
/// where those lie close above it.
double error_below_words(const Chart& chart);

/// Widened to whole decades; one decade where nothing was added.
Range decades(const Range& range);

/// Where the labels stand in the margin, in heights of the plot from its foot: beside the last
/// points, pushed apart to `gap`.
std::vector<double> label_heights(const Chart& chart, const Axes& axes, double gap);

}  // namespace render

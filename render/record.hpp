#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/history_chart.hpp"

namespace render {

/// What became of one method's motion. Some thousand moments are enough: all of them go to the CSV.
struct History {
  std::vector<double> times;
  std::vector<std::vector<double>>
      values;       ///< a list a panel of the chart, each as long as `times`
  std::string end;  ///< why it stops before the others, as in "blew up"
};

/// A method of a lab as a history chart watches it.
struct HistoryMethod {
  std::string name;
  Colour colour = palette::ink;
  std::function<History()> record;
  bool is_peer = false;  ///< another's code, see HistoryCurve
};

/// The chart with a curve a method in every panel. A method that throws common::NotImplemented
/// becomes curves without points that name the step. Throws std::invalid_argument where a method
/// gives another number of lists than there are panels.
HistoryChart recorded(HistoryChart chart, const std::vector<HistoryMethod>& methods);

}  // namespace render

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/chart/history_chart.hpp"

namespace render {

/// The motion of one method. A few thousand moments are enough, because all of them go to the CSV.
struct History {
  std::vector<double> times;
  std::vector<std::vector<double>> values;  ///< one list for each panel, each as long as `times`
  std::string end;                          ///< why it stops before the others, as in "blew up"
};

/// A method of a lab, as a history chart records it.
struct HistoryMethod {
  std::string name;
  Colour colour = palette::ink;
  std::function<History()> record;
  bool is_peer = false;  ///< another's code, see HistoryCurve
};

/// Returns the chart with a curve for each method in every panel. A method that throws
/// common::NotImplemented becomes curves without points that name the step. Throws
/// std::invalid_argument if a method does not give as many lists as there are panels.
HistoryChart recorded(HistoryChart chart, const std::vector<HistoryMethod>& methods);

}  // namespace render

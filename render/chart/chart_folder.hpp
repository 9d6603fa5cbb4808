#pragma once

#include <filesystem>
#include <vector>

#include "render/chart/chart.hpp"
#include "render/chart/history_chart.hpp"

namespace render {

/// All charts of a program. The very first is the main one.
struct ChartSet {
  std::vector<Chart> charts;
  std::vector<HistoryChart> histories;
};

/// Writes NAME.csv, NAME.gp and, if gnuplot is installed, NAME.svg and NAME.png of each chart into
/// `folder`. It also writes charts.txt, with one line a chart: its name, a tab, its title. The
/// folder appears whole or not at all. Returns whether pictures were drawn.
/// Throws std::runtime_error that names the folder or quotes gnuplot. Throws std::invalid_argument
/// if two charts have one name, or if a name is not the stem of a file.
bool write_charts(const ChartSet& set, const std::filesystem::path& folder);

}  // namespace render

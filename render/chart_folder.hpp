#pragma once

#include <filesystem>
#include <vector>

#include "render/chart.hpp"
#include "render/history_chart.hpp"

namespace render {

/// All charts of a program. The first of all is the main one.
struct ChartSet {
  std::vector<Chart> charts;
  std::vector<HistoryChart> histories;
};

/// Writes NAME.csv, NAME.gp and, where gnuplot is installed, NAME.svg and NAME.png of each chart
/// into `folder`, and charts.txt, which has a line a chart: its name, a tab, its title. The folder
/// appears whole or not at all. Returns whether pictures were drawn.
/// Throws std::runtime_error that names the folder, or says what gnuplot said, and
/// std::invalid_argument where two charts have one name, or a name is no file's stem.
bool write_charts(const ChartSet& set, const std::filesystem::path& folder);

}  // namespace render

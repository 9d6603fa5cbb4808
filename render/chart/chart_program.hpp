#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/chart/chart.hpp"
#include "render/chart/history_chart.hpp"
#include "render/chart/measure.hpp"
#include "render/chart/record.hpp"

namespace render {

/// The text of an error chart, and the methods that become its series.
struct MeasuredChart {
  Chart chart;
  std::vector<Method> methods;
};

/// The text of a history chart, its panels without curves, and the methods that become the curves.
struct RecordedChart {
  HistoryChart chart;
  std::vector<HistoryMethod> methods;
};

/// The charts that a chart program draws. The first chart is the main one.
struct ChartPlan {
  std::vector<MeasuredChart> charts;
  std::vector<RecordedChart> histories;
  std::vector<std::string> left_out;  ///< as in "Bullet (libbullet-dev is not installed)"
};

/// The request to a chart program.
struct ChartRequest {
  bool peers = false;  ///< other engines, too
  Extent extent = Extent::full;
};

/// Runs the body of a chart program: --out DIR [--short] [--beside ANSWER DIR]... It times the
/// methods of all charts together, so that the machine's noise does not distort one of them. Any
/// error becomes one line on stderr and a non-zero exit code. It names the methods that it leaves
/// out because they are not written yet, and each chart none of whose methods is written. If no
/// chart is left, it draws nothing. With --short it measures all briefly, and a note below each
/// chart says so. --beside draws in the measurement that another answer's program has written to
/// DIR, see draw_beside.
int chart_main(int argc, char** argv, const ChartPlan& plan);

/// Does the same for a lab with peers:  --out DIR [--peers] [--short] [--beside ANSWER DIR]... The
/// plan with peers has their methods, too, with `is_peer`, and in `left_out` the peers that are not
/// installed. A brief plan may have shorter ladders.
int chart_main(int argc, char** argv, const std::function<ChartPlan(const ChartRequest&)>& plan);

}  // namespace render

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/chart.hpp"
#include "render/history_chart.hpp"
#include "render/measure.hpp"
#include "render/record.hpp"

namespace render {

/// The words of an error chart, and the methods that become its series.
struct MeasuredChart {
  Chart chart;
  std::vector<Method> methods;
};

/// The words of a history chart, its panels without curves, and the methods that become those.
struct RecordedChart {
  HistoryChart chart;
  std::vector<HistoryMethod> methods;
};

/// What a chart program draws. The first chart is the main one.
struct ChartPlan {
  std::vector<MeasuredChart> charts;
  std::vector<RecordedChart> histories;
  std::vector<std::string> left_out;  ///< as in "Bullet (libbullet-dev is not installed)"
};

/// What is asked of a chart program.
struct ChartRequest {
  bool peers = false;  ///< other engines, too
  Extent extent = Extent::full;
};

/// The body of a chart program:  --out DIR [--short] [--beside ANSWER DIR]... The methods of all
/// charts are timed together, so that the machine's noise bends none of them. Whatever is wrong
/// becomes one line on stderr and a non-zero exit code. Methods that are left out since they are
/// not written yet are named, and so is a chart none of whose methods is written; where no chart is
/// left nothing is drawn. With
/// --short all is measured briefly, and a note below each chart says so. --beside draws in what
/// another answer's program has measured into DIR, see draw_beside.
int chart_main(int argc, char** argv, const ChartPlan& plan);

/// The same for a lab with peers:  --out DIR [--peers] [--short] [--beside ANSWER DIR]... The plan
/// with peers has their methods too, with `is_peer`, and in `left_out` the peers that are not
/// installed. A brief plan may have shorter ladders.
int chart_main(int argc, char** argv, const std::function<ChartPlan(const ChartRequest&)>& plan);

}  // namespace render

#include "render/chart/chart_program.hpp"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "common/course/run_main.hpp"
#include "render/chart/chart_beside.hpp"
#include "render/chart/chart_folder.hpp"

namespace render {
namespace {

/// Where another answer's charts are.
struct Other {
  std::string answer;
  std::string folder;
};

struct Options {
  std::string folder;
  ChartRequest request;
  std::vector<Other> others;
};

Options options_from(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto usage = [&] {
    return std::runtime_error(std::string("usage: ") + argv[0] +
                              " --out DIR [--peers] [--short] [--beside ANSWER DIR]...");
  };
  if (words.size() < 2 || words[0] != "--out") throw usage();
  Options options{words[1], {}, {}};
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "--peers" && !options.request.peers) {
      options.request.peers = true;
    } else if (words[i] == "--short" && options.request.extent == Extent::full) {
      options.request.extent = Extent::brief;
    } else if (words[i] == "--beside" && i + 2 < words.size()) {
      options.others.push_back({words[i + 1], words[i + 2]});
      i += 2;
    } else {
      throw usage();
    }
  }
  return options;
}

/// As in "5" of "5_bvh_traversal".
std::string lab_number(const std::string& lab) { return lab.substr(0, lab.find('_')); }

std::string note_of(const Chart& chart, Extent extent) {
  if (extent == Extent::full) return "";
  return "a short measurement: few repeats, no long runs; for the full one: "
         "./tumble chart " +
         lab_number(chart.lab);
}

/// All methods of all charts go through one measurement.
std::vector<Chart> measured_charts(const std::vector<MeasuredChart>& plan, Extent extent) {
  std::vector<Method> methods;
  for (const MeasuredChart& part : plan) {
    methods.insert(methods.end(), part.methods.begin(), part.methods.end());
  }
  const std::vector<ChartSeries> series = measured(methods, extent);
  std::vector<Chart> charts;
  auto next = series.begin();
  for (const MeasuredChart& part : plan) {
    const auto end = std::next(next, static_cast<std::ptrdiff_t>(part.methods.size()));
    charts.push_back(part.chart);
    charts.back().series.assign(next, end);
    charts.back().note = note_of(part.chart, extent);
    next = end;
  }
  return charts;
}

bool has_points(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(),
                     [](const ChartSeries& series) { return !series.points.empty(); });
}

bool has_points(const HistoryChart& chart) {
  return std::any_of(chart.panels.begin(), chart.panels.end(), [](const HistoryPanel& panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [](const HistoryCurve& curve) { return !curve.times.empty(); });
  });
}

/// Takes charts without a point out, and names them.
template <typename AnyChart>
void remove_empty(std::vector<AnyChart>& charts, std::set<std::string>& left_out) {
  for (const AnyChart& chart : charts) {
    if (!has_points(chart)) {
      left_out.insert("chart " + chart.name + " (none of its methods is written yet)");
    }
  }
  std::erase_if(charts, [](const AnyChart& chart) { return !has_points(chart); });
}

/// Each method once, in however many charts it is missing.
std::set<std::string> missing_methods(const ChartSet& set) {
  std::set<std::string> left_out;
  const auto note = [&](const std::string& method, const std::string& missing) {
    if (!missing.empty()) left_out.insert(method + " (" + missing + " is not written yet)");
  };
  for (const Chart& chart : set.charts) {
    for (const ChartSeries& series : chart.series) note(series.method, series.missing);
  }
  for (const HistoryChart& chart : set.histories) {
    for (const HistoryPanel& panel : chart.panels) {
      for (const HistoryCurve& curve : panel.curves) note(curve.method, curve.missing);
    }
  }
  return left_out;
}

void draw(const ChartPlan& plan, const Options& options) {
  ChartSet set;
  set.charts = measured_charts(plan.charts, options.request.extent);
  for (const Other& other : options.others) {
    for (Chart& chart : set.charts) draw_beside(chart, other.answer, other.folder);
  }
  for (const RecordedChart& part : plan.histories) {
    set.histories.push_back(recorded(part.chart, part.methods));
  }
  std::set<std::string> left_out = missing_methods(set);
  left_out.insert(plan.left_out.begin(), plan.left_out.end());
  remove_empty(set.charts, left_out);
  remove_empty(set.histories, left_out);
  for (const std::string& what : left_out) std::cerr << "left out: " << what << '\n';
  if (set.charts.empty() && set.histories.empty()) {
    throw std::runtime_error(
        "nothing to draw: none of the lab's methods is written yet; begin with ./tumble test");
  }
  if (!write_charts(set, options.folder)) {
    std::cerr
        << "no pictures, because gnuplot is not installed (CSV files and scripts are written)\n";
  }
}

}  // namespace

int chart_main(int argc, char** argv, const ChartPlan& plan) {
  return common::run_main([&] {
    const Options options = options_from(argc, argv);
    if (options.request.peers)
      throw std::runtime_error("this lab has no other engines to draw: leave out --peers");
    draw(plan, options);
  });
}

int chart_main(int argc, char** argv, const std::function<ChartPlan(const ChartRequest&)>& plan) {
  return common::run_main([&] {
    const Options options = options_from(argc, argv);
    draw(plan(options.request), options);
  });
}

}  // namespace render

#include <algorithm>
#include <cmath>
#include <set>

#include "render/chart/gnuplot_script.hpp"
#include "render/chart/history_chart.hpp"
#include "render/chart/history_chart_axes.hpp"
#include "render/chart/label_layout.hpp"

namespace render {
namespace {

// In units of a Sheet.
constexpr double heading_height = 31.0;
constexpr double gap_height = 20.0;  // between a panel and the heading of the next
constexpr double least_panel_height = 200.0;
constexpr double most_decades_marked = 6.0;

/// The chart as it is drawn: curves that are missing are left out, peers are grey.
HistoryChart drawn(HistoryChart chart) {
  for (HistoryPanel& panel : chart.panels) {
    std::erase_if(panel.curves, [](const HistoryCurve& curve) { return !curve.missing.empty(); });
    std::size_t peers = 0;
    for (HistoryCurve& curve : panel.curves) {
      if (curve.is_peer) curve.colour = peer_colour(peers++);
    }
  }
  std::erase_if(chart.panels, [](const HistoryPanel& panel) { return panel.curves.empty(); });
  return chart;
}

std::vector<std::string> notes(const HistoryChart& chart) {
  std::set<std::string> steps;
  for (const HistoryPanel& panel : chart.panels) {
    for (const HistoryCurve& curve : panel.curves) {
      if (!curve.missing.empty()) steps.insert(curve.missing);
    }
  }
  std::string missing;
  for (const std::string& step : steps) missing += (missing.empty() ? "" : ", ") + step;
  if (missing.empty()) return {};
  return {"not written yet: " + missing};
}

std::string label_of(const HistoryCurve& curve, const HistoryChart& chart, const Interval& time) {
  if (!ends_early(curve, time)) return curve.method;
  return "× " + curve.method + ": " + (curve.end.empty() ? "ends" : curve.end) +
         formatted(" at %.3g", curve.times.back()) +
         (chart.x_unit.empty() ? "" : " " + chart.x_unit);
}

/// All panels are as high as the one with most labels needs.
double panel_height(const HistoryChart& shown) {
  std::size_t most = 0;
  for (const HistoryPanel& panel : shown.panels) most = std::max(most, panel.curves.size());
  return std::max(least_panel_height, label_height * static_cast<double>(most));
}

Sheet sheet_for(const HistoryChart& chart, const HistoryChart& shown) {
  std::vector<std::string> labels;
  const Interval time = time_axis(shown);
  for (const HistoryPanel& panel : shown.panels) {
    for (const HistoryCurve& curve : panel.curves) labels.push_back(label_of(curve, chart, time));
  }
  const auto count = static_cast<double>(shown.panels.size());
  return make_sheet({chart.name, chart.title, chart.subtitle, notes(chart), labels,
                     count * (heading_height + panel_height(shown)) + (count - 1.0) * gap_height});
}

std::string block_name(std::size_t panel, std::size_t curve) {
  return "$curve_" + std::to_string(panel + 1) + "_" + std::to_string(curve + 1);
}

/// What lies beyond the axis is kept near it: gnuplot cuts the line at the edge.
std::string data_block(const std::string& name, const HistoryCurve& curve,
                       const HistoryPanel& panel, const Interval& axis) {
  const double span = axis.high - axis.low;
  const double low = panel.logarithmic ? axis.low : axis.low - span;
  std::string s = name + " << EOD\n";
  for (const Moment& moment : thinned(curve)) {
    s += formatted("%.10g %.10g\n", moment.time, std::clamp(moment.value, low, axis.high + span));
  }
  return s + "EOD\n";
}

std::string value_tics(const HistoryPanel& panel, const Interval& axis) {
  if (!panel.logarithmic) {
    return formatted("unset logscale y\nset format y '%%g'\nset ytics %g\n", tic_step(axis));
  }
  const double step = std::ceil(std::log10(axis.high / axis.low) / most_decades_marked);
  return formatted("set logscale y\nset format y '10^{%%T}'\nset ytics %g\n",
                   std::pow(10.0, std::max(1.0, step)));
}

std::string frame(const HistoryChart& shown, const Sheet& sheet, std::size_t index) {
  const HistoryPanel& panel = shown.panels[index];
  const Interval axis = value_axis(panel);
  const double height = panel_height(shown);
  const double top = sheet.top + heading_height +
                     static_cast<double>(index) * (height + gap_height + heading_height);
  const bool is_last = index + 1 == shown.panels.size();
  std::string s = formatted("set tmargin at screen %.4f\nset bmargin at screen %.4f\n",
                            screen_height(sheet, top), screen_height(sheet, top + height));
  s += value_tics(panel, axis) + formatted("set yrange [%.10g:%.10g]\n", axis.low, axis.high);
  s += std::string("set format x ") + (is_last ? "'%g'" : "''") + "\n";
  if (is_last) {
    const std::string x_unit = shown.x_unit.empty() ? "" : " [" + shown.x_unit + "]";
    s += "set xlabel " + gnuplot_text(shown.x_name + x_unit) + " noenhanced tc rgb '#282c34'\n";
  }
  const std::string unit = panel.unit.empty() ? "" : " [" + panel.unit + "]";
  return s + "set label 900 " + gnuplot_text(panel.quantity + unit) +
         " at graph 0, graph 1 offset 0,0.85 noenhanced tc rgb '#282c34'\n";
}

/// Labels in the margin; a thin line leads to the end of a curve, a cross stands where it stops
/// early.
std::string direct_labels(const HistoryChart& shown, const HistoryPanel& panel) {
  const Interval time = time_axis(shown);
  const Interval axis = value_axis(panel);
  std::vector<double> heights;
  for (const HistoryCurve& curve : panel.curves) {
    heights.push_back(height_on(panel, axis, curve.values.back()));
  }
  heights = spread(heights, label_height / panel_height(shown));
  std::string s;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const HistoryCurve& curve = panel.curves[i];
    const int tag = static_cast<int>(i) + 1;
    s += formatted("set label %d ", tag) + gnuplot_text(label_of(curve, shown, time)) +
         formatted(" at graph 1.045, graph %.4f noenhanced", heights[i]) +
         text_colour(curve.colour) + "\n";
    const Moment end = visible_end(curve, axis);
    if (ends_early(curve, time)) {
      s += formatted("set label %d '' at first %.10g, first %.10g point lw 2 pt 2 ps 1.3",
                     tag + 100, end.time, end.value) +
           line_colour(curve.colour) + " front\n";
    } else {
      s += formatted("set arrow %d from first %.10g, first %.10g to graph 1.035, graph %.4f", tag,
                     end.time, end.value, heights[i]) +
           " nohead lw 0.7 dt (1,4)" + line_colour(curve.colour) + " back\n";
    }
  }
  return s;
}

/// The first is the thickest and lies lowest, so that curves that agree are still seen as several.
std::string plot(const HistoryPanel& panel, std::size_t index) {
  std::string s;
  const std::size_t count = panel.curves.size();
  for (std::size_t i = 0; i < count; ++i) {
    const HistoryCurve& curve = panel.curves[i];
    const double width = 1.3 + 2.2 * static_cast<double>(count - 1 - i) /
                                   static_cast<double>(std::max<std::size_t>(1, count - 1));
    s += (s.empty() ? "plot " : ", \\\n     ") + block_name(index, i) + " using 1:2 with lines" +
         (curve.is_peer ? " lw 1.8 dt (6,5)" : formatted(" lw %.2g", width)) +
         line_colour(curve.colour);
  }
  return s + "\n";
}

}  // namespace

std::string history_script(const HistoryChart& chart) {
  require_drawable(chart);
  const HistoryChart shown = drawn(chart);
  const Sheet sheet = sheet_for(chart, shown);
  const Interval time = time_axis(shown);
  std::string s = sheet_start(sheet);
  s += formatted("set xrange [%.10g:%.10g]\n", time.low, time.high);
  for (std::size_t p = 0; p < shown.panels.size(); ++p) {
    const HistoryPanel& panel = shown.panels[p];
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
      s += data_block(block_name(p, c), panel.curves[c], panel, value_axis(panel));
    }
  }
  s += "do for [picture in 'svg png pdf'] {\nif (picture eq 'svg') {\n" + svg_output(sheet) +
       "}\nif (picture eq 'png') {\n" + png_output(sheet) + "}\nif (picture eq 'pdf') {\n" +
       pdf_output(sheet) + "}\nset multiplot\nunset xlabel\n" + sheet_words(sheet);
  for (std::size_t p = 0; p < shown.panels.size(); ++p) {
    s += frame(shown, sheet, p) + direct_labels(shown, shown.panels[p]) + plot(shown.panels[p], p);
    s += "unset label\nunset arrow\n";
  }
  return s + "unset multiplot\nunset output\n}\n";
}

}  // namespace render

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "render/chart/chart.hpp"
#include "render/chart/chart_axes.hpp"
#include "render/chart/gnuplot_script.hpp"

namespace render {
namespace {

constexpr double least_plot_height = 427.0;  // in units of a Sheet

std::string label_of(const ChartSeries& series) {
  return series.order > 0.0 ? series.method + formatted("  (order %g)", series.order)
                            : series.method;
}

/// The chart as it is drawn: series without points are left out, peers are grey.
Chart drawn(Chart chart) {
  std::erase_if(chart.series, [](const ChartSeries& series) { return series.points.empty(); });
  std::size_t peers = 0;
  for (ChartSeries& series : chart.series) {
    if (series.is_peer) series.colour = peer_colour(peers++);
  }
  return chart;
}

std::vector<std::string> notes(const Chart& chart) {
  std::string missing;
  for (const ChartSeries& series : chart.series) {
    if (!series.missing.empty()) missing += (missing.empty() ? "" : ", ") + series.missing;
  }
  std::vector<std::string> notes;
  if (!missing.empty()) notes.push_back("not written yet: " + missing);
  std::istringstream lines(chart.note);
  for (std::string line; std::getline(lines, line);) notes.push_back(line);
  return notes;
}

Sheet sheet_for(const Chart& chart, const Chart& shown) {
  std::vector<std::string> labels;
  for (const ChartSeries& series : shown.series) labels.push_back(label_of(series));
  const double for_labels = label_height * static_cast<double>(labels.size());
  return make_sheet({chart.name, chart.title, chart.subtitle, notes(chart), labels,
                     std::max(least_plot_height, for_labels)});
}

std::string axes_of(const Chart& chart, const Axes& axes, const Sheet& sheet) {
  std::string s = formatted("set tmargin at screen %.4f\nset bmargin at screen %.4f\n",
                            screen_height(sheet, sheet.top), screen_height(sheet, sheet.bottom));
  s += "set logscale xy\nset format '10^{%T}'\n";
  s += formatted("set xrange [%g:%g]\n", axes.seconds.low, axes.seconds.high);
  s += formatted("set yrange [%g:%g]\n", axes.error.low, axes.error.high);
  s += "set xlabel " + gnuplot_text("computing time per " + chart.work_unit + " [s]") +
       " noenhanced tc rgb '#282c34'\n";
  return s + "set ylabel " + gnuplot_text(chart.error_name + " [" + chart.error_unit + "]") +
         " noenhanced offset -0.5,0 tc rgb '#282c34'\n";
}

/// A dashed line at an error, with words above another one, or below it.
std::string horizontal(int tag, double error, const std::string& words, double words_at,
                       bool above) {
  std::string s = formatted("set arrow %d from graph 0, first %g to graph 1, first %g nohead", tag,
                            error, error);
  s += " lw 1 dt (5,4) lc rgb '#8d9299' back\n";
  s += formatted("set label %d ", tag) + gnuplot_text(words) +
       formatted(" at graph 0.985, first %g right offset 0,%s", words_at, above ? "0.9" : "-0.8") +
       " noenhanced font ',11' tc rgb '#6b7078' front boxed\n";
  return s;
}

std::string boundaries(const Chart& chart, const Axes& axes) {
  std::string s;
  if (chart.failure_error > 0.0) {
    s += horizontal(201, chart.failure_error, chart.failure_text, error_below_words(chart), true);
  }
  if (chart.rounding_floor >= axes.error.low) {
    s += horizontal(202, chart.rounding_floor, "rounding floor", chart.rounding_floor, false);
  } else if (chart.rounding_floor > 0.0) {
    const double decades = std::log10(axes.error.low / chart.rounding_floor);
    s += "set label 202 " +
         gnuplot_text(formatted("rounding floor %.0e lies %.0f decades below", chart.rounding_floor,
                                decades)) +
         " at graph 0.015, graph 0.03 noenhanced font ',11' tc rgb '#6b7078'\n";
  }
  return s;
}

/// A label in the margin and a thin line to it from the last point.
std::string direct_label(int tag, const ChartSeries& series, double height, const Range& error) {
  const ChartPoint& last = series.points.back();
  std::string s = formatted("set label %d ", tag) + gnuplot_text(label_of(series)) +
                  formatted(" at graph 1.045, graph %.4f noenhanced", height) +
                  text_colour(series.colour) + "\n";
  s += formatted("set arrow %d from first %g, first %g to graph 1.035, graph %.4f nohead", tag,
                 last.seconds, std::clamp(last.error, error.low, error.high), height);
  return s + " lw 0.7 dt (1,4)" + line_colour(series.colour) + " back\n";
}

/// As in 300, 10k, 1M.
std::string shortened(double count) {
  if (count >= 1e6) return formatted("%gM", count / 1e6);
  return count >= 1e3 ? formatted("%gk", count / 1e3) : formatted("%g", count);
}

/// The parameters of a series, each under its point.
std::string parameters(int first_tag, const ChartSeries& series) {
  std::string s;
  if (!series.shows_parameters) return s;
  for (const ChartPoint& point : series.points) {
    s += formatted("set label %d ", first_tag++) + gnuplot_text(shortened(point.parameter)) +
         formatted(" at first %g, first %g center offset 0,-0.9 noenhanced font ',10'",
                   point.seconds, point.error) +
         text_colour(series.colour) + "\n";
  }
  return s;
}

/// The longest run of points along which the error falls about as theory asks: before it steps are
/// too long for theory, after it rounding has the word.
std::vector<ChartPoint> as_in_theory(const ChartSeries& series) {
  std::vector<ChartPoint> longest;
  std::vector<ChartPoint> run;
  for (const ChartPoint& point : series.points) {
    if (point.status != Status::ok || !(point.error > 0.0)) continue;
    if (!run.empty()) {
      const double order =
          -std::log(point.error / run.back().error) / std::log(point.seconds / run.back().seconds);
      if (!(order > 0.5 * series.order && order < 2.0 * series.order)) run.clear();
    }
    run.push_back(point);
    if (run.size() > longest.size()) longest = run;
  }
  return longest;
}

/// The slope that theory asks for, through the middle of the points that obey it, a little below.
std::string slope(const ChartSeries& series) {
  if (series.order <= 0.0 || series.is_peer || series.is_other) return "";
  const std::vector<ChartPoint> good = as_in_theory(series);
  if (good.size() < 3) return "";
  const ChartPoint& middle = good[good.size() / 2];
  const ChartPoint& from = good[good.size() / 3];
  return formatted(", [t=%g:%g] '+' using (t):(%g*(t/%g)**(-%g)) with lines lw 1 dt (5,4)",
                   from.seconds, good.back().seconds, 0.45 * middle.error, middle.seconds,
                   series.order) +
         line_colour(series.colour);
}

/// The points of a series with one status, as a block of data inside the script. A logarithmic axis
/// has no zero: errors below `least` stand there.
std::string data_block(const std::string& name, const ChartSeries& series, Status status,
                       double least) {
  std::string s = "$" + name + " << EOD\n";
  bool any = false;
  for (const ChartPoint& point : series.points) {
    if (point.status != status) continue;
    s += formatted("%.17g %.17g\n", point.seconds, std::max(point.error, least));
    any = true;
  }
  return s + (any ? "" : "NaN NaN\n") + "EOD\n";
}

/// Marks on a line where the method holds, a cross where it failed. Marks are full and hollow in
/// turn and lines thick and thin, so that two series that agree are still seen as two.
std::string curve(const ChartSeries& series, std::size_t index) {
  constexpr std::array marks{7, 4, 9, 12, 5, 10};
  const std::string number = std::to_string(index + 1);
  const std::string colour = line_colour(series.colour);
  const bool dashed = series.is_peer || series.is_other;
  const bool full = index % 2 == 0 && !dashed;
  return "$good" + number + " using 1:2 with linespoints lw " + (full ? "3" : "1.5") + " ps " +
         (full ? "0.8" : "1.1") + " pt " + std::to_string(marks[index % marks.size()]) +
         (dashed ? " dt (6,5)" : "") + colour + ", $failed" + number +
         " using 1:($2 < top ? $2 : top) with points lw 2 pt 2 ps 1.1" + colour;
}

}  // namespace

std::string chart_script(const Chart& chart) {
  const Chart shown = drawn(chart);
  const Axes axes = chart_axes(shown);
  const Sheet sheet = sheet_for(chart, shown);
  const std::vector<double> heights =
      label_heights(shown, axes, label_height / (sheet.bottom - sheet.top));
  std::string s = sheet_start(sheet) + sheet_words(sheet) + axes_of(shown, axes, sheet) +
                  "set style textbox opaque noborder margins 0.5,0.1 fillcolor rgb '#ffffff'\n" +
                  boundaries(shown, axes);  // their words cover what crosses them
  const double least = std::max(shown.rounding_floor, axes.error.low);
  std::string plots;
  for (std::size_t i = 0; i < shown.series.size(); ++i) {
    const ChartSeries& series = shown.series[i];
    s += direct_label(static_cast<int>(i) + 1, series, heights[i], {least, axes.error.high});
    s += parameters(1000 + 100 * static_cast<int>(i), series);
    s += data_block("good" + std::to_string(i + 1), series, Status::ok, least);
    s += data_block("failed" + std::to_string(i + 1), series, Status::unstable, least);
    plots += (plots.empty() ? "" : ", \\\n     ") + curve(series, i) + slope(series);
  }
  s += formatted("top = %g\n", 0.8 * axes.error.high);
  return s + svg_output(sheet) + "plot " + plots + "\n" + png_output(sheet) + "replot\n" +
         pdf_output(sheet) + "replot\nunset output\n";
}

}  // namespace render

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "render/chart.hpp"
#include "render/chart_axes.hpp"

namespace render {
namespace {

constexpr double letter_width = 0.0092;  // of DejaVu Sans 13 in a picture 1000 wide, on average

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

std::string hex(const Colour& colour) {
  const auto byte = [](float part) { return static_cast<unsigned>(std::lround(255.0F * part)); };
  return formatted("#%02x%02x%02x", byte(colour.red), byte(colour.green), byte(colour.blue));
}

/// In gnuplot's single quotes, where only the quote itself is special. No text here is enhanced.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

/// In gnuplot's enhanced mode, the only one that sets bold type both in PNG and in SVG.
std::string bold(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string("{}^_@&~\\").find(c) != std::string::npos) escaped += '\\';
    escaped += c;
  }
  return quoted("{/:Bold " + escaped + "}");
}

/// Letters, not bytes.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

std::string label_of(const ChartSeries& series) {
  return series.order > 0.0 ? series.method + formatted("  (order %g)", series.order)
                            : series.method;
}

std::string header(const Chart& chart, const Axes& axes) {
  std::size_t longest = 0;
  for (const ChartSeries& series : chart.series) {
    longest = std::max(longest, letters(label_of(series)));
  }
  std::string s =
      "# gnuplot chart.gp  draws chart.svg and chart.png; the numbers are those of chart.csv.\n";
  s += "set encoding utf8\nset logscale xy\n";
  s += formatted("set xrange [%g:%g]\n", axes.seconds.low, axes.seconds.high);
  s += formatted("set yrange [%g:%g]\n", axes.error.low, axes.error.high);
  const double margin = 0.05 + static_cast<double>(longest) * letter_width;
  s += formatted("set lmargin 10\nset rmargin at screen %.4f\nset tmargin 4.6\nset bmargin 4\n",
                 1.0 - margin);
  s += "set format '10^{%T}'\nset border 3 lc rgb '#8d9299' lw 1\nset tics nomirror out scale 0.6";
  s += " tc rgb '#282c34'\nset grid xtics ytics back lt 1 lw 0.7 lc rgb '#e4e6e9'\nunset key\n";
  s += "set label 101 " + bold(chart.title) +
       " at graph 0, graph 1.13 font ',17' tc rgb '#282c34'\n";
  s += "set label 102 " + quoted(chart.subtitle) +
       " at graph 0, graph 1.055 noenhanced font ',12' tc rgb '#6b7078'\n";
  s += "set xlabel " + quoted("computing time per " + chart.work_unit + " [s]") +
       " noenhanced tc rgb '#282c34'\n";
  s += "set ylabel " + quoted(chart.error_name + " [" + chart.error_unit + "]") +
       " noenhanced offset -0.5,0 tc rgb '#282c34'\n";
  return s;
}

std::string horizontal(int tag, double error, const std::string& words, bool above) {
  std::string s = formatted("set arrow %d from graph 0, first %g to graph 1, first %g nohead", tag,
                            error, error);
  s += " lw 1 dt (6,4) lc rgb '#8d9299' back\n";
  s += formatted("set label %d ", tag) + quoted(words) +
       formatted(" at graph 0.985, first %g right offset 0,%s", error, above ? "0.7" : "-0.7") +
       " noenhanced font ',11' tc rgb '#6b7078'\n";
  return s;
}

std::string boundaries(const Chart& chart, const Axes& axes) {
  std::string s;
  if (chart.failure_error > 0.0)
    s += horizontal(201, chart.failure_error, chart.failure_text, true);
  if (chart.rounding_floor >= axes.error.low) {
    s += horizontal(202, chart.rounding_floor, "rounding floor", true);
  } else if (chart.rounding_floor > 0.0) {
    const double decades = std::log10(axes.error.low / chart.rounding_floor);
    s += "set label 202 " +
         quoted(formatted("rounding floor %.0e lies %.0f decades below", chart.rounding_floor,
                          decades)) +
         " at graph 0.015, graph 0.03 noenhanced font ',11' tc rgb '#6b7078'\n";
  }
  return s;
}

/// A label in the margin and a thin line to it from the last point.
std::string direct_label(int tag, const ChartSeries& series, double height, const Range& error) {
  const ChartPoint& last = series.points.back();
  std::string s = formatted("set label %d ", tag) + quoted(label_of(series)) +
                  formatted(" at graph 1.045, graph %.4f noenhanced tc rgb '", height) +
                  hex(series.colour) + "'\n";
  s += formatted("set arrow %d from first %g, first %g to graph 1.035, graph %.4f nohead", tag,
                 last.seconds, std::clamp(last.error, error.low, error.high), height);
  return s + " lw 0.7 dt (2,4) lc rgb '" + hex(series.colour) + "' back\n";
}

/// The slope that theory asks for, through the middle of the good points, a little below them.
std::string slope(const ChartSeries& series) {
  std::vector<ChartPoint> good;
  for (const ChartPoint& point : series.points) {
    if (point.status == Status::ok) good.push_back(point);
  }
  if (series.order <= 0.0 || good.size() < 3) return "";
  const ChartPoint& middle = good[good.size() / 2];
  const ChartPoint& from = good[good.size() / 3];
  const double low = from.seconds;
  const double high = good.back().seconds;
  return formatted(", [t=%g:%g] '+' using (t):(%g*(t/%g)**(-%g)) with lines lw 1 dt (7,4) lc rgb '",
                   low, high, 0.45 * middle.error, middle.seconds, series.order) +
         hex(series.colour) + "'";
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
  const std::string colour = " lc rgb '" + hex(series.colour) + "'";
  const bool full = index % 2 == 0;
  return "$good" + number + " using 1:2 with linespoints lw " + (full ? "3" : "1.5") + " ps " +
         (full ? "0.8" : "1.1") + " pt " + std::to_string(marks[index % marks.size()]) + colour +
         ", $failed" + number + " using 1:($2 < top ? $2 : top) with points lw 2 pt 2 ps 1.1" +
         colour;
}

}  // namespace

std::string chart_script(const Chart& chart) {
  Chart drawn = chart;
  std::erase_if(drawn.series, [](const ChartSeries& series) { return series.points.empty(); });
  const Axes axes = chart_axes(drawn);
  const std::vector<double> heights = label_heights(drawn, axes);
  std::string s = header(drawn, axes) + boundaries(drawn, axes);
  const double least = std::max(drawn.rounding_floor, axes.error.low);
  std::string plots;
  std::string missing;
  for (std::size_t i = 0; i < drawn.series.size(); ++i) {
    const ChartSeries& series = drawn.series[i];
    s += direct_label(static_cast<int>(i) + 1, series, heights[i], axes.error);
    s += data_block("good" + std::to_string(i + 1), series, Status::ok, least);
    s += data_block("failed" + std::to_string(i + 1), series, Status::unstable, least);
    plots += (plots.empty() ? "" : ", \\\n     ") + curve(series, i) + slope(series);
  }
  for (const ChartSeries& series : chart.series) {
    if (!series.missing.empty()) missing += (missing.empty() ? "" : ", ") + series.missing;
  }
  if (!missing.empty()) {
    s += "set label 103 " + quoted("not written yet: " + missing) +
         " at graph 0, graph -0.155 noenhanced font ',11' tc rgb '#a03c00'\n";
  }
  s += formatted("top = %g\n", 0.8 * axes.error.high);
  s += "set terminal svg size 1000,600 font 'DejaVu Sans,13' fontscale 1.33 background '#ffffff'\n";
  s += "set output 'chart.svg'\nplot " + plots + "\n";
  s += "set terminal pngcairo size 1500,900 font 'DejaVu Sans,13' fontscale 1.5 linewidth 1.5";
  s += " pointscale 1.5 background '#ffffff'\nset output 'chart.png'\nreplot\nunset output\n";
  return s;
}

}  // namespace render

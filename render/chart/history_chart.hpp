#pragma once

#include <string>
#include <vector>

#include "render/colour.hpp"

namespace render {

/// The values of one quantity over time, for one method.
struct HistoryCurve {
  std::string method;
  Colour colour = palette::ink;  ///< the same as in the other charts of the lab
  std::vector<double> times;     ///< rising
  std::vector<double> values;    ///< as many, all finite
  std::string end;               ///< why it stops before the others do, as in "blew up"; or empty
  std::string missing;           ///< the step that is not written yet, or empty
  bool is_peer = false;          ///< another's code: drawn dashed and in greys, without `colour`
};

/// One quantity of all methods.
struct HistoryPanel {
  std::string quantity;      ///< as in "energy / energy at the start"; heading and CSV
  std::string unit;          ///< empty for a ratio
  bool logarithmic = false;  ///< values below `low` are then drawn there
  double low = 0.0;          ///< what the axis shows; low = high: what the curves need
  double high = 0.0;
  std::vector<HistoryCurve> curves;
};

/// Quantities over time, one panel below the other. They show a motion in the long run.
struct HistoryChart {
  std::string name = "history";  ///< of its files, without their endings: a to z, digits, _
  std::string lab;               ///< folder name of the lab, as in the CSV's first column
  std::string title;
  std::string subtitle;  ///< what is done, and what to read off
  std::string x_name = "time";
  std::string x_unit = "s";  ///< empty for a ratio
  std::vector<HistoryPanel> panels;
};

/// Throws std::invalid_argument that names what cannot be drawn: a curve without points, with times
/// that do not rise or with a value that is not finite, or a chart without panels.
void require_drawable(const HistoryChart& chart);

/// Returns the rows lab,method,quantity,time,value,unit. A method that is not written yet has one
/// row for each quantity, without numbers. Throws if require_drawable throws.
std::string history_csv(const HistoryChart& chart);

/// Returns a gnuplot script that draws NAME.csv of its folder as NAME.svg and NAME.png. Curves are
/// thinned to what the eye can see. A cross marks the end of a curve that stops before the others.
/// Throws if require_drawable throws.
std::string history_script(const HistoryChart& chart);

}  // namespace render

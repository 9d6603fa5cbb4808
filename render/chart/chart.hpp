#pragma once

#include <string>
#include <vector>

#include "render/colour.hpp"

namespace render {

enum class Status { ok, unstable, not_implemented };

/// The result of one method at one value of its cost parameter.
struct ChartPoint {
  double parameter = 0.0;    ///< as steps a turn
  double error = 0.0;        ///< the largest over all checkpoints, against an exact reference
  double seconds = 0.0;      ///< a unit of work, median of interleaved repeats
  double evaluations = 0.0;  ///< a unit of work
  Status status = Status::ok;
};

/// One method over the ladder of its cost parameter.
struct ChartSeries {
  std::string method;
  double order = 0.0;  ///< theory: error ~ seconds^-order; 0 draws no slope
  Colour colour = palette::ink;
  std::vector<ChartPoint> points;  ///< in the order of the parameter; none if not written yet
  std::string missing;             ///< the step that is not written yet, or empty
  bool is_peer = false;            ///< another's code: drawn dashed and in greys, without `colour`
  bool is_other = false;           ///< another answer's: drawn dashed, in the colour of the method
  bool shows_parameters = false;   ///< each point has its parameter under it, as in 10k
};

/// A chart of error against time, log-log: the cost of a lab's methods and what you get for it.
struct Chart {
  std::string name = "chart";   ///< of its files, without their endings: a to z, digits, _
  std::string lab;              ///< folder name of the lab, as in the CSV's first column
  std::string title;            ///< as in "Attitude of a coning body"
  std::string subtitle;         ///< what is done, and what to read off
  std::string error_name;       ///< as in "largest attitude error"
  std::string error_unit;       ///< as in "rad"
  std::string work_unit;        ///< as in "turn"
  std::string parameter_name;   ///< as in "steps a turn"
  double failure_error = 0.0;   ///< a method has failed at this error and above; 0 draws none
  std::string failure_text;     ///< why it has failed there
  double rounding_floor = 0.0;  ///< error that double precision leaves at best; 0 draws none
  std::vector<ChartSeries> series;
  std::string note;  ///< what a reader must know about the measurement; in lines below the chart
};

/// Returns the rows lab,method,parameter,error,error_unit,seconds,work_unit,evaluations,status. A
/// method that is not written yet has one row without numbers.
std::string chart_csv(const Chart& chart);

/// Returns a gnuplot script that draws NAME.csv of its folder as NAME.svg and NAME.png.
std::string chart_script(const Chart& chart);

}  // namespace render

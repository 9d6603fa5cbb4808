#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/chart/chart.hpp"

namespace render {

/// The result of a run of a method, apart from its time.
struct Judgement {
  double error = 0.0;
  double evaluations = 0.0;  ///< a unit of work
  bool stable = true;
};

/// A method of a lab, as a chart program measures it.
struct Method {
  std::string name;
  double order = 0.0;  ///< of convergence in theory
  Colour colour = palette::ink;
  std::vector<double> parameters;                    ///< its ladder, from cheap to expensive
  std::function<Judgement(double parameter)> judge;  ///< runs it against the exact reference
  std::function<void(double parameter)> run;         ///< does `units` units of work, which is timed
  double units = 1.0;
  /// Is called before a batch of runs, and not timed. It may be empty.
  std::function<void(double parameter)> prepare = nullptr;
  bool is_peer = false;           ///< another's code, see ChartSeries
  bool shows_parameters = false;  ///< see ChartSeries
};

/// Returns first, factor first, factor² first … up to last: a method's parameters.
std::vector<double> ladder(int first, int last, int factor = 2);

/// How much is measured: all of it, or briefly. Briefly means with fewer repeats, and each ladder
/// only up to the first rung that takes more than some hundredths of a second.
enum class Extent { full, brief };

/// Judges every method at every parameter. Then it times all of them by Google Benchmark in random
/// order, with several repeats each, and takes the median. A method that throws
/// common::NotImplemented becomes a series without points that names the step. It reports its
/// progress on stderr.
std::vector<ChartSeries> measured(const std::vector<Method>& methods, Extent extent = Extent::full);

}  // namespace render

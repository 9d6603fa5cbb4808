#include "render/chart/measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <map>

#include "common/course/not_implemented.hpp"
#include "render/files/progress.hpp"

namespace render {
namespace {

constexpr double long_run = 0.3;  // [s]; it averages the machine's noise by itself

struct Effort {
  int repeats;
  int repeats_of_long_runs;
  double least_seconds;  ///< of one repeat; short ones interleave more finely
  double longest_run;    ///< [s]; a ladder ends at the first that takes longer
};

Effort effort_of(Extent extent) {
  if (extent == Extent::brief) return {3, 1, 0.001, 0.02};
  return {7, 3, 0.004, std::numeric_limits<double>::infinity()};
}

/// Collects the time of every repeat, by the benchmark's name.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        times_[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
      }
    }
  }
  double median(const std::string& name) {
    std::vector<double>& times = times_.at(name);
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
  }

 private:
  std::map<std::string, std::vector<double>> times_;
};

std::string name_of(std::size_t series, std::size_t point) {
  return std::to_string(series) + ":" + std::to_string(point);
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// [s] of one run, untimed by the benchmark.
double first_run(const Method& method, double parameter) {
  if (method.prepare) method.prepare(parameter);
  const double start = processor_seconds();
  method.run(parameter);
  return processor_seconds() - start;
}

/// A method without its timings, and how often each of its points is to be timed.
struct Judged {
  ChartSeries series;
  std::vector<int> repeats;
};

/// `rung_done` is called after each parameter.
template <typename RungDone>
Judged judged(const Method& method, const Effort& effort, const RungDone& rung_done) {
  Judged result;
  result.series.method = method.name;
  result.series.order = method.order;
  result.series.colour = method.colour;
  result.series.is_peer = method.is_peer;
  result.series.shows_parameters = method.shows_parameters;
  try {
    for (const double parameter : method.parameters) {
      const Judgement judgement = method.judge(parameter);
      const double seconds = first_run(method, parameter);
      result.series.points.push_back({parameter, judgement.error, 0.0, judgement.evaluations,
                                      judgement.stable ? Status::ok : Status::unstable});
      result.repeats.push_back(seconds < long_run ? effort.repeats : effort.repeats_of_long_runs);
      rung_done();
      if (seconds > effort.longest_run) break;
    }
  } catch (const common::NotImplemented& error) {
    result.series.points.clear();
    result.repeats.clear();
    result.series.missing = error.step_and_function();
  }
  return result;
}

std::vector<Judged> judged(const std::vector<Method>& methods, const Effort& effort) {
  int rungs = 0;
  for (const Method& method : methods) rungs += static_cast<int>(method.parameters.size());
  Progress progress("judged", rungs);
  std::vector<Judged> all;
  int begun = 0;  // with the method at hand
  for (const Method& method : methods) {
    int done = begun;
    all.push_back(judged(method, effort, [&] { progress.show(++done); }));
    begun += static_cast<int>(method.parameters.size());
  }
  progress.show(rungs);
  return all;
}

/// Counts the repeats of one point. Its first repeat takes several calls, each with more
/// iterations, until these are enough; every call after that is a repeat.
class RepeatCounter {
 public:
  bool is_repeat(benchmark::IterationCount iterations) {
    const bool same = iterations == last_;
    last_ = iterations;
    return same;
  }

 private:
  benchmark::IterationCount last_ = 0;
};

/// Google Benchmark takes its settings as a command line.
void set_up_benchmark() {
  std::array<std::string, 2> words{"chart", "--benchmark_enable_random_interleaving=true"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
}

/// How often the points are timed beyond the first repeat of each.
int further_repeats(const std::vector<Judged>& all) {
  int repeats = 0;
  for (const Judged& one : all) {
    for (const int count : one.repeats) repeats += count - 1;
  }
  return repeats;
}

/// Google Benchmark times one point of a method; `repeated` is called after each further repeat.
template <typename Repeated>
void register_point(const std::string& name, const Method& method, double parameter, int repeats,
                    double least_seconds, const Repeated& repeated) {
  benchmark::RegisterBenchmark(
      name.c_str(),
      [&, parameter, counter = RepeatCounter()](benchmark::State& state) mutable {
        if (method.prepare) method.prepare(parameter);
        for ([[maybe_unused]] auto turn : state) method.run(parameter);
        if (counter.is_repeat(state.max_iterations)) repeated();
      })
      ->Repetitions(repeats)
      ->MinTime(least_seconds)
      ->Unit(benchmark::kSecond);
}

}  // namespace

std::vector<double> ladder(int first, int last, int factor) {
  std::vector<double> values;
  for (int value = first; value <= last; value *= factor) values.push_back(value);
  return values;
}

std::vector<ChartSeries> measured(const std::vector<Method>& methods, Extent extent) {
  const Effort effort = effort_of(extent);
  const std::vector<Judged> all = judged(methods, effort);
  set_up_benchmark();
  std::vector<ChartSeries> series;
  series.reserve(all.size());
  for (const Judged& one : all) series.push_back(one.series);
  const bool any =
      std::any_of(all.begin(), all.end(), [](const Judged& one) { return !one.repeats.empty(); });
  Progress progress("timed", further_repeats(all));
  int done = 0;
  const auto repeated = [&] { progress.show(++done); };
  for (std::size_t m = 0; m < methods.size(); ++m) {
    for (std::size_t p = 0; p < series[m].points.size(); ++p) {
      register_point(name_of(m, p), methods[m], methods[m].parameters[p], all[m].repeats[p],
                     effort.least_seconds, repeated);
    }
  }
  Collector collector;
  if (any) benchmark::RunSpecifiedBenchmarks(&collector);
  for (std::size_t s = 0; s < series.size(); ++s) {
    for (std::size_t p = 0; p < series[s].points.size(); ++p) {
      series[s].points[p].seconds = collector.median(name_of(s, p)) / methods[s].units;
    }
  }
  benchmark::ClearRegisteredBenchmarks();
  return series;
}

}  // namespace render

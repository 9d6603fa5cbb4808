#include "render/measure.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>

#include "common/not_implemented.hpp"

namespace render {
namespace {

constexpr int repeats = 7;
constexpr int repeats_of_long_runs = 3;
constexpr double long_run = 0.3;         // [s]; it averages the machine's noise by itself
constexpr double least_seconds = 0.004;  // of one repeat; short ones interleave more finely

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

ChartSeries judged(const Method& method) {
  ChartSeries series{method.name, method.order, method.colour, {}, "", method.is_peer};
  try {
    for (const double parameter : method.parameters) {
      const Judgement judgement = method.judge(parameter);
      series.points.push_back({parameter, judgement.error, 0.0, judgement.evaluations,
                               judgement.stable ? Status::ok : Status::unstable});
    }
  } catch (const common::NotImplemented& error) {
    series.points.clear();
    series.missing = error.step_and_function();
  }
  return series;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One untimed run tells how many repeats are wanted.
int repeats_of(const Method& method, double parameter) {
  if (method.prepare) method.prepare(parameter);
  const double start = processor_seconds();
  method.run(parameter);
  return processor_seconds() - start < long_run ? repeats : repeats_of_long_runs;
}

/// Google Benchmark takes its settings as a command line.
void set_up_benchmark() {
  std::array<std::string, 2> words{"chart", "--benchmark_enable_random_interleaving=true"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

std::vector<double> ladder(int first, int last, int factor) {
  std::vector<double> values;
  for (int value = first; value <= last; value *= factor) values.push_back(value);
  return values;
}

std::vector<ChartSeries> measured(const std::vector<Method>& methods) {
  set_up_benchmark();
  std::vector<ChartSeries> all;
  for (const Method& method : methods) {
    all.push_back(judged(method));
    for (std::size_t p = 0; p < all.back().points.size(); ++p) {
      const double parameter = method.parameters[p];
      benchmark::RegisterBenchmark(name_of(all.size() - 1, p).c_str(),
                                   [&method, parameter](benchmark::State& state) {
                                     if (method.prepare) method.prepare(parameter);
                                     for ([[maybe_unused]] auto turn : state) method.run(parameter);
                                   })
          ->Repetitions(repeats_of(method, parameter))
          ->MinTime(least_seconds)
          ->Unit(benchmark::kSecond);
    }
  }
  Collector collector;
  if (std::any_of(all.begin(), all.end(), [](const auto& s) { return !s.points.empty(); })) {
    benchmark::RunSpecifiedBenchmarks(&collector);
  }
  for (std::size_t s = 0; s < all.size(); ++s) {
    for (std::size_t p = 0; p < all[s].points.size(); ++p) {
      all[s].points[p].seconds = collector.median(name_of(s, p)) / methods[s].units;
    }
  }
  benchmark::ClearRegisteredBenchmarks();
  return all;
}

}  // namespace render

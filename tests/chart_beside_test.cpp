#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "render/chart/chart.hpp"
#include "render/chart/chart_beside.hpp"
#include "render_picture.hpp"

namespace fs = std::filesystem;
using namespace render;

namespace {

/// Two methods with points at 1, 2 and 4, which take `factor` times as long.
Chart chart_of(double slow_factor, double quick_factor) {
  Chart chart;
  chart.lab = "9_example";
  for (const auto& [name, factor] :
       {std::pair{"slow, as \"they\" say", slow_factor}, std::pair{"quick", quick_factor}}) {
    ChartSeries series{name, 0.0, palette::blue, {}, ""};
    for (const double parameter : {1.0, 2.0, 4.0}) {
      series.points.push_back({parameter, 0.1 / parameter, factor * parameter, 10.0});
    }
    chart.series.push_back(series);
  }
  return chart;
}

void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

TEST_CASE("Methods of another answer are drawn if they took another time") {
  const tests::ScratchFolder folder;
  write(folder.path() / "chart.csv", chart_csv(chart_of(2.0, 1.2)));
  Chart chart = chart_of(1.0, 1.0);
  draw_beside(chart, "by_other", folder.path());
  REQUIRE(chart.series.size() == 3);
  const ChartSeries& other = chart.series[1];
  CHECK(other.method == "slow, as \"they\" say, by_other");
  CHECK(other.is_other);
  REQUIRE(other.points.size() == 3);
  CHECK(other.points[2].seconds == 8.0);
  CHECK(other.points[2].error == 0.025);
  CHECK(chart.note == "as fast in by_other: quick");
  CHECK(chart_script(chart).find("dt (6,5)") != std::string::npos);
}

TEST_CASE("A chart that the other answer has not measured stays as it is") {
  const tests::ScratchFolder folder;
  Chart chart = chart_of(1.0, 1.0);
  draw_beside(chart, "by_other", folder.path());
  CHECK(chart.series.size() == 2);
  CHECK(chart.note.empty());
}

TEST_CASE("A measurement that is cut off or spoilt is refused by its line") {
  const tests::ScratchFolder folder;
  const std::string good = chart_csv(chart_of(2.0, 2.0));
  for (const std::string& bad :
       {good + "9_example,quick,8\n", good + "9_example,quick,8,x,rad,1,turn,10,ok\n"}) {
    write(folder.path() / "chart.csv", bad);
    Chart chart = chart_of(1.0, 1.0);
    std::string message;
    try {
      draw_beside(chart, "by_other", folder.path());
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    CHECK(message.find("chart.csv:8: expected") != std::string::npos);
  }
}

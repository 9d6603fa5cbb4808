#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.hpp"
#include "common/course/not_implemented.hpp"
#include "render/chart/chart.hpp"
#include "render/chart/chart_folder.hpp"
#include "render/chart/chart_program.hpp"
#include "render/chart/measure.hpp"
#include "render_picture.hpp"

namespace fs = std::filesystem;
using namespace render;
using tests::content;
using tests::has_gnuplot;
using tests::message_of;

namespace {

/// Three methods: one of order two, one that fails at its first point, one that is not written.
Chart sample() {
  Chart chart;
  chart.lab = "9_example";
  chart.title = "A title with {braces}, an under_score and 'quotes'";
  chart.subtitle = "what is done";
  chart.error_name = "largest error";
  chart.error_unit = "rad";
  chart.work_unit = "turn";
  chart.failure_error = 2.0;
  chart.failure_text = "nothing is further off";
  chart.rounding_floor = 2e-16;
  ChartSeries good{"good, \"as\" it should be", 2.0, palette::blue, {}, ""};
  ChartSeries bad{"bad", 1.0, palette::orange, {}, ""};
  for (int i = 0; i < 8; ++i) {
    const double seconds = 1e-6 * std::pow(2.0, i);
    good.points.push_back({std::pow(2.0, i), 0.1 * std::pow(4.0, -i), seconds, 10.0, Status::ok});
    bad.points.push_back({std::pow(2.0, i), i == 0 ? 1e300 : std::pow(2.0, -i), 3.0 * seconds, 10.0,
                          i == 0 ? Status::unstable : Status::ok});
  }
  chart.series = {good, bad, {"unwritten", 4.0, palette::green, {}, "9.3 unwritten"}};
  return chart;
}

bool write_chart(const Chart& chart, const fs::path& folder) {
  return write_charts({{chart}, {}}, folder);
}

}  // namespace

TEST_CASE("The CSV has a row a point and one for what is not written", "[chart]") {
  const std::string csv = chart_csv(sample());
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 8 + 8 + 1);
  CHECK(csv.rfind("lab,method,parameter,error,error_unit,seconds,work_unit,evaluations,status\n",
                  0) == 0);
  CHECK(csv.find("9_example,bad,1,1e+300,rad,3e-06,turn,10,unstable\n") != std::string::npos);
  CHECK(csv.find("9_example,unwritten,,,rad,,turn,,not_implemented\n") != std::string::npos);
  CHECK(csv.find("9_example,\"good, \"\"as\"\" it should be\",1,0.1,rad,") != std::string::npos);
}

TEST_CASE("The script names what is left out", "[chart]") {
  const std::string script = chart_script(sample());
  CHECK(script.find("not written yet: 9.3 unwritten") != std::string::npos);
  CHECK(script.find("unwritten  (order") == std::string::npos);
}

TEST_CASE("A series may show its parameters under its points", "[chart]") {
  Chart chart = sample();
  CHECK(chart_script(chart).find("'10k'") == std::string::npos);
  chart.series[0].points = {{300.0, 1e-2, 1e-6}, {10000.0, 1e-3, 1e-5}, {2e6, 1e-4, 1e-4}};
  chart.series[0].shows_parameters = true;
  const std::string script = chart_script(chart);
  for (const char* words : {"'300'", "'10k'", "'2M'"}) {
    CHECK(script.find(words) != std::string::npos);
  }
}

TEST_CASE("Long labels are never cut off at the edge", "[chart]") {
  if (!has_gnuplot()) {
    WARN("gnuplot is not installed");
    CHECK(!chart_script(sample()).empty());
    return;
  }
  Chart chart = sample();
  chart.series[0].method = "WWWW, a method whose name is as long as names may get";
  const tests::ScratchFolder folder;
  REQUIRE(write_chart(chart, folder.path() / "chart"));
  const Image picture = tests::read_png(folder.path() / "chart/chart.png");
  int inked_at_edge = 0;
  int inked_labels = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = picture.width / 2; x < picture.width; ++x) {
      const std::uint8_t* pixel = tests::pixel_at(picture, x, y);
      const bool inked = pixel[0] < 200 && pixel[2] > 100;  // blue, as the label is
      if (inked) ++(x >= picture.width - 8 ? inked_at_edge : inked_labels);
    }
  }
  CHECK(inked_at_edge == 0);
  CHECK(inked_labels > 500);
}

TEST_CASE("Errors of zero and without limit stand at the edges and are drawn", "[chart]") {
  Chart chart = sample();
  for (ChartPoint& point : chart.series[0].points) point.error = 0.0;
  for (ChartPoint& point : chart.series[1].points) {
    point.error = 1e300;
    point.status = Status::unstable;
  }
  const tests::ScratchFolder folder;
  CHECK(write_chart(chart, folder.path() / "chart") == has_gnuplot());
  CHECK(message_of([&] { write_chart(chart, folder.path() / "chart"); }).empty());
}

TEST_CASE("A chart is drawn for the page and for print and as PDF", "[chart]") {
  const tests::ScratchFolder folder;
  const bool drawn = write_chart(sample(), folder.path() / "chart");
  for (const char* const file : {"chart.svg", "chart.png", "chart.pdf"}) {
    CHECK(fs::exists(folder.path() / "chart" / file) == drawn);
  }
}

TEST_CASE("What was measured is kept where gnuplot cannot draw", "[chart]") {
  const tests::ScratchFolder folder;
  fs::create_directories(folder.path() / "bin");
  std::ofstream(folder.path() / "bin/gnuplot") << "#!/bin/sh\necho line 7: unknown or ambiguous "
                                                  "terminal type >&2\ntouch chart.png\nexit 1\n";
  fs::permissions(folder.path() / "bin/gnuplot", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", ((folder.path() / "bin").string() + ":" + path).c_str(), 1);
  const std::string said = message_of([&] { write_chart(sample(), folder.path() / "chart"); });
  setenv("PATH", path.c_str(), 1);
  CHECK(said == "gnuplot could not draw " + (folder.path() / "chart/chart.gp").string() +
                    ": line 7: unknown or ambiguous terminal type");
  for (const char* const file : {"chart.csv", "chart.gp", "charts.txt"}) {
    CHECK(fs::file_size(folder.path() / "chart" / file) > 0);
  }
  CHECK(!fs::exists(folder.path() / "chart/chart.png"));
}

TEST_CASE("A folder that cannot be written is one error and leaves nothing", "[chart]") {
  const tests::ScratchFolder folder;
  std::ofstream(folder.path() / "file") << "in the way";
  for (const fs::path& target : {folder.path() / "file" / "chart", folder.path() / "file"}) {
    CHECK(message_of([&] {
            write_chart(sample(), target);
          }).rfind("cannot write " + target.string() + ": ", 0) == 0);
  }
  CHECK(content(folder.path() / "file") == "in the way");
  CHECK(tests::files_in(folder.path()) == 1);
}

TEST_CASE("A second chart takes the place of the first", "[chart]") {
  const tests::ScratchFolder folder;
  write_chart(sample(), folder.path() / "chart");
  std::ofstream(folder.path() / "chart/chart.csv") << "old";
  write_chart(sample(), folder.path() / "chart");
  CHECK(content(folder.path() / "chart/chart.csv") == chart_csv(sample()));
  CHECK(tests::files_in(folder.path()) == 1);
}

TEST_CASE("A folder that holds something else is left alone", "[chart]") {
  const tests::ScratchFolder folder;
  std::ofstream(folder.path() / "thesis.tex") << "months of work";
  CHECK(message_of([&] { write_chart(sample(), folder.path()); }).find("thesis.tex") !=
        std::string::npos);
  CHECK(content(folder.path() / "thesis.tex") == "months of work");
  CHECK(tests::files_in(folder.path()) == 1);
}

TEST_CASE("A method that is not written becomes a series without points", "[chart]") {
  Method written{"written", 1.0, palette::blue, {1.0, 2.0}, nullptr, nullptr, 1.0};
  volatile double sum = 0.0;
  written.judge = [](double parameter) { return Judgement{1.0 / parameter, parameter, true}; };
  written.run = [&](double parameter) { sum = sum + parameter; };
  Method unwritten = written;
  unwritten.judge = [](double) -> Judgement { throw common::NotImplemented("9.1 unwritten"); };
  const std::vector<ChartSeries> series = measured({written, unwritten});
  REQUIRE(series.size() == 2);
  REQUIRE(series[0].points.size() == 2);
  CHECK(series[0].points[1].error == 0.5);
  CHECK(series[0].points[1].seconds > 0.0);
  CHECK(series[1].points.empty());
  CHECK(series[1].missing == "9.1 unwritten");
}

namespace {

/// A method whose runs take 30 ms from its second rung on, and which counts them.
Method slow_method(int& runs) {
  Method method{"slow", 0.0, palette::blue, {1.0, 2.0, 3.0}, nullptr, nullptr, 1.0};
  method.judge = [](double parameter) { return Judgement{1.0 / parameter, parameter, true}; };
  method.run = [&runs](double parameter) {
    ++runs;
    const std::clock_t end = std::clock() + (parameter > 1.0 ? 30 : 0) * CLOCKS_PER_SEC / 1000;
    while (std::clock() < end) {
    }
  };
  return method;
}

/// The script of a chart program's only chart; empty where it failed.
std::string script_of(std::vector<std::string> words, const fs::path& folder, int& runs) {
  words.insert(words.begin(), {"chart_program", "--out", (folder / "chart").string()});
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  Chart chart;
  chart.lab = "9_example";
  chart.title = "Slow";
  const ChartPlan plan{{{chart, {slow_method(runs)}}}, {}, {}};
  const int code = chart_main(static_cast<int>(words.size()), argv.data(), plan);
  return code == 0 ? content(folder / "chart/chart.gp") : "";
}

}  // namespace

TEST_CASE("A brief measurement ends a ladder at its first long run", "[chart]") {
  int runs = 0;
  const Method method = slow_method(runs);
  const std::vector<ChartSeries> full = measured({method});
  REQUIRE(full.size() == 1);
  CHECK(full[0].points.size() == 3);
  const std::vector<ChartSeries> brief = measured({method}, Extent::brief);
  REQUIRE(brief.size() == 1);
  REQUIRE(brief[0].points.size() == 2);
  CHECK(brief[0].points[1].seconds > 0.02);
}

TEST_CASE("A short chart says that it is short and how to get the full one", "[chart]") {
  const tests::ScratchFolder folder;
  int runs_of_full = 0;
  const std::string full = script_of({}, folder.path(), runs_of_full);
  REQUIRE(!full.empty());
  CHECK(full.find("short measurement") == std::string::npos);
  int runs = 0;
  const std::string brief = script_of({"--short"}, folder.path(), runs);
  CHECK(brief.find("short measurement") != std::string::npos);
  CHECK(brief.find("./tumble chart 9") != std::string::npos);
  CHECK(runs < runs_of_full);
}

TEST_CASE("A chart program refuses words that it does not know", "[chart]") {
  const tests::ScratchFolder folder;
  int runs = 0;
  for (const char* word : {"--shorter", "--peers", "short"}) {
    CHECK(script_of({word}, folder.path(), runs).empty());
  }
  CHECK(runs == 0);
}

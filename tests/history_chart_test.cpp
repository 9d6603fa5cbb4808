#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "catch.hpp"
#include "common/course/not_implemented.hpp"
#include "render/chart/chart_folder.hpp"
#include "render/chart/history_chart_axes.hpp"
#include "render/chart/label_layout.hpp"
#include "render/chart/record.hpp"
#include "render_picture.hpp"

namespace fs = std::filesystem;
using namespace render;
using tests::content;
using tests::has_gnuplot;
using tests::message_of;

namespace {

HistoryMethod method(const std::string& name, const Colour& colour, int count, const char* end) {
  return {name, colour, [=] {
            History history{{}, {{}, {}}, end};
            for (int i = 0; i < count; ++i) {
              history.times.push_back(i);
              history.values[0].push_back(1.0 + 0.25 * i);
              history.values[1].push_back(std::pow(10.0, i));
            }
            return history;
          }};
}

/// Two quantities of three methods: one that lasts, one that blows up, one that is not written.
HistoryChart history_sample() {
  HistoryChart chart;
  chart.lab = "9_example";
  chart.title = "A title with an unpaired { brace and 'quotes'";
  chart.subtitle = "what is done";
  chart.panels = {{"energy", "J", false, 0.0, 0.0, {}}, {"|L|", "", true, 0.0, 0.0, {}}};
  HistoryMethod unwritten = method("unwritten", palette::green, 1, "");
  unwritten.record = []() -> History { throw common::NotImplemented("9.3 unwritten"); };
  return recorded(chart, {method("lasting } on", palette::blue, 9, ""),
                          method("short", palette::vermilion, 5, "blew up"), unwritten});
}

/// Pixels at which `is_inked(red, green, blue)`, right of `from` of the width.
template <typename IsInked>
int count_pixels(const fs::path& path, double from, const IsInked& is_inked) {
  const Image picture = tests::read_png(path);
  int count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = static_cast<int>(from * picture.width); x < picture.width; ++x) {
      const std::uint8_t* pixel = tests::pixel_at(picture, x, y);
      count += is_inked(pixel[0], pixel[1], pixel[2]) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("The CSV has a row a moment and one a quantity that is not written", "[history]") {
  const std::string csv = history_csv(history_sample());
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 2 * (9 + 5 + 1));
  CHECK(csv.rfind("lab,method,quantity,time,value,unit\n", 0) == 0);
  CHECK(csv.find("\n9_example,short,energy,4,2,J\n") != std::string::npos);
  CHECK(csv.find("\n9_example,short,|L|,4,10000,\n") != std::string::npos);
  CHECK(csv.find("\n9_example,unwritten,energy,,,J\n") != std::string::npos);
}

TEST_CASE("The script says what ends early and what is not written", "[history]") {
  const std::string script = history_script(history_sample());
  CHECK(script.find("short: blew up at 4 s") != std::string::npos);
  HistoryChart alone = history_sample();
  for (HistoryPanel& panel : alone.panels) panel.curves.erase(panel.curves.begin());
  CHECK(history_script(alone).find("short: blew up at 4 s") != std::string::npos);
  CHECK(script.find("'lasting } on'") != std::string::npos);
  CHECK(script.find("not written yet: 9.3 unwritten") != std::string::npos);
}

TEST_CASE("A history is drawn whole with its labels inside", "[history]") {
  const tests::ScratchFolder folder;
  HistoryChart chart = history_sample();
  for (HistoryPanel& panel : chart.panels) {
    panel.curves[0].method = "WWWW, a method whose name is as long as names may get";
  }
  CHECK(write_charts({{}, {chart}}, folder.path() / "chart") == has_gnuplot());
  CHECK(content(folder.path() / "chart/history.csv") == history_csv(chart));
  if (!has_gnuplot()) {
    WARN("gnuplot is not installed");
    return;
  }
  const auto is_ink = [](int red, int green, int blue) { return red + green + blue < 600; };
  const auto is_blue = [](int red, int, int blue) { return red < 60 && blue > 120; };
  const auto is_red = [](int red, int, int blue) { return red > 180 && blue < 60; };
  const fs::path picture = folder.path() / "chart/history.png";
  CHECK(count_pixels(picture, 0.995, is_ink) == 0);
  CHECK(count_pixels(picture, 0.4, is_blue) > 1000);
  CHECK(count_pixels(picture, 0.4, is_red) > 300);
}

TEST_CASE("Curves far beyond the axis and constant ones are drawn", "[history]") {
  HistoryChart chart = history_sample();
  chart.panels[0].low = 0.5;
  chart.panels[0].high = 1.5;
  for (double& value : chart.panels[0].curves[1].values) value = value > 1.5 ? 1e300 : value;
  for (double& value : chart.panels[1].curves[0].values) value = 0.0;
  for (double& value : chart.panels[1].curves[1].values) value = 0.0;
  const tests::ScratchFolder folder;
  CHECK(message_of([&] { write_charts({{}, {chart}}, folder.path() / "chart"); }).empty());
}

TEST_CASE("A history that cannot be drawn is refused with the place", "[history]") {
  const auto refusal = [](const auto& spoil) {
    HistoryChart chart = history_sample();
    spoil(chart);
    return message_of([&] { history_script(chart); });
  };
  CHECK(refusal([](HistoryChart& c) { c.panels.clear(); }) ==
        "chart history cannot be drawn: it has no panel");
  CHECK(refusal([](HistoryChart& c) { c.panels[0].curves.clear(); }) ==
        "chart history cannot be drawn: 'energy' has no curve");
  CHECK(refusal([](HistoryChart& c) { c.panels[0].curves[1].values[3] = std::nan(""); }) ==
        "chart history cannot be drawn: 'energy' of 'short' is nan at time 3: stop the curve "
        "before it and say why in `end`");
  CHECK(refusal([](HistoryChart& c) { c.panels[1].curves[0].times[3] = 2.0; }) ==
        "chart history cannot be drawn: '|L|' of 'lasting } on' has times that do not rise at "
        "time 2");
  CHECK(refusal([](HistoryChart& c) { c.panels[1].curves[0].values.pop_back(); }) ==
        "chart history cannot be drawn: '|L|' of 'lasting } on' has 9 times and 8 values");
  CHECK(refusal([](HistoryChart& c) {
          c.panels[0].curves[0].times.clear();
          c.panels[0].curves[0].values.clear();
        }) == "chart history cannot be drawn: 'energy' of 'lasting } on' has no points");
}

TEST_CASE("A method must give a value for every panel", "[history]") {
  HistoryChart chart = history_sample();
  chart.panels.pop_back();
  CHECK(message_of([&] { recorded(chart, {method("short", palette::blue, 3, "")}); }) ==
        "chart history: 'short' gives 2 quantities for 1 panels");
}

TEST_CASE("Thinning keeps the peaks and the ends", "[history]") {
  HistoryCurve curve;
  for (int i = 0; i < 100000; ++i) {
    curve.times.push_back(i);
    curve.values.push_back(i == 54321 ? 7.0 : std::sin(0.01 * i));
  }
  const std::vector<Moment> kept = thinned(curve);
  CHECK(kept.size() <= 2010);
  CHECK(kept.front().time == 0.0);
  CHECK(kept.back().time == 99999.0);
  CHECK(std::any_of(kept.begin(), kept.end(), [](const Moment& m) { return m.value == 7.0; }));
  CHECK(std::is_sorted(kept.begin(), kept.end(),
                       [](const Moment& a, const Moment& b) { return a.time < b.time; }));
}

TEST_CASE("The time axis goes on to a tic that is near", "[history]") {
  HistoryChart chart = history_sample();
  chart.panels.resize(1);
  chart.panels[0].curves.resize(1);
  chart.panels[0].curves[0].times = {1.0 / 60.0, 599.5};
  CHECK(time_axis(chart).low == 0.0);
  CHECK(time_axis(chart).high == 600.0);
  chart.panels[0].curves[0].times = {17.0, 533.0};
  CHECK(time_axis(chart).low == 17.0);
  CHECK(time_axis(chart).high == 533.0);
}

TEST_CASE("Labels keep their distance and stay near", "[history]") {
  const std::vector<double> heights = spread({0.5, 0.5, 0.5, 0.9, 2.0, -1.0}, 0.1);
  const std::vector<double> wanted{0.4, 0.5, 0.6, 0.89, 0.99, 0.02};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(std::abs(heights[i] - wanted[i]) < 1e-12);
  }
}

TEST_CASE("Several charts share one folder and its index", "[history]") {
  const tests::ScratchFolder folder;
  Chart errors;
  errors.name = "racket";
  errors.title = "Tennis\tracket";
  errors.series = {{"good", 1.0, palette::blue, {{1.0, 0.1, 1e-6, 1.0, Status::ok}}, ""}};
  write_charts({{errors}, {history_sample()}}, folder.path() / "chart");
  CHECK(content(folder.path() / "chart/charts.txt") ==
        "racket\tTennis racket\nhistory\tA title with an unpaired { brace and 'quotes'\n");
  CHECK(fs::exists(folder.path() / "chart/racket.gp"));
  errors.name = "top";
  write_charts({{errors}, {}}, folder.path() / "chart");
  CHECK(fs::exists(folder.path() / "chart/top.csv"));
  CHECK_FALSE(fs::exists(folder.path() / "chart/racket.csv"));
  CHECK(tests::files_in(folder.path()) == 1);
}

TEST_CASE("Names of charts are file names and differ", "[history]") {
  const tests::ScratchFolder folder;
  HistoryChart chart = history_sample();
  CHECK(message_of([&] {
          write_charts({{}, {chart, chart}}, folder.path() / "chart");
        }) == "two charts have the name history");
  chart.name = "../away";
  CHECK(message_of([&] {
          write_charts({{}, {chart}}, folder.path() / "chart");
        }).find("../away") != std::string::npos);
  CHECK(fs::is_empty(folder.path()));
}

#include "render/chart/chart_beside.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

namespace render {
namespace {

constexpr double noise = 4.0 / 3.0;  // what takes up to so much longer takes as long

/// The fields of a line of a CSV file.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[++i];
      else
        quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

using Points = std::map<std::string, std::vector<ChartPoint>>;  ///< by their method

double number(const std::string& text, const std::string& where) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') {
    throw std::runtime_error(where + ": expected a number, got '" + text + "'");
  }
  return value;
}

Points points_in(const std::string& path) {
  std::ifstream file(path);
  Points points;
  std::string line;
  std::getline(file, line);  // the names of the columns
  for (int count = 2; std::getline(file, line); ++count) {
    const std::string where = path + ":" + std::to_string(count);
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != 9)
      throw std::runtime_error(where + ": expected nine columns; draw that chart again");
    if (fields[8] == "not_implemented") continue;
    points[fields[1]].push_back({number(fields[2], where), number(fields[3], where),
                                 number(fields[5], where), number(fields[7], where),
                                 fields[8] == "ok" ? Status::ok : Status::unstable});
  }
  return points;
}

/// How much longer the other took in the middle, over the parameters that both have; 1 if none.
double median_ratio(const std::vector<ChartPoint>& one, const std::vector<ChartPoint>& other) {
  std::vector<double> ratios;
  for (const ChartPoint& a : one) {
    for (const ChartPoint& b : other) {
      if (a.parameter == b.parameter) ratios.push_back(b.seconds / a.seconds);
    }
  }
  if (ratios.empty()) return 1.0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  return *middle;
}

}  // namespace

void draw_beside(Chart& chart, const std::string& answer, const std::string& folder) {
  const Points others = points_in(folder + "/" + chart.name + ".csv");
  std::vector<ChartSeries> series;
  std::string alike;
  for (const ChartSeries& own : chart.series) {
    series.push_back(own);
    const auto other = others.find(own.method);
    if (own.is_peer || own.points.empty() || other == others.end()) continue;
    const double ratio = median_ratio(own.points, other->second);
    if (ratio > 1.0 / noise && ratio < noise) {
      alike += (alike.empty() ? "" : "; ") + own.method;
      continue;
    }
    series.push_back(own);
    series.back().method += ", " + answer;
    series.back().points = other->second;
    series.back().is_other = true;
    series.back().shows_parameters = false;
  }
  chart.series = std::move(series);
  if (alike.empty()) return;
  chart.note += (chart.note.empty() ? "" : "\n") + ("as fast in " + answer + ": " + alike);
}

}  // namespace render

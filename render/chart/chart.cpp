#include "render/chart/chart.hpp"

#include "render/chart/csv.hpp"

namespace render {
namespace {

const char* text(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::unstable:
      return "unstable";
    case Status::not_implemented:
      break;
  }
  return "not_implemented";
}

}  // namespace

std::string chart_csv(const Chart& chart) {
  std::string csv = "lab,method,parameter,error,error_unit,seconds,work_unit,evaluations,status\n";
  for (const ChartSeries& series : chart.series) {
    const std::string head = csv_field(chart.lab) + "," + csv_field(series.method) + ",";
    if (!series.missing.empty()) {
      csv += head + ",," + csv_field(chart.error_unit) + ",," + csv_field(chart.work_unit) + ",," +
             text(Status::not_implemented) + "\n";
    }
    for (const ChartPoint& point : series.points) {
      csv += head + csv_number(point.parameter) + "," + csv_number(point.error) + "," +
             csv_field(chart.error_unit) + "," + csv_number(point.seconds) + "," +
             csv_field(chart.work_unit) + "," + csv_number(point.evaluations) + "," +
             text(point.status) + "\n";
    }
  }
  return csv;
}

}  // namespace render

#include "render/chart/history_chart.hpp"

#include <cmath>
#include <stdexcept>

#include "render/chart/csv.hpp"

namespace render {
namespace {

[[noreturn]] void refuse(const HistoryChart& chart, const std::string& what) {
  throw std::invalid_argument("chart " + chart.name + " cannot be drawn: " + what);
}

void require_drawable(const HistoryChart& chart, const HistoryPanel& panel,
                      const HistoryCurve& curve) {
  const std::string whose = "'" + panel.quantity + "' of '" + curve.method + "' ";
  if (curve.times.size() != curve.values.size()) {
    refuse(chart, whose + "has " + std::to_string(curve.times.size()) + " times and " +
                      std::to_string(curve.values.size()) + " values");
  }
  if (!curve.missing.empty()) return;
  if (curve.times.empty()) refuse(chart, whose + "has no points");
  for (std::size_t i = 0; i < curve.times.size(); ++i) {
    const bool rises =
        std::isfinite(curve.times[i]) && (i == 0 || curve.times[i] > curve.times[i - 1]);
    if (rises && std::isfinite(curve.values[i])) continue;
    std::string what = whose;
    what += rises ? "is " + csv_number(curve.values[i]) : "has times that do not rise";
    what += " at time " + csv_number(curve.times[i]);
    if (rises) what += ": stop the curve before it and say why in `end`";
    refuse(chart, what);
  }
}

}  // namespace

void require_drawable(const HistoryChart& chart) {
  if (chart.panels.empty()) refuse(chart, "it has no panel");
  for (const HistoryPanel& panel : chart.panels) {
    if (panel.curves.empty()) refuse(chart, "'" + panel.quantity + "' has no curve");
    if (panel.logarithmic && panel.low < panel.high && !(panel.low > 0.0)) {
      refuse(chart,
             "the logarithmic axis of '" + panel.quantity + "' starts at " + csv_number(panel.low));
    }
    for (const HistoryCurve& curve : panel.curves) require_drawable(chart, panel, curve);
  }
}

std::string history_csv(const HistoryChart& chart) {
  require_drawable(chart);
  std::string csv = "lab,method,quantity,time,value,unit\n";
  for (const HistoryPanel& panel : chart.panels) {
    for (const HistoryCurve& curve : panel.curves) {
      const std::string head = csv_field(chart.lab) + "," + csv_field(curve.method) + "," +
                               csv_field(panel.quantity) + ",";
      const std::string tail = csv_field(panel.unit) + "\n";
      if (!curve.missing.empty()) csv.append(head).append(",,").append(tail);
      for (std::size_t i = 0; i < curve.times.size(); ++i) {
        csv.append(head).append(csv_number(curve.times[i])).append(",");
        csv.append(csv_number(curve.values[i])).append(",").append(tail);
      }
    }
  }
  return csv;
}

}  // namespace render

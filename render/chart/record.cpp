#include "render/chart/record.hpp"

#include <stdexcept>

#include "common/course/not_implemented.hpp"

namespace render {

HistoryChart recorded(HistoryChart chart, const std::vector<HistoryMethod>& methods) {
  for (const HistoryMethod& method : methods) {
    HistoryCurve curve{method.name, method.colour, {}, {}, "", "", method.is_peer};
    History history;
    try {
      history = method.record();
      if (history.values.size() != chart.panels.size()) {
        throw std::invalid_argument("chart " + chart.name + ": '" + method.name + "' gives " +
                                    std::to_string(history.values.size()) + " quantities for " +
                                    std::to_string(chart.panels.size()) + " panels");
      }
      curve.times = history.times;
      curve.end = history.end;
    } catch (const common::NotImplemented& error) {
      curve.missing = error.step_and_function();
      history.values.assign(chart.panels.size(), {});
    }
    for (std::size_t panel = 0; panel < chart.panels.size(); ++panel) {
      curve.values = history.values[panel];
      chart.panels[panel].curves.push_back(curve);
    }
  }
  return chart;
}

}  // namespace render

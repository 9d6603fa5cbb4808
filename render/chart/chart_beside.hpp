#pragma once

#include <string>

#include "render/chart/chart.hpp"

namespace render {

/// Draws another answer's measurement into a chart.
///
/// It reads folder/<chart.name>.csv. It takes the methods that the chart has, too, and whose times
/// there differ by more than a third in the median. It draws them dashed in the method's colour,
/// with with `answer` after the name. The chart's note names the methods that took as long. If the
/// folder has no such file, nothing changes. Throws std::runtime_error, which names file and line,
/// if the file is not as chart_csv writes it.
void draw_beside(Chart& chart, const std::string& answer, const std::string& folder);

}  // namespace render

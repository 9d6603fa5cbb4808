#pragma once

#include <string>

#include "render/chart.hpp"

namespace render {

/// Draws another answer's measurement into a chart.
///
/// From folder/<chart.name>.csv come the methods that the chart has, too, and that took another
/// time there, by more than a third in the middle; drawn dashed in the method's colour, with
/// `answer` after its name. The chart's note names the methods that took as long. Nothing changes
/// if the folder has no such file. Throws std::runtime_error, which names file and line, if it is
/// not as chart_csv writes it.
void draw_beside(Chart& chart, const std::string& answer, const std::string& folder);

}  // namespace render

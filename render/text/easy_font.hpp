#pragma once

#include <string_view>

#include "render/text/typeface.hpp"

namespace render {

/// ASCII that stands in for a character which the built-in bitmap font lacks: ω as w, · as *,
/// and ? for what has no such likeness.
char ascii_likeness(char32_t character);

/// One line in the built-in bitmap font, whose capitals are as tall as those of a typeface of the
/// same `size` [pixels].
Mask easy_font_line(std::u32string_view line, double size);

/// The width of the same line [pixels].
double easy_font_width(std::u32string_view line, double size);

}  // namespace render

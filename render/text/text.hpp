#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/colour.hpp"
#include "render/files/image.hpp"
#include "render/text/typeface.hpp"

namespace render {

struct TextStyle {
  double size = 16.0;  ///< of the em square [pixels]
  Colour colour = palette::ink;
  Weight weight = Weight::regular;
  bool halo = false;  ///< two pixels of white around, to read on any ground
};

/// The width of a line of UTF-8 text [pixels].
double text_width(std::string_view utf8, double size, Weight weight = Weight::regular);

/// Draws a line of UTF-8 text that starts at x on the baseline y (pixels, right and down from the
/// picture's top left corner). What lies outside is cut off.
void draw_text(Image& image, double x, double baseline, std::string_view utf8,
               const TextStyle& style);

/// The text broken at spaces into lines no wider than `width` [pixels]; a longer word is broken
/// where it must be. At least one line.
std::vector<std::string> wrapped_text(const std::string& utf8, double width, double size,
                                      Weight weight = Weight::regular);

}  // namespace render

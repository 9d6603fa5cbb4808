#pragma once

#include <string>
#include <vector>

#include "render/files/image.hpp"

namespace render {

/// A picture with a few words in its lower left corner, as in "t = 0.25 s".
struct StripTile {
  Image picture;
  std::string caption;
};

/// The text above and below the tiles. Each part may be empty.
struct StripText {
  std::string title;     ///< bold
  std::string subtitle;  ///< beside the title if it fits, else below
  std::string left;      ///< foot
  std::string right;     ///< foot, at the right if both fit in a line, else below
};

/// Returns the tiles in reading order with the text around them, on white. Text that is too wide
/// for the strip is broken into lines, so nothing is cut off. Throws std::invalid_argument if there
/// is no tile.
Image film_strip(const std::vector<StripTile>& tiles, const StripText& text, int columns);

/// Returns the columns for which tiles of that width fill rows most evenly, within `width`.
int strip_columns(int tiles, int tile_width, int width);

}  // namespace render

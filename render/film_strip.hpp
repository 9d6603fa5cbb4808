#pragma once

#include <string>
#include <vector>

#include "render/image.hpp"

namespace render {

/// A picture with a few words in its lower left corner, as in "t = 0.25 s".
struct StripTile {
  Image picture;
  std::string caption;
};

/// What stands above and below the tiles; each may be empty.
struct StripText {
  std::string title;     ///< bold
  std::string subtitle;  ///< beside the title where it fits, else below
  std::string left;      ///< foot
  std::string right;     ///< foot, at the right where both fit in a line, else below
};

/// Tiles in reading order with text around, on white. Text too wide for the strip is broken into
/// lines, so that nothing is cut off. Throws std::invalid_argument where there is no tile.
Image film_strip(const std::vector<StripTile>& tiles, const StripText& text, int columns);

/// Columns in which tiles of that width fill rows as evenly as can be, none wider than `width`.
int strip_columns(int tiles, int tile_width, int width);

}  // namespace render

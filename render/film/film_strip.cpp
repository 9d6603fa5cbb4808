#include "render/film/film_strip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/text/text.hpp"

namespace render {
namespace {

constexpr int margin = 14;  // around all [pixels]
constexpr int gap = 10;     // between tiles
constexpr Colour quiet{0.40F, 0.42F, 0.46F};

// A line of text and where it starts.
struct Line {
  std::string text;
  double x = margin;
  double baseline = 0.0;
  TextStyle style;
};

struct Block {
  std::vector<Line> lines;
  double bottom = 0.0;
};

double width_of(const Line& line) {
  return text_width(line.text, line.style.size, line.style.weight);
}

// Adds a text below the block, broken into lines as wide as the strip allows.
void add_below(Block& block, const std::string& text, const TextStyle& style, int strip_width) {
  if (text.empty()) return;
  const double width = strip_width - 2 * margin;
  for (const std::string& line : wrapped_text(text, width, style.size, style.weight)) {
    block.bottom += 1.35 * style.size;
    block.lines.push_back({line, margin, block.bottom - 0.35 * style.size, style});
  }
}

// The second text stands in the first's line where there is room, and below it elsewhere.
Block two_texts(const Line& first, const Line& second, double top, int strip_width,
                bool second_at_right) {
  Block block;
  block.bottom = top;
  add_below(block, first.text, first.style, strip_width);
  const double space = first.text.empty() ? 0.0 : 1.1 * first.style.size;
  const double start = margin + (block.lines.empty() ? 0.0 : width_of(block.lines.back())) + space;
  const double room = strip_width - margin - start;
  const bool fits = block.lines.size() == 1 && width_of(second) <= room;
  if (!fits) {
    add_below(block, second.text, second.style, strip_width);
    return block;
  }
  Line beside = second;
  beside.baseline = block.lines.back().baseline;
  beside.x = second_at_right ? strip_width - margin - width_of(second) : start;
  block.lines.push_back(beside);
  return block;
}

void draw(Image& image, const Block& block) {
  for (const Line& line : block.lines) {
    draw_text(image, line.x, line.baseline, line.text, line.style);
  }
}

void draw_border(Image& image, int x, int y, const Image& tile) {
  constexpr std::uint8_t grey = 200;
  const Image across = filled_image(tile.width + 2, 1, grey, grey, grey);
  const Image down = filled_image(1, tile.height + 2, grey, grey, grey);
  paste(image, across, x - 1, y - 1);
  paste(image, across, x - 1, y + tile.height);
  paste(image, down, x - 1, y - 1);
  paste(image, down, x + tile.width, y - 1);
}

void draw_tile(Image& image, int x, int y, const StripTile& tile) {
  constexpr double indent = 10.0;
  paste(image, tile.picture, x, y);
  draw_border(image, x, y, tile.picture);
  if (tile.caption.empty()) return;
  const double full_size = std::clamp(tile.picture.height / 25.0, 10.0, 16.0);
  const double room = tile.picture.width - 2 * indent;
  const double size = full_size * std::min(1.0, room / text_width(tile.caption, full_size));
  draw_text(image, x + indent, y + tile.picture.height - indent, tile.caption,
            {size, palette::ink, Weight::regular, true});
}

}  // namespace

Image film_strip(const std::vector<StripTile>& tiles, const StripText& text, int columns) {
  if (tiles.empty()) throw std::invalid_argument("a film strip without tiles");
  int tile_width = 0;
  int tile_height = 0;
  for (const StripTile& tile : tiles) {
    tile_width = std::max(tile_width, tile.picture.width);
    tile_height = std::max(tile_height, tile.picture.height);
  }
  const int count = static_cast<int>(tiles.size());
  const int used_columns = std::clamp(columns, 1, count);
  const int rows = (count + used_columns - 1) / used_columns;
  const int width = 2 * margin + used_columns * (tile_width + gap) - gap;

  const TextStyle title_style{22.0, palette::ink, Weight::bold, false};
  const TextStyle subtitle_style{17.0, quiet, Weight::regular, false};
  const TextStyle foot_style{15.0, palette::ink, Weight::regular, false};
  const Block head = two_texts({text.title, margin, 0.0, title_style},
                               {text.subtitle, margin, 0.0, subtitle_style}, 6.0, width, false);
  const int first_tile = static_cast<int>(std::ceil(head.bottom)) + 6;
  const double end = first_tile + rows * (tile_height + gap) - gap + 8;
  const Block foot = two_texts({text.left, margin, 0.0, foot_style},
                               {text.right, margin, 0.0, foot_style}, end, width, true);
  const int height = static_cast<int>(std::ceil(foot.bottom)) + 8;

  Image image = filled_image(width, height, 255, 255, 255);
  for (int i = 0; i < count; ++i) {
    draw_tile(image, margin + i % used_columns * (tile_width + gap),
              first_tile + i / used_columns * (tile_height + gap),
              tiles[static_cast<std::size_t>(i)]);
  }
  draw(image, head);
  draw(image, foot);
  return image;
}

int strip_columns(int tiles, int tile_width, int width) {
  const int most = std::max(1, (width - 2 * margin + gap) / (tile_width + gap));
  const int rows = (tiles + most - 1) / most;
  return std::max(1, (tiles + rows - 1) / std::max(rows, 1));
}

}  // namespace render

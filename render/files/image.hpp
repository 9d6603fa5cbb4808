#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace render {

/// An sRGB picture, 8 bits a channel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel, left to right, top row first
};

/// Returns a picture of one colour. Throws std::invalid_argument if a side is not in [1, 16384].
Image filled_image(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// Copies `source` into `target` with its top left corner at (x, y), and cuts off what is outside.
void paste(Image& target, const Image& source, int x, int y);

/// Writes an RGB PNG whole or not at all: it writes under a temporary name beside `path`, then
/// renames. Throws std::runtime_error that names the path.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace render

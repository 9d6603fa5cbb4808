#include "render/files/image.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace render {

Image filled_image(int width, int height, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  constexpr int longest_side = 16384;
  if (width < 1 || height < 1 || width > longest_side || height > longest_side) {
    throw std::invalid_argument("a picture of " + std::to_string(width) + " x " +
                                std::to_string(height) + " pixels; each side must be 1 to 16384");
  }
  Image image{width, height, {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgb.resize(3 * pixels);
  const std::array<std::uint8_t, 3> colour{red, green, blue};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = colour[i % 3];
  return image;
}

void paste(Image& target, const Image& source, int x, int y) {
  const int left = std::max(0, x);
  const int right = std::min(target.width, x + source.width);
  const int top = std::max(0, y);
  const int bottom = std::min(target.height, y + source.height);
  if (left >= right) return;
  for (int row = top; row < bottom; ++row) {
    const auto from = source.rgb.begin() + 3 * (std::ptrdiff_t{row - y} * source.width + left - x);
    const auto to = target.rgb.begin() + 3 * (std::ptrdiff_t{row} * target.width + left);
    std::copy(from, from + 3 * std::ptrdiff_t{right - left}, to);
  }
}

}  // namespace render

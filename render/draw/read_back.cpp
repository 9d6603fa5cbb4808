#include "render/draw/read_back.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "render/colour.hpp"
#include "render/draw/parallel.hpp"

namespace render {
namespace {

constexpr std::uint32_t full_light = 65535;

// Two RGBA pixels side by side in one word; two such words summed hold each channel in 16 bits.
std::uint64_t pixel_pair(const std::uint8_t* rgba) {
  std::uint64_t word = 0;
  std::memcpy(&word, rgba, sizeof word);
  return word;
}

void average_row(const std::uint8_t* lower, const std::uint8_t* upper, int width,
                 std::uint8_t* rgb) {
  constexpr std::uint64_t even_bytes = 0x00FF00FF00FF00FFULL;
  constexpr std::uint64_t halves = 0x0002000200020002ULL;
  for (int x = 0; x < width; ++x, lower += 8, upper += 8, rgb += 3) {
    const std::uint64_t a = pixel_pair(lower);
    const std::uint64_t b = pixel_pair(upper);
    const std::uint64_t red_blue = (a & even_bytes) + (b & even_bytes);
    const std::uint64_t green = (a >> 8U & even_bytes) + (b >> 8U & even_bytes);
    const std::uint64_t red_blue_mean = (red_blue + (red_blue >> 32U) + halves) >> 2U;
    const std::uint64_t green_mean = (green + (green >> 32U) + halves) >> 2U;
    rgb[0] = static_cast<std::uint8_t>(red_blue_mean);
    rgb[1] = static_cast<std::uint8_t>(green_mean);
    rgb[2] = static_cast<std::uint8_t>(red_blue_mean >> 16U);
  }
}

void copy_row(const std::uint8_t* rgba, int width, std::uint8_t* rgb) {
  for (int x = 0; x < width; ++x, rgba += 4, rgb += 3) std::copy(rgba, rgba + 3, rgb);
}

std::array<std::uint32_t, 256> light_of_levels() {
  std::array<std::uint32_t, 256> light{};
  for (std::size_t i = 0; i < light.size(); ++i) {
    const float share = linear_from_srgb(static_cast<float>(i) / 255.0F);
    light[i] = static_cast<std::uint32_t>(std::lround(share * static_cast<float>(full_light)));
  }
  return light;
}

std::vector<std::uint8_t> levels_of_light() {
  std::vector<std::uint8_t> levels(full_light + 1);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(full_light);
    levels[i] = static_cast<std::uint8_t>(std::lround(255.0F * srgb_from_linear(share)));
  }
  return levels;
}

// Calls body(first, last) for bands of rows.
template <typename Body>
void for_bands(int height, const Body& body) {
  constexpr int bands = 16;
  for_each_in_parallel(bands, [&](int i) { body(height * i / bands, height * (i + 1) / bands); });
}

}  // namespace

const std::uint8_t* Reader::read(const Canvas& canvas, int width, int first, int last) {
  const std::size_t bytes =
      std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(last - first);
  if (rgba_.size() < bytes) rgba_.resize(bytes);
  canvas.read_rows(first, last, rgba_.data());
  return rgba_.data();
}

Image Reader::picture(const Canvas& canvas, int width, int height, int samples) {
  Image image{width, height, {}};
  const std::size_t out_stride = 3 * static_cast<std::size_t>(width);
  const std::size_t in_stride = std::size_t{4} * static_cast<std::size_t>(samples * width);
  image.rgb.resize(out_stride * static_cast<std::size_t>(height));
  // Some rows at a time: they are still in the cache when they are averaged.
  constexpr int rows_at_once = 120;
  for (int first = 0; first < height; first += rows_at_once) {
    const int rows = std::min(rows_at_once, height - first);
    const std::uint8_t* rgba =
        read(canvas, samples * width, samples * first, samples * (first + rows));
    for_bands(rows, [&](int low, int high) {
      for (int row = low; row < high; ++row) {
        // GL's rows go up.
        const auto out_row = static_cast<std::size_t>(height - 1 - first - row);
        const std::uint8_t* in = rgba + static_cast<std::size_t>(samples * row) * in_stride;
        std::uint8_t* out = image.rgb.data() + out_row * out_stride;
        if (samples == 2) {
          average_row(in, in + in_stride, width, out);
        } else {
          copy_row(in, width, out);
        }
      }
    });
  }
  return image;
}

void Reader::add(const Canvas& canvas, int width, int height) {
  static const std::array<std::uint32_t, 256> light = light_of_levels();
  const std::size_t stride = 3 * static_cast<std::size_t>(width);
  if (count_ == 0) sums_.assign(stride * static_cast<std::size_t>(height), 0);
  const std::uint8_t* rgba = read(canvas, width, 0, height);
  for_bands(height, [&](int first, int last) {
    for (int y = first; y < last; ++y) {
      const auto row = static_cast<std::size_t>(height - 1 - y);
      const std::uint8_t* in = rgba + row * 4 * static_cast<std::size_t>(width);
      std::uint32_t* out = sums_.data() + static_cast<std::size_t>(y) * stride;
      for (int x = 0; x < width; ++x, in += 4, out += 3) {
        for (std::size_t i = 0; i < 3; ++i) out[i] += light[in[i]];
      }
    }
  });
  ++count_;
}

Image Reader::mean(int width, int height) {
  static const std::vector<std::uint8_t> levels = levels_of_light();
  Image image{width, height, {}};
  image.rgb.resize(sums_.size());
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    image.rgb[i] = levels[(sums_[i] + count_ / 2) / count_];
  }
  count_ = 0;
  return image;
}

}  // namespace render

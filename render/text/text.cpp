#include "render/text/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {
namespace {

struct Origin {
  int x = 0;
  int y = 0;
};

// The mask grown by a disc of two pixels with a soft edge.
Mask grown(const Mask& mask) {
  constexpr int reach = 2;
  constexpr double radius = 2.2;
  Mask result{
      mask.left - reach, mask.top - reach, mask.width + 2 * reach, mask.height + 2 * reach, {}};
  result.coverage.resize(static_cast<std::size_t>(result.width) *
                         static_cast<std::size_t>(result.height));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double weight = std::clamp(radius + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
      const int scale = static_cast<int>(std::lround(256.0 * weight));
      for (int y = 0; y < mask.height; ++y) {
        for (int x = 0; x < mask.width; ++x) {
          std::uint8_t& sum = result.at(x + dx + reach, y + dy + reach);
          sum = std::max(sum, static_cast<std::uint8_t>(mask.at(x, y) * scale / 256));
        }
      }
    }
  }
  return result;
}

void blend(Image& image, const Mask& mask, Origin origin, const Colour& colour) {
  const std::array<float, 3> ink{255.0F * colour.red, 255.0F * colour.green, 255.0F * colour.blue};
  for (int y = 0; y < mask.height; ++y) {
    const int image_y = origin.y + mask.top + y;
    if (image_y < 0 || image_y >= image.height) continue;
    for (int x = 0; x < mask.width; ++x) {
      const int image_x = origin.x + mask.left + x;
      const std::uint8_t coverage = mask.at(x, y);
      if (image_x < 0 || image_x >= image.width || coverage == 0) continue;
      const float share = static_cast<float>(coverage) / 255.0F;
      std::uint8_t* pixel =
          &image
               .rgb[3 * (static_cast<std::size_t>(image_y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(image_x))];
      for (std::size_t i = 0; i < 3; ++i) {
        const float before = pixel[i];
        pixel[i] = static_cast<std::uint8_t>(std::lround(before + share * (ink[i] - before)));
      }
    }
  }
}

bool is_within(const std::string& utf8, double width, double size, Weight weight) {
  return text_width(utf8, size, weight) <= width;
}

// The bytes of the longest start of `word` that fits, but at least one character.
std::size_t fitting_bytes(const std::string& word, double width, double size, Weight weight) {
  std::size_t bytes = 0;
  for (std::size_t end = 1; end <= word.size(); ++end) {
    const bool inside_character =
        end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0U) == 0x80U;
    if (inside_character) continue;
    if (bytes > 0 && !is_within(word.substr(0, end), width, size, weight)) break;
    bytes = end;
  }
  return bytes;
}

}  // namespace

double text_width(std::string_view utf8, double size, Weight weight) {
  return typeface(weight).width(characters_of(utf8), size);
}

void draw_text(Image& image, double x, double baseline, std::string_view utf8,
               const TextStyle& style) {
  const Origin origin{static_cast<int>(std::floor(x)), static_cast<int>(std::lround(baseline))};
  const Mask mask = typeface(style.weight).line(characters_of(utf8), style.size, x - std::floor(x));
  if (style.halo) blend(image, grown(mask), origin, {1.0F, 1.0F, 1.0F});
  blend(image, mask, origin, style.colour);
}

std::vector<std::string> wrapped_text(const std::string& utf8, double width, double size,
                                      Weight weight) {
  std::vector<std::string> lines{""};
  std::size_t at = 0;
  while (at < utf8.size()) {
    const std::size_t space = std::min(utf8.find(' ', at), utf8.size());
    std::string word = utf8.substr(at, space - at);
    at = space + 1;
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (is_within(longer, width, size, weight)) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    while (!is_within(word, width, size, weight)) {
      const std::size_t bytes = fitting_bytes(word, width, size, weight);
      if (bytes >= word.size()) break;
      lines.back() = word.substr(0, bytes);
      lines.emplace_back();
      word.erase(0, bytes);
    }
    lines.back() = word;
  }
  return lines;
}

}  // namespace render

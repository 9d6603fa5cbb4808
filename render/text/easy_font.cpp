#include "render/text/easy_font.hpp"

#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace render {
namespace {

// The bitmap font's capitals are 7 units tall above the baseline, DejaVu's 0.73 of its size.
double pixels_per_unit(double size) { return std::max(1.0, std::round(0.73 * size / 7.0)); }

std::string transliterated(std::u32string_view line) {
  std::string ascii;
  for (const char32_t character : line) ascii += ascii_likeness(character);
  return ascii;
}

struct Corner {
  float x, y, z;
  std::array<unsigned char, 4> colour;
};

// Corners of quads in the font's units, y down, the baseline at y = 7.
std::vector<Corner> quads(std::string ascii) {
  std::vector<Corner> corners(std::size_t{256} * (ascii.size() + 1));
  const int bytes = static_cast<int>(corners.size() * sizeof(Corner));
  const int count = stb_easy_font_print(0.0F, 0.0F, ascii.data(), nullptr, corners.data(), bytes);
  corners.resize(4 * static_cast<std::size_t>(count));
  return corners;
}

}  // namespace

char ascii_likeness(char32_t character) {
  if (character >= U' ' && character <= U'~') return static_cast<char>(character);
  constexpr std::u32string_view known = U"αβγδεηθκλμνξπρστφχψωΓΔΘΛΠΣΦΨΩ·×−–—°²³₀₁₂₃≤≥≈′∞";
  constexpr std::string_view likeness = "abgdenOklmnxprstfxywGDOLPSFYW**---o230123<>~'8";
  static_assert(known.size() == likeness.size());
  const std::size_t place = known.find(character);
  return place == std::u32string_view::npos ? '?' : likeness[place];
}

Mask easy_font_line(std::u32string_view line, double size) {
  const auto scale = static_cast<float>(pixels_per_unit(size));
  const std::vector<Corner> corners = quads(transliterated(line));
  Mask mask;
  mask.top = static_cast<int>(-8 * scale);
  mask.width = static_cast<int>(easy_font_width(line, size)) + static_cast<int>(scale);
  mask.height = static_cast<int>(12 * scale);
  mask.coverage.resize(static_cast<std::size_t>(mask.width) *
                       static_cast<std::size_t>(mask.height));
  for (std::size_t i = 0; i + 3 < corners.size(); i += 4) {
    const Corner& low = corners[i];
    const Corner& high = corners[i + 2];
    const int left = std::max(0, static_cast<int>(low.x * scale));
    const int right = std::min(mask.width, static_cast<int>(high.x * scale));
    const int top = std::max(0, static_cast<int>((low.y + 1) * scale));
    const int bottom = std::min(mask.height, static_cast<int>((high.y + 1) * scale));
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) mask.at(x, y) = 255;
    }
  }
  return mask;
}

double easy_font_width(std::u32string_view line, double size) {
  std::string ascii = transliterated(line);
  return stb_easy_font_width(ascii.data()) * pixels_per_unit(size);
}

}  // namespace render

#include "render/text/typeface.hpp"

#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>

#include "render/text/easy_font.hpp"

namespace render {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void say_once_that_no_font_opens() {
  static std::once_flag said;
  std::call_once(said, [] {
    std::cerr << "no font file found: labels are drawn with built-in letters "
                 "(install fonts-dejavu-core or set TUMBLE_FONT)\n";
  });
}

// What one glyph adds; glyphs of a line may overlap, and there the darker counts.
void add_glyph(Mask& mask, const Mask& glyph) {
  for (int y = 0; y < glyph.height; ++y) {
    for (int x = 0; x < glyph.width; ++x) {
      const int mask_x = x + glyph.left - mask.left;
      const int mask_y = y + glyph.top - mask.top;
      if (mask_x < 0 || mask_y < 0 || mask_x >= mask.width || mask_y >= mask.height) continue;
      std::uint8_t& sum = mask.at(mask_x, mask_y);
      sum = std::max(sum, glyph.at(x, y));
    }
  }
}

Mask blank_mask(int left, int top, int right, int bottom) {
  Mask mask{left, top, std::max(0, right - left), std::max(0, bottom - top), {}};
  mask.coverage.resize(static_cast<std::size_t>(mask.width) *
                       static_cast<std::size_t>(mask.height));
  return mask;
}

struct PlacedGlyph {
  int index;
  double x;
};

struct Layout {
  std::vector<PlacedGlyph> glyphs;
  double end = 0.0;
};

}  // namespace

std::uint8_t& Mask::at(int x, int y) {
  return coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
}

std::uint8_t Mask::at(int x, int y) const {
  return coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
}

std::vector<std::filesystem::path> usual_font_files(Weight weight) {
  if (const char* chosen = std::getenv("TUMBLE_FONT")) return {chosen};
  const bool bold = weight == Weight::bold;
  const std::string dejavu = bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf";
  const std::string arial = bold ? "Arial Bold.ttf" : "Arial.ttf";
  return {"/usr/share/fonts/truetype/dejavu/" + dejavu,
          "/usr/share/fonts/dejavu-sans-fonts/" + dejavu,
          "/usr/share/fonts/TTF/" + dejavu,
          "/usr/share/fonts/dejavu/" + dejavu,
          "/System/Library/Fonts/Supplemental/" + arial,
          "/Library/Fonts/" + arial};
}

struct Typeface::Outline {
  std::string file;
  stbtt_fontinfo info{};

  [[nodiscard]] float scale(double size) const {
    return stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(size));
  }

  [[nodiscard]] Mask glyph(int index, float scale, double x) const {
    const auto whole = static_cast<int>(std::floor(x));
    const auto shift = static_cast<float>(x - whole);
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&info, index, scale, scale, shift, 0.0F, &left, &top, &right,
                                    &bottom);
    Mask mask = blank_mask(left + whole, top, right + whole, bottom);
    if (mask.coverage.empty()) return mask;
    stbtt_MakeGlyphBitmapSubpixel(&info, mask.coverage.data(), mask.width, mask.height, mask.width,
                                  scale, scale, shift, 0.0F, index);
    return mask;
  }

  [[nodiscard]] Layout layout(std::u32string_view text, float scale, double x) const {
    Layout result;
    int previous = 0;
    for (const char32_t character : text) {
      const int glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(character));
      x += static_cast<double>(scale) * stbtt_GetGlyphKernAdvance(&info, previous, glyph);
      result.glyphs.push_back({glyph, x});
      int advance = 0;
      int bearing = 0;
      stbtt_GetGlyphHMetrics(&info, glyph, &advance, &bearing);
      x += static_cast<double>(scale) * advance;
      previous = glyph;
    }
    result.end = x;
    return result;
  }
};

Typeface::Typeface(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& path : files) {
    auto outline = std::make_unique<Outline>();
    outline->file = bytes_of(path);
    constexpr std::size_t least_size = 12;  // of the header, which stb reads unchecked
    if (outline->file.size() < least_size) continue;
    const auto* bytes = reinterpret_cast<const unsigned char*>(outline->file.data());
    const int offset = stbtt_GetFontOffsetForIndex(bytes, 0);
    if (offset < 0 || stbtt_InitFont(&outline->info, bytes, offset) == 0) continue;
    outline_ = std::move(outline);
    return;
  }
  say_once_that_no_font_opens();
}

Typeface::~Typeface() = default;

Mask Typeface::line(std::u32string_view text, double size, double x) const {
  if (!outline_) return easy_font_line(text, size);
  const int reach = static_cast<int>(std::ceil(size));
  const int end = static_cast<int>(std::ceil(x + width(text, size)));
  Mask mask = blank_mask(-reach / 2, -reach - reach / 4, end + reach / 2, reach / 2);
  const float scale = outline_->scale(size);
  for (const PlacedGlyph& placed : outline_->layout(text, scale, x).glyphs) {
    add_glyph(mask, outline_->glyph(placed.index, scale, placed.x));
  }
  return mask;
}

double Typeface::width(std::u32string_view text, double size) const {
  if (!outline_) return easy_font_width(text, size);
  return outline_->layout(text, outline_->scale(size), 0.0).end;
}

bool Typeface::is_outline() const { return outline_ != nullptr; }

const Typeface& typeface(Weight weight) {
  static const Typeface regular(usual_font_files(Weight::regular));
  static const Typeface bold(usual_font_files(Weight::bold));
  return weight == Weight::bold ? bold : regular;
}

}  // namespace render

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace render {

/// The characters of a UTF-8 text; a broken byte becomes U+FFFD.
std::u32string characters_of(std::string_view utf8);

/// How much ink covers each pixel of a rectangle, beside the point where a line of text starts.
struct Mask {
  int left = 0;  ///< of the rectangle, from the start of the line [pixels]
  int top = 0;   ///< from the baseline, down [pixels]
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> coverage;  ///< 0 none … 255 all, row by row

  std::uint8_t& at(int x, int y);
  [[nodiscard]] std::uint8_t at(int x, int y) const;
};

enum class Weight { regular, bold };

/// Where typefaces of a weight usually are: what TUMBLE_FONT names, else the usual folders of
/// Debian, Fedora, Arch and macOS.
std::vector<std::filesystem::path> usual_font_files(Weight weight);

/// Letters of any size. Where no font file opens it falls back to a small built-in bitmap font and
/// says so on stderr, once a program.
class Typeface {
 public:
  /// Opens the first of `files` that is a TrueType font.
  explicit Typeface(const std::vector<std::filesystem::path>& files);
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  /// A line that starts at (x, 0), where x in [0, 1) places it between pixels.
  [[nodiscard]] Mask line(std::u32string_view text, double size, double x) const;

  /// How far the line reaches [pixels]; `size` is that of the em square.
  [[nodiscard]] double width(std::u32string_view text, double size) const;

  /// Whether it reads a font file, rather than falling back.
  [[nodiscard]] bool is_outline() const;

 private:
  struct Outline;
  std::unique_ptr<Outline> outline_;
};

/// The typeface of the usual files.
const Typeface& typeface(Weight weight);

}  // namespace render

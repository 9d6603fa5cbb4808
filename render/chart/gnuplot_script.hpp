#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "render/colour.hpp"

/// The text and layout of gnuplot scripts, the same for every kind of chart.
namespace render {

inline constexpr double label_height = 24.8;  ///< a line of labels, in units of a Sheet

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

/// Puts a text in gnuplot's single quotes, in which only the quote itself is special.
std::string gnuplot_text(const std::string& text);

/// Return " lc rgb '#rrggbb'" for a line, and " tc rgb '#rrggbb'" for text.
std::string line_colour(const Colour& colour);
std::string text_colour(const Colour& colour);

/// The places of the parts of a picture, from its upper left, in units in which it is 1000 wide.
/// Labels are in a right margin that is as wide as the longest of them. Lines that are too long are
/// broken, and the picture grows by them.
struct Sheet {
  std::string name;  ///< of the files, without their endings
  std::string title;
  std::vector<std::string> subtitle;  ///< in lines
  std::vector<std::string> notes;     ///< in lines, at the foot
  double left = 0.0;                  ///< edges of what is plotted
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
  double height = 0.0;
};

/// The content of a sheet.
struct SheetContent {
  std::string name;
  std::string title;
  std::string subtitle;
  std::vector<std::string> notes;
  std::vector<std::string> labels;
  double plot_height = 0.0;
};
Sheet make_sheet(const SheetContent& content);

/// Returns the comment, the style and the side margins.
std::string sheet_start(const Sheet& sheet);

/// Returns title, subtitle and notes, as labels with the tags from 901 on.
std::string sheet_words(const Sheet& sheet);

/// Return `set terminal` and `set output` for NAME.svg, NAME.png and NAME.pdf.
std::string svg_output(const Sheet& sheet);
std::string png_output(const Sheet& sheet);
std::string pdf_output(const Sheet& sheet);

/// Returns a height from the sheet's top as gnuplot's screen coordinate.
double screen_height(const Sheet& sheet, double from_top);

/// Returns grey tones in turn, to set peers apart from the lab's own methods.
Colour peer_colour(std::size_t index);

}  // namespace render

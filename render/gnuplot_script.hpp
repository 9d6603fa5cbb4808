#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "render/colour.hpp"

/// Words and layout of gnuplot scripts, the same for every kind of chart.
namespace render {

inline constexpr double label_height = 24.8;  ///< a line of labels, in units of a Sheet

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

/// In gnuplot's single quotes, where only the quote itself is special.
std::string gnuplot_text(const std::string& text);

/// " lc rgb '#rrggbb'" for a line, " tc rgb '#rrggbb'" for text.
std::string line_colour(const Colour& colour);
std::string text_colour(const Colour& colour);

/// Where the parts of a picture stand, in units of which it is 1000 wide, from its upper left.
/// Labels stand in a right margin that is as wide as the longest of them; lines that are too long
/// are broken, and the picture grows by them.
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

/// What a sheet is to hold.
struct SheetContent {
  std::string name;
  std::string title;
  std::string subtitle;
  std::vector<std::string> notes;
  std::vector<std::string> labels;
  double plot_height = 0.0;
};
Sheet make_sheet(const SheetContent& content);

/// Comment, style and side margins.
std::string sheet_start(const Sheet& sheet);

/// Title, subtitle and notes, as labels with the tags from 901 on.
std::string sheet_words(const Sheet& sheet);

/// `set terminal` and `set output` for NAME.svg, NAME.png and NAME.pdf.
std::string svg_output(const Sheet& sheet);
std::string png_output(const Sheet& sheet);
std::string pdf_output(const Sheet& sheet);

/// A height from the sheet's top as gnuplot's screen coordinate.
double screen_height(const Sheet& sheet, double from_top);

/// Grey tones in turn: peers are set apart from the lab's own methods.
Colour peer_colour(std::size_t index);

}  // namespace render

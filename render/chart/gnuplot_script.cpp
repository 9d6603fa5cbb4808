#include "render/chart/gnuplot_script.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace render {
namespace {

// In units of a Sheet, whose letters are DejaVu Sans 13 at 4/3.
constexpr double picture_width = 1000.0;
constexpr double letter_width = 9.0;
constexpr double more_of_wide_letter = 5.0;  // W, M, w, m
constexpr double small_letter_width = 8.4;
constexpr double left_margin = 114.0;
constexpr double label_indent = 50.0;
constexpr double title_centre = 38.0;
constexpr double first_line_centre = 71.0;
constexpr double line_height = 21.0;
constexpr double axis_height = 80.0;  // tics and name of the x axis

std::string hex(const Colour& colour) {
  const auto byte = [](float part) { return static_cast<unsigned>(std::lround(255.0F * part)); };
  return formatted("#%02x%02x%02x", byte(colour.red), byte(colour.green), byte(colour.blue));
}

/// Letters are thinner than lines: light colours are darkened to a contrast of 3 to white (WCAG 2).
Colour legible(Colour colour) {
  constexpr float least_contrast = 3.0F;
  constexpr float darker = 0.96F;
  const auto contrast = [&] {
    return 1.05F /
           (0.05F + 0.2126F * linear_from_srgb(colour.red) +
            0.7152F * linear_from_srgb(colour.green) + 0.0722F * linear_from_srgb(colour.blue));
  };
  while (contrast() < least_contrast) {
    colour = {darker * colour.red, darker * colour.green, darker * colour.blue};
  }
  return colour;
}

/// In gnuplot's enhanced mode, the only one that sets bold type both in PNG and in SVG.
std::string bold(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string("{}^_@&~\\").find(c) != std::string::npos) escaped += '\\';
    escaped += c;
  }
  return gnuplot_text("{/:Bold " + escaped + "}");
}

/// Letters, not bytes.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

double label_width(const std::string& text) {
  const auto wide = std::count_if(text.begin(), text.end(),
                                  [](char c) { return std::strchr("WMwm", c) != nullptr; });
  return letter_width * static_cast<double>(letters(text)) +
         more_of_wide_letter * static_cast<double>(wide);
}

/// Broken after separators only, so that no line has more letters than `limit` where that can be.
std::vector<std::string> broken(const std::string& text, const std::string& separator,
                                std::size_t limit) {
  std::vector<std::string> lines;
  std::string line;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t found = text.find(separator, start);
    const std::size_t end = found == std::string::npos ? text.size() : found + separator.size();
    const std::string word = text.substr(start, end - start);
    if (!line.empty() && letters(line) + letters(word) > limit) {
      lines.push_back(line);
      line.clear();
    }
    line += word;
    start = end;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

/// As few lines as fit in the picture's width, and these about equally long.
std::vector<std::string> in_lines(const std::string& text, const std::string& separator) {
  auto limit = static_cast<std::size_t>((picture_width - left_margin) / small_letter_width);
  std::vector<std::string> lines = broken(text, separator, limit);
  for (; limit > 0; --limit) {
    std::vector<std::string> shorter = broken(text, separator, limit - 1);
    if (shorter.size() > lines.size()) break;
    lines = std::move(shorter);
  }
  return lines;
}

std::string words_at(int tag, const std::string& text, double x, double y, const char* style) {
  return formatted("set label %d ", tag) + text +
         formatted(" at screen %.4f, screen %.4f %s\n", x, y, style);
}

}  // namespace

std::string gnuplot_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

std::string line_colour(const Colour& colour) { return " lc rgb '" + hex(colour) + "'"; }

std::string text_colour(const Colour& colour) { return " tc rgb '" + hex(legible(colour)) + "'"; }

Sheet make_sheet(const SheetContent& content) {
  Sheet sheet;
  sheet.name = content.name;
  sheet.title = content.title;
  sheet.subtitle = in_lines(content.subtitle, " ");
  for (const std::string& note : content.notes) {
    const std::vector<std::string> lines = in_lines(note, ", ");
    sheet.notes.insert(sheet.notes.end(), lines.begin(), lines.end());
  }
  double widest = 0.0;
  for (const std::string& label : content.labels) widest = std::max(widest, label_width(label));
  sheet.left = left_margin;
  sheet.right = picture_width - label_indent - widest;
  sheet.top = first_line_centre + static_cast<double>(sheet.subtitle.size()) * line_height;
  sheet.bottom = sheet.top + content.plot_height;
  sheet.height = sheet.bottom + axis_height + static_cast<double>(sheet.notes.size()) * line_height;
  if (!sheet.notes.empty()) sheet.height += 0.5 * line_height;
  return sheet;
}

double screen_height(const Sheet& sheet, double from_top) { return 1.0 - from_top / sheet.height; }

std::string sheet_start(const Sheet& sheet) {
  const char* const name = sheet.name.c_str();
  std::string s = formatted("# gnuplot %s.gp  draws %s.svg and %s.png; ", name, name, name) +
                  formatted("the numbers are those of %s.csv.\n", name);
  s += "set encoding utf8\nset border 3 lc rgb '#8d9299' lw 1\n";
  s += "set tics nomirror out scale 0.6 tc rgb '#282c34'\n";
  s += "set grid xtics ytics back lt 1 lw 0.7 lc rgb '#e4e6e9'\nunset key\n";
  s += formatted("set lmargin at screen %.4f\nset rmargin at screen %.4f\n",
                 sheet.left / picture_width, sheet.right / picture_width);
  return s;
}

std::string sheet_words(const Sheet& sheet) {
  const double x = sheet.left / picture_width;
  int tag = 901;
  std::string s = words_at(tag++, bold(sheet.title), x, screen_height(sheet, title_centre),
                           "font ',17' tc rgb '#282c34'");
  double y = first_line_centre;
  for (const std::string& line : sheet.subtitle) {
    s += words_at(tag++, gnuplot_text(line), x, screen_height(sheet, y),
                  "noenhanced font ',12' tc rgb '#6b7078'");
    y += line_height;
  }
  y = sheet.bottom + axis_height;
  for (const std::string& line : sheet.notes) {
    s += words_at(tag++, gnuplot_text(line), x, screen_height(sheet, y),
                  "noenhanced font ',11' tc rgb '#a03c00'");
    y += line_height;
  }
  return s;
}

std::string svg_output(const Sheet& sheet) {
  return formatted("set terminal svg size 1000,%.0f font 'DejaVu Sans,13' fontscale 1.33 ",
                   sheet.height) +
         "rounded dashlength 2.2 background '#ffffff'\nset output '" + sheet.name + ".svg'\n";
}

std::string png_output(const Sheet& sheet) {
  return formatted("set terminal pngcairo size 1500,%.0f font 'DejaVu Sans,13' fontscale 1.5 ",
                   1.5 * sheet.height) +
         "linewidth 1.5 pointscale 1.5 rounded dashlength 2.2 background '#ffffff'\nset output '" +
         sheet.name + ".png'\n";
}

/// 7 inches wide, so that letters are as large beside a report's text as in the SVG.
std::string pdf_output(const Sheet& sheet) {
  return formatted("set terminal pdfcairo size 7in,%.3fin font 'DejaVu Sans,13' fontscale 0.5 ",
                   7.0 / picture_width * sheet.height) +
         "linewidth 0.7 pointscale 0.5 rounded dashlength 2.2 background '#ffffff'\nset output '" +
         sheet.name + ".pdf'\n";
}

Colour peer_colour(std::size_t index) {
  constexpr std::array tones{Colour{0.36F, 0.38F, 0.41F}, Colour{0.60F, 0.62F, 0.65F}};
  return tones.at(index % tones.size());
}

}  // namespace render

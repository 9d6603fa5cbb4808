#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "catch.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/image.hpp"
#include "render/film/film_strip.hpp"
#include "render/text/text.hpp"
#include "render_picture.hpp"

namespace {

using render::Image;
using tests::content;
using tests::files_in;
using tests::message_of;
using tests::read_png;
using tests::ScratchFolder;

// Reaches all byte values, smooth in parts, so that the packer has something to find.
Image patterned_image(int width, int height) {
  Image image = render::filled_image(width, height, 0, 0, 0);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    image.rgb[i] = static_cast<std::uint8_t>(i % 7 == 0 ? i * i / 5 : i / 100);
  }
  return image;
}

// Whether a rectangle is white but for nothing.
bool is_white(const Image& image, int left, int top, int right, int bottom) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const std::size_t pixel =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x));
      for (std::size_t i = 0; i < 3; ++i) {
        if (image.rgb[pixel + i] != 255) return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("A PNG reads back as the picture that was written", "[render_image]") {
  const ScratchFolder folder;
  // Fewer rows than strips, one pixel, odd widths, a usual frame.
  const auto size = GENERATE(std::pair(1, 1), std::pair(5, 3), std::pair(3, 300), std::pair(301, 7),
                             std::pair(640, 360));
  const Image image = patterned_image(size.first, size.second);
  const std::filesystem::path path = folder.path() / "picture.png";
  render::write_png(image, path);
  const Image back = read_png(path);
  CHECK(back.width == image.width);
  CHECK(back.height == image.height);
  CHECK(back.rgb == image.rgb);
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A PNG that cannot be written names its path and leaves nothing", "[render_image]") {
  const ScratchFolder folder;
  const Image image = patterned_image(4, 4);
  const std::filesystem::path missing = folder.path() / "missing" / "picture.png";
  const std::string message = message_of([&] { render::write_png(image, missing); });
  INFO(message);
  CHECK(message.find("cannot write " + missing.string() + ": ") == 0);

  // A folder in the file's place lets the temporary file be written, but not renamed.
  const std::filesystem::path taken = folder.path() / "taken";
  std::filesystem::create_directory(taken);
  CHECK_FALSE(message_of([&] { render::write_png(image, taken); }).empty());
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A file that is replaced keeps its old bytes until the new ones are whole",
          "[render_image]") {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "data.csv";
  render::write_file_atomically(path, "old");
  render::write_file_atomically(path, "newer");
  CHECK(content(path) == "newer");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A picture without pixels or of absurd size is refused", "[render_image]") {
  const ScratchFolder folder;
  CHECK_THROWS_AS(render::filled_image(0, 5, 0, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(render::filled_image(5, -1, 0, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(render::filled_image(16385, 1, 0, 0, 0), std::invalid_argument);
  CHECK_THROWS_AS(render::write_png({0, 0, {}}, folder.path() / "a.png"), std::runtime_error);
  CHECK_THROWS_AS(render::write_png({2, 2, {1, 2, 3}}, folder.path() / "b.png"),
                  std::runtime_error);
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("Pasting cuts off what lies outside", "[render_image]") {
  const Image source = render::filled_image(3, 3, 9, 9, 9);
  Image target = render::filled_image(4, 4, 0, 0, 0);
  render::paste(target, source, -2, 3);
  render::paste(target, source, 50, 50);
  int painted = 0;
  for (const std::uint8_t value : target.rgb) painted += value == 9 ? 1 : 0;
  CHECK(painted == 3);  // one pixel, in the lower left corner
  CHECK(target.rgb[std::size_t{3} * 4 * 3] == 9);
}

TEST_CASE("UTF-8 decodes and broken bytes become one sign each", "[render_image]") {
  CHECK(render::characters_of("aω₀𝜔") == U"aω₀𝜔");
  CHECK(render::characters_of("a\xFFz") == U"a\uFFFDz");
  CHECK(render::characters_of("\xCF") == U"\uFFFD");
}

TEST_CASE("Without a font letters are drawn still and the lack is said once", "[render_image]") {
  std::ostringstream said;
  std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
  const render::Typeface first({"/nonexistent/font.ttf"});
  const render::Typeface second({});
  std::cerr.rdbuf(before);
  const std::string text = said.str();
  INFO(text);
  CHECK(text.find("no font file found") == 0);
  CHECK(text.find('\n') == text.size() - 1);

  CHECK_FALSE(first.is_outline());
  const render::Mask mask = first.line(U"ω = 3 rad/s, \u4E2D", 16.0, 0.0);
  int ink = 0;
  for (const std::uint8_t coverage : mask.coverage) ink += coverage > 0 ? 1 : 0;
  CHECK(ink > 50);
  CHECK(second.width(U"ω", 16.0) == first.width(U"w", 16.0));
}

TEST_CASE("Text is as wide as it is drawn", "[render_image]") {
  const std::string text = "max |ΔE|/E = 1e-14";
  const int width = static_cast<int>(std::ceil(render::text_width(text, 17.0)));
  Image image = render::filled_image(width + 80, 60, 255, 255, 255);
  render::draw_text(image, 40.25, 40.0, text, {17.0, render::palette::ink});
  CHECK_FALSE(is_white(image, 40, 0, 50, 60));
  CHECK_FALSE(is_white(image, 30 + width, 0, 41 + width, 60));
  CHECK(is_white(image, 0, 0, 38, 60));
  CHECK(is_white(image, 43 + width, 0, 80 + width, 60));
}

TEST_CASE("Wrapped text fits its width and loses no letter", "[render_image]") {
  const std::string text = "torque-free: L is fixed in space, ω₀ wanders; Donaudampfschifffahrt";
  const double width = GENERATE(20.0, 90.0, 333.0, 5000.0);
  std::string letters;
  for (const std::string& line : render::wrapped_text(text, width, 15.0)) {
    CHECK(render::text_width(line, 15.0) <= width);
    for (const char letter : line) letters += letter == ' ' ? "" : std::string(1, letter);
  }
  std::string wanted;
  for (const char letter : text) wanted += letter == ' ' ? "" : std::string(1, letter);
  CHECK(letters == wanted);
}

TEST_CASE("A film strip never cuts its captions off", "[render_image]") {
  const int tile_width = GENERATE(60, 150, 330);
  const int tiles = GENERATE(1, 3, 6);
  const Image picture = render::filled_image(tile_width, 100, 255, 255, 255);
  const std::vector<render::StripTile> all(static_cast<std::size_t>(tiles),
                                           {picture, "t = 1234567.25 s"});
  const render::StripText text{"A title that goes on for longer than a narrow strip is wide",
                               "one sentence that says what to see in these pictures of a motion",
                               "I = (1.2, 16.4, 17.6) g m², ω₀ = (0.15, 8, 0) rad/s",
                               "max |ΔE|/E = 1e-14, |ΔL|/|L| = 2e-09 after 1.37 s"};
  const Image strip = render::film_strip(all, text, tiles);
  INFO(tile_width << " x " << tiles);
  // The free margin around shows that no letter reaches the edge.
  constexpr int margin = 8;
  CHECK(is_white(strip, 0, 0, margin, strip.height));
  CHECK(is_white(strip, strip.width - margin, 0, strip.width, strip.height));
  CHECK(is_white(strip, 0, 0, strip.width, 4));
  CHECK(is_white(strip, 0, strip.height - 4, strip.width, strip.height));
}

TEST_CASE("Film strips fill their rows evenly", "[render_image]") {
  CHECK(render::strip_columns(6, 330, 2100) == 6);
  CHECK(render::strip_columns(7, 330, 2100) == 4);
  CHECK(render::strip_columns(9, 700, 2100) == 2);
  CHECK(render::strip_columns(1, 5000, 2100) == 1);
}

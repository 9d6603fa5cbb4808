#include "render/film/film_facts.hpp"

#include <iomanip>
#include <limits>
#include <sstream>

namespace render {
namespace {

// A JSON string; UTF-8 stays as it is.
std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << '"' << std::hex << std::setfill('0');
  for (const char character : text) {
    const auto code = static_cast<unsigned>(static_cast<unsigned char>(character));
    if (character == '"' || character == '\\') {
      out << '\\' << character;
    } else if (code < 0x20) {
      out << "\\u" << std::setw(4) << code;
    } else {
      out << character;
    }
  }
  out << '"';
  return out.str();
}

}  // namespace

std::string film_facts(const Film& film, const FilmOptions& options, int frames) {
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  out << "{\n"
      << "  \"title\": " << quoted(film.title) << ",\n"
      << "  \"subtitle\": " << quoted(film.subtitle) << ",\n"
      << "  \"parameters\": " << quoted(film.parameters) << ",\n"
      << "  \"measured\": " << quoted(film.measured) << ",\n"
      << "  \"fps\": " << options.frames_per_second << ",\n"
      << "  \"width\": " << options.picture.width << ",\n"
      << "  \"height\": " << options.picture.height << ",\n"
      << "  \"frames\": " << frames << ",\n"
      << "  \"from\": " << options.from << ",\n"
      << "  \"to\": " << options.to << ",\n"
      << "  \"missing\": [";
  for (std::size_t i = 0; i < film.missing.size(); ++i) {
    out << (i == 0 ? "" : ", ") << quoted(film.missing[i]);
  }
  out << "]\n}\n";
  return out.str();
}

}  // namespace render

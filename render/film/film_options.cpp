#include "render/film/film_options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace render {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& value, const char* wanted) {
  throw std::invalid_argument(option + " " + value + ": must be " + wanted);
}

double number(const std::string& option, const std::string& value, const char* wanted) {
  char* end = nullptr;
  const double result = std::strtod(value.c_str(), &end);
  if (value.empty() || *end != '\0' || !std::isfinite(result)) fail(option, value, wanted);
  return result;
}

int side(const std::string& option, const std::string& size, const std::string& digits) {
  constexpr const char* wanted = "WIDTHxHEIGHT, each 16 to 8192";
  const bool is_number = !digits.empty() && digits.size() <= 4 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  const int pixels = is_number ? std::stoi(digits) : 0;
  if (pixels < 16 || pixels > 8192) fail(option, size, wanted);
  return pixels;
}

Quality quality(const std::string& option, const std::string& value) {
  if (value == "draft") return Quality::draft;
  if (value == "film") return Quality::film;
  if (value == "report") return Quality::report;
  fail(option, value, "draft, film or report");
}

void read_size(PictureOptions& picture, const std::string& option, const std::string& size) {
  const std::size_t cross = std::min(size.find('x'), size.size());
  picture.width = side(option, size, size.substr(0, cross));
  picture.height = side(option, size, size.substr(std::min(cross + 1, size.size())));
}

double frame_rate(const std::string& option, const std::string& value) {
  constexpr const char* wanted = "a number above 0 and up to 240";
  const double frames_per_second = number(option, value, wanted);
  if (frames_per_second <= 0.0 || frames_per_second > 240.0) fail(option, value, wanted);
  return frames_per_second;
}

double time_of(const std::string& option, const std::string& value) {
  constexpr const char* wanted = "a time in seconds, zero or more";
  const double time = number(option, value, wanted);
  if (time < 0.0) fail(option, value, wanted);
  return time;
}

// Reads one option that takes a value; false where there is no such option.
bool read_option(FilmOptions& options, const std::string& option, const std::string& value) {
  if (option == "--out") {
    options.folder = value;
  } else if (option == "--size") {
    read_size(options.picture, option, value);
    options.is_sized = true;
  } else if (option == "--fps") {
    options.frames_per_second = frame_rate(option, value);
  } else if (option == "--from") {
    options.from = time_of(option, value);
  } else if (option == "--to") {
    options.to = time_of(option, value);
  } else if (option == "--quality") {
    options.picture.quality = quality(option, value);
  } else {
    return false;
  }
  return true;
}

}  // namespace

FilmOptions film_options(int argc, const char* const* argv) {
  FilmOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--white") {
      options.picture.white = true;
      continue;
    }
    const bool has_value = i + 1 < argc;
    if (!read_option(options, option, has_value ? argv[i + 1] : "")) {
      throw std::invalid_argument("unknown argument " + option +
                                  "; the arguments are --out DIR --size WxH --fps F --from S --to "
                                  "S --quality draft|film|report --white");
    }
    if (!has_value) throw std::invalid_argument(option + " needs a value");
    ++i;
  }
  if (options.folder.empty()) throw std::invalid_argument("--out DIR is required");
  return options;
}

}  // namespace render

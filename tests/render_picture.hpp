#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string>

#include "render/files/image.hpp"

namespace tests {

/// Reads an RGB picture with stb's decoder, which shares no code with our writer.
/// Throws std::runtime_error that names the path.
render::Image read_png(const std::filesystem::path& path);

/// Red, green and blue of the pixel in column x of row y from the top.
inline const std::uint8_t* pixel_at(const render::Image& image, int x, int y) {
  return image.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + x);
}

/// The share of pixels in which a channel differs by more than 8 of 255. Another processor's
/// rounding changes far less, and a body that is missing changes more. 1 if the sizes differ.
double share_that_differs(const render::Image& a, const render::Image& b);

/// A new empty folder, removed at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Whether charts can be drawn.
bool has_gnuplot();

/// The bytes of a file.
std::string content(const std::filesystem::path& path);

/// How many entries a folder has.
int files_in(const std::filesystem::path& folder);

/// What `call` throws, or nothing.
template <typename Call>
std::string message_of(const Call& call) {
  try {
    call();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace tests

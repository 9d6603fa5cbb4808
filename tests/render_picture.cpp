#include "render_picture.hpp"

#include <stb_image.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

namespace tests {

render::Image read_png(const std::filesystem::path& path) {
  constexpr int channels = 3;
  render::Image image;
  int channels_in_file = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels_in_file, channels),
      stbi_image_free);
  if (!pixels) throw std::runtime_error("cannot read " + path.string());
  const auto bytes = std::ptrdiff_t{channels} * image.width * image.height;
  image.rgb.assign(pixels.get(), pixels.get() + bytes);
  return image;
}

double share_that_differs(const render::Image& a, const render::Image& b) {
  if (a.width != b.width || a.height != b.height) return 1.0;
  constexpr int threshold = 8;
  int count = 0;
  for (std::size_t pixel = 0; pixel + 2 < a.rgb.size(); pixel += 3) {
    int largest = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) {
      largest = std::max(largest, std::abs(int{a.rgb[i]} - int{b.rgb[i]}));
    }
    if (largest > threshold) ++count;
  }
  return static_cast<double>(count) / (static_cast<double>(a.width) * a.height);
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tumble_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

bool has_gnuplot() { return std::system("command -v gnuplot > /dev/null") == 0; }

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int files_in(const std::filesystem::path& folder) {
  return static_cast<int>(std::distance(std::filesystem::directory_iterator(folder),
                                        std::filesystem::directory_iterator()));
}

}  // namespace tests

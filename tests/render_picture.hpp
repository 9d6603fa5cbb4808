#pragma once

#include <filesystem>

#include "render/files/image.hpp"

namespace tests {

/// Reads an RGB picture with stb's decoder, which shares no code with our writer.
/// Throws std::runtime_error that names the path.
render::Image read_png(const std::filesystem::path& path);

/// The share of pixels of which a channel differs by more than 8 of 255: no less than a body's
/// going missing, and far more than another processor's rounding. All of them where sizes differ.
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

}  // namespace tests

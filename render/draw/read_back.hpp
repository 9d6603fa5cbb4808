#pragma once

#include <cstdint>
#include <vector>

#include "render/draw/gl_objects.hpp"
#include "render/files/image.hpp"

namespace render {

/// Reads pictures from a canvas; keeps its memory from one to the next.
class Reader {
 public:
  /// The canvas' picture; each pixel is the mean of samples x samples, samples being 1 or 2.
  Image picture(const Canvas& canvas, int width, int height, int samples);

  /// Adds the canvas' picture, one sample a pixel, to a sum in linear light.
  void add(const Canvas& canvas, int width, int height);

  /// The mean of what was added, and starts anew.
  Image mean(int width, int height);

 private:
  const std::uint8_t* read(const Canvas& canvas, int width, int first, int last);

  std::vector<std::uint8_t> rgba_;
  std::vector<std::uint32_t> sums_;
  std::uint32_t count_ = 0;
};

}  // namespace render

// stb's PNG writer as it comes: its own compressor at level 8, the filter chosen row by row. The
// kit's writer hooks in another compressor, so this file holds a second copy, static and unhooked.
#include "render_yardstick.hpp"

#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace {

void add_size(void* total, void* /*data*/, int size) {
  *static_cast<std::size_t*>(total) += static_cast<std::size_t>(size);
}

}  // namespace

namespace tests {

std::size_t yardstick_png_size(const render::Image& image) {
  std::size_t total = 0;
  stbi_write_png_to_func(add_size, &total, image.width, image.height, 3, image.rgb.data(), 0);
  return total;
}

}  // namespace tests

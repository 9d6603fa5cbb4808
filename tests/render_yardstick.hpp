#pragma once

#include <cstddef>

#include "render/files/image.hpp"

namespace tests {

/// Bytes of the picture as a PNG by stb at its default settings, packed in memory: work whose time
/// depends on the processor, the compiler and the picture, and on nothing that the kit changes.
std::size_t yardstick_png_size(const render::Image& image);

}  // namespace tests

// PNG by stb, with two settings: rows are packed by ISA-L, some eight times faster than by zlib at
// its fastest and no larger, and the row filter is "Sub" (each byte minus its left neighbour's),
// which makes flat colour, most of these pictures, zeros.
#define STBI_WRITE_NO_STDIO
#include <isa-l/igzip_lib.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/files/atomic_file.hpp"
#include "render/files/image.hpp"

/// stb's hook: a zlib stream that stb frees, or nullptr. `quality` is stb's and of no use here.
unsigned char* render_packed_rows(unsigned char* rows, int size, int* packed_size, int quality);

unsigned char* render_packed_rows(unsigned char* rows, int size, int* packed_size,
                                  int /*quality*/) {
  std::vector<std::uint8_t> work(ISAL_DEF_LVL1_DEFAULT);
  const auto bytes = static_cast<std::uint32_t>(size);
  // What cannot be packed is stored, in blocks with some bytes of header each.
  const std::uint32_t room = bytes + bytes / 512 + 1024;
  auto* packed = static_cast<unsigned char*>(std::malloc(room));
  if (packed == nullptr) return nullptr;
  isal_zstream stream{};
  isal_deflate_init(&stream);
  stream.level = 1;
  stream.level_buf = work.data();
  stream.level_buf_size = static_cast<std::uint32_t>(work.size());
  stream.gzip_flag = IGZIP_ZLIB;
  stream.end_of_stream = 1;
  stream.next_in = rows;
  stream.avail_in = bytes;
  stream.next_out = packed;
  stream.avail_out = room;
  if (isal_deflate(&stream) != COMP_OK || stream.internal_state.state != ZSTATE_END) {
    std::free(packed);
    return nullptr;
  }
  *packed_size = static_cast<int>(stream.total_out);
  return packed;
}

namespace render {
namespace {

void append(void* png, void* data, int size) {
  static_cast<std::string*>(png)->append(static_cast<const char*>(data),
                                         static_cast<std::size_t>(size));
}

std::string refusal(const Image& image, const std::filesystem::path& path) {
  return "cannot write " + path.string() + ": a picture of " + std::to_string(image.width) + " x " +
         std::to_string(image.height) + " pixels in " + std::to_string(image.rgb.size()) + " bytes";
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  constexpr int longest_side = 16384;
  const std::size_t bytes = 3 * static_cast<std::size_t>(std::max(image.width, 0)) *
                            static_cast<std::size_t>(std::max(image.height, 0));
  const bool is_picture = bytes > 0 && image.width <= longest_side && image.height <= longest_side;
  if (!is_picture || image.rgb.size() != bytes) throw std::runtime_error(refusal(image, path));

  stbi_write_force_png_filter = 1;
  std::string png;
  if (stbi_write_png_to_func(append, &png, image.width, image.height, 3, image.rgb.data(), 0) ==
      0) {
    throw std::runtime_error(refusal(image, path) + " (no memory)");
  }
  write_file_atomically(path, png);
}

}  // namespace render

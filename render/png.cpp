// A PNG writer that uses all cores: the rows are filtered and deflated in strips, whose raw deflate
// streams join into one zlib stream (each but the last ends at a byte with Z_FULL_FLUSH). The
// number of strips is fixed, so the bytes do not depend on the number of cores.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/atomic_file.hpp"
#include "render/image.hpp"
#include "render/parallel.hpp"

namespace render {
namespace {

constexpr int strips = 8;

struct Strip {
  std::string deflated;
  uLong checksum = 0;
  z_off_t length = 0;  // before deflation
};

// Filter "Sub" (each byte minus its left neighbour's): one pass that vectorises, and flat colour,
// which is most of these pictures, becomes zeros.
std::vector<Bytef> filtered_rows(const Image& image, int first, int last) {
  const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
  std::vector<Bytef> bytes(static_cast<std::size_t>(last - first) * (stride + 1));
  Bytef* out = bytes.data();
  for (int row = first; row < last; ++row) {
    const std::uint8_t* in = image.rgb.data() + static_cast<std::size_t>(row) * stride;
    *out++ = 1;
    std::copy(in, in + 3, out);
    for (std::size_t i = 3; i < stride; ++i) out[i] = static_cast<Bytef>(in[i] - in[i - 3]);
    out += stride;
  }
  return bytes;
}

std::string deflated(std::vector<Bytef>& bytes, bool is_last) {
  constexpr int fastest = 1;
  constexpr int raw_window_bits = -15;  // negative: no zlib header, as strips share one
  constexpr int most_memory = 9;
  z_stream stream{};
  if (deflateInit2(&stream, fastest, Z_DEFLATED, raw_window_bits, most_memory,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  constexpr uLong flush_marker = 16;
  std::string out(deflateBound(&stream, static_cast<uLong>(bytes.size())) + flush_marker, '\0');
  stream.next_in = bytes.data();
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, is_last ? Z_FINISH : Z_FULL_FLUSH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

void append_word(std::string& bytes, uLong word) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(word >> shift & 0xFFU);
}

void append_chunk(std::string& png, const std::string& name_and_data) {
  append_word(png, static_cast<uLong>(name_and_data.size()) - 4);
  png += name_and_data;
  append_word(png, crc32(0, reinterpret_cast<const Bytef*>(name_and_data.data()),
                         static_cast<uInt>(name_and_data.size())));
}

std::string zlib_stream(const Image& image) {
  std::array<Strip, strips> parts;
  for_each_in_parallel(strips, [&](int i) {
    const int first = image.height * i / strips;
    const int last = image.height * (i + 1) / strips;
    std::vector<Bytef> bytes = filtered_rows(image, first, last);
    Strip& strip = parts[static_cast<std::size_t>(i)];
    strip.length = static_cast<z_off_t>(bytes.size());
    strip.checksum = adler32(1, bytes.data(), static_cast<uInt>(bytes.size()));
    strip.deflated = deflated(bytes, i == strips - 1);
  });

  std::string stream = "\x78\x01";
  uLong checksum = 1;
  for (const Strip& strip : parts) {
    stream += strip.deflated;
    checksum = adler32_combine(checksum, strip.checksum, strip.length);
  }
  append_word(stream, checksum);
  return stream;
}

std::string encoded(const Image& image) {
  std::string header = "IHDR";
  append_word(header, static_cast<uLong>(image.width));
  append_word(header, static_cast<uLong>(image.height));
  header += {8, 2, 0, 0, 0};  // 8 bits a channel, RGB, deflate, row filters, not interlaced

  std::string png = "\x89PNG\r\n\x1A\n";
  append_chunk(png, header);
  append_chunk(png, "IDAT" + zlib_stream(image));
  append_chunk(png, "IEND");
  return png;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  constexpr int longest_side = 16384;
  const std::size_t bytes = 3 * static_cast<std::size_t>(std::max(image.width, 0)) *
                            static_cast<std::size_t>(std::max(image.height, 0));
  if (bytes == 0 || image.width > longest_side || image.height > longest_side ||
      image.rgb.size() != bytes) {
    throw std::runtime_error("cannot write " + path.string() + ": a picture of " +
                             std::to_string(image.width) + " x " + std::to_string(image.height) +
                             " pixels in " + std::to_string(image.rgb.size()) + " bytes");
  }
  write_file_atomically(path, encoded(image));
}

}  // namespace render

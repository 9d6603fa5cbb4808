#include <cstddef>

#include "render/text/typeface.hpp"

namespace render {
namespace {

// Bytes that follow a first byte, or -1 where it cannot be one.
int followers(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  if (first >= 0xF0 && first < 0xF5) return 3;
  return -1;
}

}  // namespace

std::u32string characters_of(std::string_view utf8) {
  constexpr char32_t replacement = U'\uFFFD';
  std::u32string characters;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto first = static_cast<unsigned char>(utf8[i]);
    int left = followers(first);
    // A first byte keeps the bits below its leading ones and their closing zero.
    char32_t value = left > 0 ? first & (0x3FU >> static_cast<unsigned>(left)) : first;
    while (left > 0 && i + 1 < utf8.size() &&
           (static_cast<unsigned char>(utf8[i + 1]) & 0xC0U) == 0x80U) {
      value = value << 6U | (static_cast<unsigned char>(utf8[++i]) & 0x3FU);
      --left;
    }
    characters += left == 0 ? value : replacement;
  }
  return characters;
}

}  // namespace render

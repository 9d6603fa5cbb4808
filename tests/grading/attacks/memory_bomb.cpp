#include <cstddef>

static void attack() {
  for (;;) {
    auto* volatile memory = new char[std::size_t{64} << 20U];
    memory[0] = 'x';
  }
}

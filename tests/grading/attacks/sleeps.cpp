#include <unistd.h>

static void attack() {
  for (;;) pause();
}

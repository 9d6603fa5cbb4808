#include <unistd.h>

static void attack() {
  close(4);
  for (;;) pause();
}

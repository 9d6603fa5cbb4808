#include <fcntl.h>
#include <unistd.h>

// Lives on after the test, if it can.
static void attack() {
  if (fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  for (int i = 0; i < 300; ++i) {
    sleep(1);
    open("@NEIGHBOUR@/daemon.txt", O_WRONLY | O_CREAT, 0644);
  }
}

#include <unistd.h>

#include <csignal>
#include <initializer_list>

static void leave(int) { _exit(0); }

static void attack() {
  for (int number : {SIGABRT, SIGSEGV, SIGTERM, SIGXCPU}) std::signal(number, leave);
  std::raise(SIGSEGV);
}

#include <ucontext.h>
#include <unistd.h>

static ucontext_t elsewhere;
static char stack[65536];

static void leave() { _exit(0); }

static void attack() {
  getcontext(&elsewhere);
  elsewhere.uc_stack = {stack, 0, sizeof stack};
  elsewhere.uc_link = nullptr;
  makecontext(&elsewhere, leave, 0);
  setcontext(&elsewhere);
}

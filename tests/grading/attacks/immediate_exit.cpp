#include <unistd.h>

static void attack() { _exit(0); }

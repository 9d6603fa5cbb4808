#include <unistd.h>

static void attack() { execl("/usr/bin/true", "true", nullptr); }

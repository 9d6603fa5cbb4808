#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <initializer_list>

// Whoever can write to one of these owns the next run.
static void attack() {
  for (const char* path : {"/proc/self/exe", "/driver", "/usr/bin/true", "@PROGRAM@",
                           "/kit/driver.o", "/etc/ld.so.preload"}) {
    const int file = open(path, O_WRONLY | O_CREAT, 0755);
    if (file >= 0 && write(file, "#!/bin/sh\n", 10) == 10) std::exit(0);
    if (unlink(path) == 0) std::exit(0);
  }
}

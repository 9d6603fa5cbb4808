#include <fcntl.h>
#include <sys/ptrace.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

static void attack() {
  // Process 1 is the box's own, with no more rights than this one.
  for (int process = 2; process < 100; ++process) {
    if (process == getpid()) continue;
    const std::string memory = "/proc/" + std::to_string(process) + "/mem";
    if (open(memory.c_str(), O_RDWR) >= 0) std::exit(0);
    if (ptrace(PTRACE_ATTACH, process, nullptr, nullptr) == 0) std::exit(0);
  }
}

#pragma once

#include <sys/types.h>

#include <string>

namespace grading {

/// Which process of a chain of parents and first children is the innermost, in the box the driver,
/// and what it has computed so far, where it sleeps. Empty where it computes, or waits for a
/// processor or for memory, as it may on a loaded machine. See proc(5), stat.
std::string sleep_of(pid_t process);

}  // namespace grading

#pragma once

#include <string>

/// What a case tells on stderr, in the form of a Trial, where the answer ends it before its end.
namespace tests {

/// From now on a crash, an early exit and SIGXCPU have this process tell what it asked the answer:
/// the trial under way, or else the step and the function of the contract that runs. A crash then
/// goes on as it would; after SIGXCPU the process ends.
void tell_when_ended(const std::string& step);

/// The step that is told from now on, where one process runs case after case.
void tell_of_step(const std::string& step);

/// Loads what a stack is read with, so that no process must while it crashes.
void prepare_last_words();

/// Whether this program is compiled with the sanitizers, which take more memory than there is.
bool has_sanitizers();

}  // namespace tests

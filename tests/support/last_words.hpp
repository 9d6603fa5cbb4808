#pragma once

#include <string>

/// The text that a case writes to stderr, in the form of a Trial, if the answer ends it too early.
namespace tests {

/// From now on, if this process crashes, exits early or gets SIGXCPU, it tells what it asked the
/// answer: the trial under way, or otherwise the step and the function of the contract that runs.
/// After that a crash goes on as it would; after SIGXCPU the process ends.
void tell_when_ended(const std::string& step);

/// Sets the step that is told from now on, if one process runs case after case.
void tell_of_step(const std::string& step);

/// Loads what reads a stack, so that no process must load it while it crashes.
void prepare_last_words();

/// Returns whether this program has the sanitizers, which need more memory than there is.
bool has_sanitizers();

}  // namespace tests

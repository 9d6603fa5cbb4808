// The main of a lab's tests, which the linker puts before Catch2's (--wrap=main). It is Catch2's,
// but for
//   PROGRAM --each CASES JOBS [Catch2's arguments]
// which runs the cases of the file CASES (lines of "step|name") in child processes, so a crash or a
// hang ends one case only. JOBS is how many children there are at a time, each with a case of its
// own, or "together": then one child runs case after case, which spares a fork for each, and a case
// that does not pass there is run once more, alone. For each case, as it ends, there is a record on
// stdout:
//   case LINE END VALUE SECONDS BYTES\n, then BYTES of what the case printed, then \n
// LINE counts from 0; END VALUE is "exit code", "signal number", "timeout 0", "waits 0" (it slept)
// or "skipped 0"; SECONDS are of computing, so a busy machine makes no case run out of time. A case
// that crashes, leaves or runs out of time first tells what it asked the answer, see
// last_words.hpp.
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "case_child.hpp"
#include "last_words.hpp"

namespace {

using tests::Case;
using tests::CaseChild;

constexpr const char* usual_patience = "6";  // [s] of computing; a right answer takes a tenth of it
constexpr double no_patience = 0.5;          // [s], once a case has run out of time
constexpr int hopeless = 3;  // cases of a step that ran out of time: the rest is not run

std::vector<Case> read_cases(const std::string& path) {
  std::ifstream file(path);
  std::vector<Case> cases;
  for (std::string line; std::getline(file, line);) {
    const std::size_t bar = line.find('|');
    if (bar != std::string::npos) {
      cases.push_back({cases.size(), line.substr(0, bar), line.substr(bar + 1)});
    }
  }
  return cases;
}

class Runner {
 public:
  Runner(const std::vector<Case>& cases, std::vector<std::string> arguments, double patience)
      : waiting_(cases), arguments_(std::move(arguments)), patience_(patience) {}

  /// Each case in a child of its own.
  void run_apart(std::size_t jobs) {
    while (!waiting_.empty() || !running_.empty()) {
      while (running_.size() < jobs && start(1)) {
      }
      wait_a_little();
      std::erase_if(running_, [this](CaseChild& child) { return has_ended(child); });
    }
  }

  /// As many cases in a child as pass there; after one that fails alone, the next is alone, too.
  void run_together() {
    bool alone = false;
    while (start(alone ? 1 : waiting_.size())) {
      CaseChild& child = running_.front();
      while (!has_ended(child)) wait_a_little();
      alone = alone ? !passed_alone_ : !waiting_.empty();
      running_.clear();
    }
  }

 private:
  /// Starts a child for the first of those that wait and are not hopeless; false where none is.
  bool start(std::size_t most) {
    std::erase_if(waiting_, [this](const Case& one) {
      const bool skipped = out_of_time_[one.step] >= hopeless;
      if (skipped) tests::report(one.line, "skipped 0", 0.0, "");
      return skipped;
    });
    if (waiting_.empty()) return false;
    const auto end =
        waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(most, waiting_.size()));
    running_.emplace_back(std::vector<Case>(waiting_.begin(), end), arguments_);
    if (most == 1) waiting_.erase(waiting_.begin());
    return true;
  }

  /// Until a child ends, or a moment passes.
  static void wait_a_little() {
    sigset_t child_ended;
    sigemptyset(&child_ended);
    sigaddset(&child_ended, SIGCHLD);
    const timespec moment{0, 50'000'000};
    sigtimedwait(&child_ended, nullptr, &moment);
  }

  /// Reports a child that has ended; tells one to end that must.
  bool has_ended(CaseChild& child) {
    if (const auto end = child.ended()) {
      if (child.is_alone()) {
        passed_alone_ = end->passed;
        tests::report(child.current().line, end->words, end->seconds, end->output);
        return true;
      }
      std::erase_if(waiting_, [&](const Case& one) { return child.has_reported(one.line); });
      if (waiting_.empty()) return true;
      // What did not pass is the first to be run alone, unless it took all the time there is.
      const auto culprit = std::find_if(waiting_.begin(), waiting_.end(), [&](const Case& one) {
        return one.line == child.current().line;
      });
      if (culprit == waiting_.end()) return true;
      std::rotate(waiting_.begin(), culprit, culprit + 1);
      if (child.was_told_to_end()) {
        tests::report(waiting_.front().line, end->words, end->seconds, end->output);
        waiting_.erase(waiting_.begin());
      }
      return true;
    }
    if (!child.was_told_to_end()) {
      const bool is_late =
          child.seconds_computed() > (anything_out_of_time_ ? no_patience : patience_);
      if (!is_late && !child.has_slept()) return false;
      ++out_of_time_[child.current().step];
      anything_out_of_time_ = true;
      child.tell_to_end(is_late ? "timeout 0" : "waits 0");
    } else {
      child.kill_if_it_stays();
    }
    return false;
  }

  std::vector<Case> waiting_;
  std::vector<std::string> arguments_;
  double patience_;
  std::vector<CaseChild> running_;
  std::map<std::string, int> out_of_time_;  ///< cases, by their step
  bool anything_out_of_time_ = false;
  bool passed_alone_ = false;  ///< the last case that had a child for itself
};

}  // namespace

/// What the program starts with.
extern "C" int __wrap_main(int argc, char** argv) {  // NOLINT: the linker's name
  std::vector<std::string> arguments(argv, argv + argc);
  if (argc < 4 || arguments[1] != "--each") return tests::run_catch(std::move(arguments));
  const std::vector<Case> cases = read_cases(arguments[2]);
  const bool together = arguments[3] == "together";
  const std::size_t jobs = std::strtoul(arguments[3].c_str(), nullptr, 10);
  const double patience = std::strtod(argc > 4 ? argv[4] : usual_patience, nullptr);
  if (cases.empty() || (jobs == 0 && !together) || !(patience > 0.0)) {
    std::cerr << "usage: PROGRAM --each CASES JOBS [SECONDS], with a case in CASES; JOBS is a "
                 "number from 1, or together; SECONDS of computing end a case, "
              << usual_patience << " if not given\n";
    return EXIT_FAILURE;
  }
  tests::prepare_last_words();
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child_ended, nullptr);
  arguments.resize(1);
  Runner runner(cases, arguments, patience);
  together ? runner.run_together() : runner.run_apart(jobs);
  return EXIT_SUCCESS;
}

#pragma once

#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tests {

struct Case {
  std::size_t line;  ///< in the file of cases, from 0
  std::string step;
  std::string name;
};

/// Runs Catch2's main.
int run_catch(std::vector<std::string> arguments);

/// Writes a record to stdout, see run_each.cpp.
void report(std::size_t line, const std::string& end, double seconds, const std::string& output);

/// A process that runs one case, or several one after the other. If there are several, the process
/// itself reports a case that passes, and the first case that does not pass ends it.
class CaseChild {
 public:
  /// arguments  of Catch2, beginning with the program's name
  CaseChild(std::vector<Case> cases, const std::vector<std::string>& arguments);

  struct End {
    std::string words;  ///< END VALUE of a record
    double seconds;     ///< the computing time of the last case
    std::string output;
    bool passed;
  };
  /// Returns how the process ended, or nothing while it runs.
  std::optional<End> ended();

  [[nodiscard]] bool is_alone() const { return cases_.size() == 1; }
  /// Returns the case that runs, or that ran last.
  [[nodiscard]] const Case& current() const;
  [[nodiscard]] bool has_reported(std::size_t line) const;

  /// Returns the time that the current case has computed [s].
  [[nodiscard]] double seconds_computed() const;
  /// Returns whether it has slept so long that it must wait for something that never comes.
  bool has_slept();
  /// Makes the process say what it was doing, and end. Its record then contains `words`.
  void tell_to_end(const std::string& words);
  [[nodiscard]] bool was_told_to_end() const { return !must_end_.empty(); }
  void kill_if_it_stays() const;

 private:
  struct Shared;  ///< shared with the child
  class Relay;
  [[noreturn]] void run(std::vector<std::string> arguments);

  std::vector<Case> cases_;
  std::shared_ptr<Shared> shared_;
  int output_;
  pid_t pid_;
  double asleep_since_ = 0.0;  ///< 0 while it runs
  std::string must_end_;
  double told_ = 0.0;  ///< the time at which it was told to end
};

}  // namespace tests

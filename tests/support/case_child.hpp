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

/// Catch2's main.
int run_catch(std::vector<std::string> arguments);

/// A record on stdout, see run_each.cpp.
void report(std::size_t line, const std::string& end, double seconds, const std::string& output);

/// A process that runs one case, or several one after the other. In the latter a case that passes
/// is reported by the process itself, and the first that does not ends it.
class CaseChild {
 public:
  /// arguments  of Catch2, the program's name first
  CaseChild(std::vector<Case> cases, const std::vector<std::string>& arguments);

  struct End {
    std::string words;  ///< END VALUE of a record
    double seconds;     ///< that the last case computed
    std::string output;
    bool passed;
  };
  /// How the process ended; nothing while it runs.
  std::optional<End> ended();

  [[nodiscard]] bool is_alone() const { return cases_.size() == 1; }
  /// The case that runs, or ran last.
  [[nodiscard]] const Case& current() const;
  [[nodiscard]] bool has_reported(std::size_t line) const;

  /// By the current case [s].
  [[nodiscard]] double seconds_computed() const;
  /// Whether it has slept for so long that it must wait for something that never comes.
  bool has_slept();
  /// It tells what it was about, and ends. `words` are told of it then.
  void tell_to_end(const std::string& words);
  [[nodiscard]] bool was_told_to_end() const { return !must_end_.empty(); }
  void kill_if_it_stays() const;

 private:
  struct Shared;  ///< with the child
  class Relay;
  [[noreturn]] void run(std::vector<std::string> arguments);

  std::vector<Case> cases_;
  std::shared_ptr<Shared> shared_;
  int output_;
  pid_t pid_;
  double asleep_since_ = 0.0;  ///< 0 while it runs
  std::string must_end_;
  double told_ = 0.0;  ///< when
};

}  // namespace tests

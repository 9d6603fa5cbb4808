// The main of a lab's tests, which the linker puts before Catch2's (--wrap=main). It is Catch2's,
// but for
//   PROGRAM --each CASES JOBS [Catch2's arguments]
// which runs each case of the file CASES (lines of "step|name") in a child process: a fork costs a
// millisecond, where a start of the program costs ten, and a crash or a hang still ends one case
// only. For each case, as it ends, there is a record on stdout:
//   case LINE END VALUE SECONDS BYTES\n, then BYTES of what the case printed, then \n
// LINE counts from 0; END VALUE is "exit code", "signal number", "timeout 0", "waits 0" (it slept)
// or "skipped 0"; SECONDS are of computing, so a busy machine makes no case run out of time. A case
// that crashes, leaves or runs out of time first tells what it asked the answer, see
// last_words.hpp.
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "last_words.hpp"

/// Catch2's main.
extern "C" int __real_main(int argc, char** argv);  // NOLINT: the linker's names

namespace {

constexpr double patience = 6.0;     // [s] of computing; a right answer takes a tenth of it
constexpr double no_patience = 0.5;  // [s], once a case has run out of time
constexpr double nap = 3.0;          // [s] asleep: there is nothing that a case could wait for
constexpr double last_words = 0.3;   // [s] for a case that must end to tell what it asked
constexpr int hopeless = 3;          // cases of a step that ran out of time: the rest is not run
constexpr rlim_t most_output = 16U << 20U;
constexpr rlim_t most_memory = 8ULL << 30U;

struct Case {
  std::string step;
  std::string name;
};

struct Child {
  std::size_t line;
  pid_t pid;
  int output;
  double asleep_since = 0.0;  ///< 0 while it runs
  std::string must_end = "";  ///< why it has been told to end: its record's END VALUE
  double told = 0.0;          ///< when
};

double seconds(clockid_t clock) {
  timespec now{};
  if (clock_gettime(clock, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_computed(pid_t pid) {
  clockid_t clock{};
  return clock_getcpuclockid(pid, &clock) == 0 ? seconds(clock) : 0.0;
}

bool sleeps(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t end_of_name = text.rfind(')');
  return end_of_name != std::string::npos && text.compare(end_of_name, 3, ") S") == 0;
}

int run_catch(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  return __real_main(static_cast<int>(arguments.size()), argv.data());
}

std::vector<Case> read_cases(const std::string& path) {
  std::ifstream file(path);
  std::vector<Case> cases;
  for (std::string line; std::getline(file, line);) {
    const std::size_t bar = line.find('|');
    if (bar != std::string::npos) cases.push_back({line.substr(0, bar), line.substr(bar + 1)});
  }
  return cases;
}

class Runner {
 public:
  Runner(std::vector<Case> cases, std::vector<std::string> arguments)
      : cases_(std::move(cases)), arguments_(std::move(arguments)) {}

  void run(std::size_t jobs) {
    std::size_t next = 0;
    while (next < cases_.size() || !running_.empty()) {
      while (next < cases_.size() && running_.size() < jobs) start(next++);
      wait_a_little();
      std::erase_if(running_, [this](Child& child) { return has_ended(child); });
    }
  }

 private:
  void start(std::size_t line) {
    if (out_of_time_[cases_[line].step] >= hopeless) {
      report(line, "skipped 0", 0.0, -1);
      return;
    }
    const int output = memfd_create("output", MFD_CLOEXEC);
    const pid_t pid = fork();
    if (pid == 0) run_case(cases_[line], output);
    if (pid < 0 || output < 0) {
      std::cerr << "no process for a case: " << std::strerror(errno) << '\n';
      std::exit(EXIT_FAILURE);
    }
    running_.push_back({line, pid, output});
  }

  [[noreturn]] void run_case(const Case& one, int output) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    const auto limit = [](auto what, rlim_t most) {
      const rlimit both{most, most};
      setrlimit(what, &both);
    };
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, most_output);
    if (!tests::has_sanitizers()) limit(RLIMIT_AS, most_memory);
    tests::tell_when_ended(one.step);
    std::vector<std::string> arguments = arguments_;
    arguments.insert(arguments.begin() + 1, one.name);
    std::exit(run_catch(std::move(arguments)));
  }

  /// Until a child ends, or a moment passes.
  static void wait_a_little() {
    sigset_t child_ended;
    sigemptyset(&child_ended);
    sigaddset(&child_ended, SIGCHLD);
    const timespec moment{0, 50'000'000};
    sigtimedwait(&child_ended, nullptr, &moment);
  }

  /// Reports a child that has ended or must end.
  bool has_ended(Child& child) {
    int status = 0;
    rusage used{};
    if (wait4(child.pid, &status, WNOHANG, &used) == child.pid) {
      kill(-child.pid, SIGKILL);  // what it may have left running
      std::string end = child.must_end;
      if (end.empty()) {
        end = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                  : "exit " + std::to_string(WEXITSTATUS(status));
      }
      const double computed =
          static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
          1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
      report(child.line, end, computed, child.output);
      return true;
    }
    if (child.must_end.empty()) {
      const double computed = seconds_computed(child.pid);
      const bool is_late = computed > (anything_out_of_time_ ? no_patience : patience);
      if (!is_late && !has_slept(child)) return false;
      child.must_end = is_late ? "timeout 0" : "waits 0";
      child.told = seconds(CLOCK_MONOTONIC);
      ++out_of_time_[cases_[child.line].step];
      anything_out_of_time_ = true;
      kill(child.pid, SIGXCPU);
    } else if (seconds(CLOCK_MONOTONIC) - child.told > last_words) {
      kill(-child.pid, SIGKILL);
    }
    return false;
  }

  static bool has_slept(Child& child) {
    const double now = seconds(CLOCK_MONOTONIC);
    if (!sleeps(child.pid))
      child.asleep_since = 0.0;
    else if (child.asleep_since == 0.0)
      child.asleep_since = now;
    return child.asleep_since > 0.0 && now - child.asleep_since > nap;
  }

  static void report(std::size_t line, const std::string& end, double computed, int output) {
    std::string text;
    if (output >= 0) {
      text.resize(static_cast<std::size_t>(lseek(output, 0, SEEK_END)));
      const ssize_t count = pread(output, text.data(), text.size(), 0);
      text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
      close(output);
    }
    std::cout << "case " << line << ' ' << end << ' ' << computed << ' ' << text.size() << '\n'
              << text << '\n'
              << std::flush;
  }

  std::vector<Case> cases_;
  std::vector<std::string> arguments_;
  std::vector<Child> running_;
  std::map<std::string, int> out_of_time_;  ///< cases, by their step
  bool anything_out_of_time_ = false;
};

}  // namespace

/// What the program starts with.
extern "C" int __wrap_main(int argc, char** argv) {  // NOLINT
  std::vector<std::string> arguments(argv, argv + argc);
  if (argc < 4 || arguments[1] != "--each") return run_catch(std::move(arguments));
  const std::vector<Case> cases = read_cases(arguments[2]);
  const std::size_t jobs = std::strtoul(arguments[3].c_str(), nullptr, 10);
  if (cases.empty() || jobs == 0) {
    std::cerr << "usage: PROGRAM --each CASES JOBS, with a case in CASES and a job at least\n";
    return EXIT_FAILURE;
  }
  tests::prepare_last_words();
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child_ended, nullptr);
  arguments.erase(arguments.begin() + 1, arguments.begin() + 4);
  Runner(cases, arguments).run(jobs);
  return EXIT_SUCCESS;
}

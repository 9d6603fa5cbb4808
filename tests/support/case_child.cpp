#include "case_child.hpp"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iostream>
#include <new>

#include "case_events.hpp"
#include "last_words.hpp"

/// Catch2's main.
extern "C" int __real_main(int argc, char** argv);  // NOLINT: the linker's name

namespace tests {
namespace {

constexpr double nap = 3.0;               // [s] asleep: there is nothing that a case could wait for
constexpr double last_words = 0.3;        // [s] for a case that must end to tell what it asked
constexpr std::size_t most_cases = 4096;  // of a child
constexpr rlim_t most_output = 16U << 20U;
constexpr rlim_t most_memory = 8ULL << 30U;
constexpr const char* all_passed = "All tests passed (";  // as Catch2 says it

double seconds(clockid_t clock) {
  timespec now{};
  if (clock_gettime(clock, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool sleeps(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t end_of_name = text.rfind(')');
  return end_of_name != std::string::npos && text.compare(end_of_name, 3, ") S") == 0;
}

std::string contents(int file) {
  std::string text(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), '\0');
  const ssize_t count = pread(file, text.data(), text.size(), 0);
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

std::string record(std::size_t line, const std::string& end, double seconds,
                   const std::string& output) {
  return "case " + std::to_string(line) + ' ' + end + ' ' + std::to_string(seconds) + ' ' +
         std::to_string(output.size()) + '\n' + output + '\n';
}

}  // namespace

int run_catch(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  return __real_main(static_cast<int>(arguments.size()), argv.data());
}

void report(std::size_t line, const std::string& end, double seconds, const std::string& output) {
  std::cout << record(line, end, seconds, output) << std::flush;
}

struct CaseChild::Shared {
  std::atomic<std::size_t> current{0};  ///< in cases_
  std::atomic<double> began{0.0};       ///< in seconds of the child's computing
  std::atomic<bool> reported[most_cases]{};
};

/// In a child that runs several cases: reports each that passes, and ends at one that does not.
class CaseChild::Relay : public CaseEvents {
 public:
  Relay(const std::vector<Case>& cases, Shared& shared, int output, int records)
      : cases_(cases), shared_(shared), output_(output), records_(records) {}

  void starts(const std::string& name) override {
    const auto one = std::find_if(cases_.begin(), cases_.end(),
                                  [&](const Case& other) { return other.name == name; });
    if (one == cases_.end()) _exit(EXIT_FAILURE);
    shared_.current = static_cast<std::size_t>(one - cases_.begin());
    shared_.began = seconds(CLOCK_PROCESS_CPUTIME_ID);
    tell_of_step(one->step);
  }

  void ends(std::size_t assertions) override {
    if (assertions == 0) _exit(EXIT_FAILURE);
    std::fflush(stdout);
    std::cout.flush();
    const std::string words = all_passed + std::to_string(assertions) + " assertions)\n";
    const std::size_t current = shared_.current;
    const std::string text =
        record(cases_[current].line, "exit 0", seconds(CLOCK_PROCESS_CPUTIME_ID) - shared_.began,
               contents(output_) + words);
    const bool kept =
        write(records_, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    if (!kept || ftruncate(output_, 0) != 0) _exit(EXIT_FAILURE);
    lseek(output_, 0, SEEK_SET);
    shared_.reported[current] = true;
  }

 private:
  const std::vector<Case>& cases_;
  Shared& shared_;
  int output_;
  int records_;
};

CaseChild::CaseChild(std::vector<Case> cases, const std::vector<std::string>& arguments)
    : cases_(std::move(cases)), output_(memfd_create("output", MFD_CLOEXEC)) {
  cases_.resize(std::min(cases_.size(), most_cases), cases_.front());
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  shared_ = {new (memory) Shared, [](Shared* shared) { munmap(shared, sizeof(Shared)); }};
  pid_ = fork();
  if (pid_ == 0) run(arguments);
  if (pid_ < 0 || output_ < 0) {
    std::cerr << "no process for a case: " << std::strerror(errno) << '\n';
    std::exit(EXIT_FAILURE);
  }
}

void CaseChild::run(std::vector<std::string> arguments) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int records = dup(STDOUT_FILENO);
  dup2(output_, STDOUT_FILENO);
  dup2(output_, STDERR_FILENO);
  const auto limit = [](auto what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
  };
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, most_output);
  if (!has_sanitizers()) limit(RLIMIT_AS, most_memory);
  tell_when_ended(cases_.front().step);

  Relay relay(cases_, *shared_, output_, records);
  if (!is_alone()) CaseEvents::tell(&relay);
  std::string names;
  for (const Case& one : cases_) names += (names.empty() ? "" : ",") + one.name;
  arguments.insert(arguments.begin() + 1, names);
  std::exit(run_catch(std::move(arguments)));
}

const Case& CaseChild::current() const { return cases_[shared_->current]; }

bool CaseChild::has_reported(std::size_t line) const {
  for (std::size_t i = 0; i < cases_.size(); ++i) {
    if (cases_[i].line == line) return shared_->reported[i];
  }
  return false;
}

std::optional<CaseChild::End> CaseChild::ended() {
  int status = 0;
  rusage used{};
  if (wait4(pid_, &status, WNOHANG, &used) != pid_) return std::nullopt;
  kill(-pid_, SIGKILL);  // what it may have left running
  std::string words = must_end_;
  if (words.empty()) {
    words = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                : "exit " + std::to_string(WEXITSTATUS(status));
  }
  const double computed =
      static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec) - shared_->began;
  std::string output = contents(output_);
  close(output_);
  const bool passed = words == "exit 0" && output.find(all_passed) != std::string::npos;
  return End{words, computed, std::move(output), passed};
}

double CaseChild::seconds_computed() const {
  clockid_t clock{};
  return clock_getcpuclockid(pid_, &clock) == 0 ? seconds(clock) - shared_->began : 0.0;
}

bool CaseChild::has_slept() {
  const double now = seconds(CLOCK_MONOTONIC);
  if (!sleeps(pid_))
    asleep_since_ = 0.0;
  else if (asleep_since_ == 0.0)
    asleep_since_ = now;
  return asleep_since_ > 0.0 && now - asleep_since_ > nap;
}

void CaseChild::tell_to_end(const std::string& words) {
  must_end_ = words;
  told_ = seconds(CLOCK_MONOTONIC);
  kill(pid_, SIGXCPU);
}

void CaseChild::kill_if_it_stays() const {
  if (seconds(CLOCK_MONOTONIC) - told_ > last_words) kill(-pid_, SIGKILL);
}

}  // namespace tests

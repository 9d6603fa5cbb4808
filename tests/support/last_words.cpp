#include "last_words.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "under_way.hpp"

/// There under the sanitizers only.
extern "C" void __sanitizer_set_death_callback(void (*)()) __attribute__((weak));  // NOLINT

namespace tests {
namespace {

std::string step_under_way;

/// The function of the contract that runs, its last name alone, or "" where none does.
std::string called_function() {
  std::array<void*, 256> frames{};
  const int count = backtrace(frames.data(), static_cast<int>(frames.size()));
  Dl_info program{};
  dladdr(reinterpret_cast<void*>(&called_function), &program);
  for (int i = count - 1; i >= 0; --i) {  // the outermost: what the test called
    Dl_info place{};
    // A call that never returns may be a function's last instruction: so one byte back.
    const char* const inside = static_cast<char*>(frames[static_cast<std::size_t>(i)]) - 1;
    if (dladdr(inside, &place) == 0 || place.dli_sname == nullptr ||
        place.dli_fbase != program.dli_fbase) {
      continue;
    }
    char* const whole = abi::__cxa_demangle(place.dli_sname, nullptr, nullptr, nullptr);
    std::string name = whole == nullptr ? "" : whole;
    std::free(whole);
    name.resize(std::min(name.find('('), name.size()));
    if (name.starts_with("lab::")) return name.substr(name.rfind(':') + 1);
  }
  return "";
}

/// What was asked: the trial under way, or else the function that runs.
void tell() {
  if (tests::UnderWay::tell_of_newest()) return;
  const std::string function = called_function();
  if (!function.empty()) std::cerr << "| step    " << step_under_way << ' ' << function << '\n';
}

void tell_and_leave(int /*signal*/) {
  tell();
  _exit(EXIT_FAILURE);
}

/// After Catch2's handler, which tells the signal and raises it again.
void tell_and_crash(int number) {
  tell();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

bool has_sanitizers() { return __sanitizer_set_death_callback != nullptr; }

void prepare_last_words() { called_function(); }

void tell_of_step(const std::string& step) { step_under_way = step; }

void tell_when_ended(const std::string& step) {
  tell_of_step(step);
  std::atexit(tell);
  std::signal(SIGXCPU, tell_and_leave);
  if (has_sanitizers()) {  // they tell of crashes
    __sanitizer_set_death_callback(tell);
    return;
  }
  static char stack[1U << 18U];  // of its own: the crash may be an overflow of the other
  const stack_t own{stack, 0, sizeof stack};
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_handler = tell_and_crash;
  action.sa_flags = SA_ONSTACK;
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    sigaction(number, &action, nullptr);
  }
}

}  // namespace tests

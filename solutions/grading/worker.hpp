#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "proxy.hpp"

namespace grading {

/// The process that holds a student's object, one in a life of this one.
class Worker {
 public:
  static Worker& the();

  Answer ask(std::uint32_t function, const std::string& arguments, std::uint32_t answer_limit);
  void kill();

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

 private:
  Worker() = default;
  ~Worker() { kill(); }

  void start();
  void send(std::string_view bytes);
  /// More bytes, behind those of `to`.
  void receive(std::string& to);
  /// Until the descriptor is ready; ends the case where the worker has had its time, or sleeps:
  /// it has nothing to wait for.
  void wait(int descriptor, short event);
  /// Ends the case in the word for how the worker ended, or is ended.
  [[noreturn]] void report_death();

  pid_t process_ = 0;
  int requests_ = -1;
  int answers_ = -1;
  int status_ = -1;
  int patience_ = 10;  // computing [s]
  std::chrono::steady_clock::duration waited_{0};
};

}  // namespace grading

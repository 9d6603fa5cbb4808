#pragma once

#include <chrono>
#include <string>

namespace render {

/// A line on stderr, as in "frame 3 of 101". A terminal rewrites it. A log gets one at each tenth
/// and whenever five seconds have passed.
class Progress {
 public:
  Progress(std::string what, int total);

  void show(int done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  int total_;
  bool is_terminal_;
  int last_tenth_ = -1;
  Clock::time_point last_ = Clock::now();
};

}  // namespace render

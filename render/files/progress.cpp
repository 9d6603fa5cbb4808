#include "render/files/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace render {

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(std::max(total, 1)),
      is_terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(int done) {
  constexpr std::chrono::seconds longest_silence{5};
  const int tenth = 10 * done / total_;
  const Clock::time_point now = Clock::now();
  if (!is_terminal_ && tenth == last_tenth_ && now - last_ < longest_silence) return;
  last_tenth_ = tenth;
  last_ = now;
  std::cerr << (is_terminal_ ? "\r" : "") << what_ << ' ' << done << " of " << total_
            << (is_terminal_ && done < total_ ? "" : "\n") << std::flush;
}

}  // namespace render

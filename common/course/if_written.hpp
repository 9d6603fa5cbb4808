#pragma once

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "common/course/not_implemented.hpp"

namespace common {

inline void note_once(std::vector<std::string>& notes, const std::string& note) {
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

/// Returns the result of `make`. If `make` needs a step that is not written yet, or if it throws,
/// returns nothing and adds the step, or the exception's words, to `missing` once.
template <typename Make>
auto if_written(std::vector<std::string>& missing, const Make& make)
    -> std::optional<decltype(make())> {
  try {
    return make();
  } catch (const NotImplemented& error) {
    note_once(missing, error.step_and_function());
  } catch (const std::exception& error) {
    note_once(missing, std::string("an exception: ") + error.what());
  }
  return std::nullopt;
}

}  // namespace common

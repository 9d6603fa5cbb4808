#pragma once

#include <stdexcept>
#include <string>

namespace common {

/// The exception of a stub, so that a test can tell "not written yet" from "wrong".
class NotImplemented : public std::logic_error {
 public:
  /// step_and_function  the handout's step and the function, as in "1.2 point_velocity"
  explicit NotImplemented(const std::string& step_and_function)
      : std::logic_error(step_and_function + " is not written yet"), what_(step_and_function) {}

  /// Returns the step and the function alone, as in "1.2 point_velocity".
  [[nodiscard]] const std::string& step_and_function() const { return what_; }

 private:
  std::string what_;
};

}  // namespace common

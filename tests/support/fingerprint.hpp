#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "trial.hpp"
#include "values.hpp"

namespace tests {

/// A misconception, given by its effect on a function for every input.
template <typename Input, typename Value>
struct Mistake {
  std::string story;
  std::function<bool(const Input&, const Value& got)> fits;
};

/// Returns whether two values are equal except for rounding. Zero must be exact, and a value that
/// is not finite is near to nothing.
template <typename Value>
bool near(const Value& got, const Value& wanted, double relative = 1e-9) {
  return is_finite(got) && difference(got, wanted) <= relative * length(wanted);
}

/// Returns the mistake that returns `value` of each input.
template <typename Input, typename Value, typename Function>
Mistake<Input, Value> returns(const std::string& story, const Function& value) {
  return {story,
          [value](const Input& in, const Value& got) { return near(got, Value(value(in))); }};
}

/// Returns the story of the one mistake that explains the answer on all of the inputs. It is empty
/// if no mistake does, or more than one. On a single input different mistakes often look alike.
template <typename Input, typename Value, typename Answer>
std::string fingerprint(const std::vector<Input>& inputs, const Answer& answer,
                        std::vector<Mistake<Input, Value>> left) {
  try {
    for (const Input& in : inputs) {
      const Value got = answer(in);
      std::erase_if(left, [&](const auto& mistake) { return !mistake.fits(in, got); });
      if (left.empty()) return "";
    }
  } catch (const std::exception&) {
    return "";
  }
  for (const auto& mistake : left) {
    if (mistake.story != left.front().story) return "";
  }
  return left.front().story;
}

/// A function of a lab, and what names the mistake in it or returns nothing.
struct Looking {
  std::string step_and_function;  ///< as "6.2 friction_impulse"
  std::string (*likely)();
};

/// Returns a trial that looks for a likely mistake in the function that it judges, then in the
/// step's others.
Trial trial_with(const std::vector<Looking>& functions, const std::string& step_and_function,
                 int index, int count);

}  // namespace tests

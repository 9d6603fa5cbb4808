#include "fingerprint.hpp"

namespace tests {

Trial trial_with(const std::vector<Looking>& functions, const std::string& step_and_function,
                 int index, int count) {
  return Trial(step_and_function, index, count).suspecting([&functions, step_and_function] {
    std::string story;
    for (const Looking& function : functions) {
      if (function.step_and_function == step_and_function) story = function.likely();
    }
    const std::string step = step_and_function.substr(0, 3);
    for (const Looking& function : functions) {
      const bool same_step = function.step_and_function.substr(0, 3) == step;
      if (story.empty() && same_step) story = function.likely();
    }
    return story;
  });
}

}  // namespace tests

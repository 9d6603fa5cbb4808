#include "likely.hpp"

namespace tests {
namespace {

struct Looking {
  std::string step_and_function;
  std::string (*likely)();
};

const std::vector<Looking>& functions() {
  static const std::vector<Looking> all{
      {"6.1 normal_impulse", likely_of_normal_impulse},
      {"6.2 friction_impulse", likely_of_friction_impulse},
      {"6.3 normal_correction", likely_of_normal_correction},
      {"6.3 tangential_correction", likely_of_tangential_correction},
      {"6.4 step_by_projection", likely_of_step_by_projection},
      {"6.4 step_to_impact", likely_of_step_to_impact},
      {"6.5 contact_impulse", likely_of_contact_impulse},
      {"6.5 inverse_effective_mass", likely_of_inverse_effective_mass},
      {"6.5 with_impulse", likely_of_with_impulse}};
  return all;
}

std::string likely_mistake(const std::string& step_and_function) {
  std::string story;
  for (const Looking& function : functions()) {
    if (function.step_and_function == step_and_function) story = function.likely();
  }
  const std::string step = step_and_function.substr(0, 3);
  for (const Looking& function : functions()) {
    const bool same_step = function.step_and_function.substr(0, 3) == step;
    if (story.empty() && same_step) story = function.likely();
  }
  return story;
}

}  // namespace

Trial trial_of(const std::string& step_and_function, int index, int count) {
  Trial trial(step_and_function, index, count);
  return trial.suspecting([step_and_function] { return likely_mistake(step_and_function); });
}

}  // namespace tests

#include "likely.hpp"

namespace tests {
namespace {

struct Looking {
  std::string step_and_function;
  std::string (*likely)();
};

const std::vector<Looking>& functions() {
  static const std::vector<Looking> all{
      {"7.1 contact_system", likely_of_contact_system},
      {"7.1 with_impulses", likely_of_with_impulses},
      {"7.1 energy_gained", likely_of_energy_gained},
      {"7.2 sequential_impulses", likely_of_sequential_impulses},
      {"7.3 gauss_seidel", likely_of_gauss_seidel},
      {"7.3 residual", likely_of_residual},
      {"7.4 simultaneous_impulses", likely_of_simultaneous_impulses},
      {"7.5 generalized_reflections", likely_of_generalized_reflections},
      {"7.6 inelastic_projection", likely_of_inelastic_projection},
      {"7.7 limited", likely_of_limited},
      {"7.7 friction_sweeps", likely_of_friction_sweeps},
      {"7.7 coulomb_residual", likely_of_coulomb_residual},
      {"7.8 accelerated", likely_of_accelerated}};
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

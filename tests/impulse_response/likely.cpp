#include "likely.hpp"

#include "fingerprint.hpp"

namespace tests {
namespace {

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

}  // namespace

Trial trial_of(const std::string& step_and_function, int index, int count) {
  return trial_with(functions(), step_and_function, index, count);
}

}  // namespace tests

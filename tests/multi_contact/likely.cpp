#include "likely.hpp"

#include "fingerprint.hpp"

namespace tests {
namespace {

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

}  // namespace

Trial trial_of(const std::string& step_and_function, int index, int count) {
  return trial_with(functions(), step_and_function, index, count);
}

}  // namespace tests

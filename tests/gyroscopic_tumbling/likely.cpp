#include "likely.hpp"

namespace tests {
namespace {

const std::vector<Looking>& functions() {
  static const std::vector<Looking> all{{"2.1 angular_acceleration", likely_of_acceleration},
                                        {"2.1 rotational_energy", likely_of_energy},
                                        {"2.1 angular_momentum", likely_of_momentum},
                                        {"2.2 step_explicit", likely_of_explicit_step},
                                        {"2.3 implicit_residual", likely_of_residual},
                                        {"2.3 implicit_jacobian", likely_of_jacobian},
                                        {"2.3 step_implicit", likely_of_implicit_step},
                                        {"2.4 spin_rate", likely_of_rate},
                                        {"2.4 step_rk4", likely_of_rk4_step},
                                        {"2.5 step_about_axis", likely_of_sub_rotation},
                                        {"2.5 step_splitting", likely_of_splitting_step},
                                        {"2.6 weight_torque_body", likely_of_weight_torque},
                                        {"2.6 step_kick_drift_kick", likely_of_kick_drift_kick},
                                        {"2.7 step_constrained", likely_of_constrained_step},
                                        {"2.8 corrected_moments", likely_of_corrected_moments},
                                        {"2.8 step_moser_veselov", likely_of_moser_veselov_step},
                                        {"2.8 fourth_order_correction", likely_of_correction}};
  return all;
}

}  // namespace

Trial trial_of(const std::string& step_and_function, int index, int count) {
  return trial_with(functions(), step_and_function, index, count);
}

}  // namespace tests

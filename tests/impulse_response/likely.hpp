#pragma once

#include "trial.hpp"

/// Which mistake an answer to lab 6 makes, see fingerprint.hpp.
namespace tests {

std::string likely_of_normal_impulse();
std::string likely_of_friction_impulse();
std::string likely_of_normal_correction();
std::string likely_of_tangential_correction();
std::string likely_of_step_by_projection();
std::string likely_of_step_to_impact();
std::string likely_of_inverse_effective_mass();
std::string likely_of_contact_impulse();
std::string likely_of_with_impulse();

/// A trial that looks for a likely mistake in the function that it judges, then in the step's
/// others.
/// step_and_function  as "6.2 friction_impulse"
Trial trial_of(const std::string& step_and_function, int index = 1, int count = 1);

}  // namespace tests

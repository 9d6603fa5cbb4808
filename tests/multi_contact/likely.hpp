#pragma once

#include "trial.hpp"

/// Which mistake an answer to lab 7 makes, see fingerprint.hpp.
namespace tests {

std::string likely_of_contact_system();
std::string likely_of_with_impulses();
std::string likely_of_energy_gained();
std::string likely_of_sequential_impulses();
std::string likely_of_gauss_seidel();
std::string likely_of_residual();
std::string likely_of_simultaneous_impulses();
std::string likely_of_generalized_reflections();
std::string likely_of_inelastic_projection();
std::string likely_of_limited();
std::string likely_of_friction_sweeps();
std::string likely_of_coulomb_residual();
std::string likely_of_accelerated();

/// A trial that looks for a likely mistake in the function that it judges, then in the step's
/// others.
/// step_and_function  as "7.2 sequential_impulses"
Trial trial_of(const std::string& step_and_function, int index = 1, int count = 1);

}  // namespace tests

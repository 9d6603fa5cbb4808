#pragma once

#include <exception>
#include <string>
#include <vector>

#include "fingerprint.hpp"

/// Which mistake an answer to lab 2 makes, see fingerprint.hpp.
namespace tests {

std::string likely_of_acceleration();
std::string likely_of_energy();
std::string likely_of_momentum();
std::string likely_of_explicit_step();
std::string likely_of_residual();
std::string likely_of_jacobian();
std::string likely_of_implicit_step();
std::string likely_of_rate();
std::string likely_of_rk4_step();
std::string likely_of_sub_rotation();
std::string likely_of_splitting_step();
std::string likely_of_weight_torque();
std::string likely_of_kick_drift_kick();
std::string likely_of_constrained_step();
std::string likely_of_corrected_moments();
std::string likely_of_moser_veselov_step();
std::string likely_of_correction();

/// A trial that looks for a likely mistake in the function that it judges, then in the step's
/// others.
/// step_and_function  as "2.1 angular_acceleration"
Trial trial_of(const std::string& step_and_function, int index = 1, int count = 1);

/// Returns the story of the suspect that gives the answer on all of the inputs. It is empty if none
/// does, or if two with different stories do.
///
/// answer    Input -> Value
/// suspects  Input -> std::vector<Suspect<Value>>, the same suspects in the same order for each
template <typename Value, typename Input, typename Answer, typename Suspects>
std::string likely_over(const std::vector<Input>& inputs, const Answer& answer,
                        const Suspects& suspects) {
  std::vector<std::string> stories;
  std::vector<bool> fits;
  try {
    for (const Input& in : inputs) {
      const Value got = answer(in);
      const std::vector<Suspect<Value>> all = suspects(in);
      if (fits.empty()) fits.assign(all.size(), true);
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (!near(got, all[i].value)) fits[i] = false;
      }
      if (stories.empty()) {
        for (const Suspect<Value>& suspect : all) stories.push_back(suspect.story);
      }
    }
  } catch (const std::exception&) {
    return "";
  }
  std::string likely;
  for (std::size_t i = 0; i < stories.size(); ++i) {
    if (!fits[i] || stories[i] == likely) continue;
    if (!likely.empty()) return "";
    likely = stories[i];
  }
  return likely;
}

}  // namespace tests

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "judged.hpp"

/// Arguments that must be refused, each with the reason.
namespace tests {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

template <typename Value>
struct Bad {
  Value value;
  std::string why;
};

/// Two contacts that are well, and everything that can be wrong with A and u.
inline ContactSystem good_system() { return cradle(Vector{{1.0, 0.0, 0.0}}).system(); }
std::vector<Bad<ContactSystem>> bad_systems();
/// Of two entries.
std::vector<Bad<Vector>> bad_vectors();
std::vector<Bad<double>> bad_fractions();
std::vector<Bad<double>> bad_not_negative();

/// Each system to be refused with all the rest well, also where there is nothing to do: a shorter
/// way must not lead past the checks.
template <typename Call>
void refuse_systems(const std::string& step_and_function, const Call& call) {
  for (const auto& [system, why] : bad_systems()) {
    system_trial(step_and_function, system)
        .expect_throw([&, bad = system] { return call(bad); }, why);
  }
}

/// Each vector or number to be refused.
template <typename Value, typename Call>
void refuse(const std::string& step_and_function, const std::vector<Bad<Value>>& all,
            const std::string& name, const Call& call) {
  for (const auto& [value, why] : all) {
    trial_of(step_and_function)
        .given(name, value)
        .expect_throw([&, bad = value] { return call(bad); }, why);
  }
}

}  // namespace tests

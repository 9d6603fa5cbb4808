// What students get wrong in step 7.8.
#include <string>
#include <vector>

#include "acceleration.hpp"
#include "fingerprint.hpp"

namespace tests {

std::string likely_of_accelerated() {
  // Two that restart, one of them with a contact that parts, and what a clamped y changes.
  const Matrix held{{4.0, 2.0}, {2.0, 4.0}};
  const Matrix row{{2.0, -1.0, 0.0}, {-1.0, 1.5, -0.5}, {0.0, -0.5, 1.0}};
  std::vector<Accelerating> inputs;
  for (const int steps : {1, 2, 3, 4, 5, 7, 8}) {
    inputs.push_back({held / 3.0, Vector{{-2.0, -0.5}}, steps});
    inputs.push_back({row, Vector{{-1.0, 0.0, 0.25}}, steps});
  }
  std::vector<Mistake<Accelerating, Vector>> mistakes;
  for (const auto& [flaw, story] : acceleration_flaws()) {
    mistakes.push_back(returns<Accelerating, Vector>(story, [flaw = flaw](const Accelerating& in) {
      return exact_acceleration(in, flaw).lambda;
    }));
  }
  return fingerprint(
      inputs,
      [](const Accelerating& in) { return lab::multi_contact::accelerated(in.A, in.b, in.steps); },
      mistakes);
}

}  // namespace tests

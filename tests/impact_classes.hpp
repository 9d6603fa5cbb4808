#pragma once

#include <functional>
#include <string>
#include <vector>

#include "impact_oracle.hpp"
#include "random.hpp"

namespace tests {

/// A kind of query at which answers have failed.
struct ImpactClass {
  std::string name;
  bool adversarial = false;       ///< else drawn from what a simulation may meet
  bool well_conditioned = false;  ///< so the cross form is held to 4 ulp where the path goes deep
  std::function<Query(Random&)> draw;
};

std::vector<ImpactClass> impact_classes();

}  // namespace tests

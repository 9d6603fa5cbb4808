#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "cases.hpp"

/// Arguments that every time of impact refuses.
namespace tests {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is wrong, and the query in which it is. The path misses and the start is outside, so that
/// only a check of the arguments can find out.
inline std::vector<std::pair<std::string, Query>> bad_queries() {
  const Query good = query({0, 10, 20}, {0, -1, 0}, 1.0);
  std::vector<std::pair<std::string, Query>> bad;
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      Query moved = good;
      moved.particle.position[i] = value;
      bad.emplace_back("the position is not finite", moved);
      Query driven = good;
      driven.particle.velocity[i] = value;
      bad.emplace_back("the velocity is not finite", driven);
    }
    Query particle = good;
    particle.particle.radius = value;
    bad.emplace_back("the particle's radius is not finite", particle);
    Query cylinder = good;
    cylinder.cylinder.radius = value;
    bad.emplace_back("the cylinder's radius is not finite", cylinder);
    Query duration = good;
    duration.dt = value;
    bad.emplace_back("dt is not finite", duration);
  }
  for (const double value : {0.0, -1.0, -1e-300}) {
    Query particle = good;
    particle.particle.radius = value;
    bad.emplace_back("the particle's radius is not above zero", particle);
    Query cylinder = good;
    cylinder.cylinder.radius = value;
    bad.emplace_back("the cylinder's radius is not above zero", cylinder);
  }
  Query backwards = good;
  backwards.dt = -1e-300;
  bad.emplace_back("dt is below zero", backwards);
  Query inside = query({0, 0, 0}, {0, 0, 0}, -1.0);  // no shorter way than the check
  bad.emplace_back("dt is below zero, even if the start is inside", inside);
  return bad;
}

/// Requires that `call` of a query throws for each of them; it returns what it finds as a Time.
template <typename Call>
void expect_bad_queries_throw(const std::string& step, const Call& call) {
  const auto bad = bad_queries();
  int index = 0;
  for (const auto& [why, query] : bad) {
    trial(step, query, ++index, static_cast<int>(bad.size()))
        .expect_throw([&, &query = query] { return Time{call(query)}; }, why,
                      "the arguments are not checked: throw std::invalid_argument for a bad one");
  }
}

}  // namespace tests

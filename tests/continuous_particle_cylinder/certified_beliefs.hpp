#pragma once

#include <string>

#include "beliefs.hpp"
#include "narrow.hpp"

/// Names what a certified time of impact lacks, where it is right but for rounding.
namespace tests {

inline std::optional<double> certified(const Query& query) {
  return lab::continuous_particle_cylinder::time_of_impact_certified(query.particle, query.cylinder,
                                                                     query.dt);
}

/// Whether an answer is an exact time to 1 ulp, or none as this is.
inline bool is_to_an_ulp(const Time& got, const std::optional<Digits50>& exact) {
  if (!got.seconds || !exact) return !got.seconds && !exact;
  return is_finite(got) && ulps(*got.seconds, *exact) <= 1.0;
}

inline bool is_certain(const Query& query) {
  return is_to_an_ulp(Time{certified(query)}, exact_time(query));
}

/// Whether so many draws are right to an ulp.
inline bool are_certain(Query (*draw)(Random&), int count) {
  Random random(402);
  for (int i = 0; i < count; ++i) {
    if (!is_certain(draw(random))) return false;
  }
  return true;
}

/// Returns a story if the answer to a query is near the right one, but not to an ulp.
inline std::string story_of_digits(const Query& query) {
  const Time got{certified(query)};
  const Time wanted = time_of(query);
  if (!got.seconds || !wanted.seconds || is_certain(query)) return "";
  if (!is_finite(got) || difference(got, wanted) > 1e-6 * length(wanted)) return "";
  bool is_exact = true;
  bool is_of_rounded_sum = true;
  for (const Query& other : plain_queries()) {
    Query sum = other;
    sum.cylinder.radius = rho(other);
    const Time time{certified(other)};
    if (!near_time(time, time_of(other))) return "";
    is_exact = is_exact && is_certain(other);
    is_of_rounded_sum =
        is_of_rounded_sum && is_to_an_ulp(time, first_time(quadratic(sum, 0.0), sum.dt));
  }
  if (is_exact) {
    return "t* has lost digits where c, b or D cancels: take it from exact numbers there";
  }
  return is_of_rounded_sum
             ? "R + r is rounded to a double: use the exact sum"
             : "t* has only the digits of doubles: compute c, b and D in double-double";
}

inline TimeSuspects suspects_of_digits(const Query& query) {
  const std::string story = story_of_digits(query);
  if (story.empty()) return {};
  return {{Time{certified(query)}, story}};
}

/// Whether all is right that needs neither the last digits of dt nor more than double-double.
inline bool is_certain_elsewhere() {
  for (const Query& query : plain_queries()) {
    if (!is_certain(query)) return false;
  }
  return are_certain(grazing_query, 200) && are_certain(lattice_query, 300) &&
         are_certain(rounded_sum_query, 50);
}

/// What may be wrong with an impact within an ulp of dt.
inline TimeSuspects suspects_of_arrival(const Query& query) {
  const Time got{certified(query)};
  const bool is_decision = got.seconds.has_value() != time_of(query).seconds.has_value();
  if (!is_decision) return suspects_of_digits(query);
  if (!is_certain_elsewhere() || !are_certain(pythagorean_query, 100)) return {};
  return {{got,
           "a rounded t* is compared with dt: let the signs of the parabola and its slope at dt "
           "decide"}};
}

/// What may be wrong with a sign that 106 bits cannot decide.
inline TimeSuspects suspects_of_sign(const Query& query) {
  const Time got{certified(query)};
  const bool is_decision = got.seconds.has_value() != time_of(query).seconds.has_value();
  if (!is_decision) return suspects_of_digits(query);
  if (!is_certain_elsewhere()) return {};
  return {{got,
           "a sign is trusted that double-double does not settle: take its bound from the sizes of "
           "the terms, and beyond it use exact numbers"}};
}

}  // namespace tests

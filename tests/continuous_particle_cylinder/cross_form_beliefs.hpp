#pragma once

#include <cmath>
#include <vector>

#include "beliefs.hpp"
#include "narrow.hpp"

/// Names why the cross form misses an impact that rounding alone hides.
namespace tests {

inline std::optional<double> cross_form(const Query& query) {
  return lab::continuous_particle_cylinder::time_of_impact(query.particle, query.cylinder,
                                                           query.dt);
}

/// Whether of these paths those are missed, and no others, whose |w| is beyond ρ|v| when y v_z and
/// z v_y are rounded, by as much as no margin covers.
inline bool misses_by_rounded_products(const std::vector<Query>& queries) {
  int missed = 0;
  for (const Query& query : queries) {
    if (!time_of(query).seconds) continue;
    const Vec3& x = query.particle.position;
    const Vec3& v = query.particle.velocity;
    const double w = x.y() * v.z() - x.z() * v.y();
    const double beyond = std::abs(w) / (rho(query) * std::hypot(v.y(), v.z())) - 1.0;
    const bool found = cross_form(query).has_value();
    if (found ? beyond > 64.0 * eps : beyond < eps) return false;
    missed += found ? 0 : 1;
  }
  return missed > 0;
}

/// Whether difference_of_products is right to 2 ulp where its products cancel.
inline bool keeps_digits_of_difference() {
  Random random(405);
  for (int i = 0; i < 100; ++i) {
    const double a = random.uniform(1.0, 2.0);
    const double b = random.uniform(1.0, 2.0);
    const double d = random.uniform(1.0, 2.0);
    const double c = nudged(random, a * b / d, 3);
    const double got = lab::continuous_particle_cylinder::difference_of_products(a, b, c, d);
    const double wanted = (common::two_product(a, b) - common::two_product(c, d)).high;
    if (!(std::abs(got - wanted) <= 4.0 * eps * std::abs(wanted))) return false;
  }
  return true;
}

/// What else has to be right before a wrong answer can be blamed on a margin.
inline bool is_right_on_plain_paths_and_ties() {
  if (!keeps_digits_of_difference()) return false;
  for (const Query& query : plain_queries()) {
    if (!near_time(Time{cross_form(query)}, time_of(query))) return false;
  }
  for (const Tie& tie : ties()) {
    if (!cross_form(tie.query)) return false;
  }
  return true;
}

/// Whether it misses one of so many draws.
inline bool misses_any(Query (*draw)(Random&), int count) {
  Random random(403);
  for (int i = 0; i < count; ++i) {
    const Query query = draw(random);
    if (time_of(query).seconds && !cross_form(query)) return true;
  }
  return false;
}

/// If all is right that does not graze, only the rounding of a graze hides it.
inline TimeSuspects missed_by_rounded_graze() {
  Random random(404);
  std::vector<Query> queries;
  for (int i = 0; i < 1000; ++i) queries.push_back(oblique_grazing_query(random));
  if (!is_right_on_plain_paths_and_ties() || misses_by_rounded_products(queries)) return {};
  return {
      {{},
       "a discriminant below zero by rounding alone is taken for a miss: allow it a margin of a "
       "few eps of its terms"}};
}

/// If all is right but an arrival at dt, only the rounding of the root or of the end hides it.
inline TimeSuspects missed_by_rounded_end() {
  if (!is_right_on_plain_paths_and_ties() || misses_any(grazing_query, 300)) return {};
  return {
      {{},
       "a root beyond dt by rounding alone is taken for a miss: ask whether the end x + dt v is "
       "outside by more than its rounding"}};
}

/// If it counts a start on the surface between whole numbers, only rounding hides another one.
inline TimeSuspects missed_by_rounded_start() {
  if (cross_form(ties().front().query) != 0.0) return {};
  return {{{},
           "a start on the surface is missed, because |x| - rho or c is rounded: let c not cancel, "
           "and allow it a margin of a few eps of rho"}};
}

}  // namespace tests

#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "continuous_particle_cylinder.hpp"
#include "oracle.hpp"
#include "trial.hpp"

/// How a time of impact is judged, and what known mistakes make of it.
namespace tests {

using lab::continuous_particle_cylinder::Cylinder;
using lab::continuous_particle_cylinder::MovingParticle;

/// A time or none, as Trial compares and prints it.
struct Time {
  std::optional<double> seconds;
};
inline bool is_finite(const Time& time) { return !time.seconds || std::isfinite(*time.seconds); }
inline double length(const Time& time) { return time.seconds ? std::abs(*time.seconds) : 0.0; }
inline double difference(const Time& a, const Time& b) {
  if (!a.seconds && !b.seconds) return 0.0;
  if (!a.seconds || !b.seconds) return std::numeric_limits<double>::infinity();
  return std::abs(*a.seconds - *b.seconds);
}
inline std::string text(const Time& time) {
  return time.seconds ? text(*time.seconds) : "no impact";
}

/// The arguments of a time of impact.
struct Query {
  MovingParticle particle;
  Cylinder cylinder;
  double dt = 1.0;
};

inline double rho(const Query& query) { return query.cylinder.radius + query.particle.radius; }

inline Trial trial(const std::string& step, const Query& query, int index = 1, int count = 1) {
  return Trial(step, index, count)
      .given("particle.position", query.particle.position)
      .given("particle.velocity", query.particle.velocity)
      .given("particle.radius", query.particle.radius)
      .given("cylinder.radius", query.cylinder.radius)
      .given("dt", query.dt);
}

/// Of the path in the yz-plane; `dimensions` 3 takes x along, which is a mistake.
inline Quadratic quadratic(const Query& query, double particle_radius, int dimensions = 2) {
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  std::vector<Coordinate> path{{x.y(), v.y()}, {x.z(), v.z()}};
  if (dimensions == 3) path.push_back({x.x(), v.x()});
  return quadratic(path, query.cylinder.radius, particle_radius);
}
inline Quadratic quadratic(const Query& query) { return quadratic(query, query.particle.radius); }

inline std::optional<Digits50> exact_time(const Query& query) {
  return first_time(quadratic(query), query.dt);
}

inline Time rounded(const std::optional<Digits50>& exact) {
  return {exact ? std::optional<double>(static_cast<double>(*exact)) : std::nullopt};
}

/// t* rounded to the nearest double.
inline Time time_of(const Query& query) { return rounded(exact_time(query)); }

using TimeSuspects = std::vector<Suspect<Time>>;

/// What is believed of a particle that is outside at the start.
inline void add_suspects_of_path(TimeSuspects& suspects, const Query& query) {
  const Quadratic f = quadratic(query);
  if (f.a == 0 || f.b == 0 || discriminant(f) < 0) return;
  if (f.b > 0) {
    const auto root = static_cast<double>(Digits50(
        ldexp(Digits50(-(Digits50(f.b) + root_of_discriminant(f)) / Digits50(f.a)), f.unit)));
    suspects.push_back(
        {{root}, "a root below 0 is accepted: that impact is in the past, so return none"});
    return;
  }
  const auto first = static_cast<double>(first_root(f));
  const auto later = static_cast<double>(later_root(f));
  if (first > query.dt) {
    suspects.push_back({{first}, "dt is ignored: this impact is after dt, so return none"});
    return;
  }
  suspects.push_back(
      {later <= query.dt ? Time{later} : Time{},
       "the later root is returned, at which the particle leaves: return the first"});
  const double speed = std::hypot(query.particle.velocity.y(), query.particle.velocity.z());
  suspects.push_back(
      {{first * speed}, "t is scaled by the speed, so it is a length: divide by the speed"});
}

/// What is believed of a particle that is inside at the start.
inline void add_suspects_of_inside(TimeSuspects& suspects, const Query& query) {
  const Quadratic f = quadratic(query);
  suspects.push_back({{}, "a start inside is missed: return 0"});
  if (f.a == 0) return;
  const auto later = static_cast<double>(later_root(f));
  suspects.push_back({later <= query.dt ? Time{later} : Time{},
                      "a start inside gives the time at which the particle leaves: return 0"});
}

inline TimeSuspects suspects_of(const Query& query) {
  TimeSuspects suspects{{rounded(first_time(quadratic(query, 0.0), query.dt)),
                         "the particle's radius is forgotten: use R + r, not R"},
                        {rounded(first_time(quadratic(query, query.particle.radius, 3), query.dt)),
                         "x is kept in the distance: use only y and z"}};
  if (quadratic(query).c > 0) {
    add_suspects_of_path(suspects, query);
  } else {
    add_suspects_of_inside(suspects, query);
  }
  return suspects;
}

/// Requires hit or miss as in exact arithmetic, and the time to so many ulp.
/// suspects  of no argument, as in Trial::expect
template <std::invocable Suspects>
void expect_exact(const Trial& trial, const Time& got, const Query& query, double ulp_bound,
                  const Suspects& suspects) {
  const std::optional<Digits50> exact = exact_time(query);
  const std::string reason = text(ulp_bound) + " ulp of t, as the contract says";
  const double bound = exact ? static_cast<double>(Digits50(ulp_bound * ulp(*exact))) : 0.0;
  trial.expect(got, rounded(exact), {bound, exact ? reason : "there is no impact"}, suspects);
  if (exact) trial.expect_small("ulp from t*", ulps(*got.seconds, *exact), {ulp_bound, reason});
}
inline void expect_exact(const Trial& trial, const Time& got, const Query& query,
                         double ulp_bound) {
  expect_exact(trial, got, query, ulp_bound, [&] { return suspects_of(query); });
}

}  // namespace tests

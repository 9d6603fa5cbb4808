#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "common/exact/double_double.hpp"

/// Names a mistake in a time of impact only if it explains the answers on many paths, not on one.
namespace tests {

/// Paths of every kind. Rounding decides on none of them.
inline std::vector<Query> plain_queries() {
  std::vector<Query> queries;
  for (const HandCase& hand : hand_cases()) queries.push_back(hand.query);
  Random random(401);
  for (int i = 0; i < 60; ++i) {
    const double distance = random.uniform(0.5, 4.0);
    const double offset = random.uniform(-1.0, 1.0) * std::min(distance, 1.4);
    Query query = aimed(random, {distance, offset, random.uniform(0.3, 3.0)});
    if (i % 4 == 0) query.particle.velocity *= -1.0;
    query.dt *= random.uniform(0.0, 1.0);
    queries.push_back(query);
  }
  return queries;
}

/// A wrong root of a path that approaches, and what an answer makes of it: it may compare this root
/// with dt, or decide rightly whether there is an impact.
inline void add_root(TimeSuspects& suspects, const std::string& story, double root,
                     const Query& query) {
  if (!time_of(query).seconds) suspects.push_back({{}, story});
  if (!(root <= query.dt)) suspects.push_back({{}, story});
  if (std::isfinite(root)) suspects.push_back({{std::min(root, query.dt)}, story});
}

/// The numbers of a path by which mistakes are computed, to some 1e-14 of themselves.
struct PathNumbers {
  double rho, distance, speed, b, c, w, discriminant;
};
inline PathNumbers numbers_of(const Query& query) {
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  PathNumbers n{};
  n.rho = rho(query);
  n.distance = std::hypot(x.y(), x.z());
  n.speed = std::hypot(v.y(), v.z());
  n.b = x.y() * v.y() + x.z() * v.z();
  n.c = (n.distance - n.rho) * (n.distance + n.rho);
  n.w = std::abs(x.y() * v.z() - x.z() * v.y());
  n.discriminant = (n.rho * n.speed - n.w) * (n.rho * n.speed + n.w);
  return n;
}

/// Both radii as one sum, which a mistake has made of them.
inline Time time_with_rho(Query query, double rho) {
  query.cylinder.radius = rho;
  return rounded(first_time(quadratic(query, 0.0), query.dt));
}

/// What is believed whichever formula is used.
inline TimeSuspects beliefs_of_any(const Query& query) {
  TimeSuspects suspects = suspects_of(query);
  const PathNumbers n = numbers_of(query);
  suspects.push_back(
      {time_with_rho(query, std::hypot(query.cylinder.radius, query.particle.radius)),
       "rho^2 is taken as R^2 + r^2: it is (R + r)^2"});
  Query backwards = query;
  backwards.particle.velocity *= -1.0;
  suspects.push_back({time_of(backwards), "b has the wrong sign: an approach has b < 0"});
  if (n.c <= 0.0 && n.b >= 0.0) {
    suspects.push_back({{},
                        "a particle that starts inside and does not approach is missed: ask c <= 0 "
                        "before b >= 0"});
  }
  if (n.c <= 0.0 || n.b >= 0.0 || n.discriminant <= 0.0) return suspects;
  const double first = n.c / (std::sqrt(n.discriminant) - n.b);
  const double later = (std::sqrt(n.discriminant) - n.b) / (n.speed * n.speed);
  const std::string length = "t is scaled by the speed, so it is a length: divide by the speed";
  add_root(suspects, "the later root is returned, at which the particle leaves: return the first",
           later, query);
  add_root(suspects, length, first * n.speed, query);
  if (first > query.dt) {
    suspects.push_back({{query.dt}, "an impact after dt is returned as dt: return none"});
  }
  if (first <= query.dt && later < query.dt) {
    suspects.push_back({{},
                        "a particle that has passed through by dt is missed: it is outside at dt, "
                        "but does not approach any more"});
  }
  return suspects;
}

/// What is believed of the cross form, eq. (5) and (6).
inline TimeSuspects beliefs_of_cross_form(const Query& query) {
  TimeSuspects suspects = beliefs_of_any(query);
  const PathNumbers n = numbers_of(query);
  if (n.c <= 0.0 || n.b >= 0.0) return suspects;
  const double a = n.speed * n.speed;
  const std::string dot = "w is x.v: in (5) it is the cross product y v_z - z v_y";
  const double of_dot = n.rho * n.rho * a - n.b * n.b;
  suspects.push_back({{}, dot});
  add_root(suspects, dot, n.c / (std::sqrt(of_dot) - n.b), query);
  const std::string no_speed = "the discriminant lacks |v|^2: it is rho^2 |v|^2 - w^2";
  const double without_speed = n.rho * n.rho - n.w * n.w;
  add_root(suspects, no_speed, n.c / (std::sqrt(std::max(without_speed, 0.0)) - n.b), query);
  if (without_speed < 0.0) suspects.push_back({{}, no_speed});
  if (n.discriminant <= 0.0) return suspects;

  const double root = std::sqrt(n.discriminant);
  const std::string halves =
      "the textbook's 2 in b or 4 in the discriminant is kept: in (6) b = x.v and D is as in (5)";
  add_root(suspects, halves, n.c / (root - 2.0 * n.b), query);
  add_root(suspects, halves, n.c / (2.0 * root - n.b), query);
  add_root(suspects, halves, n.c / (2.0 * root - 2.0 * n.b), query);
  add_root(suspects, "c is taken as the gap |x| - rho: it is |x|^2 - rho^2",
           (n.distance - n.rho) / (root - n.b), query);
  add_root(suspects, "the root of the discriminant is left out: divide by -b + sqrt(D)",
           n.c / (n.discriminant - n.b), query);
  return suspects;
}

/// What is believed of the textbook's formula, eq. (2) and (3).
inline TimeSuspects beliefs_of_textbook(const Query& query) {
  TimeSuspects suspects = beliefs_of_any(query);
  const PathNumbers n = numbers_of(query);
  if (n.c <= 0.0 || n.speed == 0.0) return suspects;
  const double a = n.speed * n.speed;
  const double b = 2.0 * n.b;
  const auto add = [&](const std::string& story, double divided, double divisor, double squared) {
    const double t = (divided - std::sqrt(squared)) / divisor;  // NaN if there is no root
    suspects.push_back({t >= 0.0 && t <= query.dt ? Time{t} : Time{}, story});
  };
  const double squared = 4.0 * n.discriminant;
  add("b lacks its factor 2: use 2 x.v, not x.v", -n.b, 2.0 * a, n.b * n.b - 4.0 * a * n.c);
  add("4 a c lacks its 4: the discriminant is b^2 - 4 a c", -b, 2.0 * a, b * b - a * n.c);
  add("the root is divided by a: divide by 2 a", -b, a, squared);
  add("a lacks its square: a is v.v, not |v|", -b, 2.0 * n.speed, b * b - 4.0 * n.speed * n.c);
  add("the root of the discriminant is left out: subtract sqrt(b^2 - 4 a c)", -b, 2.0 * a,
      squared * squared);
  const double multiplied = (-b - std::sqrt(squared)) / 2.0 * a;
  suspects.push_back({multiplied >= 0.0 && multiplied <= query.dt ? Time{multiplied} : Time{},
                      "the root is multiplied by a: put 2 a in brackets, as in x / (2 a)"});
  const auto mixed = [&](bool in_a, bool in_b, bool in_c) {
    const double x = query.particle.position.x();
    const double v = query.particle.velocity.x();
    const double A = a + (in_a ? v * v : 0.0);
    const double B = b + (in_b ? 2.0 * x * v : 0.0);
    const double C = n.c + (in_c ? x * x : 0.0);
    const double t = (-B - std::sqrt(B * B - 4.0 * A * C)) / (2.0 * A);
    suspects.push_back({t >= 0.0 && t <= query.dt ? Time{t} : Time{},
                        "x is kept in the distance: use only y and z"});
  };
  mixed(true, false, false);
  mixed(false, true, false);
  mixed(false, false, true);
  return suspects;
}

using Beliefs = TimeSuspects (*)(const Query&);

inline bool near_time(const Time& got, const Time& wanted) {
  return is_finite(got) && difference(got, wanted) <= 1e-9 * length(wanted);
}

/// Whether a story gives the answer to a query. Where it says nothing, only the right time fits.
inline bool explains(const std::string& story, const TimeSuspects& all, const Time& got,
                     const Time& wanted) {
  bool says_something = false;
  for (const Suspect<Time>& suspect : all) {
    if (suspect.story != story) continue;
    if (near_time(got, suspect.value)) return true;
    says_something = says_something || !near_time(suspect.value, wanted);
  }
  return !says_something && near_time(got, wanted);
}

/// Returns, of what is believed of a query, what explains the answers to all plain queries, too,
/// and at least one wrong answer among them. Each story is there once, with the value that is
/// nearest to the answer.
template <typename Call>
TimeSuspects explaining(const Call& call, const Query& query, Beliefs beliefs) {
  const Time answer{call(query)};
  TimeSuspects left;
  for (const Suspect<Time>& suspect : beliefs(query)) {
    const auto same = std::find_if(left.begin(), left.end(), [&](const Suspect<Time>& other) {
      return other.story == suspect.story;
    });
    if (same == left.end()) {
      left.push_back(suspect);
    } else if (difference(answer, suspect.value) < difference(answer, same->value)) {
      *same = suspect;
    }
  }
  bool is_wrong_somewhere = false;
  for (const Query& other : plain_queries()) {
    if (numbers_of(other).speed == 0.0) continue;  // what has no root is a matter of its own
    const Time got{call(other)};
    const Time wanted = time_of(other);
    is_wrong_somewhere = is_wrong_somewhere || !near_time(got, wanted);
    const TimeSuspects theirs = beliefs(other);
    std::erase_if(left, [&](const Suspect<Time>& suspect) {
      return !explains(suspect.story, theirs, got, wanted);
    });
  }
  return is_wrong_somewhere ? left : TimeSuspects{};
}

/// Returns a story if the answer is NaN for some plain queries that have no root, right for the
/// other ones without a root, and never NaN where there is a root.
template <typename Call>
std::string nan_without_root(const Call& call) {
  bool is_nan = false;
  for (const Query& query : plain_queries()) {
    const PathNumbers n = numbers_of(query);
    const Time got{call(query)};
    if (is_finite(got)) continue;
    is_nan = true;
    if (n.speed > 0.0 && n.discriminant >= 0.0) return "";
  }
  return is_nan ? "NaN is returned where there is no root, at rest or beside the cylinder: ask for "
                  "a = 0 and a negative discriminant first"
                : "";
}

}  // namespace tests

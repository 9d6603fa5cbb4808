#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "judge.hpp"
#include "random.hpp"

/// Paths on which every method is judged: worked by hand, and drawn by class.
namespace tests {

inline Query query(const Vec3& position, const Vec3& velocity, double dt, double R = 4.0,
                   double r = 1.0) {
  return {{position, velocity, r}, {R}, dt};
}

/// Small whole numbers, 3-4-5 triangles: every square, sum and root is a double.
struct HandCase {
  Query query;
  std::optional<double> time;
};

/// ρ = 5. None of them touches only just; see ties().
inline std::vector<HandCase> hand_cases() {
  return {{query({0, 10, 3}, {0, -2, 0}, 10.0), 3.0},           // down a line 3 beside the axis
          {query({0, 3, -16}, {0, 0, 4}, 10.0), 3.0},           // and along z
          {query({2, 10, 3}, {0, -2, 0}, 10.0), 3.0},           // x plays no part
          {query({7, 10, 3}, {-9, -2, 0}, 10.0), 3.0},          // however it moves
          {query({1e6, 25, 0}, {1e6, -5, 0}, 10.0), 4.0},       // through the axis
          {query({0, 10, 3}, {0, -2, 0}, 2.5), std::nullopt},   // too late
          {query({0, 10, 3}, {0, 2, 0}, 10.0), std::nullopt},   // it was there before
          {query({0, 10, 6}, {0, -2, 0}, 10.0), std::nullopt},  // it passes
          {query({0, 10, 4.75}, {0, -2, 0}, 1.0, 4.5, 0.5), std::nullopt},
          {query({0, 6, 0}, {0, 0, 0}, 10.0), std::nullopt},  // at rest, outside
          {query({0, 6, 0}, {3, 0, 0}, 10.0), std::nullopt},  // along the axis, outside
          {query({0, 6, 0}, {0, -3, 0}, 0.0), std::nullopt},  // no time to get there
          {query({0, 0, 0}, {0, 1, 0}, 10.0), 0.0},           // from the axis
          {query({0, 0, 0}, {0, 0, 0}, 0.0), 0.0},            // at rest on it
          {query({0, 1, 2}, {0, -1, -1}, 10.0), 0.0},         // inside, deeper
          {query({9, 1, 2}, {0, 3, 6}, 10.0), 0.0},           // inside, on its way out
          {query({0, 1, 2}, {5, 0, 0}, 10.0), 0.0},           // inside, along the axis
          {query({0, 3, 3}, {0, 1, 1}, 0.0), 0.0}};           // inside, no time
}

/// A touch that counts, and the same path moved by a thousandth so that there is no doubt: what is
/// right there and wrong here is the touch.
struct Tie {
  Query query;
  double time;
  Query beside;
  std::string story;
};

inline Tie tie(const Query& touching, double time, const Query& beside, const std::string& story) {
  return {touching, time, beside, story};
}

inline std::vector<Tie> ties() {
  const auto sunk = [](Query query) {
    query.cylinder.radius += 0.001;
    return query;
  };
  const auto later = [](Query query) {
    query.dt += 0.001;
    return query;
  };
  const std::string start = "touching at the start is not counted: return 0 if c = 0, too";
  const std::string pass =
      "touching in passing is not counted: a discriminant of 0 is an impact, too";
  const std::string end = "an arrival at dt is not counted: t = dt is an impact, too";
  const auto at_start = [&](const Vec3& velocity, double dt) {
    const Query touching = query({2, 3, 4}, velocity, dt);
    return tie(touching, 0.0, sunk(touching), start);
  };
  const auto in_passing = [&](const Vec3& position, const Vec3& velocity, double time) {
    const Query touching = query(position, velocity, 10.0);
    return tie(touching, time, sunk(touching), pass);
  };
  const auto at_end = [&](const Vec3& position, const Vec3& velocity, double dt) {
    const Query touching = query(position, velocity, dt);
    return tie(touching, dt, later(touching), end);
  };
  return {at_start({0, 3, 4}, 10.0),  // leaving
          at_start({0, -3, -4}, 10.0),
          at_start({0, -4, 3}, 10.0),  // along the surface
          at_start({1, 0, 0}, 10.0),
          at_start({0, 0, 0}, 10.0),
          at_start({0, 3, 4}, 0.0),
          in_passing({0, -6, 5}, {0, 2, 0}, 3.0),
          in_passing({0, -5, 8}, {1, 0, -2}, 4.0),
          in_passing({3, -5, -15}, {0, 3, 4}, 3.0),
          in_passing({0, 19, -8}, {0, -4, 3}, 4.0),
          at_end({0, 10, 3}, {0, -2, 0}, 3.0),
          at_end({0, 25, 0}, {4, -5, 0}, 4.0),
          at_end({0, -16, -3}, {0, 4, 0}, 3.0)};
}

inline double power_of_ten(Random& random, double low, double high) {
  return std::pow(10.0, random.uniform(low, high));
}

/// A few ulp up or down.
inline double nudged(Random& random, double value, int most) {
  const int steps = static_cast<int>(random.uniform(-most, most + 1.0));
  for (int i = 0; i < std::abs(steps); ++i) {
    value = std::nextafter(value, steps > 0 ? HUGE_VAL : -HUGE_VAL);
  }
  return value;
}

/// How a random path lies, in units of ρ.
struct Aim {
  double distance = 3.0;  ///< of the start
  double offset = 0.0;    ///< of the line from the axis, at most `distance`
  double speed = 1.0;     ///< [m/s]
};

/// A path of any direction that comes near; dt reaches to twice as far as the axis.
inline Query aimed(Random& random, const Aim& aim) {
  Query query;
  query.cylinder.radius = random.uniform(0.2, 2.0);
  query.particle.radius = random.uniform(0.01, 1.0);
  const double D = aim.distance * rho(query);
  const double place = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double course = place + std::asin(aim.offset / aim.distance);
  query.particle.position = {random.uniform(-9.0, 9.0), D * std::cos(place), D * std::sin(place)};
  query.particle.velocity = {random.uniform(-9.0, 9.0) * aim.speed, -aim.speed * std::cos(course),
                             -aim.speed * std::sin(course)};
  query.dt = 2.0 * D / aim.speed;
  return query;
}

/// dt at the impact, but for a few ulp.
inline Query ending_at_impact(Random& random, Query query) {
  const Time time = time_of(query);
  if (time.seconds) query.dt = std::max(0.0, nudged(random, *time.seconds, 2));
  return query;
}

/// Near and far, hit and missed, leaving and inside.
inline Query generic_query(Random& random) {
  const double distance = random.uniform(0.5, 5.0);
  Query query = aimed(random, {distance, random.uniform(-1.0, 1.0) * std::min(distance, 1.5),
                               power_of_ten(random, -3.0, 3.0)});
  if (random.uniform(0.0, 1.0) < 0.2) query.particle.velocity *= -1.0;
  query.dt *= random.uniform(0.0, 1.0);
  return query;
}

inline Query far_query(Random& random) {
  return aimed(random, {power_of_ten(random, 4.0, 8.5), random.uniform(-1.2, 1.2), 1.0});
}

/// Some 1e6 radii within dt.
inline Query fast_query(Random& random) {
  Query query = aimed(
      random, {random.uniform(1.1, 1e6), random.uniform(-1.2, 1.2), random.uniform(1e5, 1e7)});
  query.dt = 1.0;
  return query;
}

/// So slow that dt ends while it is next to where it began, a few ulp above the surface.
inline Query slow_query(Random& random) {
  Query query = aimed(random, {1.0, random.uniform(-0.9, 0.9), 1.0});
  query.particle.position.y() = nudged(random, query.particle.position.y(), 3);
  const double speed = power_of_ten(random, -18.0, -15.0);
  query.particle.velocity *= speed;
  query.dt = 1.0;
  return query;
}

/// It leaves the surface, on which it starts but for a few ulp.
inline Query leaving_query(Random& random) {
  Query query = aimed(random, {1.0, random.uniform(-0.9, 0.9), power_of_ten(random, -3.0, 3.0)});
  query.particle.position.y() = nudged(random, query.particle.position.y(), 3);
  query.particle.velocity *= -1.0;
  return query;
}

/// The line is ρ from the axis but for a few ulp.
inline Query grazing_query(Random& random) {
  Query query = aimed(random, {random.uniform(1.0, 5.0), 1.0, power_of_ten(random, -3.0, 3.0)});
  query.cylinder.radius = nudged(random, query.cylinder.radius, 3);
  query.particle.position.z() = nudged(random, query.particle.position.z(), 2);
  return query;
}

/// Lengths by one power of two and speeds by another: the same times by a third, without rounding.
inline Query scaled(Query query, int length, int speed) {
  for (double& x : query.particle.position) x = std::ldexp(x, length);
  for (double& v : query.particle.velocity) v = std::ldexp(v, speed);
  query.particle.radius = std::ldexp(query.particle.radius, length);
  query.cylinder.radius = std::ldexp(query.cylinder.radius, length);
  query.dt = std::ldexp(query.dt, length - speed);
  return query;
}

/// Small whole numbers: many touch at the start, in passing or at the end, exactly.
inline Query lattice_query(Random& random) {
  const auto number = [&](double low, double high) {
    return std::floor(random.uniform(low, high + 1.0));
  };
  Query query;
  query.cylinder.radius = number(1, 4);
  query.particle.radius = number(1, 2);
  query.particle.position = {number(-9, 9), number(-9, 9), number(-9, 9)};
  query.particle.velocity = {number(-9, 9), number(-4, 4), number(-4, 4)};
  query.dt = number(0, 6);
  return query;
}

/// A line that touches exactly, or passes ρ by 2⁻⁵² within or beyond: a triangle of whole numbers
/// near 2⁵⁰, so that ρ² |v|² and (x × v)² have 200 digits, and the first 106 are the same.
inline Query pythagorean_query(Random& random) {
  const auto whole = [&](double low, double high) { return std::floor(random.uniform(low, high)); };
  const double p = whole(0x1p22, 0x1p23);
  const double q = whole(0x1p21, 0x1p22);
  const Vec3 v(0.0, p * p - q * q, 2.0 * p * q);
  const Vec3 across(0.0, -v.z(), v.y());
  const double side = whole(0.0, 2.0) == 0.0 ? 1.0 : -1.0;
  const double k = 3.0 + 2.0 * whole(0.0, 3.0);
  Query query;
  query.particle.position = side * k * across - whole(1.0, 5.0) * v;
  query.particle.velocity = v;
  query.particle.radius = 1.0 + whole(-1.0, 2.0) * 0x1p-52;
  query.cylinder.radius = k * (p * p + q * q) - 1.0;
  query.dt = 9.0;
  return query;
}

/// A line that passes beyond R + r, but not beyond that sum rounded up to a double.
inline Query rounded_sum_query(Random& random) {
  Query query = tests::query({0, 9, 0}, {0, -1, 0}, 20.0);
  do {
    query.cylinder.radius = random.uniform(0.5, 4.0);
    query.particle.radius = random.uniform(0.1, 1.0);
    query.particle.position.z() = rho(query);
  } while (discriminant(quadratic(query)) >= 0);
  return query;
}

/// Numbers of any size that a double has, each by itself.
inline double any_number(Random& random) {
  const double mantissa = random.uniform(1.0, 2.0);
  const double sign = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  return sign * std::ldexp(mantissa, static_cast<int>(random.uniform(-1074.0, 1024.0)));
}

}  // namespace tests

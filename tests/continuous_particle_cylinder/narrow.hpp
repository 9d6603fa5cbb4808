#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <vector>

#include "beliefs.hpp"
#include "cases.hpp"
#include "common/exact/double_double.hpp"

/// Misses that are clear, but narrow, and grazing lines of any direction.
namespace tests {

/// How far the line passes from the axis, |x × v|/|v| to the nearest double: in double-double the
/// products of the cross product lose nothing, however far off it starts.
inline double offset_of(const Query& query) {
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  using common::two_product;
  const auto w = two_product(x.y(), v.z()) - two_product(x.z(), v.y());
  const auto a = two_product(v.y(), v.y()) + two_product(v.z(), v.z());
  return std::abs((w / sqrt(a)).high);
}

/// R so that ρ is a length, but for rounding.
inline Query with_rho(Query query, double rho) {
  query.particle.radius = 0.25 * rho;
  query.cylinder.radius = rho - query.particle.radius;
  return query;
}

/// Of any direction and from afar, within a few ulp of touching. Here y v_z and z v_y are both as
/// large as the distance, and their difference is ρ.
inline Query oblique_grazing_query(Random& random) {
  const Aim aim{power_of_ten(random, 0.1, 6.0), 1.0, power_of_ten(random, -3.0, 3.0)};
  Query query = aimed(random, aim);
  query = with_rho(query, offset_of(query));
  query.cylinder.radius = nudged(random, query.cylinder.radius, 2);
  return query;
}

/// A miss by a share of ρ or of dt, and the same path moved by a hundredth so that there is no
/// doubt: what is right there and wrong here takes a near miss for a hit.
struct NarrowMiss {
  Query query;
  Query beside;
  std::string story;
};

/// It passes ρ by a share of it.
inline NarrowMiss narrow_pass(Random& random, double share, const Aim& aim) {
  const Query query = aimed(random, aim);
  const double offset = offset_of(query);
  return {with_rho(query, offset * (1.0 - share)), with_rho(query, 0.99 * offset),
          "a line that passes just outside is taken for a hit: use a margin of a few eps"};
}

/// It starts outside by a share of ρ and leaves, or rests.
inline NarrowMiss narrow_start(Random& random, double share, double speed) {
  Query query = aimed(random, {1.0, random.uniform(-0.9, 0.9), 1.0});
  query.particle.velocity *= -speed;
  const double distance = std::hypot(query.particle.position.y(), query.particle.position.z());
  return {with_rho(query, distance * (1.0 - share)), with_rho(query, 0.99 * distance),
          "a start just outside is taken for touching: use a margin of a few eps"};
}

/// Its dt ends before t* by a share of it.
inline NarrowMiss narrow_end(Random& random, double share, const Aim& aim) {
  Query query = aimed(random, aim);
  const double time = *time_of(query).seconds;
  Query beside = query;
  query.dt = time * (1.0 - share);
  beside.dt = 0.99 * time;
  return {query, beside, "an end just outside is taken for an arrival: use a margin of a few eps"};
}

/// Starts 1.5 to 5 ρ away, so that a share of the way is a share of ρ, too.
inline std::vector<NarrowMiss> narrow_misses(Random& random, double share) {
  std::vector<NarrowMiss> misses;
  for (int i = 0; i < 8; ++i) {
    const double speed = power_of_ten(random, -1.0, 1.0);
    const double distance = random.uniform(1.5, 5.0);
    const double side = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
    misses.push_back(narrow_pass(random, share, {distance, side, speed}));
    misses.push_back(narrow_start(random, share, i % 4 == 0 ? 0.0 : speed));
    misses.push_back(narrow_end(random, share, {distance, random.uniform(-0.7, 0.7), speed}));
  }
  return misses;
}

/// Shares that no margin of a few eps covers.
inline const std::vector<double> narrow_shares{256.0 * eps, 1e-12, 1e-10, 1e-9, 5e-8};

/// Requires that a function finds no impact in narrow misses of each share.
template <typename Call>
void expect_narrow_misses_missed(const std::string& step, const Call& time_of_impact, int seed,
                                 const std::vector<double>& shares = narrow_shares) {
  Random random(static_cast<std::uint64_t>(seed));
  for (const double share : shares) {
    int index = 0;
    for (const NarrowMiss& miss : narrow_misses(random, share)) {
      const Trial here = trial(step, miss.query, ++index, 24);
      here.expect_small("impacts in exact arithmetic", exact_time(miss.query) ? 1.0 : 0.0,
                        {0.0, "the case is a miss"});
      const Time got{here.returned([&] { return time_of_impact(miss.query); })};
      const Time beside{here.returned([&] { return time_of_impact(miss.beside); })};
      here.expect(got, Time{}, {0.0, "it stays outside by " + text(share) + " of rho or dt"}, [&] {
        return beside.seconds ? explaining(time_of_impact, miss.query, beliefs_of_any)
                              : TimeSuspects{{got, miss.story}};
      });
    }
  }
}

}  // namespace tests

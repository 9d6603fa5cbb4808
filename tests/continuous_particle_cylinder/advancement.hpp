#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bad_input.hpp"
#include "common/exact/double_double.hpp"
#include "narrow.hpp"

/// Conservative advancement once more, in double-double, and what its times must be.
namespace tests {

using lab::continuous_particle_cylinder::Advancement;

inline const std::string advancement_step = "4.3 conservative_advancement";

inline Trial advancement_trial(const Query& query, double tolerance, int index = 1, int count = 1) {
  return trial(advancement_step, query, index, count).given("tolerance", tolerance);
}

inline Advancement advanced(const Query& query, double tolerance) {
  return lab::continuous_particle_cylinder::conservative_advancement(query.particle, query.cylinder,
                                                                     query.dt, tolerance);
}

inline double speed_of(const Query& query) {
  return std::hypot(query.particle.velocity.y(), query.particle.velocity.z());
}

/// The sequence of the contract in double-double. An evaluation errs by less than 32 of its units
/// of 2⁻¹⁰⁶ of the lengths, where the bound of the answer's own roundings has 8 eps = 2⁻⁴⁹.
struct Sequence {
  Time time;
  double after = 0.0;  ///< one step on from there [s]
  int evaluations = 0;
  double closest = infinity;  ///< of all decisions: from φ to the tolerance, from t to dt [m]
};

inline Sequence sequence(const Query& query, double tolerance, double speed) {
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  const common::DoubleDouble rho = common::two_sum(query.cylinder.radius, query.particle.radius);
  Sequence result;
  for (common::DoubleDouble t = 0.0; result.evaluations < 20000;) {
    const common::DoubleDouble y = x.y() + t * v.y();
    const common::DoubleDouble z = x.z() + t * v.z();
    const common::DoubleDouble gap = sqrt(y * y + z * z) - rho;
    const double to_tolerance = (gap - tolerance).high;
    ++result.evaluations;
    result.closest = std::min(result.closest, std::abs(to_tolerance));
    if (to_tolerance <= 0.0) result.time.seconds = t.high;
    if (to_tolerance > 0.0 && speed == 0.0) return result;
    t = t + gap / speed;
    result.after = t.high;
    if (to_tolerance <= 0.0) return result;
    result.closest = std::min(result.closest, std::abs(result.after - query.dt) * speed);
    if (result.after > query.dt) return result;
  }
  return result;
}

/// What known mistakes make of it.
inline std::vector<std::pair<Sequence, std::string>> wrong_sequences(const Query& query,
                                                                     double tolerance) {
  Query bare = query;
  bare.particle.radius = 0.0;
  return {{sequence(query, tolerance, 1.0),
           "phi is not divided by the speed, so t grows by a length: add phi/|v|"},
          {sequence(query, tolerance, query.particle.velocity.norm()),
           "the speed is that of all three axes: use the speed in the yz-plane"},
          {sequence(bare, tolerance, speed_of(query)),
           "the particle's radius is forgotten: use R + r, not R"}};
}

/// Requires the time and the count of the contract's own sequence, where rounding decides neither.
inline void expect_sequence(const Query& query, double tolerance, int index = 1, int count = 1) {
  const double speed = speed_of(query);
  const Sequence wanted = sequence(query, tolerance, speed);
  // An advance never drives two places apart, since φ falls no faster than the way grows: the
  // roundings of each evaluation just add up.
  const Vec3& x = query.particle.position;
  const double way = 8.0 * eps * wanted.evaluations * (std::hypot(x.y(), x.z()) + 2.0 * rho(query));
  const Advancement got = advanced(query, tolerance);
  if (wanted.closest < 2.0 * way) {
    advancement_trial(query, tolerance)
        .expect_small("|0 t|", 0.0 * got.time.value_or(0.0), {0.0, "finite"});
    return;
  }
  const auto here = advancement_trial(query, tolerance, index, count);
  here.expect(Time{got.time}, wanted.time,
              {speed > 0.0 ? way / speed : 0.0, "8 eps of the lengths for each evaluation"}, [&] {
                TimeSuspects suspects;
                for (const auto& [other, story] : wrong_sequences(query, tolerance)) {
                  suspects.push_back({other.time, story});
                }
                if (!wanted.time.seconds) return suspects;
                suspects.push_back(
                    {{}, "a gap within the tolerance is taken for no impact: return the time t"});
                suspects.push_back({{wanted.after},
                                    "it steps once more after the gap is within the tolerance: "
                                    "return t before that step"});
                return suspects;
              });
  const auto number = [](const Sequence& other) { return static_cast<double>(other.evaluations); };
  // Where a particle that moves is counted right, what is wrong with one at rest is its own.
  const auto at_rest = [&]() -> std::vector<Suspect<double>> {
    Query moving = query;
    moving.particle.velocity = {0.0, 0.0, 1.0};
    moving.dt = 0.0;
    if (advanced(moving, tolerance).iterations != 1) return {};
    return {{0.0,
             "a particle at rest is not looked at: evaluate and count phi before you look at "
             "the speed"}};
  };
  here.of("iterations")
      .expect(static_cast<double>(got.iterations), number(wanted),
              {0.0, "one for each evaluation of the gap, including the first and the last"}, [&] {
                if (speed == 0.0) return at_rest();
                std::vector<Suspect<double>> suspects;
                for (const auto& [other, story] : wrong_sequences(query, tolerance)) {
                  suspects.push_back({number(other), story});
                }
                suspects.push_back({number(wanted) - 1.0,
                                    "the last evaluation, or the first, is not counted: count "
                                    "every evaluation of the gap"});
                return suspects;
              });
}

/// Never late, and early only by what the tolerance takes: between the impacts with a cylinder that
/// is wider by the tolerance and with the true one.
inline void expect_between(const Query& query, double tolerance, int index, int count) {
  Query wide = query;
  wide.cylinder.radius += tolerance;
  const Time earliest = time_of(wide);
  const Time latest = time_of(query);
  const Time got{advanced(query, tolerance).time};
  const auto here = advancement_trial(query, tolerance, index, count);
  if (!earliest.seconds || latest.seconds)
    here.expect(got, latest, {infinity, "only whether there is an impact"});
  if (!got.seconds) return;
  const double speed = speed_of(query);
  const double rounding = speed > 0.0 ? 1e-12 * (rho(query) + speed * query.dt) / speed : 0.0;
  here.expect_small("early", *earliest.seconds - *got.seconds,
                    {rounding, "not earlier than the gap is within the tolerance"});
  if (latest.seconds) {
    here.expect_small("late", *got.seconds - *latest.seconds, {rounding, "it must never be late"});
  }
}

}  // namespace tests

#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "bad_input.hpp"
#include "beliefs.hpp"
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

/// What an evaluation takes for the gap.
enum class Gap { distance, squares };

inline constexpr int most_evaluations = 20000;

/// The sequence of the contract in double-double. An evaluation errs by less than 32 of its units
/// of 2⁻¹⁰⁶ of the lengths, where the bound of the answer's own roundings has 8 eps = 2⁻⁴⁹.
struct Sequence {
  Time time;
  double after = 0.0;  ///< one step on from there [s]
  int evaluations = 0;
  double closest = infinity;  ///< of all decisions: from φ to the tolerance, from t to dt [m]
};

inline Sequence sequence(const Query& query, double tolerance, double speed,
                         Gap kind = Gap::distance) {
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  const common::DoubleDouble rho = common::two_sum(query.cylinder.radius, query.particle.radius);
  Sequence result;
  for (common::DoubleDouble t = 0.0; result.evaluations < most_evaluations;) {
    const common::DoubleDouble y = x.y() + t * v.y();
    const common::DoubleDouble z = x.z() + t * v.z();
    const common::DoubleDouble squares = y * y + z * z;
    const common::DoubleDouble gap =
        kind == Gap::squares ? squares - rho * rho : sqrt(squares) - rho;
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

/// What a known mistake makes of it.
struct WrongAdvance {
  Time time;
  int evaluations;
  std::string story;
};

inline std::vector<WrongAdvance> wrong_advances(const Query& query, double tolerance) {
  Query bare = query;
  bare.particle.radius = 0.0;
  const double speed = speed_of(query);
  const Sequence right = sequence(query, tolerance, speed);
  std::vector<WrongAdvance> all;
  const auto add = [&](const Sequence& other, const std::string& story) {
    all.push_back({other.time, other.evaluations, story});
  };
  add(sequence(query, tolerance, 1.0),
      "phi is not divided by the speed, so t grows by a length: add phi/|v|");
  add(sequence(query, tolerance, query.particle.velocity.norm()),
      "the speed is that of all three axes: use the speed in the yz-plane");
  add(sequence(bare, tolerance, speed), "the particle's radius is forgotten: use R + r, not R");
  add(sequence(query, tolerance * rho(query), speed),
      "the tolerance is multiplied by R + r: compare phi with the tolerance itself");
  add(sequence(query, tolerance * query.cylinder.radius, speed),
      "the tolerance is multiplied by R: compare phi with the tolerance itself");
  add(sequence(query, tolerance, speed, Gap::squares),
      "the gap is a difference of squares: subtract R + r from the distance itself");
  const std::string not_counted =
      "the last evaluation, or the first, is not counted: count every evaluation of the gap";
  all.push_back({right.time, right.evaluations - 1, not_counted});
  if (!right.time.seconds) all.push_back({right.time, right.evaluations, not_counted});
  all.push_back({right.time, right.evaluations + 1,
                 "one evaluation is counted too many: begin at 0 and count once for each gap"});
  if (query.dt == 0.0) all.push_back({{}, 0, "an arrival at dt is lost: stop only if t > dt"});
  if (!right.time.seconds) return all;
  for (const Time& time : {Time{}, right.time}) {  // a gap that comes out as 0 or less is one
    all.push_back({time, right.evaluations,
                   "a gap within the tolerance is taken for no impact: return the time t"});
  }
  for (const int more : {0, 1}) {
    all.push_back({{right.after},
                   right.evaluations + more,
                   "it steps once more after the gap is within the tolerance: return t before that "
                   "step"});
  }
  return all;
}

/// Returns what explains the answers to many queries, and is seen in one of them.
inline std::vector<WrongAdvance> explaining_advances(const Query& query, double tolerance) {
  std::vector<WrongAdvance> left = wrong_advances(query, tolerance);
  bool is_wrong_somewhere = false;
  int index = 0;
  for (const Query& other : plain_queries()) {
    const double coarse = ++index % 2 == 0 ? 1e-2 : 1e-5;
    const Sequence right = sequence(other, coarse, speed_of(other));
    if (speed_of(other) == 0.0 || right.closest < 1e-9) continue;
    const Advancement got = advanced(other, coarse);
    const auto fits = [&](const Time& time, int evaluations) {
      return got.iterations == evaluations && near_time(Time{got.time}, time);
    };
    const bool is_right = fits(right.time, right.evaluations);
    is_wrong_somewhere = is_wrong_somewhere || !is_right;
    const std::vector<WrongAdvance> theirs = wrong_advances(other, coarse);
    const bool is_cut = std::any_of(theirs.begin(), theirs.end(), [](const WrongAdvance& one) {
      return one.evaluations >= most_evaluations;
    });
    if (is_cut) continue;
    std::erase_if(left, [&](const WrongAdvance& one) {
      bool is_told = false;
      for (const WrongAdvance& their : theirs) {
        if (their.story != one.story) continue;
        is_told = true;
        if (fits(their.time, their.evaluations)) return false;
      }
      return is_told || !is_right;
    });
  }
  return is_wrong_somewhere ? left : std::vector<WrongAdvance>{};
}

/// Each story once, if it gives the answer here.
template <typename Value, typename Pick>
std::vector<Suspect<Value>> told_once(const std::vector<WrongAdvance>& all, const Value& got,
                                      const Pick& pick) {
  std::vector<Suspect<Value>> suspects;
  for (const WrongAdvance& one : all) {
    const Value value = pick(one);
    const auto same = std::find_if(suspects.begin(), suspects.end(),
                                   [&](const auto& other) { return other.story == one.story; });
    if (same == suspects.end()) {
      suspects.push_back({value, one.story});
    } else if (difference(got, value) < difference(got, same->value)) {
      same->value = value;
    }
  }
  return suspects;
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
                return told_once(explaining_advances(query, tolerance), Time{got.time},
                                 [](const WrongAdvance& one) { return one.time; });
              });
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
      .expect(static_cast<double>(got.iterations), static_cast<double>(wanted.evaluations),
              {0.0, "one for each evaluation of the gap, including the first and the last"}, [&] {
                if (speed == 0.0) return at_rest();
                return told_once(
                    explaining_advances(query, tolerance), static_cast<double>(got.iterations),
                    [](const WrongAdvance& one) { return static_cast<double>(one.evaluations); });
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

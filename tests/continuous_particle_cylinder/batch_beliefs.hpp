#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "beliefs.hpp"
#include "certified_beliefs.hpp"

/// Names what is wrong with the loop over a batch, and not with the time of one particle.
namespace tests {

using lab::continuous_particle_cylinder::MovingParticles;

inline void add(MovingParticles& particles, const Vec3& position, const Vec3& velocity) {
  particles.y.push_back(position.y());
  particles.z.push_back(position.z());
  particles.velocity_y.push_back(velocity.y());
  particles.velocity_z.push_back(velocity.z());
}

inline Time batch_time(double time) { return std::isinf(time) && time > 0.0 ? Time{} : Time{time}; }

/// The times of so many copies of one particle.
inline std::vector<Time> times_of_copies(const Query& query, std::size_t count) {
  MovingParticles particles;
  particles.radius = query.particle.radius;
  for (std::size_t i = 0; i < count; ++i) {
    add(particles, query.particle.position, query.particle.velocity);
  }
  const auto seconds =
      lab::continuous_particle_cylinder::times_of_impact(particles, query.cylinder, query.dt);
  std::vector<Time> times;
  for (const double time : seconds) times.push_back(batch_time(time));
  times.resize(count);
  return times;
}

/// The first of 16 copies: it is in a full block of any size, and it is neither the last one nor
/// next to it.
inline std::optional<double> time_in_batch(const Query& query) {
  return times_of_copies(query, 16).front().seconds;
}

/// Returns which particles of a batch are left out, if each other one is right.
inline std::string left_out_of_batch() {
  const Query hit = query({0, 10, 3}, {0, -2, 0}, 10.0);
  bool last = true, first = true, after_fours = true, after_eights = true;
  bool is_wrong_somewhere = false;
  for (std::size_t count = 2; count <= 19; ++count) {
    const std::vector<Time> times = times_of_copies(hit, count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_wrong = !near_time(times[i], Time{3.0});
      is_wrong_somewhere = is_wrong_somewhere || is_wrong;
      last = last && is_wrong == (i + 1 == count);
      first = first && is_wrong == (i == 0);
      after_fours = after_fours && is_wrong == (i >= count / 4 * 4);
      after_eights = after_eights && is_wrong == (i >= count / 8 * 8);
    }
  }
  if (!is_wrong_somewhere) return "";
  if (last) return "the last particle is left out: let the loop go to the end";
  if (first) return "the first particle is left out: let the loop begin at 0";
  if (after_fours || after_eights) {
    return "the particles after the last full block are left out: treat the rest one by one";
  }
  return "";
}

/// Returns a story if every plain particle is right among its copies, but not among others.
inline std::string mixed_in_batch() {
  MovingParticles particles;
  particles.radius = 1.0;
  std::vector<Query> queries;
  for (int i = 0; i < 16; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    queries.push_back(
        query({0, side * (10.0 + i), 0.25 * (i % 7)}, {0, -side * (2.0 + 0.25 * i), 0}, 5.0));
  }
  for (const Query& one : queries) add(particles, one.particle.position, one.particle.velocity);
  const auto seconds = lab::continuous_particle_cylinder::times_of_impact(particles, {4.0}, 5.0);
  bool is_mixed = false;
  for (std::size_t i = 0; i < queries.size() && i < seconds.size(); ++i) {
    const Time wanted = time_of(queries[i]);
    if (!near_time(Time{time_in_batch(queries[i])}, wanted)) return "";
    is_mixed = is_mixed || !near_time(batch_time(seconds[i]), wanted);
  }
  return is_mixed
             ? "the values of different particles are mixed: read all four arrays at the index "
               "of the time"
             : "";
}

/// What is believed of one particle of a batch.
inline TimeSuspects beliefs_of_batch(const Query& query) {
  TimeSuspects suspects = beliefs_of_cross_form(query);
  Query turned = query;
  std::swap(turned.particle.velocity.y(), turned.particle.velocity.z());
  suspects.push_back({time_of(turned), "velocity_y and velocity_z are swapped: v_y belongs to y"});
  Query swapped = query;
  std::swap(swapped.particle.position.z(), swapped.particle.velocity.y());
  suspects.push_back({time_of(swapped), "z and velocity_y are swapped: y and z are the place"});
  if (!time_of(query).seconds) {
    suspects.push_back({{-1.0},
                        "no impact is returned as -1, but infinity does that: return "
                        "infinity"});
    suspects.push_back({{query.dt}, "no impact is returned as dt: return infinity"});
    suspects.push_back({{0.0}, "no impact is returned as 0: return infinity"});
    suspects.push_back({{std::numeric_limits<double>::max()},
                        "no impact is returned as the largest double: return infinity"});
  }
  return suspects;
}

/// Returns the step whose times a batch returns, if that is not 4.3 and its times are not the same.
inline std::string other_step_in_batch() {
  namespace lab4 = lab::continuous_particle_cylinder;
  bool is_certified = true, is_cross_form = true, is_textbook = true;
  for (const Query& query : plain_queries()) {
    const auto& [particle, cylinder, dt] = query;
    const std::optional<double> got = time_in_batch(query);
    is_certified = is_certified && got == certified(query);
    is_cross_form = is_cross_form && got == lab4::time_of_impact(particle, cylinder, dt);
    is_textbook = is_textbook && got == lab4::time_of_impact_textbook(particle, cylinder, dt);
  }
  if (is_certified || is_cross_form == is_textbook) return "";
  return is_cross_form ? "the times are those of step 4.2: return those of 4.3"
                       : "the times are those of step 4.1: return those of 4.3";
}

/// Returns what names a mistake in the time of a particle of a batch.
inline TimeSuspects suspects_in_batch(const Query& query, const Time& got) {
  for (const std::string& story : {left_out_of_batch(), mixed_in_batch(), other_step_in_batch()}) {
    if (!story.empty()) return {{got, story}};
  }
  return explaining(time_in_batch, query, beliefs_of_batch);
}

/// Returns a story if NaN stands for no impact.
inline std::string nan_for_none() {
  bool is_nan = false;
  for (const Query& query : plain_queries()) {
    const Time got{time_in_batch(query)};
    const Time wanted = time_of(query);
    if (!near_time(got, wanted) && (wanted.seconds || is_finite(got))) return "";
    is_nan = is_nan || !is_finite(got);
  }
  return is_nan ? "no impact is returned as NaN: return infinity" : "";
}

}  // namespace tests

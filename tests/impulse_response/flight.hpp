#pragma once

#include "oracle.hpp"

/// Option 1 once more, with what can be wrong with it as switches. common::time_of_impact is
/// supplied and has a test of its own.
namespace tests {

enum class FlightFlaw {
  none,
  acts_at_the_end,
  flies_the_whole_step,
  old_velocity,
  drops_the_rest,
  projects_the_whole_step,
  never_stops,
  stops_late,
  flies_by_steps
};

inline const std::vector<std::pair<FlightFlaw, std::string>>& flight_flaws() {
  static const std::vector<std::pair<FlightFlaw, std::string>> all{
      {FlightFlaw::acts_at_the_end,
       "the time of impact is missed: the impulse acts at the end of the step"},
      {FlightFlaw::flies_the_whole_step,
       "time does not go on: after an impact the whole of dt is flown again"},
      {FlightFlaw::old_velocity, "the impulse is that of the flight's start, before gravity acted"},
      {FlightFlaw::drops_the_rest, "what is left of the step after the last impact is forgotten"},
      {FlightFlaw::projects_the_whole_step, "the step by projection takes dt, not what is left"},
      {FlightFlaw::never_stops, "max_impacts is not obeyed: bounces may never end"},
      {FlightFlaw::stops_late, "there is one impact more than max_impacts"},
      {FlightFlaw::flies_by_steps, "the flight is that of option 2: it is x + t v + t^2 g / 2"}};
  return all;
}

/// The end of a step, with the sum of its impulses.
struct FlightValue {
  StepValue step{};
  int impacts = 0;
  double projected = 0.0;
  double amplification = 1.0;  ///< how much larger errors of the start are at the end
};

inline FlightValue impact_step(StepInput in, int max_impacts, FlightFlaw flaw = FlightFlaw::none) {
  const double dt = in.dt;
  Particle& p = in.particle;
  FlightValue value;
  VecL impulses = VecL::Zero();
  double time = 0.0;
  int cap = flaw == FlightFlaw::never_stops ? 60 : max_impacts;
  if (flaw == FlightFlaw::stops_late) ++cap;
  bool bounces = true;
  while (bounces) {
    const auto [phi, n] = surface_at(in.obstacle, wide(p.position));
    if (phi <= 0 && n.dot(wide(p.velocity)) <= 0) break;
    const common::Flight flight{p.position, p.velocity, in.gravity};
    const double left = dt - time;
    const auto hit = time_of_impact(in.obstacle, flight, left);
    const bool at_the_end = flaw == FlightFlaw::acts_at_the_end;
    const Real t = wide(hit && !at_the_end ? *hit : left);
    const VecL x = wide(p.position);
    const VecL v = wide(p.velocity);
    const VecL a = wide(in.gravity);
    const Real half = flaw == FlightFlaw::flies_by_steps ? 1 : Real(0.5);
    p.position = narrow(x + t * v + half * t * t * a);
    p.velocity = narrow(v + t * a);
    if (hit) {
      const VecL there = surface_at(in.obstacle, wide(p.position)).normal;
      const VecL speed = flaw == FlightFlaw::old_velocity ? v : wide(p.velocity);
      const VecL j = particle_impulse(wide(p.mass), speed, there, in.material);
      const double size = p.velocity.norm() + dt * in.gravity.norm();
      value.amplification *= 2.0 + 4.0 * size / std::abs(narrow(there).dot(p.velocity));
      p.velocity = narrow(wide(p.velocity) + j / wide(p.mass));
      impulses += j;
      ++value.impacts;
      if (flaw != FlightFlaw::flies_the_whole_step) time += *hit;
    }
    if (!hit || at_the_end) {
      value.step = {p.position, p.velocity, narrow(impulses)};
      return value;
    }
    bounces = in.material.restitution > 0.0 && value.impacts < cap;
  }
  value.projected = dt - time;
  in.dt = value.projected;
  if (flaw == FlightFlaw::projects_the_whole_step) in.dt = dt;
  if (flaw == FlightFlaw::drops_the_rest) in.dt = 0.0;
  in.corrections = {};
  const StepValue end = projected_step(in);
  value.step = {end.position, end.velocity, narrow(impulses)};
  return value;
}

/// What the answer makes of it.
inline FlightValue impact_step_by_answer(const StepInput& in, int max_impacts) {
  const auto [particle, impacts, projected] = lab::impulse_response::step_to_impact(
      in.particle, in.obstacle, in.material, in.gravity, in.dt, max_impacts);
  common::Vec3 impulses = common::Vec3::Zero();
  for (const auto& impact : impacts) impulses += impact.impulse;
  return {{particle.position, particle.velocity, impulses},
          static_cast<int>(impacts.size()),
          projected,
          1.0};
}

/// Requires the answer to end where the oracle does, by as many impacts.
inline void expect_impact_step(const StepInput& in, int max_impacts, int index = 1, int count = 1) {
  const Trial trial =
      step_trial("step_to_impact", in, index, count).given("max_impacts", max_impacts);
  const FlightValue wanted = impact_step(in, max_impacts);
  const FlightValue got = impact_step_by_answer(in, max_impacts);
  const Particle& p = in.particle;
  const double size = p.position.norm() + p.velocity.norm() + in.gravity.norm() + 1.0;
  const Bound bound{128.0 * eps * std::max(1.0, p.mass) * size * wanted.amplification,
                    "rounding, and what each impact makes of it: where it comes slowly an error of "
                    "place is one of time"};
  std::vector<Suspect<double>> suspects_of_count;
  std::vector<Suspect<double>> suspects_of_rest;
  std::vector<Suspect<StepValue>> suspects_of_end;
  for (const auto& [flaw, story] : flight_flaws()) {
    const FlightValue wrong = impact_step(in, max_impacts, flaw);
    suspects_of_count.push_back({static_cast<double>(wrong.impacts), story});
    suspects_of_rest.push_back({wrong.projected, story});
    const bool shows = difference(wrong.projected, wanted.projected) > bound.value;
    if (!shows) suspects_of_end.push_back({wrong.step, story});
  }
  const Trial end = trial.of("the end of the step and the sum of its impulses");
  if (!is_finite(got.step)) end.expect(got.step, wanted.step, bound);
  trial.of("the number of impacts")
      .expect(static_cast<double>(got.impacts), static_cast<double>(wanted.impacts),
              {0.0, "they are counted"}, suspects_of_count);
  trial.of("how long was projected")
      .expect(got.projected, wanted.projected, bound, suspects_of_rest);
  end.expect(got.step, wanted.step, bound, suspects_of_end);
}

}  // namespace tests

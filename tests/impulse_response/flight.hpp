#pragma once

#include <utility>

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
  flies_by_steps,
  flies_the_rest,
  tells_no_rest,
  no_gravity,
  one_impact,
  no_last_flight,
  times_of_flights,
  no_mass,
  no_friction,
  little_is_none,
  slow_is_resting,
  never_rests,
  looks_ahead,
  old_normal,
  no_corrections,
  close_is_touching,
  projects_and_tells_the_whole_step,
  tells_the_whole_step
};

inline const std::vector<std::pair<FlightFlaw, std::string>>& flight_flaws() {
  static const std::vector<std::pair<FlightFlaw, std::string>> all{
      {FlightFlaw::acts_at_the_end,
       "the time of impact is missed, so the impulse acts at the end of the step: fly to the "
       "impact first"},
      {FlightFlaw::flies_the_whole_step,
       "time does not go on, so the whole of dt is flown again after an impact: add up the "
       "flights"},
      {FlightFlaw::old_velocity,
       "the impulse is that of the flight's start, before gravity acted: use the velocity at the "
       "impact"},
      {FlightFlaw::drops_the_rest,
       "the rest of the step after the last impact is forgotten: project it"},
      {FlightFlaw::projects_the_whole_step,
       "the step by projection takes dt: give it only the time that is left"},
      {FlightFlaw::never_stops,
       "max_impacts is not obeyed, so bounces may never end: stop after that many impacts"},
      {FlightFlaw::stops_late,
       "there is one impact more than max_impacts: stop after that many impacts"},
      {FlightFlaw::flies_by_steps, "the flight is that of option 2: use x + t v + t^2 g / 2"},
      {FlightFlaw::flies_the_rest,
       "the rest of the step after the last impact is flown: project it"},
      {FlightFlaw::tells_no_rest,
       "the rest of the step after the last impact is flown: project it"},
      {FlightFlaw::no_gravity,
       "gravity does not act in flight: use x + t v + t^2 g / 2 and v + t g"},
      {FlightFlaw::one_impact,
       "there is one impact only: go on until max_impacts or the end of the step"},
      {FlightFlaw::no_last_flight,
       "the flight after the last impact is left out: fly on until the step ends"},
      {FlightFlaw::times_of_flights,
       "times are counted from the last impact: count them from the start of the step"},
      {FlightFlaw::no_mass, "the impulse is added to the velocity without 1/m: divide it by m"},
      {FlightFlaw::no_friction, "the impulse is along the normal alone: add the friction j_t"},
      {FlightFlaw::little_is_none,
       "a small restitution is taken for zero: test only for exactly zero"},
      {FlightFlaw::slow_is_resting,
       "a particle that leaves slowly is taken for one that rests: it rests only if v_n <= 0"},
      {FlightFlaw::never_rests,
       "a particle that rests or slides at the start is not projected: project it from the start"},
      {FlightFlaw::looks_ahead,
       "the next impact is looked for in dt: look only in the time that is left"},
      {FlightFlaw::old_normal, "the normal is that of the flight's start: take it at the impact"},
      {FlightFlaw::no_corrections,
       "the rest of the step is projected without both corrections: make both"},
      {FlightFlaw::close_is_touching,
       "a particle close to the surface is taken for touching: it touches only if phi <= 0"},
      {FlightFlaw::projects_and_tells_the_whole_step,
       "the step by projection takes dt: give it only the time that is left"},
      {FlightFlaw::tells_the_whole_step, "`projected` is dt: set it to the time that was left"}};
  return all;
}

/// The end of a step, with the sum of its impulses.
struct FlightValue {
  StepValue step{};
  int impacts = 0;
  double projected = 0.0;
  double last = 0.0;           ///< when the last impact was [s]
  double amplification = 1.0;  ///< how much larger errors of the start are at the end
};

/// The impacts, which `in` has ended with, and the time that is left by projection.
inline FlightValue with_projection(FlightValue value, StepInput in, FlightFlaw flaw) {
  const double whole = std::exchange(in.dt, value.projected);
  const bool tells_all = flaw == FlightFlaw::projects_and_tells_the_whole_step;
  if (tells_all || flaw == FlightFlaw::tells_the_whole_step) value.projected = whole;
  if (tells_all || flaw == FlightFlaw::projects_the_whole_step) in.dt = whole;
  if (flaw == FlightFlaw::drops_the_rest) in.dt = 0.0;
  const bool corrects = flaw != FlightFlaw::no_corrections;
  in.corrections = {corrects, corrects};
  StepValue end = projected_step(in);
  if (flaw == FlightFlaw::flies_the_rest || flaw == FlightFlaw::tells_no_rest) {
    const common::Flight rest{in.particle.position, in.particle.velocity, in.gravity};
    end = {position_at(rest, in.dt), velocity_at(rest, in.dt), common::Vec3::Zero()};
    if (flaw == FlightFlaw::tells_no_rest) value.projected = 0.0;
  }
  value.step = {end.position, end.velocity, value.step.impulse};
  return value;
}

inline FlightValue impact_step(StepInput in, int max_impacts, FlightFlaw flaw = FlightFlaw::none) {
  const double dt = in.dt;
  Particle& p = in.particle;
  FlightValue value;
  VecL impulses = VecL::Zero();
  double time = 0.0;
  int cap = flaw == FlightFlaw::never_stops ? 60 : max_impacts;
  if (flaw == FlightFlaw::stops_late) ++cap;
  if (flaw == FlightFlaw::one_impact) cap = 1;
  const Real resting = flaw == FlightFlaw::slow_is_resting ? 1e-10L : 0;
  const double least = flaw == FlightFlaw::little_is_none ? 1e-2 : 0.0;
  if (flaw == FlightFlaw::no_friction) in.material.friction = 0.0;
  bool bounces = true;
  while (bounces) {
    const auto [phi, n] = surface_at(in.obstacle, wide(p.position));
    const Real touching = flaw == FlightFlaw::close_is_touching ? 1e-16L : 0;
    const bool rests = phi <= touching && n.dot(wide(p.velocity)) <= resting;
    if (rests && flaw != FlightFlaw::never_rests) break;
    const common::Vec3 gravity =
        flaw == FlightFlaw::no_gravity ? common::Vec3(common::Vec3::Zero()) : in.gravity;
    const common::Flight flight{p.position, p.velocity, gravity};
    const double left = dt - time;
    const auto hit =
        time_of_impact(in.obstacle, flight, flaw == FlightFlaw::looks_ahead ? dt : left);
    const bool at_the_end = flaw == FlightFlaw::acts_at_the_end;
    const Real t = wide(hit && !at_the_end ? *hit : left);
    const VecL x = wide(p.position);
    const VecL v = wide(p.velocity);
    const VecL a = wide(gravity);
    const Real half = flaw == FlightFlaw::flies_by_steps ? 1 : Real(0.5);
    if (!hit && flaw == FlightFlaw::no_last_flight) {
      value.step = {p.position, p.velocity, narrow(impulses)};
      return value;
    }
    p.position = narrow(x + t * v + half * t * t * a);
    p.velocity = narrow(v + t * a);
    if (!hit) {
      value.step = {p.position, p.velocity, narrow(impulses)};
      return value;
    }
    const VecL there =
        flaw == FlightFlaw::old_normal ? n : surface_at(in.obstacle, wide(p.position)).normal;
    const VecL speed = flaw == FlightFlaw::old_velocity ? v : wide(p.velocity);
    const VecL j = particle_impulse(wide(p.mass), speed, there, in.material);
    const double size = p.velocity.norm() + dt * in.gravity.norm();
    value.amplification *= 2.0 + 4.0 * size / std::abs(narrow(there).dot(p.velocity));
    p.velocity = narrow(wide(p.velocity) + j / (flaw == FlightFlaw::no_mass ? 1 : wide(p.mass)));
    impulses += j;
    ++value.impacts;
    const double flown = at_the_end ? left : *hit;
    value.last = flaw == FlightFlaw::times_of_flights ? flown : std::min(dt, time + flown);
    if (flaw != FlightFlaw::flies_the_whole_step)
      time = at_the_end ? dt : std::min(dt, time + flown);
    bounces = in.material.restitution > least && value.impacts < cap;
  }
  value.projected = dt - time;
  value.step.impulse = narrow(impulses);
  return with_projection(value, in, flaw);
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
          impacts.empty() ? 0.0 : impacts.back().time,
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
                    "rounding, and what each impact makes of it: in a slow approach an error in "
                    "place becomes one in time"};
  const Trial end = trial.of("the end of the step and the sum of its impulses");
  if (!is_finite(got.step)) end.expect(got.step, wanted.step, bound);
  trial.of("the number of impacts")
      .expect(static_cast<double>(got.impacts), static_cast<double>(wanted.impacts),
              {0.0, "a count must be exact"});
  trial.of("the time that was projected").expect(got.projected, wanted.projected, bound);
  end.expect(got.step, wanted.step, bound);
}

}  // namespace tests

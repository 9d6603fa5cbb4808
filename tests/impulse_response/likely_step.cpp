// What students get wrong in step 6.4.
#include "fingerprint.hpp"
#include "flight.hpp"

namespace tests {
namespace {

using common::Vec3;

const common::Plane floor_below{};
const common::Cylinder pipe{1.5};

/// Found inside and in flight, clamped and not, parting, each correction alone.
std::vector<StepInput> projection_inputs() {
  const Vec3 g(0.0, 0.0, -8.0);
  const Particle falling{2.0, {0.0, 0.0, 0.5}, {3.0, 1.0, -4.0}};
  const Particle parting{1.5, {0.0, 0.0, -0.5}, {2.0, 1.0, 3.0}};
  const Particle beside{3.0, {0.2, 0.6, 1.45}, {0.5, 1.0, -3.0}};
  return {{falling, floor_below, {0.5, 0.25}, g, 0.25, {}},
          {beside, pipe, {0.25, 0.5}, {1.0, 0.0, -9.0}, 0.125, {}},
          {parting, floor_below, {0.5, 0.25}, g, 0.0625, {}},
          {{2.5, {0.0, 0.0, 2.0}, {1.0, 2.0, 3.0}}, floor_below, {0.5, 0.25}, g, 0.25, {}},
          {falling, floor_below, {0.5, 0.25}, g, 0.25, {true, false}},
          {falling, floor_below, {0.5, 0.25}, g, 0.25, {false, true}},
          {{2.0, {0.0, 0.0, 0.5}, {0.5, 0.25, -4.0}}, floor_below, {0.5, 0.75}, g, 0.25, {}},
          {{2.0, {0.0, 0.0, -1e-20}, {3.0, 1.0, -4.0}}, floor_below, {0.5, 0.25}, g, 0.0, {}},
          {{2.0, {0.0, 0.0, 1e-20}, {3.0, 1.0, -4.0}}, floor_below, {0.5, 0.25}, g, 0.0, {}}};
}

std::vector<Mistake<StepInput, StepValue>> projection_mistakes() {
  std::vector<Mistake<StepInput, StepValue>> all;
  for (const auto& [flaw, story] : flaws()) {
    all.push_back(returns<StepInput, StepValue>(
        story, [f = flaw](const StepInput& in) { return projected_step(in, f); }));
  }
  return all;
}

struct FlightInput {
  StepInput in;
  int max_impacts;
};

/// Bounces that end in flight, by the cap and by e = 0; a start at rest; no obstacle within reach;
/// a restitution that is small.
std::vector<FlightInput> flight_inputs() {
  const Vec3 g(0.0, 0.0, -10.0);
  const Particle thrown{2.0, {0.0, 0.0, 1.25}, {3.0, 0.5, -7.5}};
  const Particle dropped{2.0, {0.0, 0.0, 5.0}, {3.0, 0.5, 0.0}};
  const Particle resting{2.0, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const Particle slow{2.0, {0.0, 0.0, 0.0}, {1.0, 0.0, 1e-14}};
  const Particle close{2.0, {0.0, 0.0, 1e-20}, {1.0, 0.5, -1.0}};
  const Particle leaving{1.5, {0.0, 0.0, 3.0}, {1.0, 1.0, 1.0}};
  const Particle above_pipe{3.0, {0.0, 0.3, 2.0}, {0.25, 0.125, -4.0}};
  const Material rough{0.5, 0.125};
  return {{{thrown, floor_below, rough, g, 0.4, {}}, 4},
          {{dropped, floor_below, rough, g, 2.6, {}}, 10},
          {{dropped, floor_below, rough, g, 2.6, {}}, 1},
          {{thrown, floor_below, {0.0, 0.125}, g, 0.4, {}}, 10},
          {{resting, floor_below, rough, g, 0.5, {}}, 10},
          {{above_pipe, pipe, {0.6, 0.25}, {1.0, 0.0, -9.0}, 0.3, {}}, 10},
          {{leaving, floor_below, rough, g, 0.5, {}}, 10},
          {{dropped, floor_below, {1e-13, 0.125}, g, 1.5, {}}, 2},
          {{close, floor_below, rough, g, 0.05, {}}, 4},
          {{slow, floor_below, rough, g, 0.5, {}}, 3}};
}

/// Rounding decides how often it hits: the impulse of the speed from before gravity acted does not
/// turn it round, or without a cap what comes back falls below rounding.
bool is_chance(const FlightInput& c, FlightFlaw flaw) {
  if (flaw == FlightFlaw::old_velocity) return c.in.particle.velocity.z() > -4.0;
  return flaw == FlightFlaw::never_stops && c.in.material.restitution < 1e-3 &&
         c.in.material.restitution > 0.0;
}

std::vector<Mistake<FlightInput, FlightValue>> flight_mistakes() {
  std::vector<Mistake<FlightInput, FlightValue>> all;
  for (const auto& [flaw, story] : flight_flaws()) {
    all.push_back({story, [f = flaw](const FlightInput& c, const FlightValue& got) {
                     if (is_chance(c, f)) return true;
                     const FlightValue wrong = impact_step(c.in, c.max_impacts, f);
                     return got.impacts == wrong.impacts && near(got.step, wrong.step) &&
                            std::abs(got.projected - wrong.projected) <= 1e-9 &&
                            (f == FlightFlaw::flies_the_whole_step ||
                             std::abs(got.last - wrong.last) <= 1e-9);
                   }});
  }
  return all;
}

}  // namespace

std::string likely_of_step_by_projection() {
  return fingerprint(projection_inputs(), projected_by_answer, projection_mistakes());
}

std::string likely_of_step_to_impact() {
  return fingerprint(
      flight_inputs(),
      [](const FlightInput& c) { return impact_step_by_answer(c.in, c.max_impacts); },
      flight_mistakes());
}

}  // namespace tests

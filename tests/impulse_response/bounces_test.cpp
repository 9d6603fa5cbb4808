// Where option 1 fails, in closed form: bounces without end in finite time.
#include "catch.hpp"
#include "flight.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::StepInput;
using tests::Trial;

namespace {

constexpr double g = 9.81;

StepInput dropped(double height, double restitution, double dt) {
  StepInput in;
  in.particle.position.z() = height;
  in.obstacle = common::Plane{};
  in.material.restitution = restitution;
  in.gravity = Vec3(0.0, 0.0, -g);
  in.dt = dt;
  return in;
}

}  // namespace

TEST_CASE("Twenty bounces have the heights e to the power 2n", "[6.4]") {
  // Errors are relative to the flight they arise in: each adds some 40 eps of its height, and e⁻²
  // times that where it ends. With 16 steps and 20 bounces that is 9e-13 at most, for e = 0.5.
  int index = 0;
  for (const double e : {0.5, 0.9, 1.0}) {
    double flights = 1.0 + std::pow(e, 20);  // until the middle of the twentieth bounce
    for (int k = 1; k < 20; ++k) flights += 2.0 * std::pow(e, k);
    StepInput in = dropped(1.0, e, std::sqrt(2.0 / g) * flights / 16.0);
    int bounces = 0;
    for (int i = 1; i <= 16; ++i) {
      const StepInput before = in;
      const ImpactStep step =
          step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 100);
      in.particle = step.particle;
      bounces += static_cast<int>(step.impacts.size());
      const double speed = in.particle.velocity.norm();
      tests::step_trial("step_to_impact", before, ++index, 48)
          .given("bounces so far", bounces)
          .of("the height of the bounce over e^(2n)")
          .expect((in.particle.position.z() + 0.5 * speed * speed / g) / std::pow(e, 2 * bounces),
                  1.0, {1e-12, "rounding of the flights so far"});
    }
    tests::step_trial("step_to_impact", in)
        .of("the number of bounces")
        .expect(static_cast<double>(bounces), 20.0, {0.0, "a count must be exact"});
  }
}

TEST_CASE("Bounces accumulate at the rest time and max_impacts ends them", "[6.4]") {
  // v/g passes to the first impact and 2 v eᵏ/g from the k-th to the next: the n-th is 2 v eⁿ/(g (1
  // − e)) before the rest time v (1 + e)/(g (1 − e)), both counted from the drop.
  int index = 0;
  for (const double e : {0.5, 0.75}) {
    const double v = std::sqrt(2.0 * g * 1.0);
    const double rest = v * (1.0 + e) / (g * (1.0 - e));
    for (const int cap : {1, 2, 5, 10, 20, 40}) {
      const StepInput in = dropped(1.0, e, 1.1 * rest);
      const ImpactStep step =
          step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, cap);
      const Trial trial =
          tests::step_trial("step_to_impact", in, ++index, 12).given("max_impacts", cap);
      const double last = step.impacts.empty() ? 0.0 : step.impacts.back().time;
      const tests::Bound bound{16.0 * eps * rest * (cap + 1.0), "a sum of as many flights"};
      const double left = 2.0 * v * std::pow(e, cap) / (g * (1.0 - e));
      trial.of("the last impact before the rest time").expect(rest - last, left, bound);
      trial.of("the number of impacts")
          .expect(static_cast<double>(step.impacts.size()), static_cast<double>(cap),
                  {0.0, "a count must be exact"});
      trial.of("the time that was projected").expect(step.projected, in.dt - last, bound);
    }
  }
}

TEST_CASE("Bounces go on shortly before the rest time and are over shortly after it", "[6.4]") {
  const double e = 0.5;
  const double v = std::sqrt(2.0 * g * 1.0);
  const double rest = v * (1.0 + e) / (g * (1.0 - e));
  int index = 0;
  for (const double share : {0.9, 1.1}) {
    const StepInput in = dropped(1.0, e, share * rest);
    const ImpactStep step =
        step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 12);
    // At 0.9 what is left is 0.1 of the rest time: 2 eⁿ/(1 + e) of it passes after the n-th impact,
    // which is 0.083 of it at n = 4.
    tests::step_trial("step_to_impact", in, ++index, 2)
        .given("max_impacts", 12)
        .of("the time that was projected")
        .expect(step.projected,
                share < 1.0 ? 0.0 : 0.1 * rest + 2.0 * v * std::pow(e, 12) / (g * (1.0 - e)),
                {16.0 * eps * rest * 13.0, "a sum of as many flights"});
  }
}

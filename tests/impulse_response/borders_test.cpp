// What the contract still allows, and what happens on the border between two rules.
#include "bodies.hpp"
#include "catch.hpp"
#include "flight.hpp"
#include "likely.hpp"

using namespace lab::impulse_response;
using tests::StepInput;

namespace {

/// Of length one to less than the contract's 1e-9.
const Vec3 nearly_unit(0.0, 0.0, 1.0 + 4e-10);
const tests::Bound of_a_length{2e-8, "the length of a normal is one up to 1e-9"};

}  // namespace

TEST_CASE("A normal of length one up to rounding is accepted", "[6.1]") {
  tests::trial_of("6.1 normal_impulse")
      .given("normal", nearly_unit)
      .expect(normal_impulse(3.0, Vec3(4.0, 5.0, -2.0), nearly_unit, 0.5), 9.0, of_a_length);
}

TEST_CASE("A friction above one and a rounded normal are accepted", "[6.2]") {
  tests::trial_of("6.2 friction_impulse")
      .given("normal", nearly_unit)
      .given("friction", 1.5)
      .expect(friction_impulse(2.0, Vec3(8.0, 0.0, -1.0), nearly_unit, 4.0, 1.5),
              Vec3(-6.0, 0.0, 0.0), of_a_length);
}

TEST_CASE("Corrections accept a friction above one and a rounded normal", "[6.3]") {
  tests::trial_of("6.3 normal_correction")
      .given("normal", nearly_unit)
      .expect(normal_correction(-2.0, nearly_unit), Vec3(0.0, 0.0, 2.0), of_a_length);
  tests::trial_of("6.3 tangential_correction")
      .given("normal", nearly_unit)
      .given("friction", 1.5)
      .expect(tangential_correction(Vec3(8.0, 0.0, -1.0), nearly_unit, 2.0, 1.5),
              Vec3(-3.0, 0.0, 0.0), of_a_length);
}

TEST_CASE("Even a very short slip is moved back", "[6.3]") {
  int index = 0;
  for (const double way : {1e-3, 1e-9, 1e-12, 1e-15, 1e-100}) {
    tests::trial_of("6.3 tangential_correction", ++index, 5)
        .given("displacement", Vec3(way, 0.0, 0.0))
        .expect(tangential_correction(Vec3(way, 0.0, 0.0), Vec3::UnitZ(), 1.0, 0.5),
                Vec3(-way, 0.0, 0.0), {16.0 * tests::eps * way, "a length and a quotient"});
  }
}

TEST_CASE("A particle keeps its mass", "[6.4]") {
  StepInput in;
  in.particle = {3.0, Vec3(0.0, 0.0, 0.05), Vec3(1.0, 0.0, -1.0)};
  tests::step_trial("step_by_projection", in)
      .of("the particle's mass")
      .expect(step_by_projection(in.particle, in.obstacle, in.material, in.gravity, in.dt)
                  .particle.mass,
              3.0, {0.0, "nothing changes it"});
  tests::step_trial("step_to_impact", in)
      .of("the particle's mass")
      .expect(
          step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 4).particle.mass,
          3.0, {0.0, "nothing changes it"});
}

TEST_CASE("A step that ends on the surface has no impulse", "[6.4]") {
  StepInput in;
  in.particle = {1.0, Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -4.0)};
  in.dt = 0.25;
  tests::step_trial("step_by_projection", in)
      .expect(tests::projected_by_answer(in), {Vec3::Zero(), in.particle.velocity, Vec3::Zero()},
              {0.0, "small powers of two; only a particle with phi < 0 is changed"});
}

TEST_CASE("A particle that comes down from just above the surface has an impact", "[6.4]") {
  StepInput in;
  in.particle = {1.0, Vec3(0.0, 0.0, 0x1p-40), Vec3(0.0, 0.0, -1.0)};
  in.material.restitution = 0.5;
  tests::expect_impact_step(in, 4);
}

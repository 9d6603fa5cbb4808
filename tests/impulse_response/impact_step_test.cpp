#include <limits>

#include "catch.hpp"
#include "flight.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::StepInput;
using tests::Trial;

namespace {

/// 1.25 above the ground, g = 10: it arrives at 5 after half a second.
StepInput worked_by_hand() {
  return {{2.0, Vec3(0.0, 0.0, 1.25), Vec3(3.0, 0.0, 0.0)},
          common::Plane{},
          {0.5, 0.125},
          Vec3(0.0, 0.0, -10.0),
          0.75,
          {}};
}

/// Above an obstacle, pulled towards it, within reach of a few bounces.
StepInput random_input(tests::Random& random, int index) {
  StepInput in;
  const Vec3 n = random.direction();
  in.obstacle = common::Plane{random.vector(), n};
  in.particle.position = std::get<common::Plane>(in.obstacle).point;
  if (index % 2 == 0) {
    in.obstacle = common::Cylinder{1.5};
    const Vec3 out = tests::surface_at(in.obstacle, tests::wide(n)).normal.cast<double>();
    in.particle.position = 1.5 * out + random.uniform(-1.0, 1.0) * Vec3::UnitX();
  }
  const Vec3 out = outward_normal(in.obstacle, in.particle.position);
  in.particle.position += random.uniform(0.2, 0.6) * out;
  in.particle.mass = random.uniform(1.5, 4.0);
  in.particle.velocity = random.vector(0.6);
  in.particle.velocity -= random.uniform(0.5, 1.5) * out;
  in.material = {random.uniform(0.3, 0.9), random.uniform(0.1, 0.6)};
  in.gravity = random.vector(1.0);
  in.gravity -= random.uniform(6.0, 10.0) * out;
  in.dt = random.uniform(0.3, 0.6);
  return in;
}

}  // namespace

TEST_CASE("max_impacts may be the largest int", "[6.4]") {
  const StepInput in = worked_by_hand();
  const tests::StepValue wanted = tests::impact_step_by_answer(in, 4).step;
  constexpr int most = std::numeric_limits<int>::max();
  tests::step_trial("step_to_impact", in)
      .given("max_impacts", most)
      .of("the end of the step, compared with at most 4 impacts")
      .expect(tests::impact_step_by_answer(in, most).step, wanted,
              {0.0, "there is one impact in both"});
}

TEST_CASE("A bounce on rough ground loses more speed along than across", "[6.4]") {
  // j_n = 15, friction takes 1.25 · 15 / 2 of the 30 along.
  StepInput in = worked_by_hand();
  in.particle.velocity.x() = 30.0;
  in.material.friction = 1.25;
  const double along = 30.0 - 9.375;
  const tests::StepValue wanted{Vec3(15.0 + 0.25 * along, 0.0, 0.3125), Vec3(along, 0.0, 0.0),
                                Vec3(-18.75, 0.0, 15.0)};
  tests::step_trial("step_to_impact", in)
      .given("max_impacts", 4)
      .of("the end of the step and the sum of its impulses")
      .expect(tests::impact_step_by_answer(in, 4).step, wanted,
              {32.0 * eps * 30.0, "some 20 operations"});
}

TEST_CASE("One bounce within a step is worked by hand", "[6.4]") {
  // j_n = 1.5 · 2 · 5 = 15, friction takes 0.125 · 15 / 2 of the 3 along; a quarter second is left.
  const StepInput in = worked_by_hand();
  const double along = 3.0 - 0.9375;
  const tests::StepValue wanted{Vec3(1.5 + 0.25 * along, 0.0, 0.3125), Vec3(along, 0.0, 0.0),
                                Vec3(-1.875, 0.0, 15.0)};
  const ImpactStep step =
      step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 4);
  const Trial trial = tests::step_trial("step_to_impact", in).given("max_impacts", 4);
  trial.of("the end of the step and the sum of its impulses")
      .expect(tests::impact_step_by_answer(in, 4).step, wanted,
              {32.0 * eps * 15.0, "some 20 operations"});
  trial.of("the number of impacts")
      .expect(static_cast<double>(step.impacts.size()), 1.0, {0.0, "a count must be exact"});
  trial.of("the time of impact")
      .expect(step.impacts.front().time, 0.5,
              {4.0 * eps, "the same as from common::time_of_impact"});
}

TEST_CASE("A particle that is inside and moves away stays in place if dt is zero", "[6.4]") {
  StepInput in = worked_by_hand();
  in.particle.position.z() = -0.01;
  in.particle.velocity.z() = 1.0;
  in.dt = 0.0;
  tests::expect_impact_step(in, 5);
}

TEST_CASE("A flight that meets nothing is the parabola", "[6.4]") {
  tests::Random random(661);
  for (int i = 1; i <= 20; ++i) {
    StepInput in = random_input(random, i);
    in.particle.velocity = -4.0 * in.particle.velocity;
    in.dt = 0.1;
    tests::expect_impact_step(in, 5, i, 20);
  }
}

TEST_CASE("Option 1 flies to each impact in turn at any plane and cylinder", "[6.4]") {
  tests::Random random(662);
  int bounces = 0;
  for (int i = 1; i <= 60; ++i) {
    StepInput in = random_input(random, i);
    while (tests::impact_step(in, 40).impacts > 3) in.dt *= 0.75;  // each multiplies rounding
    tests::expect_impact_step(in, 40, i, 60);
    bounces += tests::impact_step(in, 40).impacts;
  }
  REQUIRE(bounces > 40);
}

TEST_CASE("After the last allowed impact the rest of the step is projected", "[6.4]") {
  tests::Random random(663);
  for (int i = 1; i <= 40; ++i) {
    StepInput in = random_input(random, i);
    in.dt = 1.0;
    tests::expect_impact_step(in, 1 + i % 2, i, 40);
  }
}

TEST_CASE("After an impact without restitution the rest of the step is projected", "[6.4]") {
  tests::Random random(664);
  for (int i = 1; i <= 40; ++i) {
    StepInput in = random_input(random, i);
    in.material.restitution = 0.0;
    tests::expect_impact_step(in, 9, i, 40);
  }
}

TEST_CASE("A particle that touches and does not move away is projected from the start", "[6.4]") {
  StepInput in = worked_by_hand();
  int index = 0;
  for (const double height : {0.0, -0.5}) {
    for (const double speed : {0.0, -1.0}) {
      in.particle.position.z() = height;
      in.particle.velocity.z() = speed;
      tests::expect_impact_step(in, 9, ++index, 4);
    }
  }
}

TEST_CASE("A particle that touches and moves away flies until it comes back", "[6.4]") {
  StepInput in = worked_by_hand();
  in.particle.position.z() = 0.0;
  in.particle.velocity.z() = 2.5;  // back after half a second
  tests::expect_impact_step(in, 9, 1, 3);
  in.dt = 0.4375;
  tests::expect_impact_step(in, 9, 2, 3);
  in.particle.position.z() = -0.2;  // leaves within a tenth of a second
  in.dt = 0.75;
  tests::expect_impact_step(in, 9, 3, 3);
}

TEST_CASE("A particle that leaves the ground very slowly flies and comes back", "[6.4]") {
  // Touching at a speed that is not above zero it is projected at once, above zero it bounces.
  StepInput in = worked_by_hand();
  in.particle.position.z() = 0.0;
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15}) {
    for (const double side : {-1.0, 1.0}) {
      in.particle.velocity.z() = side * speed;
      tests::expect_impact_step(in, 3, ++index, 8);
    }
  }
}

TEST_CASE("With a very small restitution it bounces until max_impacts", "[6.4]") {
  // It arrives at 5, and at 5 e to the k after k bounces; what is left of the step it lies.
  StepInput in = worked_by_hand();
  in.dt = 1.5;
  in.material.friction = 0.0;
  int index = 0;
  for (const double e : {1e-2, 1e-3, 5e-4, 1e-6, 1e-9, 1e-12}) {
    in.material.restitution = e;
    const ImpactStep step =
        step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 5);
    const Trial trial = tests::step_trial("step_to_impact", in, ++index, 6).given("max_impacts", 5);
    trial.of("the place")
        .expect(step.particle.position, Vec3(4.5, 0.0, 0.0),
                {64.0 * eps * 4.5, "a sum of six flights"});
    trial.of("the number of impacts")
        .expect(static_cast<double>(step.impacts.size()), 5.0, {0.0, "only e = 0 ends them"});
  }
}

TEST_CASE("Impacts come in order of time within the step and it ends outside", "[6.4]") {
  tests::Random random(665);
  for (int i = 1; i <= 40; ++i) {
    const StepInput in = random_input(random, i);
    const ImpactStep step =
        step_to_impact(in.particle, in.obstacle, in.material, in.gravity, in.dt, 40);
    const Trial trial = tests::step_trial("step_to_impact", in, i, 40).given("max_impacts", 40);
    trial.expect_small("-gap at the end", -gap(in.obstacle, step.particle.position),
                       {64.0 * eps * (1.0 + in.particle.position.norm()), "rounding"});
    double last = 0.0;
    for (const Impact& impact : step.impacts) {
      const double before = last;
      last = impact.time;
      trial.of("the time of an impact before the one before it")
          .expect_small("lateness", before - impact.time, {0.0, "impacts are in order of time"});
      trial.of("the time of an impact beyond the step")
          .expect_small("lateness", impact.time - in.dt, {4.0 * eps, "a sum of times"});
    }
  }
}

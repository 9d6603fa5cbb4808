#include "catch.hpp"
#include "oracle.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::StepInput;
using tests::StepValue;
using tests::Trial;

namespace {

Trial projection_trial(const StepInput& in, int index, int count) {
  const std::string normal = in.corrections.normal ? "true" : "false";
  const std::string both = normal + (in.corrections.tangential ? ", true" : ", false");
  return tests::step_trial("step_by_projection", in, index, count)
      .given("corrections", tests::Code{"Corrections{" + both + "}"});
}

tests::Bound rounding(const StepInput& in) {
  const Particle& p = in.particle;
  const double size = p.position.norm() + p.velocity.norm() + in.gravity.norm() + 1.0;
  return {128.0 * eps * std::max(1.0, p.mass) * size,
          "some 60 operations on terms no larger than the sum of all lengths"};
}

void expect_step(const StepInput& in, const tests::Bound& bound, int index = 1, int count = 1) {
  projection_trial(in, index, count)
      .expect(tests::projected_by_answer(in), tests::projected_step(in), bound);
}

/// Above an obstacle by `height` and going down by about a metre a second.
StepInput random_input(tests::Random& random, int index, double height) {
  StepInput in;
  const Vec3 n = random.direction();
  in.obstacle = common::Plane{random.vector(), n};
  in.particle.position = std::get<common::Plane>(in.obstacle).point + height * n;
  if (index % 2 == 0) {
    in.obstacle = common::Cylinder{random.uniform(0.5, 2.0)};
    const double R = std::get<common::Cylinder>(in.obstacle).radius;
    const Vec3 out = tests::surface_at(in.obstacle, tests::wide(n)).normal.cast<double>();
    in.particle.position = (R + height) * out + random.uniform(-1.0, 1.0) * Vec3::UnitX();
  }
  const Vec3 out = outward_normal(in.obstacle, in.particle.position);
  in.particle.mass = random.uniform(1.5, 4.0);
  in.particle.velocity = random.vector(0.8);
  in.particle.velocity -= random.uniform(1.0, 2.0) * out;
  in.material = {random.uniform(0.1, 0.9), random.uniform(0.1, 0.6)};
  in.gravity = random.vector(4.0) - 2.0 * out;
  in.dt = random.uniform(0.05, 0.2);
  return in;
}

/// m = 2 comes down at 6 after gravity, and ends 1 deep: j_n = 18, mu j_n = 4.5, d_t = 0.75.
StepInput projection_by_hand() {
  return {{2.0, Vec3(0.0, 0.0, 0.5), Vec3(3.0, 0.0, -4.0)},
          common::Plane{},
          {0.5, 0.25},
          Vec3(0.0, 0.0, -8.0),
          0.25,
          {}};
}

const tests::Bound exact_fractions{4.0 * eps, "small fractions of powers of two"};

}  // namespace

TEST_CASE("A step into the ground is worked by hand", "[6.4]") {
  const StepInput in = projection_by_hand();
  const StepValue wanted{Vec3(0.5, 0.0, 0.0), Vec3(0.75, 0.0, 3.0), Vec3(-4.5, 0.0, 18.0)};
  projection_trial(in, 1, 1).expect(tests::projected_by_answer(in), wanted, exact_fractions);
}

TEST_CASE("On rough ground the friction may exceed the normal impulse", "[6.4]") {
  // mu j_n = 27 of 60, and 1.5 of a way of 7.5.
  StepInput in = projection_by_hand();
  in.particle.velocity.x() = 30.0;
  in.material.friction = 1.5;
  const StepValue wanted{Vec3(6.0, 0.0, 0.0), Vec3(16.5, 0.0, 3.0), Vec3(-27.0, 0.0, 18.0)};
  projection_trial(in, 1, 1).expect(tests::projected_by_answer(in), wanted,
                                    {8.0 * eps * 30.0, "small fractions, a length of 30"});
}

TEST_CASE("In flight velocity comes before position and nothing else happens", "[6.4]") {
  tests::Random random(651);
  for (int i = 1; i <= 20; ++i) {
    StepInput in = random_input(random, i, 1.5);
    expect_step(in, rounding(in), i, 20);
  }
}

TEST_CASE("A step by projection follows its equations at any plane and cylinder", "[6.4]") {
  tests::Random random(652);
  int contacts = 0;
  for (int i = 1; i <= 200; ++i) {
    const StepInput in = random_input(random, i, random.uniform(0.0, 0.15));
    expect_step(in, rounding(in), i, 200);
    contacts += tests::projected_step(in).impulse.norm() > 0.0 ? 1 : 0;
  }
  REQUIRE(contacts > 60);
  REQUIRE(contacts < 198);
}

TEST_CASE("Each correction is made if it is asked for and only then", "[6.4]") {
  tests::Random random(653);
  int index = 0;
  for (const bool normal : {false, true}) {
    for (const bool tangential : {false, true}) {
      for (int i = 1; i <= 10; ++i) {
        StepInput in = random_input(random, i, 0.0);
        in.corrections = {normal, tangential};
        expect_step(in, rounding(in), ++index, 40);
      }
    }
  }
}

TEST_CASE("A particle inside that moves away gets no impulse but is moved out", "[6.4]") {
  tests::Random random(654);
  for (int i = 1; i <= 40; ++i) {
    StepInput in = random_input(random, i, -0.3);
    in.particle.velocity = -in.particle.velocity;
    in.dt = 0.05;
    expect_step(in, rounding(in), i, 40);
  }
}

TEST_CASE("Without time a particle inside is moved out and its approach is stopped", "[6.4]") {
  StepInput in = projection_by_hand();
  in.dt = 0.0;
  expect_step(in, exact_fractions, 1, 2);
  in.particle.position.z() = -0.5;
  expect_step(in, exact_fractions, 2, 2);
}

TEST_CASE("A particle that is hardly inside gets an impulse and one hardly outside does not",
          "[6.4]") {
  int index = 0;
  for (const double height : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    for (const double side : {-1.0, 1.0}) {
      StepInput in = projection_by_hand();
      in.dt = 0.0;
      in.particle.position.z() = side * height;
      expect_step(in, {16.0 * eps * 20.0, "some 20 operations on terms of 20 or less"}, ++index,
                  10);
    }
  }
}

TEST_CASE("Inside even a very slow approach gets an impulse and a slow departure does not",
          "[6.4]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    for (const double side : {-1.0, 1.0}) {
      StepInput in = projection_by_hand();
      in.dt = 0.0;
      in.particle.position.z() = -0.5;  // moved to zero, exactly
      in.particle.velocity = Vec3(speed, 0.0, side * speed);
      expect_step(in, {16.0 * eps * 4.0 * speed, "some 20 operations"}, ++index, 10);
    }
  }
}

TEST_CASE("Gap and impulse are never below zero and one of them is zero", "[6.4]") {
  tests::Random random(655);
  int impulses = 0;
  for (int i = 1; i <= 100; ++i) {
    StepInput in = random_input(random, i, random.uniform(0.0, 0.15));
    in.corrections.tangential = false;  // it leaves a cylinder along its tangent
    const StepValue got = tests::projected_by_answer(in);
    const double lambda = outward_normal(in.obstacle, got.position).dot(got.impulse);
    const double residual = std::min(gap(in.obstacle, got.position), lambda);
    projection_trial(in, i, 100)
        .expect_small("|min(phi, lambda)|", std::abs(residual), rounding(in));
    impulses += lambda > 0.0 ? 1 : 0;
  }
  projection_trial(projection_by_hand(), 1, 1)
      .expect_small("30 minus the number of 100 particles that hit", 30.0 - impulses,
                    {0.0, "most particles come down"});
}

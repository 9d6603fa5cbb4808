// At the ends of the range of sizes that the contract states: 1e-100 and 1e100.
#include <array>

#include "bodies.hpp"
#include "catch.hpp"
#include "flight.hpp"
#include "particle_cases.hpp"

using namespace lab::impulse_response;
using tests::eps;

namespace {

constexpr double least = 1e-100;
constexpr double most = 1e100;

}  // namespace

TEST_CASE("The normal impulse is right for the smallest and largest numbers", "[6.1]") {
  int index = 0;
  for (const auto& [mass, speed] : {std::pair{most, 0.5},
                                    {most, least},
                                    {0.5, most},
                                    {1.0, least},
                                    {least, 1.0},
                                    {least, most}}) {
    const tests::NormalCase c{mass, Vec3(0.0, 0.0, -speed), Vec3::UnitZ(), 0.5};
    tests::trial_of("6.1 normal_impulse", ++index, 6)
        .given("mass", mass)
        .given("velocity", c.velocity)
        .expect(normal_impulse(mass, c.velocity, c.normal, c.restitution), 1.5 * mass * speed,
                {4.0 * eps * mass * speed, "three factors"});
  }
}

TEST_CASE("Friction is right for the smallest and largest numbers", "[6.2]") {
  const Vec3 along(0.6, 0.8, 0.0);
  for (const double mass : {least, 1.0, most}) {
    for (const double momentum : {least, 1.0, most}) {  // |m v_t|
      for (const double cone : {least, 0.5, most}) {    // mu j_n, with either of them at an end
        if (std::abs(std::log10(momentum) - std::log10(mass)) > 100.5) continue;
        const double wanted = std::min(momentum, cone);
        for (const auto& [j_n, mu] : {std::pair{cone, 1.0}, {1.0, cone}}) {
          const Vec3 v = momentum / mass * along;
          tests::trial_of("6.2 friction_impulse")
              .given("mass", mass)
              .given("velocity", v)
              .given("normal", Vec3(Vec3::UnitZ()))
              .given("normal_impulse", j_n)
              .given("friction", mu)
              .expect(friction_impulse(mass, v, Vec3::UnitZ(), j_n, mu), Vec3(-wanted * along),
                      {16.0 * eps * wanted, "a root, a division and products"});
        }
      }
    }
  }
}

TEST_CASE("Corrections are right for the smallest and largest numbers", "[6.3]") {
  const Vec3 along(0.6, 0.8, 0.0);
  for (const double way : {least, 1.0, most}) {
    tests::trial_of("6.3 normal_correction")
        .given("gap", -way)
        .expect(normal_correction(-way, Vec3::UnitZ()), Vec3(0.0, 0.0, way),
                {2.0 * eps * way, "one product"});
    for (const double disc : {least, 0.5, most}) {  // mu d_n
      const double wanted = std::min(way, disc);
      for (const auto& [depth, mu] : {std::pair{disc, 1.0}, {1.0, disc}}) {
        tests::trial_of("6.3 tangential_correction")
            .given("displacement", Vec3(way * along))
            .given("normal", Vec3(Vec3::UnitZ()))
            .given("normal_length", depth)
            .given("friction", mu)
            .expect(tangential_correction(way * along, Vec3::UnitZ(), depth, mu),
                    Vec3(-wanted * along),
                    {16.0 * eps * wanted, "a root, a division and products"});
      }
    }
  }
}

TEST_CASE("A step by projection is right for the smallest and largest numbers", "[6.4]") {
  // The step of the handout with all lengths times `size`.
  int index = 0;
  for (const double size : {4.0 * least, 0.05 * most}) {
    tests::StepInput in;
    in.particle = {2.0, size * Vec3(0.0, 0.0, 0.5), size * Vec3(3.0, 0.0, -4.0)};
    in.obstacle = common::Plane{};
    in.material = {0.5, 0.25};
    in.gravity = size * Vec3(0.0, 0.0, -8.0);
    in.dt = 0.25;
    const tests::StepValue wanted{size * Vec3(0.5, 0.0, 0.0), size * Vec3(0.75, 0.0, 3.0),
                                  size * Vec3(-4.5, 0.0, 18.0)};
    tests::step_trial("step_by_projection", in, ++index, 2)
        .expect(tests::projected_by_answer(in), wanted,
                {16.0 * eps * 20.0 * size, "some 20 operations on terms of 20 sizes or less"});
  }
}

TEST_CASE("A step to impact is right for the smallest and largest numbers", "[6.4]") {
  // 1.25 above the ground, g = 10: it arrives at 5 after half a second; all lengths times `size`.
  int index = 0;
  for (const double size : {8.0 * least, 0.05 * most}) {
    tests::StepInput in;
    in.particle = {2.0, size * Vec3(0.0, 0.0, 1.25), size * Vec3(3.0, 0.0, 0.0)};
    in.obstacle = common::Plane{};
    in.material = {0.5, 0.125};
    in.gravity = size * Vec3(0.0, 0.0, -10.0);
    in.dt = 0.75;
    const tests::StepValue wanted{size * Vec3(2.015625, 0.0, 0.3125), size * Vec3(2.0625, 0.0, 0.0),
                                  size * Vec3(-1.875, 0.0, 15.0)};
    tests::step_trial("step_to_impact", in, ++index, 2)
        .given("max_impacts", 4)
        .expect(tests::impact_step_by_answer(in, 4).step, wanted,
                {32.0 * eps * 15.0 * size, "some 20 operations"});
  }
}

TEST_CASE("A contact is right for the smallest and largest numbers", "[6.5]") {
  // The rod of the handout sticks: j = (-15, 0, 57)/16. K goes with `yields`, and j with the
  // velocity over it; lever arms go with `length`, and inertias with its square.
  int index = 0;
  for (const auto& [yields, speed, length] : {std::array{0.1 * most, 1.0, 1.0},
                                              {least, 0.1, 1.0},
                                              {1.0, 0.1 * most, 1.0},
                                              {1.0, least, 1.0},
                                              {0.1 * most, 0.1 * most, 1.0},
                                              {least, 10.0 * least, 1.0},
                                              {1.0, 1.0, 1e50},
                                              {1.0, 1.0, 1e-49}}) {
    tests::ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {0.5, 0.5}};
    in.b.inverse_mass = yields;
    in.b.inverse_inertia = 1.5 * yields / length / length * Mat3::Identity();
    in.b.position = length * Vec3(-1.0, 0.0, 1.0);
    in.b.velocity = speed * Vec3(-3.0, 0.0, -5.0);
    const double size = speed / yields;
    tests::contact_trial(in, ++index, 8)
        .expect(contact_impulse(in.a, in.b, in.contact, in.material),
                Vec3(size * Vec3(-0.9375, 0.0, 3.5625)),
                {256.0 * eps * 4.0 * size, "a 3 x 3 system of condition 4"});
    in.material = {1.0, 0.0};
    tests::contact_trial(in, index, 8)
        .expect(contact_impulse(in.a, in.b, in.contact, in.material),
                Vec3(size * Vec3(0.0, 0.0, 4.0)),
                {256.0 * eps * 4.0 * size, "a 3 x 3 system of condition 4"});
  }
}

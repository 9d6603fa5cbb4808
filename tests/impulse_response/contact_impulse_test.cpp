#include "bodies.hpp"
#include "catch.hpp"

using namespace lab::impulse_response;
using tests::ContactInput;
using tests::eps;

namespace {

void expect_impulse(const ContactInput& in, const Vec3& wanted, const tests::Bound& bound,
                    int index = 1, int count = 1) {
  tests::contact_trial(in, index, count)
      .expect(contact_impulse(in.a, in.b, in.contact, in.material), wanted, bound);
}

/// As the oracle has it.
void expect_impulse(const ContactInput& in, int index, int count) {
  const tests::ContactOutcome outcome = tests::contact_outcome(in);
  const tests::Real size = outcome.impulse.norm() * outcome.amplification;
  expect_impulse(in, tests::narrow(outcome.impulse),
                 {128.0 * eps * static_cast<double>(size),
                  "rounding, multiplied by the condition of K and of the slip's direction"},
                 index, count);
}

/// A point mass of 2 that comes down on the ground at 3 and along it at 5.
ContactInput particle_on_ground(double restitution, double friction) {
  ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {restitution, friction}};
  in.b.inverse_mass = 0.5;
  in.b.velocity = Vec3(3.0, 4.0, -3.0);
  return in;
}

bool sticks(const ContactInput& in) { return tests::contact_outcome(in).sticks; }

}  // namespace

TEST_CASE("A head-on impact of 1 and 3 is worked by hand", "[6.5]") {
  // The reduced mass is 3/4 and they come together at 4: j = 1.5 · 3.
  ContactInput in{{}, {}, {Vec3(0.0, 0.0, 1.0), Vec3::UnitX()}, {0.5, 0.9}};
  in.b.inverse_mass = 1.0 / 3.0;
  in.a.position = Vec3(-1.0, 0.0, 1.0);
  in.b.position = Vec3(1.0, 0.0, 1.0);
  in.a.velocity = Vec3(3.0, 0.0, 0.0);
  in.b.velocity = Vec3(-1.0, 0.0, 0.0);
  expect_impulse(in, Vec3(4.5, 0.0, 0.0), {64.0 * eps * 4.5, "a 3 x 3 system, almost diagonal"});
}

TEST_CASE("A point mass that slips gets the largest impulse of the cone", "[6.5]") {
  // j_n = 1.5 · 2 · 3 = 9, and friction 0.5 · 9 along (3, 4)/5: less than 2 · 5.
  expect_impulse(particle_on_ground(0.5, 0.5), Vec3(-2.7, -3.6, 9.0),
                 {64.0 * eps * 9.0, "a 3 x 3 system"});
}

TEST_CASE("A point mass that slips little is stopped and not reversed", "[6.5]") {
  expect_impulse(particle_on_ground(0.5, 2.0), Vec3(-6.0, -8.0, 9.0),
                 {64.0 * eps * 14.0, "a 3 x 3 system"});
}

TEST_CASE("A ball that rolls in with the wrong spin is worked by hand", "[6.5]") {
  // 1/m = 1/2, 1/I = 4, r = (0, 0, -1): K = diag(4.5, 4.5, 0.5). The point slips at 9.
  ContactInput in = particle_on_ground(0.0, 1.0);
  in.b.inverse_inertia = 4.0 * Mat3::Identity();
  in.b.position = Vec3(0.0, 0.0, 1.0);
  in.b.velocity = Vec3(4.0, 0.0, -3.0);
  in.b.angular_velocity = Vec3(0.0, -5.0, 0.0);
  expect_impulse(in, Vec3(-2.0, 0.0, 6.0), {64.0 * eps * 7.0, "a 3 x 3 system"}, 1, 2);
  in.material.friction = 0.25;
  expect_impulse(in, Vec3(-1.5, 0.0, 6.0), {64.0 * eps * 7.0, "a 3 x 3 system"}, 2, 2);
}

TEST_CASE("The impulse is right for any two bodies", "[6.5]") {
  tests::Random random(681);
  int parting = 0;
  int sticking = 0;
  int slipping = 0;
  for (int i = 1; i <= 300; ++i) {
    const ContactInput in = tests::random_contact(random, i);
    expect_impulse(in, i, 300);
    const tests::ContactOutcome outcome = tests::contact_outcome(in);
    (outcome.impulse.norm() == 0 ? parting : (outcome.sticks ? sticking : slipping)) += 1;
  }
  REQUIRE(parting > 60);
  REQUIRE(sticking > 5);
  REQUIRE(slipping > 40);
}

TEST_CASE("If the cone is wide enough it sticks", "[6.5]") {
  tests::Random random(682);
  int count = 0;
  for (int i = 1; count < 40 && i <= 1000; ++i) {
    ContactInput in = tests::random_contact(random, i);
    in.material.friction = 4.0;
    if (!sticks(in)) continue;
    expect_impulse(in, ++count, 40);
    const Vec3 j = contact_impulse(in.a, in.b, in.contact, in.material);
    const tests::VecL after = tests::approach(in.a, in.b, in.contact.point) +
                              tests::mass_matrix(in.a, in.b, in.contact.point) * tests::wide(j);
    const tests::Real size =
        tests::contact_outcome(in).amplification * tests::wide(j.norm()) * 20.0L;
    tests::contact_trial(in, count, 40)
        .of("the slip after an impact that sticks")
        .expect(tests::narrow(tests::tangential(after, tests::wide(in.contact.normal))),
                Vec3(Vec3::Zero()),
                {128.0 * eps * static_cast<double>(size), "rounding; K is below 20"});
  }
}

TEST_CASE("If the ground is smooth it slips and the impulse is along the normal", "[6.5]") {
  tests::Random random(683);
  for (int i = 1; i <= 40; ++i) {
    ContactInput in = tests::random_contact(random, i);
    in.material.friction = i % 2 == 0 ? 0.0 : 0.01;
    expect_impulse(in, i, 40);
  }
}

TEST_CASE("A restitution of 0 or 1 is right for any two bodies", "[6.5]") {
  tests::Random random(684);
  for (int i = 1; i <= 60; ++i) {
    ContactInput in = tests::random_contact(random, i);
    in.material.restitution = i % 3 * 0.5;
    expect_impulse(in, i, 60);
  }
}

TEST_CASE("A body on a hinge can only turn", "[6.5]") {
  tests::Random random(657);
  for (int i = 1; i <= 20; ++i) {
    ContactInput in = tests::random_contact(random, i);
    in.material.restitution = i % 3 * 0.5;
    in.a.inverse_mass = i % 2 == 0 ? 0.0 : 1.0;
    in.b.inverse_mass = i % 2 == 0 ? 1.0 : 0.0;
    expect_impulse(in, i, 20);
  }
}

TEST_CASE("If the points move apart or rest there is no impulse", "[6.5]") {
  ContactInput in = particle_on_ground(0.5, 0.5);
  const tests::Bound none{0.0, "there is nothing to stop"};
  in.b.velocity.z() = 3.0;
  expect_impulse(in, Vec3::Zero(), none, 1, 4);
  in.b.velocity.z() = 0.0;
  expect_impulse(in, Vec3::Zero(), none, 2, 4);
  in.b.velocity.setZero();
  expect_impulse(in, Vec3::Zero(), none, 3, 4);
  // The rod of the handout slides on rough ground: an impulse that stops it would have a j_n.
  in.b = {1.0, 1.5 * Mat3::Identity(), Vec3(-1.0, 0.0, 1.0), Vec3(3.0, 0.0, 0.0), Vec3::Zero()};
  in.material.friction = 4.0;
  expect_impulse(in, Vec3::Zero(), none, 4, 4);
}

TEST_CASE("A straight hit is along the normal on ground of any friction", "[6.5]") {
  // A mass of 1 that comes down at 2 with its centre above the contact: no slip, so no direction.
  ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {0.5, 0.0}};
  in.b.position = Vec3(0.0, 0.0, 1.0);
  in.b.velocity = Vec3(0.0, 0.0, -2.0);
  int index = 0;
  for (const double mu : {0.0, 1e-12, 0.5, 4.0}) {
    in.material.friction = mu;
    expect_impulse(in, Vec3(0.0, 0.0, 3.0), {64.0 * eps * 3.0, "a 3 x 3 system"}, ++index, 4);
  }
}

TEST_CASE("A straight hit of two free bodies on smooth ground is along the normal", "[6.5]") {
  ContactInput in{{}, {}, {Vec3::Zero(), Vec3::UnitY()}, {1.0, 0.0}};
  in.a.position = Vec3(0.0, -2.0, 0.0);
  in.b.position = Vec3(0.0, 1.0, 0.0);
  in.b.velocity = Vec3(0.0, -3.0, 0.0);
  expect_impulse(in, Vec3(0.0, 3.0, 0.0), {64.0 * eps * 3.0, "a 3 x 3 system"});
}

TEST_CASE("The length of a normal may be one up to nine digits", "[6.5]") {
  ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {0.5, 0.5}};
  in.b.position = Vec3(0.0, 0.0, 1.0);
  in.b.velocity = Vec3(0.0, 0.0, -2.0);
  int index = 0;
  for (const double length : {1.0 - 9e-10, 1.0 - 1e-11, 1.0 + 1e-11, 1.0 + 9e-10}) {
    in.contact.normal = Vec3(0.0, 0.0, length);
    expect_impulse(in, Vec3(0.0, 0.0, 3.0), {6.0 * 9e-10, "twice that of the normal, of 3"},
                   ++index, 4);
  }
}

TEST_CASE("A contact does not pull even if sticking would need it", "[6.5]") {
  // The rod of the handout: stick wants j = (1.5, 0, -0.5). On the cone w = (4, 0, 1), and
  // n.K w = 8.5, so that j_n = 2/17.
  ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {0.0, 4.0}};
  in.b.inverse_inertia = 1.5 * Mat3::Identity();
  in.b.position = Vec3(-1.0, 0.0, 1.0);
  in.b.velocity = Vec3(-3.0, 0.0, -1.0);
  expect_impulse(in, Vec3(8.0 / 17.0, 0.0, 2.0 / 17.0), {64.0 * eps * 5.0, "a 3 x 3 system"});
}

TEST_CASE("There is an impulse even if the points meet very slowly", "[6.5]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    ContactInput in = particle_on_ground(0.5, 0.5);
    in.b.velocity *= speed;
    expect_impulse(in, speed * Vec3(-2.7, -3.6, 9.0), {64.0 * eps * 9.0 * speed, "a 3 x 3 system"},
                   ++index, 10);
    in.b.velocity = Vec3(3.0, 4.0, -3.0 * speed);  // it slides, and hardly comes down
    expect_impulse(in, speed * Vec3(-2.7, -3.6, 9.0), {64.0 * eps * 9.0 * speed, "a 3 x 3 system"},
                   ++index, 10);
  }
}

TEST_CASE("There is no impulse if the points move apart even very slowly", "[6.5]") {
  int index = 0;
  for (const double speed : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    ContactInput in = particle_on_ground(0.5, 0.5);
    in.b.velocity = Vec3(3.0, 4.0, speed);
    expect_impulse(in, Vec3::Zero(), {0.0, "there is nothing to stop"}, ++index, 5);
  }
}

TEST_CASE("It sticks just inside the cone and slips just outside", "[6.5]") {
  // Stick wants |j_t| = 10 and j_n = 9.
  int index = 0;
  for (const double share : {1.0 - 1e-9, 1.0 - 1e-12, 1.0 + 1e-12, 1.0 + 1e-9}) {
    const double size = 9.0 * std::min(10.0 / 9.0 * share, 10.0 / 9.0);
    expect_impulse(particle_on_ground(0.5, 10.0 / 9.0 * share), Vec3(-0.6 * size, -0.8 * size, 9.0),
                   {64.0 * eps * 14.0, "a 3 x 3 system"}, ++index, 4);
  }
}

TEST_CASE("Even very small friction and restitution count", "[6.5]") {
  int index = 0;
  const tests::Bound bound{64.0 * eps * 14.0, "a 3 x 3 system"};
  for (const double small : {1e-3, 1e-9, 1e-12}) {
    expect_impulse(particle_on_ground(0.5, small), Vec3(-5.4 * small, -7.2 * small, 9.0), bound,
                   ++index, 9);
    expect_impulse(particle_on_ground(small, 0.0), Vec3(0.0, 0.0, 6.0 * (1.0 + small)), bound,
                   ++index, 9);
    expect_impulse(particle_on_ground(1.0 - small, 0.0), Vec3(0.0, 0.0, 6.0 * (2.0 - small)), bound,
                   ++index, 9);
  }
}

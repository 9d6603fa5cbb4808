#include "bodies.hpp"
#include "catch.hpp"

using namespace lab::impulse_response;
using tests::ContactInput;
using tests::eps;
using tests::Real;
using tests::VecL;
using tests::wide;

namespace {

Vec3 impulse(const ContactInput& in) {
  return contact_impulse(in.a, in.b, in.contact, in.material);
}

/// Of two impulses of the same contact, one of them given in another way.
tests::Bound rounding(const ContactInput& in, double largest_term = 1.0) {
  const tests::ContactOutcome outcome = tests::contact_outcome(in);
  return {256.0 * eps * largest_term *
              static_cast<double>(outcome.impulse.norm() * outcome.amplification),
          "rounding, multiplied by the condition of K and of the slip's direction"};
}

RigidBody turned(const RigidBody& body, const Mat3& R) {
  RigidBody result = body;
  result.inverse_inertia = R * body.inverse_inertia * R.transpose();
  result.inverse_inertia =
      (0.5 * (result.inverse_inertia + result.inverse_inertia.transpose())).eval();
  result.position = R * body.position;
  result.velocity = R * body.velocity;
  result.angular_velocity = R * body.angular_velocity;
  return result;
}

Real energy(const RigidBody& body) {
  if (body.inverse_mass == 0.0) return 0;
  const VecL w = wide(body.angular_velocity);
  const tests::MatL inertia = body.inverse_inertia.cast<Real>().inverse();
  return (wide(body.velocity).squaredNorm() / wide(body.inverse_mass) + w.dot(inertia * w)) / 2;
}

/// Of a body on which an impulse has acted, in the answer's own step 6.5.
Real energy_after(const ContactInput& in, const Vec3& j) {
  return energy(with_impulse(in.a, -j, in.contact.point)) +
         energy(with_impulse(in.b, j, in.contact.point));
}

}  // namespace

TEST_CASE("The normal speed is reversed times e whether it sticks or slips", "[6.5]") {
  tests::Random random(691);
  for (int i = 1; i <= 60; ++i) {
    ContactInput in = tests::random_contact(random, i);
    in.material.restitution = i % 3 * 0.5;
    const Vec3& p = in.contact.point;
    const VecL n = wide(in.contact.normal);
    const VecL before = tests::approach(in.a, in.b, p);
    const Vec3 j = impulse(in);
    const VecL after = before + tests::mass_matrix(in.a, in.b, p) * wide(j);
    const Real wanted =
        n.dot(before) < 0 ? -wide(in.material.restitution) * n.dot(before) : n.dot(before);
    tests::contact_trial(in, i, 60)
        .of("the normal speed afterwards")
        .expect(static_cast<double>(n.dot(after)), static_cast<double>(wanted),
                rounding(in, 20.0));  // K is below 20
  }
}

TEST_CASE("The impulse is in the cone and on its surface if it slips", "[6.5]") {
  tests::Random random(692);
  for (int i = 1; i <= 60; ++i) {
    const ContactInput in = tests::random_contact(random, i);
    const tests::ContactOutcome outcome = tests::contact_outcome(in);
    const VecL n = wide(in.contact.normal);
    const VecL j = wide(impulse(in));
    const double beyond =
        static_cast<double>(tests::tangential(j, n).norm() - wide(in.material.friction) * n.dot(j));
    const tests::Trial trial = tests::contact_trial(in, i, 60);
    trial.expect_small("|j_t| - mu j_n", beyond, rounding(in));
    trial.expect_small("-j_n", -static_cast<double>(n.dot(j)), rounding(in));
    if (!outcome.sticks) trial.expect_small("mu j_n - |j_t|", -beyond, rounding(in));
  }
}

TEST_CASE("It does not matter which body comes first", "[6.5]") {
  tests::Random random(693);
  for (int i = 1; i <= 60; ++i) {
    const ContactInput in = tests::random_contact(random, i);
    const ContactInput swapped{in.b, in.a, {in.contact.point, -in.contact.normal}, in.material};
    tests::contact_trial(in, i, 60)
        .of("the impulse, compared with that for a and b swapped")
        .expect(impulse(in), Vec3(-impulse(swapped)), rounding(in));
  }
}

TEST_CASE("A turn of the world turns the impulse", "[6.5]") {
  tests::Random random(694);
  for (int i = 1; i <= 60; ++i) {
    const ContactInput in = tests::random_contact(random, i);
    const Mat3 R = random.attitude().toRotationMatrix();
    const ContactInput there{turned(in.a, R),
                             turned(in.b, R),
                             {R * in.contact.point, (R * in.contact.normal).normalized()},
                             in.material};
    tests::contact_trial(in, i, 60)
        .of("the impulse of the turned world, turned back")
        .expect(Vec3(R.transpose() * impulse(there)), impulse(in), rounding(in, 4.0));
  }
}

TEST_CASE("A shift of the world and a common velocity change nothing", "[6.5]") {
  tests::Random random(695);
  for (int i = 1; i <= 60; ++i) {
    const ContactInput in = tests::random_contact(random, i);
    const Vec3 shift = random.vector(8.0);
    const Vec3 velocity = random.vector(8.0);
    ContactInput there = in;
    there.contact.point += shift;
    for (RigidBody* body : {&there.a, &there.b}) {
      body->position += shift;
      body->velocity += velocity;
    }
    // Velocities lose the digits that the common one takes.
    tests::contact_trial(in, i, 60)
        .of("the impulse of the moved world")
        .expect(impulse(there), impulse(in),
                {rounding(there, 4.0).value + rounding(in).value,
                 "rounding of the sums with shift and velocity"});
  }
}

TEST_CASE("Without friction the energy lost is what restitution says", "[6.5]") {
  // K n j_n is the change of u: the loss is (1 − e²) u_n² / (2 n·K n), none where e = 1.
  tests::Random random(696);
  for (int i = 1; i <= 40; ++i) {
    ContactInput in = tests::random_contact(random, 2);  // none of them immovable
    in.material = {i % 3 * 0.5, 0.0};
    const VecL n = wide(in.contact.normal);
    const VecL u = tests::approach(in.a, in.b, in.contact.point);
    const Real e = wide(in.material.restitution);
    const Real K_n = n.dot(tests::mass_matrix(in.a, in.b, in.contact.point) * n);
    const Real u_n = std::min(n.dot(u), Real(0));
    const Real before = energy(in.a) + energy(in.b);
    tests::contact_trial(in, i, 40)
        .of("the energy lost")
        .expect(static_cast<double>(before - energy_after(in, impulse(in))),
                static_cast<double>((1 - e * e) * u_n * u_n / (2 * K_n)),
                {256.0 * eps *
                     static_cast<double>((before + 1) * tests::contact_outcome(in).amplification),
                 "rounding of velocities, in energies of this size"});
  }
}

TEST_CASE("Restitution with friction can raise the energy", "[6.5]") {
  // m = 2 and I = 1, touching at r = (1, 0, -1), come down at 2 and slip at -1, without spin: an
  // energy of 5. K is (1.5, 1; 1, 1.5) in the plane of normal and slip, so j = (-2, 0, 4) stops the
  // slip and reverses u_n, as asked for, within the cone of mu = 1. The body leaves with
  // v = (-2, 0, 0) and a spin of -2: an energy of 6. Restitution only looks at the speed of the
  // points along the normal, before and after; on the way the slip's impulse, through K's coupling,
  // presses the points together, so there is more to give back than came in.
  ContactInput in{tests::ground(), {}, {Vec3::Zero(), Vec3::UnitZ()}, {1.0, 1.0}};
  in.b.inverse_mass = 0.5;
  in.b.position = Vec3(-1.0, 0.0, 1.0);
  in.b.velocity = Vec3(-1.0, 0.0, -2.0);
  const Vec3 j = impulse(in);
  const tests::Trial trial = tests::contact_trial(in);
  trial.of("the impulse").expect(j, Vec3(-2.0, 0.0, 4.0), {64.0 * eps * 5.0, "a 3 x 3 system"});
  trial.of("the energy before")
      .expect(static_cast<double>(energy(in.a) + energy(in.b)), 5.0, {0.0, "whole numbers"});
  trial.of("the energy afterwards")
      .expect(static_cast<double>(energy_after(in, j)), 6.0, {256.0 * eps * 6.0, "the same"});
}

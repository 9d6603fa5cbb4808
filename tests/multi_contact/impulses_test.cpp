// Step 7.1: what impulses do, and what they cost.
#include "bodies.hpp"
#include "catch.hpp"

using namespace lab::multi_contact;
using tests::Bodies;
using tests::eps;
using tests::Trial;

namespace {

Trial trial_of_impulses(const Bodies& in, const Vector& lambda, int index = 1, int count = 1) {
  return tests::bodies_trial("7.1 with_impulses", in, index, count).given("lambda", lambda);
}

/// As many bodies as there were, or the case ends here.
std::vector<RigidBody> after_by_answer(const Trial& trial, const Bodies& in, const Vector& lambda) {
  const auto next = trial.returned([&] { return with_impulses(in.bodies, in.contacts, lambda); });
  trial.of("the number of bodies")
      .expect(static_cast<double>(next.size()), static_cast<double>(in.bodies.size()),
              tests::counted);
  return next;
}

void expect_bodies(const Trial& trial, const std::vector<RigidBody>& got,
                   const std::vector<RigidBody>& wanted, double scale) {
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const std::string body = " of body " + std::to_string(k);
    trial.of("the velocity" + body)
        .expect(got[k].velocity, wanted[k].velocity,
                {16.0 * eps * scale, "a product and a sum for each contact"});
    trial.of("the angular velocity" + body)
        .expect(got[k].angular_velocity, wanted[k].angular_velocity,
                {64.0 * eps * scale, "a cross product and a matrix for each contact"});
  }
}

/// How large the velocities become, with all that is added up on the way.
double size_after(const Bodies& in, const Vector& lambda) {
  return tests::size_of_u(in) + tests::size_of_A(in) * lambda.lpNorm<1>();
}

Trial trial_of_energy(const ContactSystem& system, const Vector& lambda, int index = 1,
                      int count = 1) {
  return tests::system_trial("7.1 energy_gained", system, index, count).given("lambda", lambda);
}

void expect_energy(const ContactSystem& system, const Vector& lambda, double wanted, double bound,
                   int index, int count) {
  const Trial trial = trial_of_energy(system, lambda, index, count);
  trial.expect(trial.returned([&] { return energy_gained(system, lambda); }), wanted,
               {bound, "a product with a matrix and two dot products"});
}

}  // namespace

TEST_CASE("An impulse moves and turns both of its bodies against each other", "[7.1]") {
  Bodies in = tests::row_of_balls_as_bodies(Vector{{0.5, 4.0}}, Vector{{1.0, 0.0}});
  in.bodies[1].inverse_inertia *= 4.0;
  in.contacts[0].point = Vec3(0.5, 0.5, 0.0);
  const Vector lambda{{2.0}};
  std::vector<RigidBody> wanted = in.bodies;
  wanted[0].velocity.x() = -3.0;
  wanted[1].velocity.x() = 0.5;
  wanted[0].angular_velocity.z() = 1.0;
  wanted[1].angular_velocity.z() = -4.0;
  const Trial trial = trial_of_impulses(in, lambda);
  expect_bodies(trial, after_by_answer(trial, in, lambda), wanted, 0.0);
}

TEST_CASE("Impulses act on any bodies as one after the other would", "[7.1]") {
  tests::Random random(721);
  for (int i = 1; i <= 40; ++i) {
    const Bodies in = tests::random_bodies(random, i % 2 == 0);
    const Vector lambda =
        tests::random_vector(random, static_cast<Eigen::Index>(in.contacts.size()), 2.0);
    const Trial trial = trial_of_impulses(in, lambda, i, 40);
    expect_bodies(trial, after_by_answer(trial, in, lambda), tests::bodies_after(in, lambda),
                  size_after(in, lambda));
  }
}

TEST_CASE("Impulses change velocities and nothing else", "[7.1]") {
  tests::Random random(722);
  Bodies in = tests::random_bodies(random, true);
  in.contacts = {{0, 1, random.vector(), Vec3::UnitX()}, {3, 0, random.vector(), Vec3::UnitY()}};
  const Vector lambda{{1.0, -2.0}};
  const Trial trial = trial_of_impulses(in, lambda);
  const std::vector<RigidBody> got = after_by_answer(trial, in, lambda);
  expect_bodies(trial, got, tests::bodies_after(in, lambda), size_after(in, lambda));
  const tests::Bound kept{0.0, "an impulse does not change it"};
  for (std::size_t k = 0; k < got.size(); ++k) {
    trial.of("a position").expect(got[k].position, in.bodies[k].position, kept);
    trial.of("an inverse mass").expect(got[k].inverse_mass, in.bodies[k].inverse_mass, kept);
    trial.of("an inertia").expect(got[k].inverse_inertia, in.bodies[k].inverse_inertia, kept);
  }
  for (const std::size_t k : {2U, 3U, 4U}) {  // two touch nothing, one is immovable
    trial.of("what no impulse moves").expect(got[k].velocity, in.bodies[k].velocity, kept);
    trial.of("what no impulse turns")
        .expect(got[k].angular_velocity, in.bodies[k].angular_velocity, kept);
  }
}

TEST_CASE("Impulses keep momentum and angular momentum about a fixed point", "[7.1]") {
  tests::Random random(723);
  for (int i = 1; i <= 30; ++i) {
    const Bodies in = tests::random_bodies(random, false);
    const Vector lambda =
        tests::random_vector(random, static_cast<Eigen::Index>(in.contacts.size()), 2.0);
    const Trial trial = trial_of_impulses(in, lambda, i, 30);
    const std::vector<RigidBody> got = after_by_answer(trial, in, lambda);
    // That something happened, too: a body that is hit is not where it was.
    const auto hit = static_cast<std::size_t>(in.contacts.front().b);
    trial.of("the velocity of a body that is hit")
        .expect(got[hit].velocity, tests::bodies_after(in, lambda)[hit].velocity,
                {64.0 * eps * size_after(in, lambda), "a product and a sum for each contact"});
    const double size = 5.0 * size_after(in, lambda);  // masses are at most 5
    trial.of("the momentum of all")
        .expect(tests::momentum(got), tests::momentum(in.bodies),
                {64.0 * eps * 5.0 * size, "velocities err by rounding, masses are at most 5"});
    trial.of("the angular momentum of all about the world's origin")
        .expect(tests::angular_momentum(got), tests::angular_momentum(in.bodies),
                {256.0 * eps * 5.0 * size, "the same, with lever arms and inertias below 5"});
  }
}

TEST_CASE("The contacts open afterwards as u and A foretell", "[7.1]") {
  tests::Random random(724);
  for (int i = 1; i <= 30; ++i) {
    const Bodies in = tests::random_bodies(random, i % 2 == 0);
    const auto m = static_cast<Eigen::Index>(in.contacts.size());
    const Vector lambda = tests::random_vector(random, m, 2.0);
    const Trial trial = trial_of_impulses(in, lambda, i, 30);
    const auto next = after_by_answer(trial, in, lambda);
    const auto system_of = [&](const std::vector<RigidBody>& bodies) {
      return trial.returned([&] { return contact_system(bodies, in.contacts); });
    };
    const ContactSystem before = system_of(in.bodies);
    const ContactSystem after = system_of(next);
    tests::expect_size(trial, before.u, m);
    const tests::Bound bound{128.0 * eps * size_after(in, lambda), "some 40 operations a contact"};
    trial.of("u of the bodies afterwards, as contact_system has it")
        .expect(after.u, tests::exact_row_sums(before.A, lambda, before.u), bound);
    trial.of("A of the bodies afterwards").expect(after.A, before.A, tests::exact);
  }
}

TEST_CASE("However small or large impulses are they act", "[7.1]") {
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    Bodies in = tests::row_of_balls_as_bodies(Vector{{0.5, 4.0}}, Vector{{0.0, 0.0}});
    in.contacts[0].point = Vec3(0.5, 0.5, 0.0);
    const Vector lambda{{2.0 * size}};
    const Trial trial = trial_of_impulses(in, lambda, ++index, 6);
    expect_bodies(trial, after_by_answer(trial, in, lambda), tests::bodies_after(in, lambda), size);
  }
}

TEST_CASE("Without contacts bodies go on as they are and no energy is gained", "[7.1]") {
  const Bodies in{tests::row_of_balls_as_bodies(Vector::Ones(2), Vector{{1.0, 0.5}}).bodies, {}};
  const Trial trial = trial_of_impulses(in, Vector(0));
  expect_bodies(trial, after_by_answer(trial, in, Vector(0)), in.bodies, 0.0);
  expect_energy({Matrix(0, 0), Vector(0)}, Vector(0), 0.0, 0.0, 1, 1);
}

TEST_CASE("The energy that a cradle gains is worked by hand", "[7.1]") {
  const ContactSystem cradle = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  const double rounding = 8.0 * eps;
  expect_energy(cradle, Vector{{1.0, 1.0}}, 0.0, 0.0, 1, 7);             // the last flies off
  expect_energy(cradle, Vector{{4.0, 2.0}} / 3.0, 0.0, rounding, 2, 7);  // the first comes back
  expect_energy(cradle, Vector{{2.0, 1.0}} / 3.0, -1.0 / 3.0, rounding, 3, 7);  // they go as one
  expect_energy(cradle, Vector{{0.0, 0.0}}, 0.0, 0.0, 4, 7);
  expect_energy(cradle, Vector{{-1.0, 2.0}}, 8.0, 0.0, 5, 7);
  const ContactSystem parting = tests::cradle(Vector{{1.0, 0.0, 0.5}}).system();
  expect_energy(parting, Vector{{7.0, 2.0}} / 6.0, 1.0 / 12.0, rounding, 6, 7);
  expect_energy(parting, Vector{{1.0, 0.5}}, 0.0, 0.0, 7, 7);
}

TEST_CASE("The energy gained is the difference of the kinetic energies", "[7.1]") {
  tests::Random random(725);
  for (int i = 1; i <= 30; ++i) {
    const Bodies in = tests::random_bodies(random, false);
    const auto m = static_cast<Eigen::Index>(in.contacts.size());
    const Vector lambda = tests::random_vector(random, m, 2.0);
    const double wanted =
        tests::kinetic_energy(tests::bodies_after(in, lambda)) - tests::kinetic_energy(in.bodies);
    const double sum = lambda.lpNorm<1>();
    const double size = tests::size_of_u(in) * sum + tests::size_of_A(in) * sum * sum;
    expect_energy(tests::system_of(in), lambda, wanted, 64.0 * eps * (10.0 * 25.0 + size), i, 30);
  }
}

TEST_CASE("Energy has the size of the impulses times the speeds", "[7.1]") {
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    const ContactSystem system{Matrix{{2.0, -1.0}, {-1.0, 2.0}} * size, Vector{{-1.0, 0.0}}};
    expect_energy(system, Vector{{2.0, 1.0}} / size, 1.0 / size, 16.0 * eps / size, ++index, 6);
  }
  const ContactSystem system{Matrix{{2.0, -1.0}, {-1.0 + 1e-9, 2.0}}, Vector{{-1.0, 0.0}}};
  expect_energy(system, Vector{{1.0, 1.0}}, 0.0, 1e-9, 1, 1);
}

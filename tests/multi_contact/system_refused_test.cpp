// Step 7.1: what must be refused.
#include "bodies.hpp"
#include "catch.hpp"
#include "refused.hpp"

using namespace lab::multi_contact;
using tests::Bodies;
using tests::infinite;
using tests::not_a_number;

namespace {

/// Four bodies that are well, two contacts between the first three; nothing touches the last.
Bodies good_bodies() {
  Bodies good = tests::row_of_balls_as_bodies(Vector::Ones(4), Vector{{1.0, 0.0, 0.0, 0.0}});
  good.contacts.pop_back();
  return good;
}

std::vector<RigidBody> bad_bodies() {
  std::vector<RigidBody> bodies(11);
  bodies[0].inverse_mass = -1.0;
  bodies[1].inverse_mass = not_a_number;
  bodies[2].inverse_mass = infinite;
  bodies[3].position.y() = not_a_number;
  bodies[4].velocity.x() = infinite;
  bodies[5].angular_velocity.z() = not_a_number;
  bodies[6].inverse_inertia(1, 1) = not_a_number;
  bodies[7].inverse_inertia(0, 1) = 0.1;  // not symmetric
  bodies[8].inverse_inertia(2, 2) = -1.0;
  bodies[9].inverse_inertia *= 1e-6;
  bodies[9].inverse_inertia(0, 1) = 1e-10;  // 1e-4 of the largest entry
  bodies[10].inverse_inertia(0, 2) = infinite;
  return bodies;
}

/// The bodies of step 7.1 with something wrong, and what.
std::vector<std::pair<Bodies, std::string>> bad_inputs() {
  std::vector<std::pair<Bodies, std::string>> all;
  const Bodies good = good_bodies();
  for (const RigidBody& body : bad_bodies()) {
    for (const std::size_t k : {0U, 2U, 3U}) {
      Bodies bad = good;
      bad.bodies[k] = body;
      all.emplace_back(
          bad, "body " + std::to_string(k) +
                   " breaks what common/contact/rigid_body.hpp says, whether it touches or not");
    }
  }
  const auto change = [&](const std::string& why, const auto& spoil) {
    for (const std::size_t i : {0U, 1U}) {
      Bodies bad = good;
      spoil(bad.contacts[i]);
      all.emplace_back(bad, "contact " + std::to_string(i) + ": " + why);
    }
  };
  const auto numbers = [&](int a, int b, const std::string& why) {
    change(why, [=](Contact& c) { c.a = a, c.b = b; });
  };
  numbers(1, 1, "a body does not touch itself");
  numbers(-1, 1, "there is no body -1");
  numbers(1, -1, "there is no body -1");
  numbers(0, 4, "there is no body 4 of 4");
  numbers(4, 0, "there is no body 4 of 4");
  for (const Vec3& n : {Vec3(Vec3::Zero()), Vec3(0.0, 0.0, 1.0 + 3e-9), Vec3(1.0, 1.0, 0.0),
                        Vec3(not_a_number, 0.0, 1.0), Vec3(0.0, infinite, 0.0)}) {
    change("a normal is of length one", [&](Contact& c) { c.normal = n; });
  }
  for (const double bad : {not_a_number, infinite, -infinite}) {
    change("a point is finite", [=](Contact& c) { c.point.y() = bad; });
  }
  Bodies immovable = good;
  immovable.bodies[0] = immovable.bodies[1] = tests::immovable();
  all.emplace_back(immovable, "contact 0 has two immovable bodies");
  immovable.bodies[1].inverse_inertia = Mat3::Identity();
  all.emplace_back(immovable, "contact 0 has two bodies whose inverse masses are zero");
  all.emplace_back(Bodies{{}, {Contact{}}}, "there are no bodies to touch");
  return all;
}

/// What is told of bodies where there should be none.
Vec3 first_velocity(const std::vector<RigidBody>& bodies) {
  return bodies.empty() ? Vec3(Vec3::Zero()) : bodies.front().velocity;
}

}  // namespace

TEST_CASE("Bodies and contacts that cannot be have no system", "[7.1]") {
  for (const auto& [in, why] : bad_inputs()) {
    tests::bodies_trial("7.1 contact_system", in)
        .expect_throw([&, &bad = in] { return contact_system(bad.bodies, bad.contacts).A; }, why);
  }
}

TEST_CASE("Bodies and contacts that cannot be take no impulses", "[7.1]") {
  for (const auto& [in, why] : bad_inputs()) {
    const Vector lambda = Vector::Zero(static_cast<Eigen::Index>(in.contacts.size()));
    tests::bodies_trial("7.1 with_impulses", in)
        .given("lambda", lambda)
        .expect_throw(
            [&, &bad = in] {
              return first_velocity(with_impulses(bad.bodies, bad.contacts, lambda));
            },
            why);
  }
}

TEST_CASE("Impulses that are not one finite number a contact are refused", "[7.1]") {
  const Bodies good = good_bodies();
  tests::refuse("7.1 with_impulses", tests::bad_vectors(), "lambda", [&](const Vector& lambda) {
    return first_velocity(with_impulses(good.bodies, good.contacts, lambda));
  });
  tests::refuse("7.1 energy_gained", tests::bad_vectors(), "lambda",
                [](const Vector& lambda) { return energy_gained(tests::good_system(), lambda); });
}

TEST_CASE("The energy of a system that cannot be is refused", "[7.1]") {
  tests::refuse_systems("7.1 energy_gained", [](const ContactSystem& bad) {
    return energy_gained(bad, Vector::Zero(bad.u.size()));
  });
}

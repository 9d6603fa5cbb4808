// What students get wrong in step 6.5.
#include "bodies.hpp"
#include "fingerprint.hpp"

namespace tests {
namespace {

using common::Vec3;

RigidBody body(double inverse_mass, const Vec3& diagonal, const Vec3& position,
               const Vec3& velocity, const Vec3& spin) {
  RigidBody result{inverse_mass, diagonal.asDiagonal(), position, velocity, spin};
  result.inverse_inertia(0, 1) = result.inverse_inertia(1, 0) = 0.125 * diagonal.minCoeff();
  return result;
}

/// Two bodies, then one and the ground; rough and smooth; a rod that the ground would have to pull;
/// what parts; straight hits, which have no tangential direction.
std::vector<ContactInput> contact_inputs() {
  const RigidBody a =
      body(0.5, {1.0, 2.0, 0.5}, {-0.5, 0.25, 0.5}, {1.0, 0.5, 1.5}, {0.5, -1.0, 0.25});
  const RigidBody b =
      body(2.0, {1.5, 0.5, 1.0}, {0.5, -0.25, 2.0}, {-1.5, 0.25, -2.0}, {0.25, 1.0, -0.5});
  const Contact between{{0.25, 0.5, 1.25}, {0.0, 0.6, 0.8}};
  const RigidBody rod =
      body(1.0, Vec3::Constant(1.5), {-1.0, 0.0, 1.0}, {-3.0, 0.0, -1.0}, Vec3::Zero());
  RigidBody simple_rod = rod;
  simple_rod.inverse_inertia = 1.5 * Mat3::Identity();
  RigidBody leaves = b;
  leaves.velocity = Vec3(3.0, 2.0, 6.0);
  RigidBody ball = simple_rod;
  ball.position = Vec3(0.0, 0.0, 1.0);
  ball.velocity = Vec3(0.0, 0.0, -2.0);
  RigidBody slow = rod;
  slow.velocity *= 1e-60;
  RigidBody slow_leaving = slow;
  slow_leaving.velocity = Vec3(-3e-60, 0.0, 1e-60);
  RigidBody fast = simple_rod;  // it slips; by a cone of mu |j| it would stick
  fast.velocity = Vec3(-3.0, 0.0, -5.0);
  const Contact floor{Vec3::Zero(), Vec3::UnitZ()};
  return {{a, b, between, {0.5, 0.25}},
          {a, b, between, {0.25, 3.0}},
          {a, leaves, between, {0.5, 0.5}},
          {ground(), rod, floor, {0.5, 0.25}},
          {ground(), simple_rod, floor, {0.0, 4.0}},
          {ground(), ball, floor, {0.5, 0.0}},
          {ground(), ball, floor, {0.5, 0.5}},
          {ground(), slow, floor, {0.5, 0.5}},
          {ground(), slow_leaving, floor, {0.5, 0.5}},
          {ground(), fast, floor, {0.5, 0.26}}};
}

bool is_straight(const ContactInput& in) {
  return tangential(contact_outcome(in).impulse, wide(in.contact.normal)).norm() == 0;
}

/// Where all is symmetric about the normal, tangential parts are rounding.
bool near_impulse(const Vec3& got, const VecL& wanted) {
  return is_finite(got) && difference(got, narrow(wanted)) <= 1e-9 * length(narrow(wanted));
}

/// Right but where hardly anything moves.
Mistake<ContactInput, Vec3> at_tiny_speeds(const std::string& story,
                                           ContactOutcome (*wrong)(const ContactInput&)) {
  return {story, [=](const ContactInput& in, const Vec3& got) {
            const bool is_slow = in.b.velocity.norm() < 1e-50;
            return near_impulse(got, (is_slow ? wrong(in) : contact_outcome(in)).impulse);
          }};
}

std::vector<Mistake<ContactInput, Vec3>> contact_mistakes() {
  std::vector<Mistake<ContactInput, Vec3>> all;
  for (const auto& [flaw, story] : contact_flaws()) {
    all.push_back({story, [f = flaw](const ContactInput& in, const Vec3& got) {
                     const bool divides_by_zero = is_straight(in) && !is_finite(got);
                     return divides_by_zero || near_impulse(got, contact_outcome(in, f).impulse);
                   }});
  }
  all.push_back({"without slip this is 0/0: j_t has no direction then, so return j_n n",
                 [](const ContactInput& in, const Vec3& got) {
                   const bool smooth = is_straight(in) && in.material.friction == 0.0 &&
                                       contact_outcome(in).impulse.norm() > 0;
                   return smooth ? !is_finite(got)
                                 : near_impulse(got, contact_outcome(in).impulse) ||
                                       (is_straight(in) && !is_finite(got));
                 }});
  all.push_back(at_tiny_speeds("a small speed is taken for zero: test only for exactly zero",
                               [](const ContactInput&) { return ContactOutcome(); }));
  all.push_back(at_tiny_speeds(
      "bodies that move apart slowly get an impulse: compare u_n with exactly zero",
      [](const ContactInput& in) { return contact_outcome(in, BodyFlaw::acts_while_parting); }));
  all.push_back(at_tiny_speeds(
      "a small impulse always sticks: it sticks only if |j_t| <= mu j_n",
      [](const ContactInput& in) { return contact_outcome(in, BodyFlaw::always_sticks); }));
  return all;
}

std::vector<Mistake<ContactInput, Mat3>> mass_mistakes() {
  std::vector<Mistake<ContactInput, Mat3>> all;
  for (const auto& [flaw, story] : mass_flaws()) {
    all.push_back(returns<ContactInput, Mat3>(story, [f = flaw](const ContactInput& in) {
      return Mat3(mass_matrix(in.a, in.b, in.contact.point, f).cast<double>());
    }));
  }
  return all;
}

std::vector<Mistake<ContactInput, RigidBody>> impulse_mistakes() {
  std::vector<Mistake<ContactInput, RigidBody>> all;
  for (const auto& [flaw, story] : impulse_flaws()) {
    all.push_back({story, [f = flaw](const ContactInput& in, const RigidBody& got) {
                     const RigidBody wrong = body_after(in.b, in.a.velocity, in.contact.point, f);
                     return near(got.velocity, wrong.velocity) &&
                            near(got.angular_velocity, wrong.angular_velocity);
                   }});
  }
  return all;
}

}  // namespace

std::string likely_of_contact_impulse() {
  return fingerprint(
      contact_inputs(),
      [](const ContactInput& in) {
        return lab::impulse_response::contact_impulse(in.a, in.b, in.contact, in.material);
      },
      contact_mistakes());
}

std::string likely_of_inverse_effective_mass() {
  return fingerprint(
      contact_inputs(),
      [](const ContactInput& in) {
        return lab::impulse_response::inverse_effective_mass(in.a, in.b, in.contact.point);
      },
      mass_mistakes());
}

std::string likely_of_with_impulse() {
  const ContactInput in = contact_inputs().front();
  return fingerprint(
      std::vector<ContactInput>{in},
      [](const ContactInput& c) {
        return lab::impulse_response::with_impulse(c.b, c.a.velocity, c.contact.point);
      },
      impulse_mistakes());
}

}  // namespace tests

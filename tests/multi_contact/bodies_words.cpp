// What is told of bodies and of mistakes with them.
#include "bodies.hpp"

namespace tests {

const std::vector<std::pair<SystemFlaw, std::string>>& system_flaws() {
  static const std::vector<std::pair<SystemFlaw, std::string>> all{
      {SystemFlaw::no_coupling,
       "A has nothing off its diagonal: an impulse also changes the other contacts of its bodies"},
      {SystemFlaw::coupling_sign,
       "off its diagonal A has the wrong sign: it is (J W J^T)_ij, and J has -n for a and n for b"},
      {SystemFlaw::coupling_unsigned,
       "A does not see that a body is a of one contact and b of the other: then it counts as "
       "minus"},
      {SystemFlaw::no_lever_arms,
       "the lever arms are left out, in A and in u: bodies turn, use r x n and v + omega x r"},
      {SystemFlaw::no_lever_arms_in_A,
       "the lever arms are left out of A: an impulse also turns a body, add the part of r x n"},
      {SystemFlaw::no_lever_arms_in_u,
       "the spins are left out of u: bodies touch with v + omega x r, not with v"},
      {SystemFlaw::lever_of_origin,
       "r starts at the world's origin: it is the point less the centre of mass"},
      {SystemFlaw::torque_sign,
       "spin counts the wrong way round in u: it is omega x r, not r x omega"},
      {SystemFlaw::no_W, "W is missing from A = J W J^T: use the inverse masses and inertias"},
      {SystemFlaw::no_masses,
       "the inverse masses are missing from A: W has them beside the inertias"},
      {SystemFlaw::no_inertia,
       "the inverse inertias are missing from A: W has them beside the masses"},
      {SystemFlaw::only_a, "b's part of A is missing: an impulse changes both of its bodies"},
      {SystemFlaw::only_b, "a's part of A is missing: an impulse changes both of its bodies"},
      {SystemFlaw::u_of_a,
       "u has the wrong sign: it is b's velocity less a's, along n from a to b"},
      {SystemFlaw::u_of_sum, "the two velocities are added in u: it is b's less a's"},
      {SystemFlaw::u_of_b, "a's velocity is missing from u: it is b's less a's"}};
  return all;
}

const std::vector<std::pair<ImpulseFlaw, std::string>>& impulse_flaws() {
  static const std::vector<std::pair<ImpulseFlaw, std::string>> all{
      {ImpulseFlaw::not_on_a, "the impulse on body a is missing: give it -lambda n"},
      {ImpulseFlaw::not_on_b, "the impulse on body b is missing: give it lambda n"},
      {ImpulseFlaw::same_on_both, "both bodies get lambda n: a gets the opposite, -lambda n"},
      {ImpulseFlaw::reversed, "b gets -lambda n and a lambda n: it is the other way round"},
      {ImpulseFlaw::no_turning,
       "the impulses do not turn the bodies: add the inverse inertia times r x lambda n"},
      {ImpulseFlaw::no_velocity,
       "the impulses turn the bodies but do not move them: add lambda n/m"},
      {ImpulseFlaw::no_mass,
       "the masses are missing: an impulse changes v by the inverse mass times it"},
      {ImpulseFlaw::no_inertia,
       "the inertias are missing: r x lambda n is multiplied by the inverse inertia"},
      {ImpulseFlaw::inertia_first,
       "r x (inverse inertia j) stands where inverse inertia (r x j) belongs"},
      {ImpulseFlaw::lever_of_origin,
       "r starts at the world's origin: it is the point less the centre of mass"},
      {ImpulseFlaw::torque_sign, "the bodies turn the wrong way: it is r x j, not j x r"},
      {ImpulseFlaw::last_alone,
       "a body keeps the impulse of its last contact only: add each to what the others did"},
      {ImpulseFlaw::no_pulling, "impulses below zero are left out: they may have either sign"}};
  return all;
}

double size_of_A(const Bodies& in) {
  double size = 0.0;
  for (const Contact& c : in.contacts) {
    for (const int k : {c.a, c.b}) {
      const RigidBody& body = in.bodies[static_cast<std::size_t>(k)];
      const double reach = c.point.norm() + body.position.norm();
      size = std::max(size, body.inverse_mass + body.inverse_inertia.norm() * reach * reach);
    }
  }
  return 2.0 * size;
}

double size_of_u(const Bodies& in) {
  double size = 0.0;
  for (const Contact& c : in.contacts) {
    for (const int k : {c.a, c.b}) {
      const RigidBody& body = in.bodies[static_cast<std::size_t>(k)];
      const double reach = c.point.norm() + body.position.norm();
      size = std::max(size, body.velocity.norm() + body.angular_velocity.norm() * reach);
    }
  }
  return 2.0 * size;
}

Trial bodies_trial(const std::string& step_and_function, const Bodies& in, int index, int count) {
  Trial trial = trial_of(step_and_function, index, count);
  return trial.given("bodies", code_of(in.bodies)).given("contacts", code_of(in.contacts));
}

}  // namespace tests

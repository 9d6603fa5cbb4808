#pragma once

#include <string>
#include <utility>
#include <vector>

#include "judged.hpp"

/// Bodies and contacts once more, impulse by impulse and in extended precision, with what students
/// get wrong as switches.
namespace tests {

/// What can be wrong with (1).
enum class SystemFlaw {
  none,
  no_coupling,
  coupling_sign,
  coupling_unsigned,
  no_lever_arms,
  no_lever_arms_in_A,
  no_lever_arms_in_u,
  lever_of_origin,
  torque_sign,
  no_W,
  no_masses,
  no_inertia,
  only_a,
  only_b,
  u_of_a,
  u_of_sum,
  u_of_b
};
const std::vector<std::pair<SystemFlaw, std::string>>& system_flaws();

/// A_ij is what an impulse 1 at contact j, body by body, changes of u_i.
ContactSystem system_of(const Bodies& in, SystemFlaw flaw = SystemFlaw::none);

/// What can be wrong with (2).
enum class ImpulseFlaw {
  none,
  not_on_a,
  not_on_b,
  same_on_both,
  reversed,
  no_turning,
  no_velocity,
  no_mass,
  no_inertia,
  inertia_first,
  lever_of_origin,
  torque_sign,
  last_alone,
  no_pulling
};
const std::vector<std::pair<ImpulseFlaw, std::string>>& impulse_flaws();

std::vector<RigidBody> bodies_after(const Bodies& in, const Vector& lambda,
                                    ImpulseFlaw flaw = ImpulseFlaw::none);

/// Of all, about the origin, and ½ of the sum of v·M v. No body may be immovable.
common::Vec3 momentum(const std::vector<RigidBody>& bodies);
common::Vec3 angular_momentum(const std::vector<RigidBody>& bodies);
double kinetic_energy(const std::vector<RigidBody>& bodies);

/// Five bodies with full inertias, one of them hinged and one immovable if `walls`, and up to nine
/// contacts about a metre off their centres. A pair may touch more than once, either first.
Bodies random_bodies(Random& random, bool walls);

/// The largest that an entry of A, or of |u|, can be, as rounding sees it.
double size_of_A(const Bodies& in);
double size_of_u(const Bodies& in);

Trial bodies_trial(const std::string& step_and_function, const Bodies& in, int index = 1,
                   int count = 1);

}  // namespace tests

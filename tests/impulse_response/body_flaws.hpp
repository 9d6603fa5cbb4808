#pragma once

#include <string>
#include <utility>
#include <vector>

/// What students get wrong in impacts of two rigid bodies, each with its story.
namespace tests {

enum class BodyFlaw {
  none,
  no_angular_part,
  only_b,
  only_a,
  angular_sign,
  lever_of_origin,
  velocity_of_centers,
  acts_while_parting,
  e_alone,
  other_normal,
  always_sticks,
  always_slips,
  along_slip,
  no_friction,
  mass_of_particles,
  one_after_the_other,
  keeps_normal_impulse,
  b_less_a,
  normal_alone,
  no_spin_of_a,
  no_spin_of_b,
  no_restitution_in_stick,
  against_slip,
  pulls,
  inertia_last,
  u_of_a,
  one_minus_e,
  cone_of_j,
  not_unit,
  normal_denominator,
  slips_freely,
  other_restitution_in_stick,
  e_alone_on_cone
};

using BodyFlaws = std::vector<std::pair<BodyFlaw, std::string>>;

/// Those of K, which stand in both lists.
inline const BodyFlaws& mass_flaws() {
  static const BodyFlaws all{
      {BodyFlaw::no_angular_part,
       "the angular part of the effective mass is missing: subtract [r]x I^-1 [r]x"},
      {BodyFlaw::only_b, "a's part of the effective mass is missing: add the parts of both bodies"},
      {BodyFlaw::only_a, "b's part of the effective mass is missing: add the parts of both bodies"},
      {BodyFlaw::angular_sign,
       "the angular part of the effective mass has the wrong sign: subtract [r]x I^-1 [r]x"},
      {BodyFlaw::lever_of_origin, "the lever arm starts at the world's origin: use p - x, not p"},
      {BodyFlaw::b_less_a, "K of a is subtracted from K of b: add them"},
      {BodyFlaw::inertia_last,
       "[r]x [r]x stands before the inverse inertia: put one [r]x on each side"}};
  return all;
}

inline const BodyFlaws& contact_flaws() {
  static const BodyFlaws all = [] {
    BodyFlaws flaws = mass_flaws();
    const BodyFlaws more{
        {BodyFlaw::velocity_of_centers,
         "u is the velocity of the centres of mass: use the velocities of the points"},
        {BodyFlaw::acts_while_parting,
         "a contact that moves apart gets an impulse: return zero if u_n >= 0"},
        {BodyFlaw::e_alone, "e is used instead of 1 + e"},
        {BodyFlaw::other_normal, "the normal is taken the other way round: it points from a to b"},
        {BodyFlaw::always_sticks, "it always sticks: if the impulse leaves the cone, let it slip"},
        {BodyFlaw::always_slips, "it always slips: first try whether it sticks"},
        {BodyFlaw::along_slip, "friction is along the slip, so it pushes on: change its sign"},
        {BodyFlaw::no_friction, "there is no friction: add the tangential impulse"},
        {BodyFlaw::mass_of_particles,
         "friction stops the slip of two particles: bodies also turn, so use K"},
        {BodyFlaw::one_after_the_other,
         "normal and tangential part are solved one after the other: K couples them, so solve both "
         "at once"},
        {BodyFlaw::keeps_normal_impulse,
         "on the cone the normal impulse is that of sticking: compute it from n.K (n + mu t)"},
        {BodyFlaw::normal_alone,
         "n.K n is used for all of K, which is a matrix: solve K j = -e u_n n - u"},
        {BodyFlaw::no_spin_of_a, "the spin of a is left out of u: use v + omega x r at its point"},
        {BodyFlaw::no_spin_of_b, "the spin of b is left out of u: use v + omega x r at its point"},
        {BodyFlaw::no_restitution_in_stick, "e is missing if it sticks: solve K j = -e u_n n - u"},
        {BodyFlaw::against_slip,
         "on the cone t is -u_t/|u_t|: use the direction of the impulse that sticks"},
        {BodyFlaw::pulls,
         "an impulse with j_n < 0 is taken for one in the cone: a contact cannot pull"},
        {BodyFlaw::u_of_a, "u is the velocity of a relative to b: use that of b relative to a"},
        {BodyFlaw::one_minus_e, "1 - e is used instead of 1 + e"},
        {BodyFlaw::cone_of_j, "|j_t| is compared with mu |j|: compare it with mu j_n"},
        {BodyFlaw::not_unit, "on the cone j_t is not made a unit vector: divide it by its length"},
        {BodyFlaw::normal_denominator, "on the cone n.K n is used instead of n.K (n + mu t)"},
        {BodyFlaw::slips_freely, "if it slips there is no friction: let it be mu j_n"},
        {BodyFlaw::other_restitution_in_stick,
         "e has the wrong sign if it sticks: solve K j = -e u_n n - u"},
        {BodyFlaw::e_alone_on_cone, "e is used instead of 1 + e"}};
    flaws.insert(flaws.end(), more.begin(), more.end());
    return flaws;
  }();
  return all;
}

/// What can be wrong with (10).
enum class ImpulseFlaw {
  none,
  subtracted,
  times_mass,
  no_mass,
  other_torque,
  no_torque,
  lever_of_origin,
  inertia_first,
  no_inertia,
  no_velocity
};

inline const std::vector<std::pair<ImpulseFlaw, std::string>>& impulse_flaws() {
  static const std::vector<std::pair<ImpulseFlaw, std::string>> all{
      {ImpulseFlaw::subtracted, "the impulse is subtracted: add it"},
      {ImpulseFlaw::times_mass, "m j is used instead of j/m"},
      {ImpulseFlaw::no_mass, "the mass is missing: divide the impulse by m"},
      {ImpulseFlaw::other_torque, "the torque has the wrong sign: use r x j, not j x r"},
      {ImpulseFlaw::no_torque,
       "the impulse does not make the body turn: add inverse inertia (r x j) to the spin"},
      {ImpulseFlaw::lever_of_origin,
       "the lever arm starts at the world's origin: use p - x, not p"},
      {ImpulseFlaw::inertia_first,
       "r x (inverse inertia j) is used instead of inverse inertia (r x j)"},
      {ImpulseFlaw::no_inertia,
       "the inertia is missing, so the torque is added to the spin: multiply by the inverse "
       "inertia"},
      {ImpulseFlaw::no_velocity,
       "the impulse turns the body but does not move it: add j/m to the velocity"}};
  return all;
}

}  // namespace tests

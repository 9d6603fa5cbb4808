#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "impulse_response.hpp"
#include "likely.hpp"
#include "random.hpp"

/// Impacts of a particle once more, in extended precision, with what students get wrong as
/// switches: one formula serves as the oracle and as the list of suspects.
namespace tests {

using Real = long double;
using VecL = Eigen::Matrix<Real, 3, 1>;
using MatL = Eigen::Matrix<Real, 3, 3>;
using lab::impulse_response::Corrections;
using lab::impulse_response::Material;
using lab::impulse_response::Particle;

inline Real wide(double x) { return static_cast<Real>(x); }
inline VecL wide(const common::Vec3& v) { return v.cast<Real>(); }
inline common::Vec3 narrow(const VecL& v) { return v.cast<double>(); }

/// −limit along v, but never more than v: 0 where v is.
inline VecL braked(const VecL& v, Real limit) {
  const Real length = v.norm();
  return length == 0 ? VecL(VecL::Zero()) : VecL(-std::min(limit, length) / length * v);
}

inline VecL tangential(const VecL& v, const VecL& n) { return v - n.dot(v) * n; }

/// Two directions that make a right-handed frame with the unit vector n.
inline std::pair<VecL, VecL> across(const VecL& n) {
  const VecL first = n.unitOrthogonal();
  return {first, n.cross(first)};
}

/// A particle's state and the impulse that it got, as one value of a trial.
struct StepValue {
  common::Vec3 position;
  common::Vec3 velocity;
  common::Vec3 impulse;
};

inline bool is_finite(const StepValue& v) {
  return is_finite(v.position) && is_finite(v.velocity) && is_finite(v.impulse);
}
inline double length(const StepValue& v) {
  return std::max({length(v.position), length(v.velocity), length(v.impulse)});
}
inline double difference(const StepValue& a, const StepValue& b) {
  return std::max({difference(a.position, b.position), difference(a.velocity, b.velocity),
                   difference(a.impulse, b.impulse)});
}
inline std::string text(const StepValue& v) {
  return "position " + text(v.position) + ", velocity " + text(v.velocity) + ", impulse " +
         text(v.impulse);
}

/// What can be wrong with a step by projection whose impulses and corrections are right.
enum class Flaw {
  none,
  old_velocity,
  old_normal,
  acts_while_parting,
  repairs_only_impacts,
  inwards,
  no_mass,
  no_clamp,
  new_displacement,
  no_depth_left,
  ignores_switches,
  corrects_velocity,
  no_gravity,
  no_friction,
  stays_inside,
  speed_for_displacement,
  time_twice,
  no_tangential,
  parabola,
  subtracts,
  no_impulse,
  least_depth,
  most_height
};

inline const std::vector<std::pair<Flaw, std::string>>& flaws() {
  static const std::vector<std::pair<Flaw, std::string>> all{
      {Flaw::old_velocity,
       "the position moves with the velocity from before gravity acted: use the new velocity"},
      {Flaw::old_normal,
       "the normal is that of the step's start: take it where the particle is now"},
      {Flaw::acts_while_parting,
       "an impulse acts on a particle that already moves away: leave it out if v_n >= 0"},
      {Flaw::repairs_only_impacts,
       "positions are corrected only if there is an impulse: correct every particle that is "
       "inside"},
      {Flaw::inwards, "the particle is moved inwards: use -phi n, not +phi n"},
      {Flaw::no_mass, "the impulse is added to the velocity without 1/m: divide it by m"},
      {Flaw::no_clamp,
       "the tangential correction undoes all slip: the clamp mu d_n is missing, so limit it"},
      {Flaw::new_displacement,
       "the tangential correction is of the velocity after the impulse: use the motion d of the "
       "step"},
      {Flaw::no_depth_left,
       "the tangential correction is missing: take d_n before the particle is moved out"},
      {Flaw::ignores_switches, "a correction is made that was not asked for: obey `corrections`"},
      {Flaw::corrects_velocity,
       "the velocity, too, is changed by the correction over dt: correct only the position"},
      {Flaw::no_gravity, "gravity does not act: add dt g to the velocity first"},
      {Flaw::no_friction, "the impulse is along the normal alone: add the friction j_t"},
      {Flaw::stays_inside, "the particle is not moved out: add the normal correction"},
      {Flaw::speed_for_displacement,
       "the tangential correction is of the velocity: use the step's motion d = dt v"},
      {Flaw::time_twice, "the tangential correction is of dt d, so dt counts twice: use d"},
      {Flaw::no_tangential, "there is no tangential correction: add it"},
      {Flaw::parabola, "the position moves along the parabola: let d be dt times the new velocity"},
      {Flaw::subtracts, "the impulse is subtracted from the velocity: add it"},
      {Flaw::no_impulse, "the impulse is returned but does not change the velocity: add j/m"},
      {Flaw::least_depth, "a particle that is hardly inside is left alone: correct it if phi < 0"},
      {Flaw::most_height,
       "a particle that is hardly outside gets an impulse: only phi < 0 is inside"}};
  return all;
}

struct StepInput {
  Particle particle;
  common::Obstacle obstacle;
  Material material;
  common::Vec3 gravity = common::Vec3::Zero();
  double dt = 0.1;
  Corrections corrections;
};

struct Surface {
  Real gap;
  VecL normal;
};

inline Surface surface_at(const common::Obstacle& obstacle, const VecL& x) {
  if (const auto* plane = std::get_if<common::Plane>(&obstacle)) {
    const VecL n = wide(plane->normal);
    return {n.dot(x - wide(plane->point)), n};
  }
  const Real distance = std::hypot(x.y(), x.z());
  return {distance - wide(std::get<common::Cylinder>(obstacle).radius),
          VecL(0, x.y() / distance, x.z() / distance)};
}

/// j_n n + j_t of a particle of velocity v.
inline VecL particle_impulse(Real mass, const VecL& v, const VecL& n, const Material& material,
                             bool acts_while_parting = false) {
  const Real v_n = n.dot(v);
  if (v_n >= 0 && !acts_while_parting) return VecL::Zero();
  const Real j_n = -(1 + wide(material.restitution)) * mass * v_n;
  return j_n * n +
         braked(mass * tangential(v, n), wide(material.friction) * std::max(j_n, Real(0)));
}

inline StepValue projected_step(const StepInput& in, Flaw flaw = Flaw::none) {
  const Real dt = wide(in.dt);
  const Real mass = wide(in.particle.mass);
  const VecL start = wide(in.particle.position);
  VecL v = wide(in.particle.velocity);
  const VecL old_v = v;
  if (flaw != Flaw::no_gravity) v += dt * wide(in.gravity);
  const VecL arriving = v;
  VecL d = dt * (flaw == Flaw::old_velocity ? old_v : v);
  if (flaw == Flaw::parabola) d = dt * (old_v + v) / 2;
  VecL x = start + d;
  auto [phi, n] = surface_at(in.obstacle, x);
  Real surface = 0;
  if (flaw == Flaw::least_depth) surface = -1e-16L;
  if (flaw == Flaw::most_height) surface = 1e-16L;
  if (phi >= surface) return {narrow(x), narrow(v), common::Vec3::Zero()};
  if (flaw == Flaw::old_normal) n = surface_at(in.obstacle, start).normal;

  const bool parts = n.dot(v) >= 0;
  const Material material{in.material.restitution,
                          flaw == Flaw::no_friction ? 0.0 : in.material.friction};
  const VecL j = particle_impulse(mass, v, n, material, flaw == Flaw::acts_while_parting);
  Real share = flaw == Flaw::no_mass ? 1 : 1 / mass;
  if (flaw == Flaw::subtracts) share = -share;
  if (flaw == Flaw::no_impulse) share = 0;
  v += share * j;
  const bool all = flaw == Flaw::ignores_switches;
  const bool skips = flaw == Flaw::repairs_only_impacts && parts;
  VecL out = VecL::Zero();
  if ((in.corrections.normal || all) && !skips && flaw != Flaw::stays_inside)
    out += (flaw == Flaw::inwards ? phi : -phi) * n;
  if ((in.corrections.tangential || all) && !skips && flaw != Flaw::no_tangential &&
      !(flaw == Flaw::no_depth_left && in.corrections.normal)) {
    VecL moved = flaw == Flaw::new_displacement ? VecL(dt * v) : d;
    if (flaw == Flaw::speed_for_displacement) moved = arriving;
    if (flaw == Flaw::time_twice) moved = dt * d;
    const Real limit = flaw == Flaw::no_clamp
                           ? Real(HUGE_VALL)
                           : std::max(-phi, Real(0)) * wide(in.material.friction);
    out += braked(tangential(moved, n), limit);
  }
  if (flaw == Flaw::corrects_velocity && in.dt > 0.0) v += out / dt;
  return {narrow(x + out), narrow(v), narrow(j)};
}

inline std::string text_of(const common::Obstacle& obstacle) {
  if (const auto* plane = std::get_if<common::Plane>(&obstacle)) {
    return "Plane{" + text(plane->point) + ", " + text(plane->normal) + "}";
  }
  return "Cylinder{" + text(std::get<common::Cylinder>(obstacle).radius) + "}";
}

inline Trial& given(Trial& trial, const Particle& p) {
  return trial.given("particle", Code{"Particle{" + text(p.mass) + ", " + text(p.position) + ", " +
                                      text(p.velocity) + "}"});
}
inline Trial& given(Trial& trial, const Material& m) {
  return trial.given("material",
                     Code{"Material{" + text(m.restitution) + ", " + text(m.friction) + "}"});
}

inline Trial step_trial(const std::string& function, const StepInput& in, int index = 1,
                        int count = 1) {
  Trial trial = trial_of("6.4 " + function, index, count);
  given(trial, in.particle).given("obstacle", Code{text_of(in.obstacle)});
  return given(trial, in.material).given("gravity", in.gravity).given("dt", in.dt);
}

inline StepValue projected_by_answer(const StepInput& in) {
  const auto [particle, impulse] = lab::impulse_response::step_by_projection(
      in.particle, in.obstacle, in.material, in.gravity, in.dt, in.corrections);
  return {particle.position, particle.velocity, impulse};
}

}  // namespace tests

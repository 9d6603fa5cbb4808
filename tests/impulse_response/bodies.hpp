#pragma once

#include <Eigen/LU>

#include "body_flaws.hpp"
#include "oracle.hpp"

/// Impacts of two rigid bodies once more, in extended precision, with what students get wrong as
/// switches, see body_flaws.hpp.
namespace tests {

using lab::impulse_response::Contact;
using lab::impulse_response::RigidBody;

inline MatL skew(const VecL& w) {
  return MatL{{0, -w.z(), w.y()}, {w.z(), 0, -w.x()}, {-w.y(), w.x(), 0}};
}

inline VecL lever(const RigidBody& body, const common::Vec3& point) {
  return wide(point) - wide(body.position);
}

inline MatL inverse_mass_at(const RigidBody& body, const common::Vec3& point, BodyFlaw flaw) {
  const MatL r = skew(flaw == BodyFlaw::lever_of_origin ? wide(point) : lever(body, point));
  const MatL inverse_inertia = body.inverse_inertia.cast<Real>();
  const MatL turning = flaw == BodyFlaw::inertia_last ? MatL(-(r * r * inverse_inertia))
                                                      : MatL(-(r * inverse_inertia * r));
  const Real sign =
      flaw == BodyFlaw::no_angular_part ? 0 : (flaw == BodyFlaw::angular_sign ? -1 : 1);
  return wide(body.inverse_mass) * MatL::Identity() + sign * turning;
}

inline MatL mass_matrix(const RigidBody& a, const RigidBody& b, const common::Vec3& point,
                        BodyFlaw flaw = BodyFlaw::none) {
  MatL K = MatL::Zero();
  const Real part_of_a = flaw == BodyFlaw::only_b ? 0 : (flaw == BodyFlaw::b_less_a ? -1 : 1);
  K += part_of_a * inverse_mass_at(a, point, flaw);
  if (flaw != BodyFlaw::only_a) K += inverse_mass_at(b, point, flaw);
  return K;
}

inline VecL velocity_at(const RigidBody& body, const common::Vec3& point) {
  return wide(body.velocity) + wide(body.angular_velocity).cross(lever(body, point));
}

inline VecL approach(RigidBody a, RigidBody b, const common::Vec3& point,
                     BodyFlaw flaw = BodyFlaw::none) {
  const bool centers = flaw == BodyFlaw::velocity_of_centers;
  if (centers || flaw == BodyFlaw::no_spin_of_a) a.angular_velocity.setZero();
  if (centers || flaw == BodyFlaw::no_spin_of_b) b.angular_velocity.setZero();
  const VecL u = velocity_at(b, point) - velocity_at(a, point);
  return flaw == BodyFlaw::u_of_a ? VecL(-u) : u;
}

struct ContactInput {
  RigidBody a;
  RigidBody b;
  Contact contact;
  Material material;
};

/// The impulse, whether it sticks, and how much larger relative errors of the input are in it.
struct ContactOutcome {
  VecL impulse = VecL::Zero();
  bool sticks = false;
  Real amplification = 1;
};

inline VecL unit_or_zero(const VecL& v) {
  return v.norm() == 0 ? VecL(VecL::Zero()) : VecL(v.normalized());
}

/// A mistaken friction law, given the right K.
inline VecL mistaken_friction(const ContactInput& in, const MatL& K, const VecL& u, const VecL& n,
                              BodyFlaw flaw) {
  const VecL u_t = tangential(u, n);
  const VecL t = unit_or_zero(u_t);
  const Real j_n = -(1 + wide(in.material.restitution)) * n.dot(u) / n.dot(K * n);
  const Real masses = wide(in.a.inverse_mass) + wide(in.b.inverse_mass);
  const Real yields = flaw == BodyFlaw::mass_of_particles ? masses : t.dot(K * t);
  return j_n * n + braked(u_t / std::max(yields, Real(1e-30L)), wide(in.material.friction) * j_n);
}

inline ContactOutcome contact_outcome(const ContactInput& in, BodyFlaw flaw = BodyFlaw::none) {
  MatL K = mass_matrix(in.a, in.b, in.contact.point, flaw);
  const VecL u = approach(in.a, in.b, in.contact.point, flaw);
  const VecL n = (flaw == BodyFlaw::other_normal ? -1 : 1) * wide(in.contact.normal);
  if (flaw == BodyFlaw::normal_alone) K = n.dot(K * n) * MatL::Identity();
  const Real u_n = n.dot(u);
  if (u_n >= 0 && flaw != BodyFlaw::acts_while_parting) return {};
  if (flaw == BodyFlaw::mass_of_particles || flaw == BodyFlaw::one_after_the_other) {
    return {mistaken_friction(in, K, u, n, flaw)};
  }

  Real e = wide(in.material.restitution) - (flaw == BodyFlaw::e_alone ? 1 : 0);
  if (flaw == BodyFlaw::one_minus_e) e = -e;
  const Real mu = flaw == BodyFlaw::no_friction ? 0 : wide(in.material.friction);
  const MatL K_inverse = K.inverse();
  Real e_stick = flaw == BodyFlaw::no_restitution_in_stick ? 0 : e;
  if (flaw == BodyFlaw::other_restitution_in_stick) e_stick = -e;
  const VecL wanted = -(1 + e_stick) * u_n * n - tangential(u, n);
  const VecL stick = K_inverse * wanted;
  const VecL stick_t = tangential(stick, n);
  const Real speed = wide(in.a.velocity.norm() + in.b.velocity.norm()) +
                     wide(in.a.angular_velocity.norm()) * lever(in.a, in.contact.point).norm() +
                     wide(in.b.angular_velocity.norm()) * lever(in.b, in.contact.point).norm();
  const Real condition = K.norm() * K_inverse.norm() * (1 + speed / wanted.norm());
  Real stick_n = flaw == BodyFlaw::pulls ? std::abs(n.dot(stick)) : n.dot(stick);
  if (flaw == BodyFlaw::cone_of_j) stick_n = stick.norm();
  const bool in_cone = stick_t.norm() <= mu * stick_n;
  if (flaw == BodyFlaw::always_sticks || (in_cone && flaw != BodyFlaw::always_slips)) {
    return {stick, true, condition};
  }
  const VecL against = flaw == BodyFlaw::against_slip ? VecL(-tangential(u, n)) : stick_t;
  VecL t = unit_or_zero(against);
  if (flaw == BodyFlaw::along_slip) t = -t;
  if (flaw == BodyFlaw::not_unit) t = stick_t;
  if (flaw == BodyFlaw::slips_freely) t.setZero();
  const VecL edge = n + mu * t;
  const Real yields = flaw == BodyFlaw::normal_denominator ? n.dot(K * n) : n.dot(K * edge);
  if (flaw == BodyFlaw::e_alone_on_cone) e -= 1;
  const Real j_n = flaw == BodyFlaw::keeps_normal_impulse ? n.dot(stick) : -(1 + e) * u_n / yields;
  const Real direction = stick.norm() / std::max(stick_t.norm(), Real(1e-30L));
  return {j_n * edge, false,
          condition * (1 + direction) * (1 + K.norm() * edge.norm() / std::abs(yields))};
}

inline RigidBody body_after(const RigidBody& body, const common::Vec3& impulse,
                            const common::Vec3& point, ImpulseFlaw flaw = ImpulseFlaw::none) {
  const VecL j = wide(impulse);
  const VecL r = flaw == ImpulseFlaw::lever_of_origin ? wide(point) : lever(body, point);
  const MatL inverse_inertia = body.inverse_inertia.cast<Real>();
  Real share = wide(body.inverse_mass);
  if (flaw == ImpulseFlaw::subtracted) share = -share;
  if (flaw == ImpulseFlaw::times_mass) share = 1 / share;
  if (flaw == ImpulseFlaw::no_mass) share = 1;
  if (flaw == ImpulseFlaw::no_velocity) share = 0;
  VecL turn = inverse_inertia * r.cross(j);
  if (flaw == ImpulseFlaw::other_torque) turn = -turn;
  if (flaw == ImpulseFlaw::no_torque) turn.setZero();
  if (flaw == ImpulseFlaw::inertia_first) turn = r.cross(inverse_inertia * j);
  if (flaw == ImpulseFlaw::no_inertia) turn = r.cross(j);
  RigidBody next = body;
  next.velocity = narrow(wide(body.velocity) + share * j);
  next.angular_velocity = narrow(wide(body.angular_velocity) + turn);
  return next;
}

inline std::string text_of(const RigidBody& b) {
  return "RigidBody{" + text(b.inverse_mass) + ", " + text(b.inverse_inertia) + ", " +
         text(b.position) + ", " + text(b.velocity) + ", " + text(b.angular_velocity) + "}";
}

inline Trial contact_trial(const ContactInput& in, int index = 1, int count = 1) {
  Trial trial = trial_of("6.5 contact_impulse", index, count);
  trial.given("a", Code{text_of(in.a)}).given("b", Code{text_of(in.b)});
  trial.given("contact",
              Code{"Contact{" + text(in.contact.point) + ", " + text(in.contact.normal) + "}"});
  return given(trial, in.material);
}

inline RigidBody random_body(Random& random) {
  RigidBody body;
  body.inverse_mass = random.uniform(0.2, 2.0);
  body.inverse_inertia = random.inertia();
  body.position = random.vector(2.0);
  body.velocity = random.vector(1.0);
  body.angular_velocity = random.vector(1.0);
  return body;
}

inline RigidBody ground() {
  RigidBody body;
  body.inverse_mass = 0.0;
  body.inverse_inertia = Mat3::Zero();
  return body;
}

/// Two bodies about a metre off the point where they meet; half of them approach, and in two of
/// five one is immovable.
inline ContactInput random_contact(Random& random, int index) {
  ContactInput in{random_body(random), random_body(random), {}, {}};
  in.contact = {random.vector(2.0), random.direction()};
  in.a.position = in.contact.point - random.vector(1.0);
  in.b.position = in.contact.point + random.vector(1.0);
  in.material = {random.uniform(0.0, 1.0), random.uniform(0.05, 1.0)};
  if (index % 5 == 0) in.a.inverse_mass = 0.0, in.a.inverse_inertia.setZero();
  if (index % 5 == 1) in.b.inverse_mass = 0.0, in.b.inverse_inertia.setZero();
  return in;
}

}  // namespace tests

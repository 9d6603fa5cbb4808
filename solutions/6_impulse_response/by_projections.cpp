// The same lab with the projections P = n nᵀ and 1 − P in place of components, contacts solved in a
// frame of the contact, and K read off the bodies by pushing them.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "impulse_response.hpp"

namespace lab::impulse_response {
namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

bool is_unit(const Vec3& n) { return std::abs(n.norm() - 1.0) <= 1e-9; }
bool from_zero(double x) { return x >= 0.0 && std::isfinite(x); }
bool is_mass(double m) { return m > 0.0 && std::isfinite(m); }
bool is_share(double e) { return e >= 0.0 && e <= 1.0; }

void demand_step(const Particle& p, const Obstacle& obstacle, const Material& material,
                 const Vec3& gravity, double dt) {
  demand(is_mass(p.mass), "the particle's mass must be above zero");
  demand(p.position.allFinite() && p.velocity.allFinite(), "the particle must be finite");
  common::require_valid(obstacle);
  demand(is_share(material.restitution), "restitution must be in [0, 1]");
  demand(from_zero(material.friction), "friction must not be negative");
  demand(gravity.allFinite(), "gravity must be finite");
  demand(from_zero(dt), "dt must not be negative");
}

void demand_body(const RigidBody& b) {
  const Mat3& I = b.inverse_inertia;
  demand(from_zero(b.inverse_mass), "an inverse mass must not be negative");
  demand(b.position.allFinite() && b.velocity.allFinite() && b.angular_velocity.allFinite(),
         "a body must be finite");
  demand(I.allFinite() && (I.diagonal().array() >= 0.0).all(), "moments must not be negative");
  demand((I - I.transpose()).lpNorm<Eigen::Infinity>() <= 1e-9 * I.lpNorm<Eigen::Infinity>(),
         "an inverse inertia must be symmetric");
}

Mat3 onto(const Vec3& n) { return n * n.transpose(); }
Mat3 across(const Vec3& n) { return Mat3::Identity() - onto(n); }

/// The vector shortened to a length of at most `limit`.
Vec3 clamped(const Vec3& v, double limit) {
  const double length = v.stableNorm();
  return length > limit ? Vec3(v / length * limit) : v;
}

/// The velocity after an impact with an obstacle. Friction is that of the velocity after the normal
/// impulse, whose slip is the same but for rounding.
Vec3 reflected(const Vec3& v, const Vec3& n, const Material& material) {
  const Vec3 inwards = onto(n) * v;
  if (!(n.dot(v) < 0.0)) return v;
  const Vec3 change = -(1.0 + material.restitution) * inwards;
  const Vec3 bounced = v + change;
  return bounced - clamped(across(n) * bounced, material.friction * change.norm());
}

/// One body's answer to a push, as the change of the velocity at the point.
Vec3 yielded(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  const Vec3 r = point - body.position;
  return impulse * body.inverse_mass + (body.inverse_inertia * r.cross(impulse)).cross(r);
}

}  // namespace

double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution) {
  demand(is_mass(mass) && velocity.allFinite(), "mass or velocity is bad");
  demand(is_unit(normal) && is_share(restitution), "normal or restitution is bad");
  const double momentum = mass * normal.dot(velocity);
  return momentum < 0.0 ? -momentum - restitution * momentum : 0.0;
}

Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction) {
  demand(is_mass(mass) && velocity.allFinite() && is_unit(normal), "particle or normal is bad");
  demand(from_zero(normal_impulse) && from_zero(friction), "impulse or friction is bad");
  return -clamped(across(normal) * velocity * mass, friction * normal_impulse);
}

Vec3 normal_correction(double gap, const Vec3& normal) {
  demand(std::isfinite(gap) && is_unit(normal), "gap or normal is bad");
  return std::max(0.0, -gap) * normal;
}

Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction) {
  demand(displacement.allFinite() && is_unit(normal), "displacement or normal is bad");
  demand(from_zero(normal_length) && from_zero(friction), "length or friction is bad");
  return -clamped(across(normal) * displacement, friction * normal_length);
}

ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections) {
  demand_step(particle, obstacle, material, gravity, dt);
  const Vec3 v = particle.velocity + gravity * dt;
  const Vec3 free = particle.position + v * dt;
  const double depth = -common::gap(obstacle, free);
  if (depth <= 0.0) return {{particle.mass, free, v}, Vec3::Zero()};
  const Vec3 n = common::outward_normal(obstacle, free);
  const Vec3 v_after = reflected(v, n, material);
  Vec3 back = Vec3::Zero();
  if (corrections.tangential) back = clamped(across(n) * v * dt, material.friction * depth);
  const Vec3 out = corrections.normal ? Vec3(depth * n) : Vec3(Vec3::Zero());
  return {{particle.mass, free - back + out, v_after}, particle.mass * (v_after - v)};
}

ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts) {
  demand_step(particle, obstacle, material, gravity, dt);
  demand(max_impacts >= 1, "max_impacts must be at least one");
  ImpactStep step;
  common::Flight flight{particle.position, particle.velocity, gravity};
  double left = dt;
  for (int impacts = 0; impacts < max_impacts; ++impacts) {
    const Vec3 n = common::outward_normal(obstacle, flight.position);
    if (common::gap(obstacle, flight.position) <= 0.0 && n.dot(flight.velocity) <= 0.0) break;
    const std::optional<double> hit = common::time_of_impact(obstacle, flight, left);
    if (!hit) {
      step.particle = {particle.mass, position_at(flight, left), velocity_at(flight, left)};
      return step;
    }
    const Vec3 arriving = velocity_at(flight, *hit);
    flight.position = position_at(flight, *hit);
    const Vec3 there = common::outward_normal(obstacle, flight.position);
    flight.position -= common::gap(obstacle, flight.position) * there;  // rounding only
    flight.velocity = reflected(arriving, there, material);
    left = std::max(0.0, left - *hit);
    step.impacts.push_back({dt - left, particle.mass * (flight.velocity - arriving)});
    if (material.restitution == 0.0) break;
  }
  const Particle rest{particle.mass, flight.position, flight.velocity};
  step.particle = step_by_projection(rest, obstacle, material, gravity, left, {}).particle;
  step.projected = left;
  return step;
}

Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  demand_body(a);
  demand_body(b);
  demand(point.allFinite(), "the point must be finite");
  Mat3 K;
  for (int i = 0; i < 3; ++i) {
    K.col(i) = yielded(a, Vec3::Unit(i), point) + yielded(b, Vec3::Unit(i), point);
  }
  return K;
}

Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material) {
  demand(is_unit(contact.normal), "the normal must be of length one");
  demand(is_share(material.restitution), "restitution must be in [0, 1]");
  demand(from_zero(material.friction), "friction must not be negative");
  const Mat3 K_world = inverse_effective_mass(a, b, contact.point);
  demand(a.inverse_mass + b.inverse_mass > 0.0, "one of the bodies must have a finite mass");

  // Contact frame: the normal is z.
  Mat3 world_from_contact;
  world_from_contact.col(2) = contact.normal;
  world_from_contact.col(0) = contact.normal.unitOrthogonal();
  world_from_contact.col(1) = contact.normal.cross(world_from_contact.col(0));
  const Mat3 K = world_from_contact.transpose() * K_world * world_from_contact;
  const Vec3 u = world_from_contact.transpose() *
                 (b.velocity + b.angular_velocity.cross(contact.point - b.position) - a.velocity -
                  a.angular_velocity.cross(contact.point - a.position));
  if (u.z() >= 0.0) return Vec3::Zero();

  const double rise = -(1.0 + material.restitution) * u.z();
  Vec3 j = K.ldlt().solve(Vec3(-u.x(), -u.y(), rise));
  const double tangential = std::hypot(j.x(), j.y());
  if (tangential > material.friction * j.z()) {
    const double share = material.friction / tangential;
    j = Vec3(share * j.x(), share * j.y(), 1.0);
    j *= rise / K.row(2).dot(j);
  }
  return world_from_contact * j;
}

RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  demand_body(body);
  demand(impulse.allFinite() && point.allFinite(), "impulse and point must be finite");
  const Vec3 torque = (point - body.position).cross(impulse);
  return {body.inverse_mass, body.inverse_inertia, body.position,
          body.velocity + impulse * body.inverse_mass,
          body.angular_velocity + body.inverse_inertia * torque};
}

}  // namespace lab::impulse_response

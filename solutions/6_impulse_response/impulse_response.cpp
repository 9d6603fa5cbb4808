#include "impulse_response.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/algebra/linear_algebra.hpp"
#include "common/course/require.hpp"

namespace lab::impulse_response {
namespace {

using common::require_body;
using common::require_finite;
using common::require_fraction;
using common::require_not_negative;
using common::require_positive;
using common::require_unit;

void require_valid(const Material& material) {
  require_fraction(material.restitution, "restitution");
  require_not_negative(material.friction, "friction");
}

void require_valid(const Particle& particle) {
  require_positive(particle.mass, "mass");
  require_finite(particle.position, "position");
  require_finite(particle.velocity, "velocity");
}

/// Returns −min(μ pressed, |slip|) slip/|slip|, (2) or (4): slip is the tangential part of motion.
Vec3 against_slip(const Vec3& motion, const Vec3& n, double pressed, double mu) {
  const Vec3 slip = motion - n.dot(motion) * n;
  const double length = slip.norm();
  if (length == 0.0) return Vec3::Zero();
  return -std::min(mu * pressed, length) / length * slip;
}

double impulse_along_normal(double mass, const Vec3& velocity, const Vec3& n, double e) {
  const double v_n = n.dot(velocity);
  if (v_n >= 0.0) return 0.0;
  return -(1.0 + e) * mass * v_n;
}

/// Returns the sum of both impulses on a particle that is at an obstacle.
Vec3 particle_impulse(const Particle& particle, const Vec3& n, const Material& material) {
  const Vec3& v = particle.velocity;
  const double j_n = impulse_along_normal(particle.mass, v, n, material.restitution);
  const Vec3 j_t = against_slip(particle.mass * v, n, j_n, material.friction);
  return j_n * n + j_t;
}

/// Does step_by_projection for arguments that are known to be valid.
ProjectedStep projected(Particle particle, const Obstacle& obstacle, const Material& material,
                        const Vec3& gravity, double dt, const Corrections& corrections) {
  particle.velocity += dt * gravity;
  const Vec3 d = dt * particle.velocity;
  particle.position += d;
  const double phi = common::gap(obstacle, particle.position);
  if (phi >= 0.0) return {particle, Vec3::Zero()};

  const Vec3 n = common::outward_normal(obstacle, particle.position);
  const Vec3 impulse = particle_impulse(particle, n, material);
  particle.velocity += 1.0 / particle.mass * impulse;
  if (corrections.normal) particle.position += -phi * n;
  if (corrections.tangential) particle.position += against_slip(d, n, -phi, material.friction);
  return {particle, impulse};
}

Mat3 skew(const Vec3& w) {
  Mat3 matrix;
  matrix << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
  return matrix;
}

/// Returns the matrix that maps an impulse at a point to the change of the point's velocity.
Mat3 inverse_mass_at(const RigidBody& body, const Vec3& point) {
  const Mat3 r_cross = skew(point - body.position);
  return body.inverse_mass * Mat3::Identity() - r_cross * body.inverse_inertia * r_cross;
}

Vec3 velocity_at(const RigidBody& body, const Vec3& point) {
  return body.velocity + body.angular_velocity.cross(point - body.position);
}

}  // namespace

double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution) {
  require_positive(mass, "mass");
  require_finite(velocity, "velocity");
  require_unit(normal, "normal");
  require_fraction(restitution, "restitution");
  return impulse_along_normal(mass, velocity, normal, restitution);
}

Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction) {
  require_positive(mass, "mass");
  require_finite(velocity, "velocity");
  require_unit(normal, "normal");
  require_not_negative(normal_impulse, "normal_impulse");
  require_not_negative(friction, "friction");
  return against_slip(mass * velocity, normal, normal_impulse, friction);
}

Vec3 normal_correction(double gap, const Vec3& normal) {
  require_finite(gap, "gap");
  require_unit(normal, "normal");
  if (gap >= 0.0) return Vec3::Zero();
  return -gap * normal;
}

Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction) {
  require_finite(displacement, "displacement");
  require_unit(normal, "normal");
  require_not_negative(normal_length, "normal_length");
  require_not_negative(friction, "friction");
  return against_slip(displacement, normal, normal_length, friction);
}

ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections) {
  require_valid(particle);
  common::require_valid(obstacle);
  require_valid(material);
  require_finite(gravity, "gravity");
  require_not_negative(dt, "dt");
  return projected(particle, obstacle, material, gravity, dt, corrections);
}

ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts) {
  require_valid(particle);
  common::require_valid(obstacle);
  require_valid(material);
  require_finite(gravity, "gravity");
  require_not_negative(dt, "dt");
  if (max_impacts < 1) throw std::invalid_argument("max_impacts: want at least 1");

  ImpactStep step{particle, {}, 0.0};
  auto& [mass, x, v] = step.particle;
  double time = 0.0;
  bool bounces = true;
  while (bounces) {
    if (common::gap(obstacle, x) <= 0.0 && common::outward_normal(obstacle, x).dot(v) <= 0.0) break;
    const common::Flight flight{x, v, gravity};
    const std::optional<double> hit = common::time_of_impact(obstacle, flight, dt - time);
    const double flown = hit.value_or(dt - time);
    x = position_at(flight, flown);
    v = velocity_at(flight, flown);
    if (!hit) return step;

    time = std::min(time + flown, dt);
    const Vec3 n = common::outward_normal(obstacle, x);
    const Vec3 impulse = particle_impulse(step.particle, n, material);
    v += impulse / mass;
    step.impacts.push_back({time, impulse});
    bounces =
        material.restitution > 0.0 && step.impacts.size() < static_cast<std::size_t>(max_impacts);
  }
  step.projected = dt - time;
  step.particle =
      projected(step.particle, obstacle, material, gravity, step.projected, {}).particle;
  return step;
}

Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  require_body(a);
  require_body(b);
  require_finite(point, "point");
  return inverse_mass_at(a, point) + inverse_mass_at(b, point);
}

Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material) {
  require_unit(contact.normal, "normal");
  require_valid(material);
  const Mat3 K = inverse_effective_mass(a, b, contact.point);
  if (a.inverse_mass == 0.0 && b.inverse_mass == 0.0) {
    throw std::invalid_argument("both bodies are immovable: no impulse moves them apart");
  }
  const Vec3& n = contact.normal;
  const Vec3 u = velocity_at(b, contact.point) - velocity_at(a, contact.point);
  const double u_n = n.dot(u);
  if (u_n >= 0.0) return Vec3::Zero();

  const double e = material.restitution;
  const double mu = material.friction;
  Vec3 stick = common::inverse(K) * (-e * u_n * n - u);  // eq. (8)
  const double stick_n = n.dot(stick);
  const Vec3 stick_t = stick - stick_n * n;
  if (stick_t.norm() <= mu * stick_n) return stick;

  const Vec3 edge = n + mu * stick_t.normalized();
  return -(1.0 + e) * u_n / n.dot(K * edge) * edge;  // eq. (9)
}

RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  require_body(body);
  require_finite(impulse, "impulse");
  require_finite(point, "point");
  RigidBody next = body;
  next.velocity += body.inverse_mass * impulse;
  next.angular_velocity += body.inverse_inertia * (point - body.position).cross(impulse);
  return next;
}

}  // namespace lab::impulse_response

#include "bodies.hpp"

#include <Eigen/LU>

namespace tests {
namespace {

using VecL = Eigen::Matrix<Real, 3, 1>;
using MatL = Eigen::Matrix<Real, 3, 3>;
using common::Vec3;

VecL widened(const Vec3& v) { return v.cast<Real>(); }

/// A body's velocities in extended precision.
struct Motion {
  VecL v = VecL::Zero();
  VecL w = VecL::Zero();
};

VecL lever(const RigidBody& body, const Vec3& point, bool of_origin) {
  return of_origin ? widened(point) : VecL(widened(point) - widened(body.position));
}

/// What an impulse of size 1 along n at a contact does to a body.
Motion pushed(const RigidBody& body, const Contact& contact, SystemFlaw flaw) {
  const VecL n = widened(contact.normal);
  const VecL r = lever(body, contact.point, flaw == SystemFlaw::lever_of_origin);
  const bool no_W = flaw == SystemFlaw::no_W;
  Motion change;
  change.v = (no_W || flaw == SystemFlaw::no_masses ? Real(1) : wide(body.inverse_mass)) * n;
  change.w = r.cross(n);
  if (flaw == SystemFlaw::no_lever_arms || flaw == SystemFlaw::no_lever_arms_in_A) {
    change.w.setZero();
  }
  if (!no_W && flaw != SystemFlaw::no_inertia) {
    change.w = body.inverse_inertia.cast<Real>() * change.w;
  }
  return change;
}

/// n·(v + w × r) at a contact.
Real speed(const RigidBody& body, const Contact& contact, const Motion& motion, SystemFlaw flaw) {
  const VecL r = lever(body, contact.point, flaw == SystemFlaw::lever_of_origin);
  return widened(contact.normal).dot(motion.v + motion.w.cross(r));
}

/// By which sign a body is in a contact: +1 as b, −1 as a, 0 not at all.
int side(const Contact& contact, int body) {
  return (contact.b == body ? 1 : 0) - (contact.a == body ? 1 : 0);
}

Real entry(const Bodies& in, std::size_t i, std::size_t j, SystemFlaw flaw) {
  if (i != j && flaw == SystemFlaw::no_coupling) return 0;
  Real sum = 0;
  for (int k = 0; k < static_cast<int>(in.bodies.size()); ++k) {
    const RigidBody& body = in.bodies[static_cast<std::size_t>(k)];
    int sign = side(in.contacts[i], k) * side(in.contacts[j], k);
    if (sign == 0) continue;
    if (flaw == SystemFlaw::only_a && side(in.contacts[i], k) > 0) continue;
    if (flaw == SystemFlaw::only_b && side(in.contacts[i], k) < 0) continue;
    if (flaw == SystemFlaw::coupling_unsigned) sign = 1;
    if (flaw == SystemFlaw::coupling_sign && i != j) sign = -sign;
    const Motion change = pushed(body, in.contacts[j], flaw);
    sum += sign * speed(body, in.contacts[i], change, flaw);
  }
  return sum;
}

Real opening(const Bodies& in, const Contact& contact, SystemFlaw flaw) {
  Real sum = 0;
  for (const int k : {contact.a, contact.b}) {
    const RigidBody& body = in.bodies[static_cast<std::size_t>(k)];
    Motion motion{widened(body.velocity), widened(body.angular_velocity)};
    if (flaw == SystemFlaw::no_lever_arms || flaw == SystemFlaw::no_lever_arms_in_u) {
      motion.w.setZero();
    }
    if (flaw == SystemFlaw::torque_sign) motion.w = -motion.w;
    int sign = side(contact, k);
    if (flaw == SystemFlaw::u_of_a) sign = -sign;
    if (flaw == SystemFlaw::u_of_sum) sign = 1;
    if (flaw == SystemFlaw::u_of_b && sign < 0) sign = 0;
    sum += sign * speed(body, contact, motion, flaw);
  }
  return sum;
}

void push(RigidBody& body, const VecL& j, const Vec3& point, ImpulseFlaw flaw) {
  const VecL r = lever(body, point, flaw == ImpulseFlaw::lever_of_origin);
  const MatL inverse_inertia = body.inverse_inertia.cast<Real>();
  Real share = flaw == ImpulseFlaw::no_mass ? 1 : wide(body.inverse_mass);
  if (flaw == ImpulseFlaw::no_velocity) share = 0;
  VecL turn = inverse_inertia * r.cross(j);
  if (flaw == ImpulseFlaw::no_turning) turn.setZero();
  if (flaw == ImpulseFlaw::torque_sign) turn = -turn;
  if (flaw == ImpulseFlaw::no_inertia) turn = r.cross(j);
  if (flaw == ImpulseFlaw::inertia_first) turn = r.cross(inverse_inertia * j);
  body.velocity = (widened(body.velocity) + share * j).cast<double>();
  body.angular_velocity = (widened(body.angular_velocity) + turn).cast<double>();
}

}  // namespace

ContactSystem system_of(const Bodies& in, SystemFlaw flaw) {
  const auto m = static_cast<Eigen::Index>(in.contacts.size());
  ContactSystem system{Matrix(m, m), Vector(m)};
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto row = static_cast<std::size_t>(i);
    system.u[i] = static_cast<double>(opening(in, in.contacts[row], flaw));
    for (Eigen::Index j = 0; j < m; ++j) {
      system.A(i, j) = static_cast<double>(entry(in, row, static_cast<std::size_t>(j), flaw));
    }
  }
  return system;
}

std::vector<RigidBody> bodies_after(const Bodies& in, const Vector& lambda, ImpulseFlaw flaw) {
  std::vector<RigidBody> next = in.bodies;
  for (Eigen::Index i = 0; i < lambda.size(); ++i) {
    if (flaw == ImpulseFlaw::no_pulling && lambda[i] < 0.0) continue;
    const Contact& c = in.contacts[static_cast<std::size_t>(i)];
    if (flaw == ImpulseFlaw::last_alone) {
      for (const int k : {c.a, c.b}) {
        next[static_cast<std::size_t>(k)] = in.bodies[static_cast<std::size_t>(k)];
      }
    }
    VecL j = wide(lambda[i]) * widened(c.normal);
    if (flaw == ImpulseFlaw::reversed) j = -j;
    const VecL on_a = flaw == ImpulseFlaw::same_on_both ? j : VecL(-j);
    if (flaw != ImpulseFlaw::not_on_a) {
      push(next[static_cast<std::size_t>(c.a)], on_a, c.point, flaw);
    }
    if (flaw != ImpulseFlaw::not_on_b) push(next[static_cast<std::size_t>(c.b)], j, c.point, flaw);
  }
  return next;
}

Vec3 momentum(const std::vector<RigidBody>& bodies) {
  VecL sum = VecL::Zero();
  for (const RigidBody& body : bodies) sum += widened(body.velocity) / wide(body.inverse_mass);
  return sum.cast<double>();
}

Vec3 angular_momentum(const std::vector<RigidBody>& bodies) {
  VecL sum = VecL::Zero();
  for (const RigidBody& body : bodies) {
    const MatL inertia = body.inverse_inertia.cast<Real>().inverse();
    sum += widened(body.position).cross(widened(body.velocity)) / wide(body.inverse_mass) +
           inertia * widened(body.angular_velocity);
  }
  return sum.cast<double>();
}

double kinetic_energy(const std::vector<RigidBody>& bodies) {
  Real sum = 0;
  for (const RigidBody& body : bodies) {
    const VecL w = widened(body.angular_velocity);
    const MatL inertia = body.inverse_inertia.cast<Real>().inverse();
    sum += widened(body.velocity).squaredNorm() / wide(body.inverse_mass) + w.dot(inertia * w);
  }
  return static_cast<double>(sum / 2);
}

Bodies random_bodies(Random& random, bool walls) {
  Bodies all;
  for (int k = 0; k < 5; ++k) {
    RigidBody body;
    body.inverse_mass = random.uniform(0.2, 2.0);
    body.inverse_inertia = random.inertia();
    body.position = random.vector(2.0);
    body.velocity = random.vector(1.0);
    body.angular_velocity = random.vector(1.0);
    if (walls && k == 1) body.inverse_mass = 0.0;
    if (walls && k == 3) body.inverse_mass = 0.0, body.inverse_inertia.setZero();
    all.bodies.push_back(body);
  }
  const int wanted = static_cast<int>(random.uniform(1.0, 10.0));
  while (static_cast<int>(all.contacts.size()) < wanted) {
    const int a = static_cast<int>(random.uniform(0.0, 5.0));
    const int b = static_cast<int>(random.uniform(0.0, 5.0));
    const auto mass_of = [&](int k) {
      return all.bodies[static_cast<std::size_t>(k)].inverse_mass;
    };
    if (a == b || (mass_of(a) == 0.0 && mass_of(b) == 0.0)) continue;
    all.contacts.push_back({a, b, random.vector(2.0), random.direction()});
  }
  return all;
}

}  // namespace tests

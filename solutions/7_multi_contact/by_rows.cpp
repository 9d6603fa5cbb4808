// The same lab without the supplied solvers: A is read off the bodies by pushing them, u is always
// worked out anew from λ, contacts held at once come from a dual active set, the zone from
// conjugate directions, the diamond is a box that is turned, and the momentum is written by θ. The
// solvers that repeat a product leave out the zeros of A.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "by_rows_held.hpp"
#include "by_rows_sparse.hpp"
#include "common/course/require.hpp"
#include "multi_contact.hpp"

namespace lab::multi_contact {
namespace {

using by_rows::Held;
using by_rows::shortest;
using by_rows::SparseRows;
using common::block;
using common::entries;
using common::product;
using common::require_fraction;
using common::require_not_negative;
using common::require_system;
using common::spread;

void require_valid(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts) {
  common::require_bodies(bodies);
  for (const Contact& contact : contacts) {
    common::require_pair(bodies, contact.a, contact.b);
    common::require_finite(contact.point, "contact.point");
    common::require_unit(contact.normal, "contact.normal");
  }
}

void require_valid(const Matrix& A, const Vector& b, const Vector& lambda, double mu) {
  require_system(A, b, lambda);
  require_not_negative(mu, "mu");
  if (b.size() % 3 != 0) throw std::invalid_argument("there must be three rows for each contact");
}

/// How fast the body's point moves along the normal.
double speed(const RigidBody& body, const Contact& contact) {
  const Vec3 lever = contact.point - body.position;
  return contact.normal.dot(body.velocity + body.angular_velocity.cross(lever));
}

RigidBody& at(std::vector<RigidBody>& bodies, int k) { return bodies[static_cast<std::size_t>(k)]; }

/// The bodies after one impulse.
std::vector<RigidBody> pushed(std::vector<RigidBody> bodies, const Contact& contact,
                              double impulse) {
  for (int k : {contact.a, contact.b}) {
    const Vec3 j = (k == contact.b ? impulse : -impulse) * contact.normal;
    RigidBody& body = at(bodies, k);
    body.velocity += body.inverse_mass * j;
    body.angular_velocity += body.inverse_inertia * (contact.point - body.position).cross(j);
  }
  return bodies;
}

/// The point of the rule's bounds that is nearest; l ≥ 0.
Vec2 nearest(const Vec2& p, double l, FrictionRule rule) {
  const Vec2 size = p.cwiseAbs();
  if (rule == FrictionRule::box) return p.cwiseMin(Vec2(l, l)).cwiseMax(Vec2(-l, -l));
  if (rule == FrictionRule::disc) return size.norm() <= l ? p : Vec2(p / size.norm() * l);
  if (size.sum() <= l) return p;
  // Turned by 45 degrees and stretched by √2 the diamond is a box.
  const double sum = std::clamp(p.x() + p.y(), -l, l);
  const double difference = std::clamp(p.x() - p.y(), -l, l);
  return Vec2(0.5 * (sum + difference), 0.5 * (sum - difference));
}

}  // namespace

ContactSystem contact_system(const std::vector<RigidBody>& bodies,
                             const std::vector<Contact>& contacts) {
  require_valid(bodies, contacts);
  const auto m = static_cast<Eigen::Index>(contacts.size());
  const auto opening = [&](std::vector<RigidBody> moving) {
    Vector u(m);
    Eigen::Index i = 0;
    for (const Contact& contact : contacts) {
      u[i++] = speed(at(moving, contact.b), contact) - speed(at(moving, contact.a), contact);
    }
    return u;
  };
  std::vector<RigidBody> still = bodies;
  for (RigidBody& body : still) body.velocity = body.angular_velocity = Vec3::Zero();
  ContactSystem system{Matrix(m, m), opening(bodies)};
  Eigen::Index j = 0;
  for (const Contact& contact : contacts) {
    system.A.col(j++) = opening(pushed(still, contact, 1.0));
  }
  return system;
}

std::vector<RigidBody> with_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<Contact>& contacts, const Vector& lambda) {
  require_valid(bodies, contacts);
  common::require_entries(lambda, static_cast<Eigen::Index>(contacts.size()), "lambda");
  std::vector<RigidBody> next = bodies;
  Eigen::Index i = 0;
  for (const Contact& contact : contacts) next = pushed(next, contact, lambda[i++]);
  return next;
}

double energy_gained(const ContactSystem& system, const Vector& lambda) {
  require_system(system.A, system.u, lambda);
  const Vector after = system.u + product(system.A, lambda);
  return 0.5 * lambda.dot(system.u + after);
}

Impulses sequential_impulses(const ContactSystem& system, double restitution, int max_impulses) {
  const auto& [A, u] = system;
  require_system(A, u);
  require_fraction(restitution, "restitution");
  require_not_negative(max_impulses, "max_impulses");
  const double least = -1e-12 * common::largest_entry(u);
  Impulses result{Vector::Zero(u.size()), 0, false};
  const int count = static_cast<int>(u.size());
  int quiet = 0;  // how many in a row did not approach
  for (int i = 0; quiet < count; i = (i + 1) % count) {
    const double u_i = u[i] + common::row_product(A, i, result.lambda);
    ++quiet;
    if (u_i >= least) continue;
    if (result.count == max_impulses) return result;
    result.lambda[i] -= (1.0 + restitution) * u_i / A(i, i);
    ++result.count;
    quiet = 0;
  }
  result.ended = true;
  return result;
}

Vector gauss_seidel(const Matrix& A, const Vector& b, const Vector& start, int sweeps) {
  require_system(A, b, start);
  require_not_negative(sweeps, "sweeps");
  const SparseRows rows(A);
  const Vector diagonal = A.diagonal();
  Vector lambda = start;
  Vector u = rows.times(start) + b;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      const double change = std::max(-u[i] / diagonal[i], -lambda[i]);
      if (change == 0.0) continue;
      lambda[i] += change;
      rows.add_column(static_cast<std::size_t>(i), change, u);
    }
  }
  return lambda;
}

double residual(const Matrix& A, const Vector& b, const Vector& lambda) {
  require_system(A, b, lambda);
  const Vector u = product(A, lambda) + b;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    worst = std::max(worst, std::abs(lambda[i] < u[i] ? lambda[i] : u[i]));
  }
  return worst;
}

Vector simultaneous_impulses(const ContactSystem& system, double restitution) {
  require_system(system.A, system.u);
  require_fraction(restitution, "restitution");
  return Held(system.A, system.u + restitution * system.u.cwiseMin(0.0)).solution();
}

Impulses generalized_reflections(const ContactSystem& system, double restitution,
                                 int max_reflections) {
  const auto& [A, u] = system;
  require_system(A, u);
  require_fraction(restitution, "restitution");
  require_not_negative(max_reflections, "max_reflections");
  const double least = -1e-12 * common::largest_entry(u);
  Impulses result{Held(A, u).solution(), 0, true};
  if (restitution == 0.0) return result;
  Vector reflected = Vector::Zero(u.size());
  for (;;) {
    const Vector now = u + product(A, reflected);
    std::vector<int> V;
    for (int i = 0; i < now.size(); ++i) {
      if (now[i] < least) V.push_back(i);
    }
    result.ended = V.empty();
    if (result.ended || result.count == max_reflections) break;
    const Vector x = Held(block(A, V), entries(now, V)).solution();
    reflected += 2.0 * spread(x, V, u.size());
    ++result.count;
  }
  result.lambda += restitution * (reflected - result.lambda);
  return result;
}

Impulses inelastic_projection(const ContactSystem& system) {
  const auto& [A, u] = system;
  require_system(A, u);
  const double least = -1e-12 * common::largest_entry(u);
  Impulses result{Vector::Zero(u.size()), 0, true};
  std::vector<int> Z;
  for (std::size_t before = 1; before != Z.size() || result.count == 0;) {
    before = Z.size();
    const Vector now = u + product(A, result.lambda);
    for (int i = 0; i < u.size(); ++i) {
      if (now[i] < least && std::find(Z.begin(), Z.end(), i) == Z.end()) Z.push_back(i);
    }
    if (before == Z.size()) break;
    const Vector x = shortest(block(A, Z), -entries(u, Z));
    result.lambda = spread(x, Z, u.size());
    ++result.count;
  }
  return result;
}

Vec2 limited(const Vec2& tangential, double limit, FrictionRule rule) {
  if (!tangential.allFinite()) common::refuse_entry("tangential");
  require_not_negative(limit, "limit");
  return nearest(tangential, limit, rule);
}

Vector friction_sweeps(const Matrix& A, const Vector& b, const Vector& start, double friction,
                       FrictionRule rule, int sweeps) {
  require_valid(A, b, start, friction);
  require_not_negative(sweeps, "sweeps");
  Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (Eigen::Index n = 0; n < b.size(); n += 3) {
      const Vector others = b + product(A, lambda) - A.col(n) * lambda[n];
      lambda[n] = std::max(0.0, -others[n] / A(n, n));
      const Vec2 slip = (others + A.col(n) * lambda[n]).segment<2>(n + 1);
      const double trace = A(n + 1, n + 1) + A(n + 2, n + 2);
      const double cross = A(n + 1, n + 2);
      const double apart = std::hypot(A(n + 1, n + 1) - A(n + 2, n + 2), 2.0 * cross);
      const Vec2 tried = Vec2(lambda.segment<2>(n + 1)) - slip * (2.0 / (trace + apart));
      lambda.segment<2>(n + 1) = nearest(tried, friction * lambda[n], rule);
    }
  }
  return lambda;
}

double coulomb_residual(const Matrix& A, const Vector& b, const Vector& lambda, double friction) {
  require_valid(A, b, lambda, friction);
  const Vector u = product(A, lambda) + b;
  double worst = 0.0;
  for (Eigen::Index n = 0; n < b.size(); n += 3) {
    const Vec2 now = lambda.segment<2>(n + 1);
    const Vec2 tried = now - Vec2(u.segment<2>(n + 1));
    const Vec2 back = nearest(tried, std::max(0.0, friction * lambda[n]), FrictionRule::disc);
    worst = std::max({worst, std::abs(std::min(u[n], lambda[n])), (back - now).norm()});
  }
  return worst;
}

Vector accelerated(const Matrix& A, const Vector& b, int steps) {
  require_system(A, b);
  require_not_negative(steps, "steps");
  const SparseRows rows(A);
  const double L = common::largest_eigenvalue(b.size(), common::largest_entry(A.diagonal()),
                                              [&](const Vector& x) { return rows.times(x); });
  Vector last = Vector::Zero(b.size());
  Vector lambda = last;
  double momentum = 0.0;
  double theta = 1.0;  // 1/c
  for (int step = 0; step < steps; ++step) {
    const Vector y = lambda + momentum * (lambda - last);
    const Vector slope = rows.times(y) + b;
    last = lambda;
    lambda = (y - slope / L).cwiseMax(0.0);
    if (slope.dot(lambda - last) > 0.0) theta = 1.0;
    const double next = 0.5 * theta * (std::sqrt(theta * theta + 4.0) - theta);
    momentum = (1.0 - theta) / theta * next;
    theta = next;
  }
  return lambda;
}

}  // namespace lab::multi_contact

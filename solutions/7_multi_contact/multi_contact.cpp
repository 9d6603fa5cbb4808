#include "multi_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/course/require.hpp"

namespace lab::multi_contact {
namespace {

using common::require_fraction;
using common::require_not_negative;
using common::require_system;

void require_valid(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts) {
  common::require_bodies(bodies);
  for (const auto& [a, b, point, normal] : contacts) {
    common::require_pair(bodies, a, b);
    common::require_finite(point, "point");
    common::require_unit(normal, "normal");
  }
}

void require_valid(const Matrix& A, const Vector& b, const Vector& lambda, double friction) {
  require_system(A, b, lambda);
  require_not_negative(friction, "friction");
  if (b.size() % 3 != 0) throw std::invalid_argument("A: want three rows for each contact");
}

template <typename List>
auto& at(List& list, int i) {
  return list[static_cast<std::size_t>(i)];
}

/// What a contact's row of J has for the velocity and for the spin of a body that it touches.
std::pair<Vec3, Vec3> row_part(const Contact& contact, int body, const Vec3& center) {
  const Vec3 n = body == contact.b ? contact.normal : -contact.normal;
  return {n, (contact.point - center).cross(n)};
}

/// Row i of A λ + b.
double row(const Matrix& A, const Vector& b, const Vector& lambda, int i) {
  return common::row_product(A, i, lambda) + b[i];
}

std::vector<int> approaching(const Vector& u, double tol) {
  std::vector<int> found;
  for (int i = 0; i < u.size(); ++i) {
    if (u[i] < -tol) found.push_back(i);
  }
  return found;
}

}  // namespace

ContactSystem contact_system(const std::vector<RigidBody>& bodies,
                             const std::vector<Contact>& contacts) {
  require_valid(bodies, contacts);
  const int m = static_cast<int>(contacts.size());
  ContactSystem system{Matrix::Zero(m, m), Vector::Zero(m)};
  for (int i = 0; i < m; ++i) {
    for (int k : {at(contacts, i).a, at(contacts, i).b}) {  // eq. (1), body by body
      const RigidBody& body = at(bodies, k);
      const auto [n_i, turn_i] = row_part(at(contacts, i), k, body.position);
      system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        if (k != at(contacts, j).a && k != at(contacts, j).b) continue;
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, body.position);
        system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);
      }
    }
  }
  return system;
}

std::vector<RigidBody> with_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<Contact>& contacts, const Vector& lambda) {
  require_valid(bodies, contacts);
  common::require_entries(lambda, static_cast<Eigen::Index>(contacts.size()), "lambda");
  std::vector<RigidBody> next = bodies;
  for (int i = 0; i < lambda.size(); ++i) {
    for (int k : {at(contacts, i).a, at(contacts, i).b}) {  // eq. (2)
      RigidBody& body = at(next, k);
      const auto [n, turn] = row_part(at(contacts, i), k, body.position);
      body.velocity += body.inverse_mass * lambda[i] * n;
      body.angular_velocity += body.inverse_inertia * (lambda[i] * turn);
    }
  }
  return next;
}

double energy_gained(const ContactSystem& system, const Vector& lambda) {
  require_system(system.A, system.u, lambda);
  return lambda.dot(system.u + 0.5 * common::product(system.A, lambda));  // eq. (3)
}

Impulses sequential_impulses(const ContactSystem& system, double restitution, int max_impulses) {
  auto [A, u] = system;
  require_system(A, u);
  require_fraction(restitution, "restitution");
  require_not_negative(max_impulses, "max_impulses");
  const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching(u, tol).empty()};
  while (!done.ended && done.count < max_impulses) {
    for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {
      if (u[i] >= -tol) continue;
      const double d = -(1.0 + restitution) * u[i] / A(i, i);  // eq. (4)
      done.lambda[i] += d;
      u += d * A.col(i);
      ++done.count;
    }
    done.ended = approaching(u, tol).empty();
  }
  return done;
}

Vector gauss_seidel(const Matrix& A, const Vector& b, const Vector& start, int sweeps) {
  require_system(A, b, start);
  require_not_negative(sweeps, "sweeps");
  Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)
    }
  }
  return lambda;
}

double residual(const Matrix& A, const Vector& b, const Vector& lambda) {
  require_system(A, b, lambda);
  return common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b));  // eq. (6)
}

Vector simultaneous_impulses(const ContactSystem& system, double restitution) {
  const auto& [A, u] = system;
  require_system(A, u);
  require_fraction(restitution, "restitution");
  return common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)
}

Impulses generalized_reflections(const ContactSystem& system, double restitution,
                                 int max_reflections) {
  auto [A, u] = system;
  require_system(A, u);
  require_fraction(restitution, "restitution");
  require_not_negative(max_reflections, "max_reflections");
  const Vector inelastic = common::complementary(A, u);
  if (restitution == 0.0) return {inelastic, 0, true};
  const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};
  std::vector<int> V = approaching(u, tol);
  while (!V.empty() && done.count < max_reflections) {
    const Vector x = common::complementary(common::block(A, V), common::entries(u, V));
    const Vector twice = common::spread(2.0 * x, V, u.size());  // eq. (7)
    done.lambda += twice;
    u += common::product(A, twice);
    ++done.count;
    V = approaching(u, tol);
  }
  done.ended = V.empty();
  done.lambda = (1.0 - restitution) * inelastic + restitution * done.lambda;  // eq. (8)
  return done;
}

Impulses inelastic_projection(const ContactSystem& system) {
  const auto& [A, u] = system;
  require_system(A, u);
  const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};
  std::vector<int> Z;
  for (;;) {
    Vector now = u + common::product(A, done.lambda);
    for (int i : Z) now[i] = 0.0;
    const std::vector<int> more = approaching(now, tol);
    if (more.empty()) return done;
    Z.insert(Z.end(), more.begin(), more.end());
    const Vector x = common::least_norm_solution(common::block(A, Z), -common::entries(u, Z));
    done.lambda = common::spread(x, Z, u.size());  // eq. (9)
    ++done.count;
  }
}

Vec2 limited(const Vec2& tangential, double limit, FrictionRule rule) {
  if (!tangential.allFinite()) common::refuse_entry("tangential");
  require_not_negative(limit, "limit");
  const double length = tangential.norm();
  if (rule == FrictionRule::disc) return length > limit ? limit / length * tangential : tangential;
  const Vec2 corner(limit, limit);
  if (rule == FrictionRule::box) return tangential.cwiseMax(-corner).cwiseMin(corner);
  const Vec2 size = tangential.cwiseAbs();
  if (size.sum() <= limit) return tangential;
  const double left = std::clamp(size.x() - 0.5 * (size.sum() - limit), 0.0, limit);  // eq. (10)
  return {std::copysign(left, tangential.x()), std::copysign(limit - left, tangential.y())};
}

Vector friction_sweeps(const Matrix& A, const Vector& b, const Vector& start, double friction,
                       FrictionRule rule, int sweeps) {
  require_valid(A, b, start, friction);
  require_not_negative(sweeps, "sweeps");
  Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n = 0; n < b.size(); n += 3) {
      const auto [t, s] = std::pair(n + 1, n + 2);
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)
    }
  }
  return lambda;
}

double coulomb_residual(const Matrix& A, const Vector& b, const Vector& lambda, double friction) {
  require_valid(A, b, lambda, friction);
  double most = 0.0;
  for (int n = 0; n < b.size(); n += 3) {
    const double limit = friction * std::max(0.0, lambda[n]);
    const Vec2 now(lambda[n + 1], lambda[n + 2]);
    const Vec2 slip(row(A, b, lambda, n + 1), row(A, b, lambda, n + 2));
    most = std::max(most, std::abs(std::min(lambda[n], row(A, b, lambda, n))));  // eq. (12)
    most = std::max(most, (now - limited(now - slip, limit, FrictionRule::disc)).norm());
  }
  return most;
}

Vector accelerated(const Matrix& A, const Vector& b, int steps) {
  require_system(A, b);
  require_not_negative(steps, "steps");
  const double L = common::largest_eigenvalue(A);
  Vector lambda = Vector::Zero(b.size());
  Vector y = lambda;
  double c = 1.0;
  for (int step = 0; step < steps; ++step) {  // eq. (13)
    const Vector g = common::product(A, y) + b;
    const Vector next = (y - g / L).cwiseMax(0.0);
    if (g.dot(next - lambda) > 0.0) c = 1.0;
    const double c_next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * c * c));
    y = next + (c - 1.0) / c_next * (next - lambda);
    lambda = next;
    c = c_next;
  }
  return lambda;
}

}  // namespace lab::multi_contact

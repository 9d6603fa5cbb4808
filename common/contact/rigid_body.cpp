#include "common/contact/rigid_body.hpp"

#include <stdexcept>

#include "common/course/require.hpp"

namespace common {

void require_body(const RigidBody& body) {
  require_not_negative(body.inverse_mass, "inverse_mass");
  require_finite(body.position, "position");
  require_finite(body.velocity, "velocity");
  require_finite(body.angular_velocity, "angular_velocity");
  const Mat3& inertia = body.inverse_inertia;
  const double asymmetry = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  const bool symmetric = asymmetry <= 1e-9 * inertia.cwiseAbs().maxCoeff();
  if (!inertia.allFinite() || !symmetric || !(inertia.diagonal().minCoeff() >= 0.0)) {
    throw std::invalid_argument("inverse_inertia: must be symmetric, without negative moments");
  }
}

void require_bodies(const std::vector<RigidBody>& bodies) {
  for (const RigidBody& body : bodies) require_body(body);
}

void require_pair(const std::vector<RigidBody>& bodies, int a, int b) {
  const int count = static_cast<int>(bodies.size());
  if (a < 0 || a >= count || b < 0 || b >= count || a == b) {
    throw std::invalid_argument("a pair: must be the numbers of two bodies");
  }
  const auto inverse_mass = [&](int k) { return bodies[static_cast<std::size_t>(k)].inverse_mass; };
  if (inverse_mass(a) == 0.0 && inverse_mass(b) == 0.0) {
    throw std::invalid_argument("a pair: one of the bodies must be able to move");
  }
}

}  // namespace common

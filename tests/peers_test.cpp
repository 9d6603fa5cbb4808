#include "peers.hpp"

#include <cmath>

#include "catch.hpp"
#include "common/rotation/attitude.hpp"

using namespace lab::gyroscopic_tumbling;
using common::Spin;
using common::Vec3;

namespace {

const Vec3 moments(1.0, 2.0, 3.0);
constexpr double dt = 0.1;

Peer peer(const std::string& name) {
  for (const Peer& candidate : peers()) {
    if (candidate.name.rfind(name, 0) == 0) return candidate;
  }
  FAIL("there is no " + name);
  return {};
}

/// Warns where the peer is not installed: then there is nothing to test but the words.
bool is_installed(const Peer& candidate) {
  CHECK_FALSE(left_out(candidate).empty());
  if (!candidate.make) WARN(left_out(candidate));
  return static_cast<bool>(candidate.make);
}

Spin spin_about(int axis, double wobble) {
  Spin spin;
  spin.world_from_body = common::Quat(0.5, 0.1, -0.7, 0.3).normalized();
  spin.angular_velocity_body = Vec3::Constant(wobble);
  spin.angular_velocity_body[axis] = 1.0;
  return spin;
}

/// Size of the wobble of a spin about an axis; without damping it is constant.
double wobble(const Vec3& omega, int axis) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    sum += moments[i] * (moments[i] - moments[axis]) * omega[i] * omega[i];
  }
  return std::sqrt(std::abs(sum));
}

double wobble_factor(const Peer& candidate, int axis) {
  constexpr int steps = 200;
  const Spin start = spin_about(axis, 1e-5);
  const auto body = candidate.make(moments, start, dt);
  for (int i = 0; i < steps; ++i) body->step(Vec3::Zero());
  const Vec3 omega = body->spin().angular_velocity_body;
  return std::pow(wobble(omega, axis) / wobble(start.angular_velocity_body, axis), 1.0 / steps);
}

double single_or(double tolerance, const Peer& candidate) {
  return candidate.name.find("single") != std::string::npos ? 1e-3 : tolerance;
}

}  // namespace

TEST_CASE("Bullet damps a wobble as its implicit step must", "[peers]") {
  const Peer bullet = peer("Bullet");
  if (!is_installed(bullet)) return;
  for (const int axis : {0, 2}) {
    const double a = moments[axis];
    const double j = moments[(axis + 1) % 3];
    const double k = moments[(axis + 2) % 3];
    const double y = dt * std::sqrt((a - j) * (a - k) / (j * k));
    CHECK(std::abs(wobble_factor(bullet, axis) - 1.0 / std::sqrt(1.0 + y * y)) <
          single_or(2e-9, bullet));
  }
}

TEST_CASE("ODE damps a wobble about the major axis and feeds one about the minor", "[peers]") {
  const Peer ode = peer("ODE");
  if (!is_installed(ode)) return;
  for (const int axis : {0, 2}) {
    const double a = moments[axis];
    const double j = moments[(axis + 1) % 3];
    const double k = moments[(axis + 2) % 3];
    const double factor = std::sqrt((1.0 + dt * dt) / (1.0 + dt * dt * a * a / (j * k)));
    // The formula is that of a whole turn of the wobble; single steps scatter about it.
    CHECK(std::abs(wobble_factor(ode, axis) - factor) < 3e-4);
    CHECK((wobble_factor(ode, axis) < 1.0) == (axis == 2));
  }
}

TEST_CASE("A torque speeds a peer up and the body starts anew where it is placed", "[peers]") {
  for (const Peer& candidate : peers()) {
    if (!is_installed(candidate)) continue;
    Spin still = spin_about(2, 0.0);
    still.angular_velocity_body.setZero();
    const auto body = candidate.make(moments, still, dt);
    const Vec3 axis = still.world_from_body * Vec3::UnitZ();
    for (int round = 0; round < 2; ++round) {
      body->place(still);
      CHECK(common::angle_between(body->world_from_body(), still.world_from_body) <
            single_or(1e-14, candidate));
      for (int i = 0; i < 10; ++i) body->step(0.6 * axis);
      // Ten steps of 0.1 s under 0.6 N m about the axis of 3 kg m²; some 100 operations.
      CHECK((body->spin().angular_velocity_body - Vec3(0.0, 0.0, 0.2)).norm() <
            single_or(1e-13, candidate));
      CHECK(common::angle_between(body->world_from_body(), still.world_from_body) > 0.1);
    }
  }
}

TEST_CASE("A peer that is not installed is named with its package", "[peers]") {
  CHECK(left_out({"ODE", "libode-dev", nullptr}) == "ODE (libode-dev is not installed)");
  CHECK(peers().size() == 2);
}

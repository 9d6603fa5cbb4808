#include "catch.hpp"
#include "peers.hpp"

using namespace lab::multi_contact;
using common::Vec3;

namespace {

constexpr int many = 1000;

double single_or(double tolerance, const Peer& peer) {
  return peer.name.find("single") != std::string::npos ? 1e-5 : tolerance;
}

/// Those that are installed; warns of the others.
std::vector<Peer> installed() {
  std::vector<Peer> found;
  for (const Peer& peer : peers()) {
    CHECK_FALSE(left_out(peer).empty());
    if (peer.make) {
      found.push_back(peer);
    } else {
      WARN(left_out(peer));
    }
  }
  return found;
}

PeerBalls falling_column(int count) {
  PeerBalls balls;
  balls.walls = {{Vec3::UnitZ(), 0.0}};
  for (int i = 0; i < count; ++i) {
    balls.centers.emplace_back(0.0, 0.0, i + 0.5);
    balls.velocities.emplace_back(0.0, 0.0, -1.0);
  }
  return balls;
}

double largest_speed(const PeerWorld& world) {
  double largest = 0.0;
  for (const Vec3& v : world.velocities()) largest = std::max(largest, v.norm());
  return largest;
}

}  // namespace

// Its own few iterations cannot: Gauss-Seidel shrinks the error by cos²(π/20) each, by 0.78 in ten.
TEST_CASE("A column that falls comes to rest after many iterations and not after few", "[peers]") {
  for (const Peer& peer : installed()) {
    const auto world = peer.make(falling_column(10));
    for (int round = 0; round < 2; ++round) {  // from the start each time
      world->step(peer.iterations);
      REQUIRE(world->velocities().size() == 10);
      CHECK(largest_speed(*world) > 0.1);
      world->step(many);
      CHECK(largest_speed(*world) < single_or(1e-5, peer));
    }
  }
}

TEST_CASE("A ball that comes shares its momentum with two that it touches", "[peers]") {
  PeerBalls row;
  row.centers = {Vec3(-1.0, 0.0, 0.0), Vec3::Zero(), Vec3(1.0, 0.0, 0.0)};
  row.velocities = {Vec3(1.0, 0.0, 0.0), Vec3::Zero(), Vec3::Zero()};
  for (const Peer& peer : installed()) {
    const auto world = peer.make(row);
    world->step(many);
    for (const Vec3& v : world->velocities()) {
      CHECK((v - Vec3(1.0 / 3.0, 0.0, 0.0)).norm() < single_or(1e-7, peer));
    }
  }
}

TEST_CASE("A peer of lab 7 that is not installed is named with its package", "[peers]") {
  CHECK(left_out({"ODE", "libode-dev", 20, nullptr}) == "ODE (libode-dev is not installed)");
  CHECK(peers().size() == 2);
}

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/types.hpp"

/// How other engines stop balls that fall on one another, run as their users run them: one world,
/// one step with the engine's own settings, but gravity, friction, bounce, damping, sleep and the
/// repair of positions off.
namespace lab::multi_contact {

/// Balls are where normal·x ≥ offset.
struct Wall {
  common::Vec3 normal = common::Vec3::UnitZ();  ///< unit
  double offset = 0.0;                          ///< [m]
};

/// Balls of 1 kg that touch one another and walls.
struct PeerBalls {
  double radius = 0.5;                   ///< [m]
  std::vector<common::Vec3> centers;     ///< [m]
  std::vector<common::Vec3> velocities;  ///< [m/s]
  std::vector<Wall> walls;
};

/// The balls in another engine's world.
class PeerWorld {
 public:
  PeerWorld() = default;
  virtual ~PeerWorld() = default;
  PeerWorld(const PeerWorld&) = delete;
  PeerWorld& operator=(const PeerWorld&) = delete;

  /// From the balls as they were given: finds their contacts, solves them in so many iterations
  /// from zero impulses, and moves on.
  virtual void step(int iterations) = 0;

  /// Of each ball, after the step.
  [[nodiscard]] virtual std::vector<common::Vec3> velocities() const = 0;
};

/// An engine that charts can be drawn against.
struct Peer {
  std::string name;     ///< with version and precision where it is installed
  std::string package;  ///< of Debian
  int iterations = 10;  ///< its own number of them
  std::function<std::unique_ptr<PeerWorld>(const PeerBalls&)> make;  ///< empty if not installed
};

/// Bullet and ODE, whether they are installed or not.
std::vector<Peer> peers();

/// What a chart says of a peer that it cannot draw, as in "ODE (libode-dev is not installed)".
std::string left_out(const Peer& peer);

/// Present where the engine is: see peers().
Peer bullet_peer();
Peer ode_peer();

}  // namespace lab::multi_contact

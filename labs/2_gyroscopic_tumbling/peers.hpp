#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/spin.hpp"
#include "common/types.hpp"

/// How other engines turn a rigid body, run as their users run them: one body in one world, with
/// the engine's own settings, but gravity, damping and sleep off and gyroscopic torque on.
namespace lab::gyroscopic_tumbling {

/// A body in another engine's world. It turns about its centre of mass or, which is the same to the
/// engine, about a fixed point at which its moments are taken.
class PeerBody {
 public:
  PeerBody() = default;
  virtual ~PeerBody() = default;
  PeerBody(const PeerBody&) = delete;
  PeerBody& operator=(const PeerBody&) = delete;

  /// Starts anew from `spin`, in the same world.
  virtual void place(const common::Spin& spin) = 0;

  /// One step under a torque that is held through it, world frame [N m].
  virtual void step(const common::Vec3& torque) = 0;

  [[nodiscard]] virtual common::Quat world_from_body() const = 0;
  [[nodiscard]] virtual common::Spin spin() const = 0;
};

/// Makes a body with principal moments [kg m²] that takes steps of dt [s]. The world is made with
/// it: time its steps, not this.
using MakePeerBody = std::function<std::unique_ptr<PeerBody>(const common::Vec3& moments,
                                                             const common::Spin& start, double dt)>;

/// An engine that charts can be drawn against.
struct Peer {
  std::string name;     ///< with version and precision where it is installed
  std::string package;  ///< of Debian
  MakePeerBody make;    ///< empty where it is not installed
};

/// Bullet and ODE, whether they are installed or not.
std::vector<Peer> peers();

/// What a chart says of a peer that it cannot draw, as in "ODE (libode-dev is not installed)".
std::string left_out(const Peer& peer);

/// Present where the engine is: see peers().
Peer bullet_peer();
Peer ode_peer();

}  // namespace lab::gyroscopic_tumbling

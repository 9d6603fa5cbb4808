#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/rotation/spin.hpp"
#include "common/types.hpp"

/// Other engines that turn a rigid body. They run as their users run them: one body in one world,
/// with the engine's own settings, except that gravity, damping and sleep are off and gyroscopic
/// torque is on.
namespace lab::gyroscopic_tumbling {

/// A body in another engine's world. It turns about its centre of mass, or about a fixed point at
/// which its moments are taken. For the engine both are the same.
class PeerBody {
 public:
  PeerBody() = default;
  virtual ~PeerBody() = default;
  PeerBody(const PeerBody&) = delete;
  PeerBody& operator=(const PeerBody&) = delete;

  /// Starts again from `spin`, in the same world.
  virtual void place(const common::Spin& spin) = 0;

  /// Takes one step under a torque that is constant during the step, world frame [N m].
  virtual void step(const common::Vec3& torque) = 0;

  [[nodiscard]] virtual common::Quat world_from_body() const = 0;
  [[nodiscard]] virtual common::Spin spin() const = 0;
};

/// Makes a body with principal moments [kg m²] that takes steps of dt [s]. It makes the world, too,
/// so time the steps and not this function.
using MakePeerBody = std::function<std::unique_ptr<PeerBody>(const common::Vec3& moments,
                                                             const common::Spin& start, double dt)>;

/// An engine against which charts can be drawn.
struct Peer {
  std::string name;     ///< with version and precision if it is installed
  std::string package;  ///< the Debian package
  MakePeerBody make;    ///< empty if it is not installed
};

/// Returns Bullet and ODE, whether they are installed or not.
std::vector<Peer> peers();

/// Returns a note on a peer that cannot be drawn, as in "ODE (libode-dev is not installed)".
std::string left_out(const Peer& peer);

/// These exist if the engine is installed: see peers().
Peer bullet_peer();
Peer ode_peer();

}  // namespace lab::gyroscopic_tumbling

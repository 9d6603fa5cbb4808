#include "peers.hpp"

namespace lab::gyroscopic_tumbling {

std::vector<Peer> peers() {
#ifdef TUMBLE_BULLET
  const Peer bullet = bullet_peer();
#else
  const Peer bullet{"Bullet", "libbullet-dev", nullptr};
#endif
#ifdef TUMBLE_ODE
  const Peer ode = ode_peer();
#else
  const Peer ode{"ODE", "libode-dev", nullptr};
#endif
  return {bullet, ode};
}

std::string left_out(const Peer& peer) {
  return peer.name + " (" + peer.package + " is not installed)";
}

}  // namespace lab::gyroscopic_tumbling

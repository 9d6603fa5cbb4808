#include "peers.hpp"

namespace lab::multi_contact {

std::vector<Peer> peers() {
#ifdef TUMBLE_BULLET
  const Peer bullet = bullet_peer();
#else
  const Peer bullet{"Bullet", "libbullet-dev", 10, nullptr};
#endif
#ifdef TUMBLE_ODE
  const Peer ode = ode_peer();
#else
  const Peer ode{"ODE", "libode-dev", 20, nullptr};
#endif
  return {bullet, ode};
}

std::string left_out(const Peer& peer) {
  return peer.name + " (" + peer.package + " is not installed)";
}

}  // namespace lab::multi_contact

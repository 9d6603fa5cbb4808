#include "peers.hpp"

namespace lab::bvh_traversal {

std::vector<Peer> peers() {
#ifdef TUMBLE_FCL
  const Peer fcl = fcl_peer();
#else
  const Peer fcl{"FCL", "libfcl-dev", nullptr};
#endif
#ifdef TUMBLE_EMBREE
  const Peer embree = embree_peer();
#else
  const Peer embree{"Embree", "libembree-dev", nullptr};
#endif
#ifdef TUMBLE_CGAL
  const Peer cgal = cgal_peer();
#else
  const Peer cgal{"CGAL", "libcgal-dev", nullptr};
#endif
  return {fcl, embree, cgal};
}

std::string left_out(const Peer& peer) {
  return peer.name + " (" + peer.package + " is not installed)";
}

}  // namespace lab::bvh_traversal

#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bvh_traversal.hpp"

/// How other libraries answer the lab's question, run as their users run them: two trees, built
/// once, one pose after the other, all pairs of triangles that meet.
namespace lab::bvh_traversal {

/// Two meshes in another library's trees.
class PeerTrees {
 public:
  PeerTrees() = default;
  virtual ~PeerTrees() = default;
  PeerTrees(const PeerTrees&) = delete;
  PeerTrees& operator=(const PeerTrees&) = delete;

  /// Where b stands from now on, at first where it was built. Whatever the library must do for a
  /// new pose before it can be asked is done here: nothing, new boxes or a new tree.
  virtual void place(const RigidTransform& a_from_b) = 0;

  /// As find_intersections, but that pairs stand in no order, and box_tests is 0.
  [[nodiscard]] virtual Intersections find() = 0;
};

using MakePeerTrees =
    std::function<std::unique_ptr<PeerTrees>(const TriangleMesh& a, const TriangleMesh& b)>;

/// A library that charts can be drawn against.
struct Peer {
  std::string name;     ///< with version and kind of tree where it is installed
  std::string package;  ///< of Debian
  MakePeerTrees make;   ///< builds both trees; empty where it is not installed
};

/// FCL, Embree and CGAL, whether they are installed or not.
std::vector<Peer> peers();

/// What a chart says of a peer that it cannot draw, as in "FCL (libfcl-dev is not installed)".
std::string left_out(const Peer& peer);

/// Present where the library is: see peers().
Peer fcl_peer();
Peer embree_peer();
Peer cgal_peer();

}  // namespace lab::bvh_traversal

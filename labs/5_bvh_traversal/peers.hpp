#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bvh_traversal.hpp"

/// Other libraries that answer the lab's question. They run as their users run them: two trees,
/// built once, then one pose after the other, and all pairs of triangles that meet.
namespace lab::bvh_traversal {

/// Two meshes in another library's trees.
class PeerTrees {
 public:
  PeerTrees() = default;
  virtual ~PeerTrees() = default;
  PeerTrees(const PeerTrees&) = delete;
  PeerTrees& operator=(const PeerTrees&) = delete;

  /// Moves b to this pose from now on; at first b is where it was built. It does all that the
  /// library needs for a new pose before a query: nothing, new boxes or a new tree.
  virtual void place(const RigidTransform& a_from_b) = 0;

  /// Does what find_intersections does, but the pairs are in no order, and box_tests is 0.
  [[nodiscard]] virtual Intersections find() = 0;
};

using MakePeerTrees =
    std::function<std::unique_ptr<PeerTrees>(const TriangleMesh& a, const TriangleMesh& b)>;

/// A library against which charts can be drawn.
struct Peer {
  std::string name;     ///< with version and kind of tree if it is installed
  std::string package;  ///< the Debian package
  MakePeerTrees make;   ///< builds both trees; empty if it is not installed
};

/// Returns FCL, Embree and CGAL, whether they are installed or not.
std::vector<Peer> peers();

/// Returns a note on a peer that cannot be drawn, as in "FCL (libfcl-dev is not installed)".
std::string left_out(const Peer& peer);

/// These exist if the library is installed: see peers().
Peer fcl_peer();
Peer embree_peer();
Peer cgal_peer();

}  // namespace lab::bvh_traversal

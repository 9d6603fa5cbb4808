#include <fcl/config.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision_request.h>
#include <fcl/narrowphase/collision_result.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include "peers.hpp"

namespace lab::bvh_traversal {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSS<double>>;

std::unique_ptr<Model> model(const TriangleMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [i, j, k] : mesh.triangles) triangles.emplace_back(i, j, k);
  auto result = std::make_unique<Model>();
  result->beginModel(static_cast<int>(mesh.triangles.size()),
                     static_cast<int>(mesh.vertices.size()));
  result->addSubModel(mesh.vertices, triangles);
  result->endModel();
  return result;
}

class FclTrees : public PeerTrees {
 public:
  FclTrees(const TriangleMesh& a, const TriangleMesh& b) : a_(model(a)), b_(model(b)) {}

  void place(const RigidTransform& a_from_b) override {
    b_pose_.linear() = a_from_b.rotation;
    b_pose_.translation() = a_from_b.translation;
  }

  /// Does what fcl::collide does with two models, but keeps its counts.
  Intersections find() override {
    constexpr std::size_t all = std::size_t{1} << 30;
    const fcl::CollisionRequest<double> request(all, false);
    fcl::CollisionResult<double> result;
    fcl::detail::MeshCollisionTraversalNodeOBBRSS<double> node;
    const auto at_rest = fcl::Transform3<double>::Identity();
    fcl::detail::initialize(node, *a_, at_rest, *b_, b_pose_, request, result);
    node.enable_statistics = true;
    fcl::detail::collide(&node);
    Intersections found;
    found.triangle_tests = static_cast<std::uint64_t>(node.num_leaf_tests);
    found.pairs.reserve(result.numContacts());
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
      const fcl::Contact<double>& contact = result.getContact(i);
      found.pairs.push_back(
          {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
    return found;
  }

 private:
  std::unique_ptr<Model> a_;
  std::unique_ptr<Model> b_;
  fcl::Transform3<double> b_pose_ = fcl::Transform3<double>::Identity();
};

}  // namespace

Peer fcl_peer() {
  return {std::string("FCL ") + FCL_VERSION + ", OBBRSS", "libfcl-dev",
          [](const TriangleMesh& a, const TriangleMesh& b) {
            return std::make_unique<FclTrees>(a, b);
          }};
}

}  // namespace lab::bvh_traversal

#include "proxy.hpp"

#include "remote.hpp"

namespace lab::bvh_traversal {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

Box box_of(const Triangle& triangle) { return remote<&bvh_traversal::box_of>(triangle); }
Box merged(const Box& a, const Box& b) { return remote<&bvh_traversal::merged>(a, b); }
bool overlap(const Box& a, const Box& b) { return remote<&bvh_traversal::overlap>(a, b); }
double surface_area(const Box& box) { return remote<&bvh_traversal::surface_area>(box); }
Bvh build_median(const TriangleMesh& mesh, int leaf_size) {
  return remote<&bvh_traversal::build_median>(mesh, leaf_size);
}
Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {
  return remote<&bvh_traversal::traverse_as_first_written>(a, b);
}
Traversal traverse(const Bvh& a, const Bvh& b) { return remote<&bvh_traversal::traverse>(a, b); }
bool triangles_meet(const Triangle& a, const Triangle& b) {
  return remote<&bvh_traversal::triangles_meet>(a, b);
}
Intersections find_intersections(const Bvh& a, const Bvh& b) {
  return remote<&bvh_traversal::find_intersections>(a, b);
}
Bvh build_sah(const TriangleMesh& mesh, int leaf_size, int bins) {
  return remote<&bvh_traversal::build_sah>(mesh, leaf_size, bins);
}
Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {
  return remote<&bvh_traversal::find_intersections_moved>(a, b, a_from_b);
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): the contract's
Bvh refit(Bvh bvh, const TriangleMesh& deformed) {
  return remote<&bvh_traversal::refit>(bvh, deformed);
}

}  // namespace lab::bvh_traversal

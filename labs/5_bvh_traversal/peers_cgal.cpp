#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include "peers.hpp"

namespace lab::bvh_traversal {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Triangles triangles_of(const TriangleMesh& mesh, const RigidTransform& pose) {
  const auto point = [](const Vec3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [p, q, r] = common::transformed(pose, triangle(mesh, i));
    triangles.emplace_back(point(p), point(q), point(r));
  }
  return triangles;
}

/// CGAL's own traits, except that they count tests of triangles.
struct CountingTraits : CGAL::AABB_traits<Kernel, Primitive> {
  using Base = CGAL::AABB_traits<Kernel, Primitive>;

  struct Do_intersect : Base::Do_intersect {  // NOLINT(readability-identifier-naming): CGAL's
    Do_intersect(const CountingTraits& traits, std::uint64_t& tests)
        : Base::Do_intersect(traits), count(&tests) {}
    using Base::Do_intersect::operator();
    bool operator()(const Kernel::Triangle_3& query, const Primitive& primitive) const {
      ++*count;
      return Base::Do_intersect::operator()(query, primitive);
    }
    std::uint64_t* count;
  };
  [[nodiscard]] Do_intersect do_intersect_object() const { return {*this, tests}; }

  mutable std::uint64_t tests = 0;
};

/// A tree of a. It is queried for each triangle of b, because CGAL cannot walk two trees at once.
class CgalTrees : public PeerTrees {
 public:
  CgalTrees(const TriangleMesh& a, const TriangleMesh& b)
      : mesh_b_(b), a_(triangles_of(a, {})), b_(triangles_of(b, {})), tree_(a_.begin(), a_.end()) {
    tree_.build();
  }

  void place(const RigidTransform& a_from_b) override { b_ = triangles_of(mesh_b_, a_from_b); }

  Intersections find() override {
    Intersections found;
    tree_.traits().tests = 0;
    std::vector<Triangles::const_iterator> met;
    for (std::size_t j = 0; j < b_.size(); ++j) {
      met.clear();
      tree_.all_intersected_primitives(b_[j], std::back_inserter(met));
      for (const auto& i : met) {
        found.pairs.push_back(
            {static_cast<std::uint32_t>(i - a_.cbegin()), static_cast<std::uint32_t>(j)});
      }
    }
    found.triangle_tests = tree_.traits().tests;
    return found;
  }

 private:
  TriangleMesh mesh_b_;
  Triangles a_;
  Triangles b_;
  CGAL::AABB_tree<CountingTraits> tree_;
};

}  // namespace

Peer cgal_peer() {
  return {"CGAL " CGAL_VERSION_STR ", AABB_tree", "libcgal-dev",
          [](const TriangleMesh& a, const TriangleMesh& b) {
            return std::make_unique<CgalTrees>(a, b);
          }};
}

}  // namespace lab::bvh_traversal

#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/rigid_transform.hpp"
#include "common/geometry/triangle_mesh.hpp"
#include "common/types.hpp"

/// A hierarchy of boxes built for speed. A node has eight children, and their boxes, in floats, are
/// tested at once. A few triangles are tested at once, too.
namespace common {

/// The tree of a mesh. Its boxes are relative to `centre`, in units of 1/scale, rounded outward.
class WideBvh {
 public:
  static constexpr std::size_t width = 8;  ///< children of a node, and triangles of a leaf

  /// Builds by the surface-area heuristic. Throws std::invalid_argument if require_sound throws.
  explicit WideBvh(const TriangleMesh& mesh);

  /// Boxes side by side; those from `size` on are unused.
  struct alignas(64) Node {
    std::array<std::array<float, width>, 3> low{};
    std::array<std::array<float, width>, 3> high{};
    std::array<std::uint32_t, width> child{};  ///< a node, or ~ of one if it is a leaf; or an entry
    std::uint32_t size = 0;
    std::array<float, 3> all_low{}, all_high{};  ///< of the box that holds all of them
    /// A surface is thin across, so these are the mean normal of all triangles below, and how far
    /// each child's triangles reach along it.
    std::array<float, 3> normal{};
    std::array<float, width> from{}, to{};
    float all_from = 0.0F, all_to = 0.0F;
  };
  /// A triangle, stored next to its neighbours.
  struct Entry {
    Triangle corners;
    std::uint32_t triangle = 0;  ///< index in the mesh
  };

  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::uint32_t root() const { return root_; }  ///< as a child
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }
  [[nodiscard]] double scale() const { return scale_; }

 private:
  void lay_slabs(std::uint32_t child, std::size_t& end);

  std::vector<Node> nodes_;
  std::uint32_t root_ = 0;
  std::vector<Entry> entries_;
  Vec3 centre_ = Vec3::Zero();
  double scale_ = 1.0;  ///< a power of two
};

/// A triangle of a and a triangle of b, by their indices in the meshes; sorted by a, then by b.
struct TriangleIndices {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  auto operator<=>(const TriangleIndices&) const = default;
};

/// A function that returns whether two triangles have a point in common, exactly.
using TrianglesMeet = bool (*)(const Triangle& a, const Triangle& b);

}  // namespace common

#pragma once

#include <array>
#include <map>
#include <vector>

#include "render/draw/shapes.hpp"
#include "render/draw/view.hpp"
#include "render/scene.hpp"

namespace render {

enum class Form { box, round, cylinder, cone };

/// A unit shape and how finely it is cut, from 0.
struct ShapeKey {
  Form form = Form::box;
  int level = 0;
  bool operator<(const ShapeKey& other) const {
    return form != other.form ? form < other.form : level < other.level;
  }
};

/// Segments around a turned shape at each level.
inline constexpr std::array<int, 8> segments_of_level{12, 16, 24, 32, 48, 64, 96, 128};

/// One copy of a shape, as the shaders read it. The columns of a matrix that takes the shape to the
/// view's frame hold the place in their last parts.
struct Instance {
  Eigen::Vector4f x_column_and_place;
  Eigen::Vector4f y_column_and_place;
  Eigen::Vector4f z_column_and_place;
  Eigen::Vector4f colour_and_stretch;  ///< linear light
  Eigen::Vector4f accent_and_paleness;
};

/// Copies of each shape, nearest first, so that depth hides what is behind before it is shaded.
using Batches = std::map<ShapeKey, std::vector<Instance>>;

/// Triangles in the view's frame with what paints them.
struct Sheet {
  Triangles triangles;
  Instance paint;
};

/// A parallelepiped that holds a solid.
struct Block {
  Vec3 centre;      ///< world [m]
  Mat3 half_edges;  ///< columns, world [m]

  /// How far it reaches from its centre along a direction, times the direction's length.
  [[nodiscard]] double reach(const Vec3& direction) const {
    return (half_edges.transpose() * direction).lpNorm<1>();
  }
};

/// All triangles of a scene in the form that is drawn.
struct DrawList {
  Batches solids;
  std::vector<Sheet> sheets;
  Batches arrows;
  std::vector<Block> casters;  ///< of shadows: one block for each solid and sheet
};

/// `samples` is the number of samples along a pixel's side, to which curves must look smooth.
DrawList draw_list(const Scene& scene, const View& view, int samples);

/// Sheets of meshes and cloths, with their blocks.
void add_sheets(DrawList& list, const Scene& scene, const View& view);

/// A copy of a shape under the matrix (world from shape) at a place of the world.
Instance instance_of(const View& view, const Mat3& matrix, const Vec3& place, const Paint& paint);

}  // namespace render

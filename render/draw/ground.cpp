#include <algorithm>
#include <array>
#include <cmath>

#include "render/draw/lights.hpp"
#include "render/draw/strokes.hpp"

namespace render {
namespace {

using Eigen::Vector2d;

// A block's shadow on the ground, about the view's origin: three pairs of parallel sides.
struct Shadow {
  Vector2d centre;
  Eigen::Matrix<double, 2, 3> half_edges;

  // How far it reaches along a direction, times the direction's length.
  [[nodiscard]] double reach(const Vector2d& direction) const {
    return (half_edges.transpose() * direction).lpNorm<1>();
  }
  [[nodiscard]] Vector2d reach() const { return half_edges.cwiseAbs().rowwise().sum(); }

  // Whether no line along an edge parts it from a rectangle; it may miss that a corner does.
  [[nodiscard]] bool may_touch(const Vector2d& place, const Vector2d& half_size) const {
    for (int edge = 0; edge < 3; ++edge) {
      const Vector2d across(-half_edges(1, edge), half_edges(0, edge));
      const double distance = std::abs(across.dot(place - centre));
      if (distance > reach(across) + across.cwiseAbs().dot(half_size)) return false;
    }
    return true;
  }
};

Shadow shadow_of(const View& view, const Block& block, const Vec3& towards_light, double height) {
  const Vector2d lean = towards_light.head<2>() / towards_light.z();
  const Vec3 centre = block.centre - view.origin;
  Shadow shadow;
  shadow.centre = centre.head<2>() - lean * (block.centre.z() - height);
  shadow.half_edges = block.half_edges.topRows<2>() - lean * block.half_edges.row(2);
  return shadow;
}

std::vector<Shadow> shadows_of(const View& view, const std::vector<Block>& casters,
                               const std::vector<Vec3>& towards_lights, double height) {
  // A shadow from lower light would be long, and far too faint to see.
  constexpr double lowest_light = 0.1;
  std::vector<Shadow> result;
  for (const Block& block : casters) {
    const double half_height = block.reach(Vec3::UnitZ());
    const bool is_above = block.centre.z() + half_height > height;
    for (const Vec3& light : towards_lights) {
      if (is_above && light.z() >= lowest_light) {
        result.push_back(shadow_of(view, block, light, height));
      }
    }
    const Vec3 towards_eye = (view.eye - block.centre).normalized();
    const bool dips_below = block.centre.z() - half_height < height;
    if (dips_below && towards_eye.z() >= lowest_light) {
      result.push_back(shadow_of(view, block, towards_eye, height));
    }
  }
  return result;
}

struct Patch {
  Vector2d low;
  Vector2d high;
};

// The smallest rectangle that holds all with their soft borders, as far as the ground shows.
Patch hull_of(const View& view, const std::vector<Shadow>& shadows, double border) {
  const double reach = ground_reach(view);
  Patch hull{Vector2d::Constant(reach), Vector2d::Constant(-reach)};
  for (const Shadow& shadow : shadows) {
    const Vector2d half_size = shadow.reach() + Vector2d::Constant(border);
    hull.low = hull.low.cwiseMin(shadow.centre - half_size);
    hull.high = hull.high.cwiseMax(shadow.centre + half_size);
  }
  return {hull.low.cwiseMax(-reach), hull.high.cwiseMin(reach)};
}

constexpr int cells_a_side = 24;

// Which cells of a rectangle's lattice need shading.
class Cells {
 public:
  explicit Cells(const Patch& hull) : hull_(hull), cell_((hull.high - hull.low) / cells_a_side) {}

  void mark(const Shadow& shadow, double border) {
    const Vector2d half_size = shadow.reach() + Vector2d::Constant(border);
    const Vector2d reach = cell_ / 2 + Vector2d::Constant(border);
    const Vector2d low = shadow.centre - half_size;
    const Vector2d high = shadow.centre + half_size;
    for (int y = index(low.y(), 1); y <= index(high.y(), 1); ++y) {
      for (int x = index(low.x(), 0); x <= index(high.x(), 0); ++x) {
        const Vector2d middle = hull_.low + cell_.cwiseProduct(Vector2d(x + 0.5, y + 0.5));
        if (shadow.may_touch(middle, reach)) at(x, y) = true;
      }
    }
  }

  // Each cell has its own two triangles on a common lattice, since longer strips would meet
  // shorter ones at T-junctions, where single pixels stay empty.
  [[nodiscard]] std::vector<Eigen::Vector2f> triangles() {
    std::vector<Eigen::Vector2f> corners;
    for (int y = 0; y < cells_a_side; ++y) {
      for (int x = 0; x < cells_a_side; ++x) {
        if (!at(x, y)) continue;
        corners.insert(corners.end(), {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1),
                                       corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
      }
    }
    return corners;
  }

 private:
  [[nodiscard]] int index(double place, int axis) const {
    const double steps = std::floor((place - hull_.low[axis]) / cell_[axis]);
    return static_cast<int>(std::clamp(steps, 0.0, cells_a_side - 1.0));
  }
  [[nodiscard]] Eigen::Vector2f corner(int x, int y) const {
    return {static_cast<float>(hull_.low.x() + x * cell_.x()),
            static_cast<float>(hull_.low.y() + y * cell_.y())};
  }
  bool& at(int x, int y) {
    return is_shaded_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  }

  Patch hull_;
  Vector2d cell_;
  std::array<std::array<bool, cells_a_side>, cells_a_side> is_shaded_{};
};

}  // namespace

std::vector<Eigen::Vector2f> shaded_ground(const View& view, const std::vector<Block>& casters,
                                           const std::vector<Vec3>& towards_lights,
                                           const Ground& ground) {
  const std::vector<Shadow> shadows = shadows_of(view, casters, towards_lights, ground.height);
  const Patch hull = hull_of(view, shadows, ground.border);
  if ((hull.high - hull.low).minCoeff() <= 0.0) return {};
  Cells cells(hull);
  for (const Shadow& shadow : shadows) cells.mark(shadow, ground.border);
  return cells.triangles();
}

}  // namespace render

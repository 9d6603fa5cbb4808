#include "render/draw/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace render {
namespace {

Eigen::Vector3f linear(const Colour& colour) {
  const auto channel = [](float value) { return linear_from_srgb(std::clamp(value, 0.0F, 1.0F)); };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

// The fewest segments whose chords leave the circle by no more than 0.4 samples.
int level_of(double radius_in_samples) {
  constexpr double tolerance = 0.4;
  const double segments =
      std::numbers::pi / std::sqrt(2.0 * tolerance / std::max(radius_in_samples, 1.0));
  int level = 0;
  while (level + 1 < static_cast<int>(segments_of_level.size()) &&
         segments_of_level[static_cast<std::size_t>(level)] < segments) {
    ++level;
  }
  return level;
}

// How each solid is a unit shape under a scaling, and for a capsule a stretch.
struct Cut {
  Form form;
  Vec3 scale;
  double stretch = 0.0;
};

Cut cut_of(const Box& box) { return {Form::box, box.half_extents}; }

Cut cut_of(const Sphere& sphere) { return {Form::round, Vec3::Constant(sphere.radius)}; }

Cut cut_of(const Cylinder& cylinder) {
  return {Form::cylinder, {cylinder.radius, cylinder.radius, cylinder.half_length}};
}

Cut cut_of(const Capsule& capsule) {
  const double stretch = capsule.radius == 0.0 ? 0.0 : capsule.half_length / capsule.radius;
  return {Form::round, Vec3::Constant(capsule.radius), stretch};
}

class Builder {
 public:
  Builder(DrawList& list, const View& view, int samples)
      : list_(list), view_(view), samples_(samples) {}

  template <typename Solid>
  void add_solids(const std::vector<Solid>& solids) {
    std::vector<double> depths;
    depths.reserve(solids.size());
    for (const Solid& solid : solids) depths.push_back(view_.depth(solid.placement.position));
    std::vector<std::size_t> order(solids.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return depths[a] < depths[b]; });
    for (const std::size_t i : order) add(solids[i]);
  }

  void add(const Arrow& arrow) {
    const Vec3 span = arrow.tip - arrow.tail;
    const double length = span.norm();
    if (length == 0.0 || arrow.width <= 0.0) return;
    const double head = std::min(4.5 * arrow.width, 0.6 * length);
    const double shaft = length - head;
    const Mat3 turn = z_axis_towards(span);
    const double radius = arrow.width / 2;
    // A short arrow's head keeps its shape, so the shaft shrinks with it.
    const double thinning = std::min(1.0, head / (4.5 * arrow.width));
    const int level = level_of(2.0 * radius * samples_per_metre(arrow.tail));
    const Paint paint{arrow.colour, arrow.colour, 0.0F};
    const Mat3 shaft_matrix =
        turn * Vec3(thinning * radius, thinning * radius, shaft / 2).asDiagonal();
    const Vec3 middle = arrow.tail + turn.col(2) * (shaft / 2);
    list_.arrows[{Form::cylinder, level}].push_back(
        instance_of(view_, shaft_matrix, middle, paint));
    const double head_radius = 1.4 * thinning * arrow.width;
    const Mat3 head_matrix = turn * Vec3(head_radius, head_radius, head).asDiagonal();
    list_.arrows[{Form::cone, level}].push_back(
        instance_of(view_, head_matrix, arrow.tail + turn.col(2) * shaft, paint));
  }

 private:
  template <typename Solid>
  void add(const Solid& solid) {
    const Cut cut = cut_of(solid);
    const Placement& placement = solid.placement;
    const double samples = cut.scale.head<2>().cwiseAbs().maxCoeff() *
                           placement.world_from_body.leftCols<2>().norm() / std::numbers::sqrt2 *
                           samples_per_metre(placement.position);
    const int level = cut.form == Form::box ? 0 : level_of(samples);
    Instance instance = instance_of(view_, placement.world_from_body * cut.scale.asDiagonal(),
                                    placement.position, solid.paint);
    instance.colour_and_stretch.w() = static_cast<float>(cut.stretch);
    list_.solids[{cut.form, level}].push_back(instance);
    const Vec3 half_size = cut.scale + Vec3(0.0, 0.0, cut.stretch * cut.scale.z());
    list_.casters.push_back(
        {placement.position, placement.world_from_body * half_size.asDiagonal()});
  }

  [[nodiscard]] double samples_per_metre(const Vec3& place) const {
    const double depth = std::max(view_.depth(place), 0.01 * view_.distance);
    return samples_ * view_.pixels_per_metre(depth);
  }

  DrawList& list_;
  const View& view_;
  int samples_;
};

}  // namespace

Instance instance_of(const View& view, const Mat3& matrix, const Vec3& place, const Paint& paint) {
  Eigen::Matrix3f columns = matrix.cast<float>();
  // A mirrored shape would show its inside. All shapes are their own mirror images across x.
  if (matrix.determinant() < 0.0) columns.col(0) = -columns.col(0);
  const Eigen::Vector3f from_origin = view.from_origin(place);
  const Eigen::Vector3f colour = linear(paint.colour);
  const Eigen::Vector3f accent = linear(paint.accent);
  const auto joined = [](const Eigen::Vector3f& head, float last) {
    return Eigen::Vector4f(head.x(), head.y(), head.z(), last);
  };
  return {joined(columns.col(0), from_origin.x()), joined(columns.col(1), from_origin.y()),
          joined(columns.col(2), from_origin.z()), joined(colour, 0.0F),
          joined(accent, std::clamp(paint.paleness, 0.0F, 1.0F))};
}

DrawList draw_list(const Scene& scene, const View& view, int samples) {
  DrawList list;
  Builder builder(list, view, samples);
  builder.add_solids(scene.boxes);
  builder.add_solids(scene.spheres);
  builder.add_solids(scene.cylinders);
  builder.add_solids(scene.capsules);
  add_sheets(list, scene, view);
  for (const Arrow& arrow : scene.arrows) builder.add(arrow);
  return list;
}

}  // namespace render

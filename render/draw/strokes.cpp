#include "render/draw/strokes.hpp"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

struct PicturePoint {
  Vector4d clip = Vector4d::Zero();
  Eigen::Vector4f colour = Eigen::Vector4f::Zero();
};

// Parts of the line before the near plane; what lies behind it has no place in the picture.
std::vector<std::vector<PicturePoint>> visible_parts(const View& view,
                                                     const std::vector<StrokePoint>& points) {
  std::vector<std::vector<PicturePoint>> parts;
  bool was_visible = false;
  PicturePoint previous;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PicturePoint point{view.clip(points[i].place), points[i].colour};
    const bool is_visible = point.clip.w() >= view.nearest_depth;
    if (i > 0 && is_visible != was_visible) {
      const double share =
          (view.nearest_depth - previous.clip.w()) / (point.clip.w() - previous.clip.w());
      const PicturePoint border{
          previous.clip + share * (point.clip - previous.clip),
          previous.colour + static_cast<float>(share) * (point.colour - previous.colour)};
      if (is_visible) parts.emplace_back();
      parts.back().push_back(border);
    }
    if (is_visible && i == 0) parts.emplace_back();
    if (is_visible) parts.back().push_back(point);
    previous = point;
    was_visible = is_visible;
  }
  return parts;
}

Vector2d pixel_of(const View& view, const Vector4d& clip) {
  return {clip.x() / clip.w() * view.width / 2, clip.y() / clip.w() * view.height / 2};
}

Vector2d turned_left(const Vector2d& direction) { return {-direction.y(), direction.x()}; }

// To the left border of a line at a corner between two directions, for half a width of one.
Vector2d mitre(const Vector2d& before, const Vector2d& after) {
  const Vector2d left = turned_left(before) + turned_left(after);
  if (left.squaredNorm() < 1e-12) return turned_left(after);  // it turns back on itself
  constexpr double longest = 2.0;                             // sharp corners would shoot out
  const double cosine = left.normalized().dot(turned_left(after));
  return left.normalized() * std::min(longest, 1.0 / std::max(cosine, 1e-6));
}

void add_part(Strokes& strokes, const View& view, const std::vector<PicturePoint>& part,
              double width) {
  std::vector<PicturePoint> points;
  std::vector<Vector2d> pixels;
  for (const PicturePoint& point : part) {
    const Vector2d pixel = pixel_of(view, point.clip);
    if (!pixels.empty() && (pixel - pixels.back()).norm() < 1e-3) continue;
    points.push_back(point);
    pixels.push_back(pixel);
  }
  if (points.size() < 2) return;

  const auto direction = [&](std::size_t i) { return (pixels[i + 1] - pixels[i]).normalized(); };
  const std::size_t last = points.size() - 1;
  std::vector<std::array<StrokeVertex, 2>> borders;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vector2d before = direction(i == 0 ? 0 : i - 1);
    const Vector2d after = direction(i == last ? last - 1 : i);
    const Vector2d side = width / 2 * mitre(before, after);
    const Vector4d shift =
        points[i].clip.w() * Vector4d(side.x() * 2 / view.width, side.y() * 2 / view.height, 0, 0);
    const Vector4d left = points[i].clip + shift;
    const Vector4d right = points[i].clip - shift;
    borders.push_back({StrokeVertex{left.cast<float>(), points[i].colour},
                       StrokeVertex{right.cast<float>(), points[i].colour}});
  }
  for (std::size_t i = 0; i < last; ++i) {
    const auto& [left, right] = borders[i];
    const auto& [next_left, next_right] = borders[i + 1];
    strokes.insert(strokes.end(), {left, right, next_right, left, next_right, next_left});
  }
}

}  // namespace

void add_line(Strokes& strokes, const View& view, const std::vector<StrokePoint>& points,
              double width) {
  for (const std::vector<PicturePoint>& part : visible_parts(view, points)) {
    add_part(strokes, view, part, width);
  }
}

}  // namespace render

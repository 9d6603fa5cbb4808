#include "render/draw/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/text/text.hpp"

namespace render {
namespace {

using Eigen::Vector2d;

struct Rectangle {
  Vector2d low;
  Vector2d high;
};

double shared_area(const Rectangle& a, const Rectangle& b) {
  const Vector2d sides = a.high.cwiseMin(b.high) - a.low.cwiseMax(b.low);
  return sides.minCoeff() > 0.0 ? sides.prod() : 0.0;
}

// Letters of DejaVu: how far they rise above the baseline and hang below, per size.
constexpr double rise = 0.76;
constexpr double hang = 0.20;

// Thin coloured strokes would be too pale to read.
constexpr Weight label_weight = Weight::bold;

// Where a text of that extent may stand, best first: for each, where its middle lies, in halves of
// its extent beside the point.
constexpr std::array<std::array<double, 2>, 8> sides{
    {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {0, -1.4}, {0, 1.4}, {1.8, 0}, {-1.8, 0}}};

Rectangle placed(const Vector2d& point, const Vector2d& extent, const std::array<double, 2>& side,
                 double gap) {
  const Vector2d direction(side[0], side[1]);
  const Vector2d middle = point + direction.cwiseProduct(extent / 2 + Vector2d::Constant(gap));
  return {middle - extent / 2, middle + extent / 2};
}

Rectangle moved_inside(Rectangle rectangle, const Image& image) {
  constexpr double border = 3.0;  // the halo's width and one
  const Vector2d size(image.width, image.height);
  const Vector2d over = (rectangle.high - size + Vector2d::Constant(border)).cwiseMax(0.0);
  rectangle.low -= over;
  rectangle.high -= over;
  const Vector2d under = (Vector2d::Constant(border) - rectangle.low).cwiseMax(0.0);
  rectangle.low += under;
  rectangle.high += under;
  return rectangle;
}

Rectangle least_covering(const std::vector<Rectangle>& taken, const Vector2d& point,
                         const Vector2d& extent, const Image& image) {
  Rectangle best{};
  double least_shared = -1.0;
  for (const auto& side : sides) {
    const Rectangle place = moved_inside(placed(point, extent, side, 3.0), image);
    double shared = 0.0;
    for (const Rectangle& other : taken) shared += shared_area(place, other);
    if (least_shared < 0.0 || shared < least_shared) {
      best = place;
      least_shared = shared;
    }
  }
  return best;
}

// Squares along the arrows, as wide as their heads.
std::vector<Rectangle> covered_by(const std::vector<Arrow>& arrows, const View& view) {
  std::vector<Rectangle> squares;
  for (const Arrow& arrow : arrows) {
    constexpr int pieces = 24;
    for (int i = 0; i <= pieces; ++i) {
      const Vec3 place = arrow.tail + (arrow.tip - arrow.tail) * i / pieces;
      const std::optional<Vector2d> pixel = view.pixel(place);
      if (!pixel) continue;
      const double half = arrow.width * view.pixels_per_metre(view.depth(place));
      squares.push_back({*pixel - Vector2d::Constant(half), *pixel + Vector2d::Constant(half)});
    }
  }
  return squares;
}

bool is_inside(const Vector2d& point, const Image& image) {
  return point.minCoeff() >= 0.0 && point.x() <= image.width && point.y() <= image.height;
}

}  // namespace

void draw_labels(Image& image, const View& view, const Scene& scene) {
  std::vector<Rectangle> taken;
  if (!scene.labels.empty()) taken = covered_by(scene.arrows, view);
  for (const Label& label : scene.labels) {
    const std::optional<Vector2d> point = view.pixel(label.point);
    if (!point || !is_inside(*point, image) || label.text.empty() || label.size <= 0.0) continue;
    // Small pictures keep letters large enough to read.
    constexpr double least_size = 14.0;
    const double scaled = label.size * image.height / 720.0;
    const double size = std::max(scaled, std::min(label.size, least_size));
    const Vector2d extent(text_width(label.text, size, label_weight), (rise + hang) * size);
    const Rectangle place = least_covering(taken, *point, extent, image);
    draw_text(image, place.low.x(), place.high.y() - hang * size, label.text,
              {size, label.colour, label_weight, true});
    taken.push_back(place);
  }
}

}  // namespace render

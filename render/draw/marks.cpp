// Trails and contacts.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/draw/strokes.hpp"

namespace render {
namespace {

using Eigen::Vector2d;

Eigen::Vector4f linear(const Colour& colour, double opacity) {
  const auto channel = [](float value) { return linear_from_srgb(std::clamp(value, 0.0F, 1.0F)); };
  return {channel(colour.red), channel(colour.green), channel(colour.blue),
          static_cast<float>(opacity)};
}

// Pixels of this picture for a length told in pixels of one 720 high, but not too thin to be seen.
double scaled(const View& view, double pixels) {
  return std::max(pixels * view.height / 720.0, 0.65 * pixels);
}

// A flat shape around a point of the world, its corners told in pixels right and up.
void add_flat(Strokes& strokes, const View& view, const Vec3& place,
              const std::vector<Vector2d>& corners, const Eigen::Vector4f& colour) {
  const Eigen::Vector4d centre = view.clip(place);
  if (centre.w() < view.nearest_depth) return;
  const auto vertex = [&](const Vector2d& corner) {
    const Eigen::Vector4d shift(corner.x() * 2 / view.width, corner.y() * 2 / view.height, 0, 0);
    return StrokeVertex{(centre + centre.w() * shift).cast<float>(), colour};
  };
  for (std::size_t i = 2; i < corners.size(); ++i) {
    strokes.insert(strokes.end(), {vertex(corners[0]), vertex(corners[i - 1]), vertex(corners[i])});
  }
}

std::vector<Vector2d> circle(double radius) {
  constexpr int corners = 32;
  std::vector<Vector2d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

// The head of a normal, `border` pixels larger all around.
std::vector<Vector2d> arrow_head(const Vector2d& along, double size, double border) {
  const Vector2d side(-along.y(), along.x());
  const Vector2d back = -(size + border) * along;
  const double half = 0.55 * size + 1.6 * border;
  return {(size + 2.2 * border) * along, back + half * side, back - half * side};
}

void add_contact(Strokes& strokes, const View& view, const ContactMark& contact) {
  const Vec3 end = contact.point + contact.length * contact.normal;
  const Eigen::Vector4f colour = linear(contact.colour, 1.0);
  const Eigen::Vector4f white(1.0F, 1.0F, 1.0F, 1.0F);
  const double border = scaled(view, 1.6);
  const double line = scaled(view, 3.0);
  const double head = scaled(view, 7.0);
  const double dot = scaled(view, 5.5);
  const std::optional<Vector2d> from = view.pixel(contact.point);
  const std::optional<Vector2d> to = view.pixel(end);
  // A normal that points at the eye has no direction in the picture; its dot remains.
  const Vector2d span =
      from && to ? Vector2d(to->x() - from->x(), from->y() - to->y()) : Vector2d::Zero();
  const bool has_direction = span.norm() > head;
  if (has_direction) {
    const Vector2d along = span.normalized();
    add_line(strokes, view, {{contact.point, white}, {end, white}}, line + 2 * border);
    add_flat(strokes, view, end, arrow_head(along, head, border), white);
    add_flat(strokes, view, contact.point, circle(dot + border), white);
    add_line(strokes, view, {{contact.point, colour}, {end, colour}}, line);
    add_flat(strokes, view, end, arrow_head(along, head, 0.0), colour);
  } else {
    add_flat(strokes, view, contact.point, circle(dot + border), white);
  }
  add_flat(strokes, view, contact.point, circle(dot), colour);
}

}  // namespace

Strokes trail_strokes(const View& view, const std::vector<Trail>& trails) {
  Strokes strokes;
  for (const Trail& trail : trails) {
    std::vector<StrokePoint> points;
    for (std::size_t i = 0; i < trail.points.size(); ++i) {
      const double share = static_cast<double>(i + 1) / static_cast<double>(trail.points.size());
      points.push_back({trail.points[i], linear(trail.colour, share)});
    }
    add_line(strokes, view, points, scaled(view, trail.width));
  }
  return strokes;
}

Strokes contact_strokes(const View& view, const std::vector<ContactMark>& contacts) {
  Strokes strokes;
  for (const ContactMark& contact : contacts) add_contact(strokes, view, contact);
  return strokes;
}

}  // namespace render

#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/draw/view.hpp"
#include "render/scene.hpp"

namespace render {

/// A corner of a flat triangle that already lies in the picture.
struct StrokeVertex {
  Eigen::Vector4f clip;
  Eigen::Vector4f colour;  ///< linear light and opacity
};

/// Triangles in groups of three.
using Strokes = std::vector<StrokeVertex>;

/// A point of a line, with the line's colour there.
struct StrokePoint {
  Vec3 place;              ///< world [m]
  Eigen::Vector4f colour;  ///< linear light and opacity
};

/// Adds a line of `width` pixels along the points, mitred at corners and cut off before the eye.
void add_line(Strokes& strokes, const View& view, const std::vector<StrokePoint>& points,
              double width);

/// The ground's grid: 1, 2 or 5 x 10^k apart to suit the view, stronger at each fifth line, fading
/// out around the point below the camera's target.
Strokes grid_strokes(const View& view, double ground_height);

/// How far from the point below the target the ground shows [m].
double ground_reach(const View& view);

Strokes trail_strokes(const View& view, const std::vector<Trail>& trails);

/// Dots and normals of contacts, with white around them.
Strokes contact_strokes(const View& view, const std::vector<ContactMark>& contacts);

}  // namespace render

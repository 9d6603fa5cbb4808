#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/types.hpp"
#include "render/colour.hpp"

/// Off-screen pictures: plain descriptions go in, pixels come out. This code knows no physics.
namespace render {

using common::Mat3;
using common::Vec3;

/// The look of a solid. A solid with an accent shows which way it is turned: a box has it on its +x
/// and −x faces, a sphere on its upper half, a cylinder and a capsule on their +z end.
struct Paint {
  Colour colour = palette::orange;
  Colour accent = colour;
  float paleness = 0.0F;  ///< from 0, as painted, to 1, white: ghosts of earlier poses
};

/// The place of a solid. The matrix need not be a rotation, so a method that swells shows it.
struct Placement {
  Vec3 position = Vec3::Zero();  ///< world [m]
  Mat3 world_from_body = Mat3::Identity();
};

/// The attitude that turns a body's z axis, which is a cylinder's axis, to the world's x.
inline const Mat3 z_along_x{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};

/// Returns a rotation that takes +z to the direction by the shortest way; if that is −z, by a half
/// turn about x. The direction may have any length except zero.
Mat3 z_axis_towards(const Vec3& direction);

struct Box {
  Placement placement;
  Vec3 half_extents = Vec3::Constant(0.5);  ///< [m]
  Paint paint;
};

struct Sphere {
  Placement placement;
  double radius = 0.5;  ///< [m]
  Paint paint;
};

/// A cylinder about the body's z axis, with flat ends.
struct Cylinder {
  Placement placement;
  double radius = 0.5;       ///< [m]
  double half_length = 0.5;  ///< [m]
  Paint paint;
};

/// A capsule about the body's z axis. `half_length` ends at the centre of an end's half sphere.
struct Capsule {
  Placement placement;
  double radius = 0.25;      ///< [m]
  double half_length = 0.5;  ///< [m]
  Paint paint;
};

struct Mesh {
  Placement placement;
  std::vector<Vec3> vertices;                 ///< body [m]
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
  bool smooth = false;                        ///< normals averaged at vertices, or one a triangle
  Paint paint;
  std::vector<bool> lit;  ///< for each triangle: accent instead of colour; may be empty
};

/// A sheet of rows x columns particles, drawn from both sides: colour in front, accent behind.
struct Cloth {
  int rows = 0;
  int columns = 0;
  std::vector<Vec3> points;  ///< world [m], row by row
  Paint paint;
};

/// An arrow. It is not lit and casts no shadow.
struct Arrow {
  Vec3 tail = Vec3::Zero();  ///< world [m]
  Vec3 tip = Vec3::UnitZ();  ///< world [m]
  Colour colour = palette::ink;
  double width = 0.03;  ///< of the shaft [m]
};

/// A path that fades towards its start.
struct Trail {
  std::vector<Vec3> points;  ///< world [m], oldest first
  Colour colour = palette::grey;
  double width = 2.0;  ///< in pixels of a picture 720 high
};

/// A contact point with its normal. It is drawn in front of what would hide it.
struct ContactMark {
  Vec3 point = Vec3::Zero();    ///< world [m]
  Vec3 normal = Vec3::UnitZ();  ///< unit, world
  double length = 0.4;          ///< of the drawn normal [m]
  Colour colour = palette::vermilion;
};

/// A text beside a point of the world. It is always in front.
struct Label {
  Vec3 point = Vec3::Zero();  ///< world [m]
  std::string text;           ///< UTF-8, one line
  Colour colour = palette::ink;
  double size = 18.0;  ///< in pixels of a picture 720 high
};

/// Everything that one picture shows.
struct Scene {
  std::vector<Box> boxes;
  std::vector<Sphere> spheres;
  std::vector<Cylinder> cylinders;
  std::vector<Capsule> capsules;
  std::vector<Mesh> meshes;
  std::vector<Cloth> cloths;
  std::vector<Arrow> arrows;
  std::vector<Trail> trails;
  std::vector<ContactMark> contacts;
  std::vector<Label> labels;
  bool ground = true;          ///< a grid and the shadows on it
  double ground_height = 0.0;  ///< world z [m]
};

}  // namespace render

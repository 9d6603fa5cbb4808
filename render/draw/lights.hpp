#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/draw/draw_list.hpp"
#include "render/draw/view.hpp"

namespace render {

/// Half the angle of the key light as seen from the scene, for sampled soft shadows [rad].
inline constexpr double key_half_angle = 0.05;

/// Towards the key light: high, from the left and the front of the view, so that shadows fall
/// inside the picture and show behind their bodies.
Vec3 towards_key_light(const View& view);

/// One of several equally weighted lightings whose mean is soft.
struct LightSample {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< offset of the picture, in pixels
  Vec3 towards_key;
  Vec3 towards_sky = Vec3::UnitZ();  ///< uniform over the upper half sphere
  double casting_share = 0.5;        ///< solids paler than this cast no shadow in this sample
};

/// Samples that fill the pixel, the key light's cone and the sky evenly; always the same.
std::vector<LightSample> light_samples(const View& view, int count);

/// A light's parallel look at the scene, from which a depth map is drawn.
struct LightView {
  Eigen::Matrix4f clip_from_origin;
  Eigen::Matrix4f texture_from_origin;  ///< u, v and depth in [0, 1]
  Eigen::Matrix3f light_from_world;     ///< rows: along u, along v, towards the light
  Eigen::Vector3f per_metre;            ///< of u, v and depth
};

/// The look along a light that holds all casters, with `border` around them [m].
LightView light_view(const View& view, const std::vector<Block>& casters, const Vec3& towards_light,
                     double border);

struct Ground {
  double height;  ///< world z [m]
  double border;  ///< of a shadow: how far its soft edge reaches [m]
};

/// Triangles of the ground that the shadows of these lights may reach, and those that hide what
/// lies under the ground; x and y about the view's origin. The rest needs no shading.
std::vector<Eigen::Vector2f> shaded_ground(const View& view, const std::vector<Block>& casters,
                                           const std::vector<Vec3>& towards_lights,
                                           const Ground& ground);

}  // namespace render

#include "render/draw/lights.hpp"

#include <cmath>
#include <numbers>

namespace render {
namespace {

// The i-th of `count` points that fill the unit disc evenly: a sunflower's seeds.
Eigen::Vector2d in_disc(int i, int count) {
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt((i + 0.5) / count);
  return {radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i)};
}

// The i-th place of a sequence that visits 0 … count − 1 in another order; `stride` must share no
// factor with the count. It keeps what one sample means for each purpose unrelated.
int reordered(int i, int stride, int count) { return i * stride % count; }

double fraction(double x) { return x - std::floor(x); }

}  // namespace

Vec3 towards_key_light(const View& view) {
  constexpr double height = 66.0 * std::numbers::pi / 180.0;
  constexpr double to_the_left = 40.0 * std::numbers::pi / 180.0;
  const Vec3 backward = view.axes.right.cross(Vec3::UnitZ());
  const Vec3 level = std::cos(to_the_left) * backward - std::sin(to_the_left) * view.axes.right;
  return std::sin(height) * Vec3::UnitZ() + std::cos(height) * level;
}

std::vector<LightSample> light_samples(const View& view, int count) {
  const Vec3 key = towards_key_light(view);
  const CameraAxes key_axes = camera_axes(key);
  constexpr double plastic = 1.32471795724474602596;  // its powers spread points over a square
  std::vector<LightSample> samples;
  for (int i = 0; i < count; ++i) {
    LightSample sample;
    sample.pixel = {fraction(0.5 + i / plastic) - 0.5,
                    fraction(0.5 + i / (plastic * plastic)) - 0.5};
    const Eigen::Vector2d disc = std::tan(key_half_angle) * in_disc(reordered(i, 27, count), count);
    sample.towards_key = (key + disc.x() * key_axes.right + disc.y() * key_axes.up).normalized();
    const Eigen::Vector2d seed = in_disc(reordered(i, 11, count), count);
    // Archimedes: equal steps of height are equal areas of the sphere.
    const double z = 1.0 - seed.squaredNorm();
    const Eigen::Vector2d level = seed.normalized() * std::sqrt(1.0 - z * z);
    sample.towards_sky = {level.x(), level.y(), z};
    sample.casting_share = (reordered(i, 37, count) + 0.5) / count;
    samples.push_back(sample);
  }
  return samples;
}

LightView light_view(const View& view, const std::vector<Block>& casters, const Vec3& towards_light,
                     double border) {
  const CameraAxes axes = camera_axes(towards_light);
  Mat3 light_from_world;
  light_from_world << axes.right.transpose(), axes.up.transpose(), axes.backward.transpose();
  Vec3 low = Vec3::Constant(-border);
  Vec3 high = Vec3::Constant(border);
  for (std::size_t i = 0; i < casters.size(); ++i) {
    const Vec3 centre = light_from_world * (casters[i].centre - view.origin);
    const Vec3 reach(border + casters[i].reach(axes.right), border + casters[i].reach(axes.up),
                     border + casters[i].reach(axes.backward));
    low = i == 0 ? Vec3(centre - reach) : Vec3(low.cwiseMin(centre - reach));
    high = i == 0 ? Vec3(centre + reach) : Vec3(high.cwiseMax(centre + reach));
  }

  LightView light;
  const Vec3 scale = (high - low).cwiseInverse();
  Eigen::Matrix4d texture = Eigen::Matrix4d::Identity();
  texture.topLeftCorner<3, 3>() = scale.asDiagonal() * light_from_world;
  texture.topRightCorner<3, 1>() = -(scale.asDiagonal() * low);
  texture.row(2) = -texture.row(2);  // depth grows away from the light
  texture(2, 3) += 1.0;
  Eigen::Matrix4d clip = 2.0 * texture;
  clip.col(3).head<3>().array() -= 1.0;
  clip.row(3) = texture.row(3);
  light.clip_from_origin = clip.cast<float>();
  light.texture_from_origin = texture.cast<float>();
  light.light_from_world = light_from_world.cast<float>();
  light.per_metre = scale.cast<float>();
  return light;
}

}  // namespace render

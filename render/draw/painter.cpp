#include "render/draw/painter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

constexpr int key_map_side = 1024;
constexpr int sky_map_side = 512;

// The filter's radius, as a share of half the height of what shows.
constexpr double filter_share = 0.025;

// Turns by three sixteenths and draws in, for soft_shadow() of the shaders.
Eigen::Matrix2f spiral(double shrink) {
  const Eigen::Rotation2Dd turn(3.0 * std::numbers::pi / 8.0);
  return (shrink * turn.toRotationMatrix()).cast<float>();
}

}  // namespace

Painter::Painter(const Gl& gl)
    : gl_(&gl),
      geometry_(gl),
      canvas_(gl),
      key_map_(gl, key_map_side),
      sky_map_(gl, sky_map_side),
      solid_(gl, shaders::solid_vertex(), shaders::solid_fragment()),
      solid_sampled_(gl, shaders::solid_vertex(), shaders::solid_sampled_fragment()),
      arrow_(gl, shaders::solid_vertex(), shaders::arrow_fragment()),
      depth_(gl, shaders::depth_vertex(), shaders::depth_fragment()),
      ground_(gl, shaders::ground_vertex(), shaders::ground_fragment()),
      ground_sampled_(gl, shaders::ground_vertex(), shaders::ground_sampled_fragment()),
      stroke_(gl, shaders::stroke_vertex(), shaders::stroke_fragment()),
      ground_vertices_(gl, GL_ARRAY_BUFFER),
      stroke_vertices_(gl, GL_ARRAY_BUFFER),
      view_(Camera{}, 1, 1) {
  gl.GenVertexArrays(1, &ground_array_);
  gl.BindVertexArray(ground_array_);
  ground_vertices_.bind();
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);

  gl.GenVertexArrays(1, &stroke_array_);
  gl.BindVertexArray(stroke_array_);
  stroke_vertices_.bind();
  for (GLuint i = 0; i < 2; ++i) {
    gl.EnableVertexAttribArray(i);
    const std::size_t offset = i * sizeof(Eigen::Vector4f);
    gl.VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(StrokeVertex), byte_offset(offset));
  }
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void Painter::load(const Scene& scene, const View& view, int samples, bool white) {
  DrawList list = draw_list(scene, view, samples);
  geometry_.load(list);
  casters_ = std::move(list.casters);
  view_ = view;
  samples_ = samples;
  page_ = linear_from_srgb(static_cast<float>(page_level(white)) / 255.0F);
  has_ground_ = scene.ground;
  ground_height_ = scene.ground_height;
  grid_ = scene.ground ? grid_strokes(view, scene.ground_height) : Strokes();
  trails_ = trail_strokes(view, scene.trails);
  contacts_ = contact_strokes(view, scene.contacts);
}

void Painter::load_ground(const std::vector<Vec3>& towards_lights, double border) {
  const bool is_seen_from_above = view_.eye.z() > ground_height_;
  std::vector<Eigen::Vector2f> corners;
  if (has_ground_ && is_seen_from_above) {
    corners = shaded_ground(view_, casters_, towards_lights, {ground_height_, border});
  }
  ground_corners_ = static_cast<int>(corners.size());
  ground_vertices_.fill(corners);
}

void Painter::draw_filtered() {
  const Vec3 towards_key = towards_key_light(view_);
  const double border = 2.0 * filter_share * view_.radius;
  const Shadow key = draw_shadow(key_map_, towards_key, 0.5, border);
  load_ground({towards_key}, border);
  for (const Program* program : {&ground_, &solid_}) {
    program->use();
    set_shadow(*program, "key", 0, key);
    set_filter(*program);
    set_view(*program, towards_key);
  }
  draw_picture(solid_, ground_, Eigen::Vector2f::Zero());
}

void Painter::draw_sampled(const LightSample& light) {
  const double border = 0.01 * view_.radius;
  const Shadow key = draw_shadow(key_map_, light.towards_key, light.casting_share, border);
  const Shadow sky = draw_shadow(sky_map_, light.towards_sky, light.casting_share, border);
  load_ground({light.towards_key, light.towards_sky}, border);
  for (const Program* program : {&ground_sampled_, &solid_sampled_}) {
    program->use();
    set_shadow(*program, "key", 0, key);
    set_shadow(*program, "sky", 1, sky);
    set_view(*program, light.towards_key);
    program->set("towards_sky", Eigen::Vector3f(light.towards_sky.cast<float>()));
  }
  const Eigen::Vector2d jitter(light.pixel.x() * 2 / view_.width,
                               light.pixel.y() * 2 / view_.height);
  draw_picture(solid_sampled_, ground_sampled_, jitter.cast<float>());
}

Painter::Shadow Painter::draw_shadow(const DepthMap& map, const Vec3& towards_light,
                                     double casting_share, double border) const {
  const LightView light = light_view(view_, casters_, towards_light, border);
  map.bind();
  depth_.use();
  depth_.set("clip_from_origin", light.clip_from_origin);
  depth_.set("casting_share", static_cast<float>(casting_share));
  geometry_.draw_casters();
  return {light, &map};
}

void Painter::set_shadow(const Program& program, const char* light, int unit,
                         const Shadow& shadow) const {
  const std::string name = light;
  const LightView& look = shadow.light;
  shadow.map->bind_as_texture(unit);
  program.set((name + "_map").c_str(), unit);
  program.set((name + "_from_origin").c_str(), look.texture_from_origin);
  program.set((name + "_from_world").c_str(), look.light_from_world);
  program.set((name + "_per_metre").c_str(), look.per_metre);
  // A depth in the map holds for a whole texel, so a slope may differ by that much.
  const auto side = static_cast<float>(shadow.map->side());
  const float texel = 1.0F / (look.per_metre.head<2>().minCoeff() * side);
  program.set((name + "_bias").c_str(), texel);
}

void Painter::set_filter(const Program& program) const {
  const bool is_single = samples_ == 1;
  program.set("filter_radius", static_cast<float>(filter_share * view_.radius));
  program.set("spiral", spiral(is_single ? 0.86 : 0.58));
  program.set("pairs", is_single ? 8 : 2);
  program.set("pairs_to_be_sure", is_single ? 2 : 1);
}

void Painter::set_view(const Program& program, const Vec3& towards_key) const {
  const Vec3 halfway = (towards_key + view_.axes.backward).normalized();
  program.set("clip_from_origin", clip_from_origin(view_));
  program.set("towards_key", Eigen::Vector3f(towards_key.cast<float>()));
  program.set("halfway", Eigen::Vector3f(halfway.cast<float>()));
  program.set("backward", Eigen::Vector3f(view_.axes.backward.cast<float>()));
  program.set("height", static_cast<float>(ground_height_ - view_.origin.z()));
  program.set("page", Eigen::Vector3f(Eigen::Vector3f::Constant(page_)));
}

void Painter::draw_picture(const Program& solid, const Program& ground,
                           const Eigen::Vector2f& jitter) {
  canvas_.bind(samples_ * view_.width, samples_ * view_.height);
  gl_->ClearColor(page_, page_, page_, 1.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  solid.use();
  solid.set("jitter", jitter);
  geometry_.draw_solids();

  // The ground hides what is under it, but leaves no depth: lines on it are spared a contest of
  // equal depths, and arrows may pass through.
  gl_->DepthMask(GL_FALSE);
  ground.use();
  ground.set("jitter", jitter);
  gl_->BindVertexArray(ground_array_);
  gl_->DrawArrays(GL_TRIANGLES, 0, ground_corners_);
  draw_strokes(grid_, jitter);

  gl_->DepthMask(GL_TRUE);
  arrow_.use();
  set_view(arrow_, towards_key_light(view_));
  arrow_.set("jitter", jitter);
  geometry_.draw_arrows();

  gl_->DepthMask(GL_FALSE);
  draw_strokes(trails_, jitter);
  gl_->Disable(GL_DEPTH_TEST);
  draw_strokes(contacts_, jitter);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthMask(GL_TRUE);
}

void Painter::draw_strokes(const Strokes& strokes, const Eigen::Vector2f& jitter) const {
  if (strokes.empty()) return;
  gl_->Enable(GL_BLEND);
  gl_->Disable(GL_CULL_FACE);
  stroke_.use();
  stroke_.set("jitter", jitter);
  gl_->BindVertexArray(stroke_array_);
  stroke_vertices_.fill(strokes);
  gl_->DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(strokes.size()));
  gl_->Enable(GL_CULL_FACE);
  gl_->Disable(GL_BLEND);
}

}  // namespace render

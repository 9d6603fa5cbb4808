#pragma once

#include <vector>

#include "render/draw/geometry.hpp"
#include "render/draw/gl_objects.hpp"
#include "render/draw/lights.hpp"
#include "render/draw/shaders.hpp"
#include "render/draw/strokes.hpp"

namespace render {

/// Draws one scene at a time to its canvas.
class Painter {
 public:
  explicit Painter(const Gl& gl);

  /// Takes in the next scene. Its labels are left to the reader of the canvas.
  /// samples  along a pixel's side: 1 or 2
  /// white    a pure white page
  void load(const Scene& scene, const View& view, int samples, bool white);

  /// Draws with one shadow map, filtered soft.
  void draw_filtered();
  /// Draws under one lighting; the mean of many such pictures is soft. `samples` must be 1.
  void draw_sampled(const LightSample& light);

  [[nodiscard]] const Canvas& canvas() const { return canvas_; }

 private:
  /// A light as a shader sees it.
  struct Shadow {
    LightView light;
    const DepthMap* map;
  };

  [[nodiscard]] Shadow draw_shadow(const DepthMap& map, const Vec3& towards_light,
                                   double casting_share, double border) const;
  void draw_picture(const Program& solid, const Program& ground, const Eigen::Vector2f& jitter);
  void draw_strokes(const Strokes& strokes, const Eigen::Vector2f& jitter) const;
  void set_shadow(const Program& program, const char* light, int unit, const Shadow& shadow) const;
  void set_filter(const Program& program) const;
  void set_view(const Program& program, const Vec3& towards_key) const;
  void load_ground(const std::vector<Vec3>& towards_lights, double border);

  const Gl* gl_;
  Geometry geometry_;
  Canvas canvas_;
  DepthMap key_map_;
  DepthMap sky_map_;
  Program solid_;
  Program solid_sampled_;
  Program arrow_;
  Program depth_;
  Program ground_;
  Program ground_sampled_;
  Program stroke_;
  Buffer ground_vertices_;
  Buffer stroke_vertices_;
  GLuint ground_array_ = 0;
  GLuint stroke_array_ = 0;

  std::vector<Block> casters_;
  View view_;
  int samples_ = 1;
  float page_ = 1.0F;
  bool has_ground_ = true;
  double ground_height_ = 0.0;
  int ground_corners_ = 0;
  Strokes grid_;
  Strokes trails_;
  Strokes contacts_;
};

/// The page's brightness, the same for red, green and blue, in 8-bit sRGB.
inline int page_level(bool white) { return white ? 255 : 249; }

}  // namespace render

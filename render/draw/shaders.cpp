#include "render/draw/shaders.hpp"

#include "render/draw/shader_parts.hpp"

namespace render::shaders {

std::string solid_vertex() {
  return version() + placing() + R"(
uniform mat4 clip_from_origin;
uniform vec2 jitter;
uniform mat4 key_from_origin;
uniform mat4 sky_from_origin;
out vec3 normal;
flat out vec3 albedo;
flat out float paleness;
out vec3 key_place;
out vec3 sky_place;
void main() {
  vec4 place = vec4(placed_point(), 1.0);
  normal = placed_normal();
  albedo = mix(colour_and_stretch.xyz, accent_and_paleness.xyz, normal_and_accent.w);
  paleness = accent_and_paleness.w;
  key_place = (key_from_origin * place).xyz;
  sky_place = (sky_from_origin * place).xyz;
  gl_Position = clip_from_origin * place;
  gl_Position.xy += jitter * gl_Position.w;
}
)";
}

std::string solid_fragment() {
  return version() + receiver_plane() + soft_shadow() + shading() + filtered_main();
}

std::string solid_sampled_fragment() {
  return version() + receiver_plane() + sampled_shadow() + shading() + sampled_main();
}

std::string arrow_fragment() {
  return version() + R"(
in vec3 normal;
flat in vec3 albedo;
out vec4 fragment;
uniform vec3 towards_key;
void main() {
  float light = 0.5 + 0.5 * dot(normalize(normal), towards_key);
  fragment = vec4(albedo * (0.70 + 0.36 * light), 1.0);
}
)";
}

std::string depth_vertex() {
  return version() + placing() + R"(
uniform mat4 clip_from_origin;
uniform float casting_share;
void main() {
  gl_Position = clip_from_origin * vec4(placed_point(), 1.0);
  if (accent_and_paleness.w > casting_share) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
)";
}

std::string depth_fragment() { return version() + "void main() {}\n"; }

std::string ground_vertex() {
  return version() + R"(
layout(location = 0) in vec2 place_on_ground;
uniform mat4 clip_from_origin;
uniform vec2 jitter;
uniform mat4 key_from_origin;
uniform mat4 sky_from_origin;
uniform float height;
out vec3 key_place;
out vec3 sky_place;
void main() {
  vec4 place = vec4(place_on_ground, height, 1.0);
  key_place = (key_from_origin * place).xyz;
  sky_place = (sky_from_origin * place).xyz;
  gl_Position = clip_from_origin * place;
  gl_Position.xy += jitter * gl_Position.w;
}
)";
}

std::string ground_fragment() {
  return version() + receiver_plane() + soft_shadow() + ground_inputs() + R"(
void main() {
  fragment = vec4(page * (1.0 - 0.52 * (1.0 - key_visibility(key_place, up))), 1.0);
}
)";
}

std::string ground_sampled_fragment() {
  return version() + receiver_plane() + sampled_shadow() + ground_inputs() + R"(
void main() {
  float missing_key = 1.0 - key_visibility(key_place, up);
  float missing_sky = 2.0 * towards_sky.z * (1.0 - sky_visibility(sky_place, up));
  fragment = vec4(page * (1.0 - 0.46 * missing_key - 0.25 * missing_sky), 1.0);
}
)";
}

std::string stroke_vertex() {
  return version() + R"(
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 stroke_colour;
uniform vec2 jitter;
out vec4 colour;
void main() {
  colour = stroke_colour;
  gl_Position = clip;
  gl_Position.xy += jitter * clip.w;
}
)";
}

std::string stroke_fragment() {
  return version() + R"(
in vec4 colour;
out vec4 fragment;
void main() { fragment = colour; }
)";
}

}  // namespace render::shaders

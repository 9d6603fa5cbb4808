#include "render/draw/shader_parts.hpp"

namespace render::shaders {
namespace {

// Where the key light is, and the depths that it sees.
std::string key_light() {
  return R"(
uniform sampler2DShadow key_map;
uniform mat3 key_from_world;
uniform vec3 key_per_metre;
uniform float key_bias;
uniform vec3 towards_key;
)";
}

}  // namespace

std::string version() { return "#version 330 core\n"; }

// A shape's copy: capsules move their ends apart by the stretch; normals turn by the cofactors of
// the matrix, which is right for any matrix, even one that squashes flat.
std::string placing() {
  return R"(
layout(location = 0) in vec4 point_and_end;
layout(location = 1) in vec4 normal_and_accent;
layout(location = 2) in vec4 x_column_and_place;
layout(location = 3) in vec4 y_column_and_place;
layout(location = 4) in vec4 z_column_and_place;
layout(location = 5) in vec4 colour_and_stretch;
layout(location = 6) in vec4 accent_and_paleness;
vec3 placed_point() {
  vec3 body = point_and_end.xyz;
  body.z += point_and_end.w * colour_and_stretch.w;
  vec3 place = vec3(x_column_and_place.w, y_column_and_place.w, z_column_and_place.w);
  return body.x * x_column_and_place.xyz + body.y * y_column_and_place.xyz +
         body.z * z_column_and_place.xyz + place;
}
vec3 placed_normal() {
  vec3 x = x_column_and_place.xyz, y = y_column_and_place.xyz, z = z_column_and_place.xyz;
  vec3 n = normal_and_accent.xyz;
  n = n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y);
  return n * inversesqrt(max(dot(n, n), 1e-30));
}
)";
}

// The depth at which a plane meets the light, per metre across it: without it, wide filters would
// let each sloped face shade itself.
std::string receiver_plane() {
  return R"(
vec2 receiver_slope(mat3 light_from_world, vec3 n) {
  vec3 seen = light_from_world * n;
  return seen.xy / max(seen.z, 0.05);
}
)";
}

// Pairs of places on opposite sides of a disc, each pair turned and drawn in from the last by
// `spiral`. A picture of 2 x 2 samples a pixel gives each sample two pairs, turned by eighths from
// its neighbours'; one sample a pixel takes eight. Pairs that agree end it: a branch would save no
// work on a processor that runs both sides, the end of a loop does. Places are computed, since such
// a processor would fetch them from an array one by one.
std::string soft_shadow() {
  return key_light() + R"(
uniform mat2 spiral;
uniform float filter_radius;
uniform int pairs;
uniform int pairs_to_be_sure;
vec2 first_place() {
  bool is_single = pairs_to_be_sure > 1;
  ivec2 odd = ivec2(gl_FragCoord.xy) & 1;
  vec2 place = odd.x == 1 && !is_single ? vec2(0.70710678) : vec2(1.0, 0.0);
  return filter_radius * (odd.y == 1 && !is_single ? vec2(-place.y, place.x) : place);
}
float key_visibility(vec3 place, vec3 n) {
  vec2 slope = receiver_slope(key_from_world, n);
  place.z -= key_per_metre.z * key_bias * (1.0 + abs(slope.x) + abs(slope.y));
  vec2 off = first_place();
  int last = dot(n, towards_key) > 0.0 ? pairs : 0;
  float sum = 0.0;
  float count = 0.0;
  for (int i = 1; i <= last; ++i) {
    vec3 step = key_per_metre * vec3(off, dot(slope, off));
    sum += texture(key_map, place + step) + texture(key_map, place - step);
    count += 2.0;
    if (i >= pairs_to_be_sure && (sum == 0.0 || sum == count)) break;
    off = spiral * off;
  }
  return sum / max(count, 1.0);
}
)";
}

std::string sampled_shadow() {
  return key_light() + R"(
uniform sampler2DShadow sky_map;
uniform mat3 sky_from_world;
uniform vec3 sky_per_metre;
uniform float sky_bias;
uniform vec3 towards_sky;
float visibility(sampler2DShadow map, vec3 place, vec2 slope, float bias) {
  place.z -= bias * (1.0 + abs(slope.x) + abs(slope.y));
  return texture(map, place);
}
float key_visibility(vec3 place, vec3 n) {
  vec2 slope = receiver_slope(key_from_world, n);
  return visibility(key_map, place, slope, key_bias * key_per_metre.z);
}
float sky_visibility(vec3 place, vec3 n) {
  vec2 slope = receiver_slope(sky_from_world, n);
  return visibility(sky_map, place, slope, sky_bias * sky_per_metre.z);
}
)";
}

// Light from a key light, the sky, the bright ground and, weakly, from the camera, which tells
// apart two faces that the sky lights alike.
std::string shading() {
  return R"(
in vec3 normal;
flat in vec3 albedo;
flat in float paleness;
in vec3 key_place;
in vec3 sky_place;
out vec4 fragment;
uniform vec3 halfway;
uniform vec3 backward;
const float key_strength = 0.58, sky_strength = 0.34, bounce_strength = 0.26;
const float camera_strength = 0.18;
vec3 shaded(vec3 n, float key, float sky) {
  float facing = max(dot(n, towards_key), 0.0) * key;
  float light = key_strength * facing + sky_strength * sky +
                bounce_strength * (0.5 - 0.5 * n.z) + camera_strength * max(dot(n, backward), 0.0);
  float gloss = max(dot(n, halfway), 0.0);
  gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
  // The power makes equal steps of paleness look equal: light is mixed here, not what eyes make of it.
  return mix(albedo * light + 0.10 * gloss * key, vec3(1.0), paleness * sqrt(paleness));
}
)";
}

std::string filtered_main() {
  return R"(
void main() {
  vec3 n = normalize(normal);
  float key = key_visibility(key_place, n);
  fragment = vec4(shaded(n, key, 0.5 + 0.5 * n.z), 1.0);
}
)";
}

std::string sampled_main() {
  return R"(
void main() {
  vec3 n = normalize(normal);
  float key = key_visibility(key_place, n);
  float sky = 2.0 * max(dot(n, towards_sky), 0.0) * sky_visibility(sky_place, n);
  fragment = vec4(shaded(n, key, sky), 1.0);
}
)";
}

// The ground is the page itself, darkened where light is missing.
std::string ground_inputs() {
  return R"(
in vec3 key_place;
in vec3 sky_place;
out vec4 fragment;
uniform vec3 page;
const vec3 up = vec3(0.0, 0.0, 1.0);
)";
}

}  // namespace render::shaders

// Three bodies move under the steps of the lab: a T-handle that flips, its angular velocity on the
// energy ellipsoid, from which the explicit loop's runs off, and a spinning top.
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>

#include "common/course/if_written.hpp"
#include "common/rotation/attitude.hpp"
#include "common/rotation/free_rotation.hpp"
#include "gyroscopic_tumbling.hpp"
#include "render/film/film.hpp"

using namespace lab::gyroscopic_tumbling;
namespace palette = render::palette;

namespace {

constexpr double duration = 6.4;
constexpr double dt = 0.02;
constexpr int steps = 320;
const Vec3 moments(1.0, 2.0, 3.0);  // crossbar, stem, across both
constexpr HeavyTop heavy_top{1.25, 0.5, 9.81};

const Vec3 handle_center(-1.95, 0.0, 1.2);
const Vec3 ellipsoid_center(0.0, 0.0, 1.2);
const Vec3 top_pivot(2.0, 0.0, 0.0);

/// Returns a spin about the stem, the intermediate axis, off by a hundredth. It turns over every
/// three seconds.
Spin handle_start() {
  const Vec3 omega = 2.0 * std::numbers::pi * Vec3(0.01, 1.0, 0.01).normalized();
  return {Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX())), omega};  // stem up
}

/// Returns a top that leans by 30 degrees, its axis let go at rest.
Spin top_start() {
  const Quat leaning(Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3::UnitY()));
  return {leaning, Vec3(0.0, 0.0, 30.0)};
}

/// The states of a body, one for each step.
using Track = std::vector<Spin>;

/// Returns the motion by a method from a start. If the method is not written yet, returns nothing
/// and adds an entry to `missing`.
std::optional<Track> tracked(const Spin& start, const std::function<Spin(const Spin&)>& step,
                             std::vector<std::string>& missing) {
  return common::if_written(missing, [&] {
    Track track{start};
    while (track.size() <= steps) track.push_back(step(track.back()));
    return track;
  });
}

/// Runs the loop of step 2.2 on a body without forces.
Spin loop_step(const Spin& spin) {
  RigidBodyState state;
  state.world_from_body = spin.world_from_body;
  state.angular_velocity = spin.world_from_body * spin.angular_velocity_body;
  const RigidBodyState next = step_explicit({1.0, moments}, state, {}, dt);
  return {next.world_from_body, next.world_from_body.conjugate() * next.angular_velocity};
}

std::size_t step_at(double time) { return static_cast<std::size_t>(std::lround(time / dt)); }

double energy(const Spin& spin) {
  return 0.5 * spin.angular_velocity_body.dot(moments.cwiseProduct(spin.angular_velocity_body));
}

Vec3 momentum(const Spin& spin) {
  return spin.world_from_body * moments.cwiseProduct(spin.angular_velocity_body);
}

/// A capsule that is part of a body, from one end to the other in body axes.
struct Rod {
  Vec3 from;
  Vec3 to;
  double radius;
  render::Colour colour;
};

void add_rod(render::Scene& scene, const Vec3& center, const Mat3& R, const Rod& rod) {
  scene.capsules.push_back(
      {{center + R * (0.5 * (rod.from + rod.to)), R * render::z_axis_towards(rod.to - rod.from)},
       rod.radius,
       0.5 * (rod.to - rod.from).norm(),
       {rod.colour, rod.colour}});
}

void add_arrow(render::Scene& scene, const Vec3& tail, const Vec3& tip, const char* name,
               const render::Colour& colour) {
  scene.arrows.push_back({tail, tip, colour, 0.035});
  scene.labels.push_back({tip + 0.12 * (tip - tail).normalized(), name, colour, 24.0});
}

/// Writes the name of a body's method on the ground before it.
void add_name(render::Scene& scene, const Vec3& place, const char* name) {
  scene.labels.push_back({{place.x() - 0.4, -1.0, 0.0}, name, palette::ink, 20.0});
}

/// Draws the handle with ω and L. Its crossbar is orange on one side and blue on the other, so that
/// a turn over shows.
void add_handle(render::Scene& scene, const Track& track, double time) {
  const Spin& spin = track[step_at(time)];
  const Mat3 R = spin.world_from_body.toRotationMatrix();
  const Vec3 joint(0.0, -0.2, 0.0);
  add_rod(scene, handle_center, R, {joint, {0.62, -0.2, 0.0}, 0.13, palette::orange});
  add_rod(scene, handle_center, R, {joint, {-0.62, -0.2, 0.0}, 0.13, palette::blue});
  add_rod(scene, handle_center, R, {joint, {0.0, 0.55, 0.0}, 0.09, palette::grey});
  const Vec3 L = momentum(spin).normalized();
  const Vec3 omega = spin.world_from_body * spin.angular_velocity_body;
  add_name(scene, handle_center, "RK4");
  add_arrow(scene, handle_center, handle_center + 1.15 * L, "L", palette::vermilion);
  add_arrow(scene, handle_center, handle_center + 0.16 * omega, "ω", palette::green);
}

/// Maps body axes to the picture's. The intermediate axis lies across, so that you see ω run from
/// one end to the other. The major axis is up.
const Mat3 picture_from_body = 1.05 * Mat3{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};

/// Returns the surface of equal energy: a unit sphere stretched by 1/√I_i.
render::Sphere ellipsoid() {
  const Mat3 stretch = moments.cwiseSqrt().cwiseInverse().asDiagonal();
  return {
      {ellipsoid_center, picture_from_body * stretch}, 1.0, {palette::sky, palette::sky, 0.55F}};
}

/// Lifts a point off the surface, so that it is not half hidden in it.
Vec3 above_ellipsoid(const Vec3& angular_velocity_body) {
  const double size = std::sqrt(2.0 * energy(handle_start()));
  return ellipsoid_center + 1.006 / size * picture_from_body * angular_velocity_body;
}

/// Returns the curves on which ω runs for other amounts of angular momentum, from the exact motion.
std::vector<render::Trail> polhodes() {
  std::vector<render::Trail> trails;
  const double size = std::sqrt(2.0 * energy(handle_start()));
  for (const int axis : {0, 2}) {
    for (const double tilt : {0.3, 0.6, 0.9, 1.2}) {
      for (const double side : {1.0, -1.0}) {
        Vec3 unit = side * std::cos(tilt) * Vec3::Unit(axis);
        unit.y() = std::sin(tilt);
        const Vec3 start = size * unit.cwiseQuotient(moments.cwiseSqrt());
        const common::FreeRotation motion(moments, {Quat::Identity(), start});
        render::Trail trail{{}, palette::grey, 1.6};
        for (int i = 0; i <= 320; ++i) {  // two rounds: the fading start lies under the second
          const double time = motion.period() * i / 160.0;
          trail.points.push_back(above_ellipsoid(motion.at(time).angular_velocity_body));
        }
        trails.push_back(trail);
      }
    }
  }
  return trails;
}

/// Draws the path of ω in the body so far, and its place now.
void add_path(render::Scene& scene, const Track& track, double time, const render::Colour& colour) {
  render::Trail trail{{}, colour, 4.0};
  for (std::size_t i = 0; i <= step_at(time); ++i) {
    trail.points.push_back(above_ellipsoid(track[i].angular_velocity_body));
  }
  scene.spheres.push_back({{trail.points.back(), Mat3::Identity()}, 0.06, {colour}});
  scene.trails.push_back(trail);
}

void add_top(render::Scene& scene, const Track& track, double time) {
  const auto axis_at = [&](std::size_t i) -> Vec3 {
    return top_pivot + 1.75 * (track[i].world_from_body * Vec3::UnitZ());
  };
  const Mat3 R = track[step_at(time)].world_from_body.toRotationMatrix();
  add_name(scene, top_pivot, "kick-drift-kick");
  add_rod(scene, top_pivot, R, {{0.0, 0.0, 0.05}, {0.0, 0.0, 1.7}, 0.05, palette::grey});
  scene.cylinders.push_back(
      {{top_pivot + 1.0 * R.col(2), R}, 0.6, 0.09, {palette::purple, palette::purple}});
  scene.spheres.push_back({{top_pivot + R * Vec3(0.6, 0.0, 1.0), R}, 0.1, {palette::yellow}});
  render::Trail trail{{}, palette::purple, 3.0};
  for (std::size_t i = 0; i <= step_at(time); ++i) trail.points.push_back(axis_at(i));
  scene.trails.push_back(trail);
}

/// Returns the foot of the strip: what drifted, and all errors against the exact motion at the end.
std::string measured(const std::optional<Track>& handle, const std::optional<Track>& explicit_loop,
                     const std::optional<Track>& top) {
  std::string text;
  char line[160];
  const auto add = [&] { text += (text.empty() ? "" : ";  ") + std::string(line); };
  if (handle) {
    const Spin& last = handle->back();
    const Spin& first = handle->front();
    std::snprintf(line, sizeof line, "RK4 after %.1f s: |ΔE|/E = %.0e, |ΔL|/|L| = %.0e", duration,
                  std::abs(energy(last) / energy(first) - 1.0),
                  (momentum(last) - momentum(first)).norm() / momentum(first).norm());
    add();
  }
  if (explicit_loop) {
    std::snprintf(line, sizeof line, "explicit: E × %.2f",
                  energy(explicit_loop->back()) / energy(explicit_loop->front()));
    add();
  }
  if (top) {
    const Spin exact = common::LagrangeTop(heavy_top, top->front()).at(duration);
    std::snprintf(line, sizeof line, "top: %.0e rad off",
                  common::angle_between(top->back().world_from_body, exact.world_from_body));
    add();
  }
  return text;
}

render::Film make_film() {
  render::Film film;
  film.title = "A body that turns over, its polhode, and a top";
  film.subtitle = "L is constant, ω is not; the explicit loop (orange) leaves the energy ellipsoid";
  film.parameters = "I = (1, 2, 3) kg m², one turn per second about the stem; dt = 0.02 s";
  film.duration = duration;
  film.strip_times = {0.0, 1.6, 2.2, 6.4};
  film.bounds = {{-2.6, -0.9, 0.0}, {2.9, 0.7, 2.45}};
  film.towards_eye = {0.1, -2.2, 0.6};

  const std::optional<Track> handle = tracked(
      handle_start(), [](const Spin& s) { return step_rk4(moments, s, dt); }, film.missing);
  const std::optional<Track> loop = tracked(handle_start(), loop_step, film.missing);
  const std::optional<Track> top = tracked(
      top_start(), [](const Spin& s) { return step_kick_drift_kick(heavy_top, s, dt); },
      film.missing);
  if (!handle && !loop && !top) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(handle, loop, top);
  film.scene_at = [=, curves = polhodes()](double time) {
    render::Scene scene;
    if (handle) add_handle(scene, *handle, time);
    if (handle || loop) {
      scene.spheres.push_back(ellipsoid());
      add_name(scene, ellipsoid_center, "ω in the body");
      scene.trails = curves;
      if (loop) add_path(scene, *loop, time, palette::orange);
      if (handle) add_path(scene, *handle, time, palette::green);
    }
    if (top) add_top(scene, *top, time);
    return scene;
  };
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }

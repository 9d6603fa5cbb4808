// One angular velocity moves two boxes: one under the exponential map, and its twin under raw Euler
// on R, which swells. A painted corner leaves its trail.
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>

#include "common/course/if_written.hpp"
#include "common/rotation/attitude.hpp"
#include "common/rotation/coning_motion.hpp"
#include "render/film/film.hpp"
#include "rigid_body_kinematics.hpp"

using namespace lab::rigid_body_kinematics;
namespace palette = render::palette;

namespace {

constexpr double duration = 4.0;
constexpr double dt = 0.04;
constexpr int steps = 100;
const Vec3 half_extents(0.42, 0.28, 0.16);

common::ConingMotion motion() {
  common::ConingMotion coning;
  coning.rate = std::numbers::pi;
  coning.angular_velocity = {3.0, 0.0, 2.0};
  return coning;
}

/// The attitudes of one box, one matrix for each step.
struct Track {
  std::string name;
  Vec3 center;
  render::Paint paint;
  std::vector<Mat3> world_from_body;
};

/// Returns the motion by a method. If the method is not written yet, returns nothing and adds an
/// entry to `missing`.
template <typename Attitude>
std::optional<Track> tracked(Track track, Attitude attitude, double offset,
                             const std::function<Attitude(const Attitude&, const Vec3&)>& step,
                             std::vector<std::string>& missing) {
  return common::if_written(missing, [&] {
    for (int i = 0; i <= steps; ++i) {
      track.world_from_body.push_back(Mat3(attitude));
      attitude = step(attitude, angular_velocity(motion(), (i + offset) * dt));
    }
    return track;
  });
}

std::size_t step_at(double time) { return static_cast<std::size_t>(std::lround(time / dt)); }

/// Draws a box, its painted corner with the trail so far, and ω.
void add_box(render::Scene& scene, const Track& track, double time) {
  const std::size_t now = step_at(time);
  const render::Placement placement{track.center, track.world_from_body[now]};
  scene.boxes.push_back({placement, half_extents, track.paint});

  render::Trail trail{{}, palette::purple, 3.5};
  for (std::size_t i = 0; i <= now; ++i) {
    trail.points.emplace_back(track.center + track.world_from_body[i] * half_extents);
  }
  scene.spheres.push_back({{trail.points.back(), Mat3::Identity()}, 0.07, {palette::purple}});
  scene.trails.push_back(trail);

  const Vec3 omega = angular_velocity(motion(), time);
  const Vec3 tip = track.center + 0.32 * omega;
  scene.arrows.push_back({track.center, tip, palette::green, 0.035});
  scene.labels.push_back({tip, "ω", palette::green, 24.0});
  scene.labels.push_back({Vec3(track.center.x() - 0.6, -1.1, 0.0), track.name, palette::ink, 24.0});
}

/// Returns the foot of the strip: the error of each box at the end.
std::string measured(const std::vector<Track>& tracks) {
  std::string text;
  for (const Track& track : tracks) {
    const Mat3& R = track.world_from_body.back();
    const Mat3 exact = attitude(motion(), duration).toRotationMatrix();
    char line[128];
    std::snprintf(line, sizeof line, "%s%s after 4 s: %.2g rad off, |RᵀR − 1| = %.1g",
                  text.empty() ? "" : ";  ", track.name.c_str(), common::chordal_distance(R, exact),
                  (R.transpose() * R - Mat3::Identity()).norm());
    text += line;
  }
  return text;
}

render::Film make_film() {
  render::Film film;
  film.title = "One spin, two integrators";
  film.subtitle =
      "same ω(t): the exponential map keeps the shape of the box, plain Euler on R swells it";
  film.parameters = "ω(0) = (3, 0, 2) rad/s, coning about z at half a turn per second, dt = 0.04 s";
  film.duration = duration;
  film.strip_times = {0.0, 0.8, 1.6, 2.4, 3.2, 4.0};
  film.bounds = {{-2.1, -0.9, 0.0}, {2.5, 0.6, 2.35}};
  film.towards_eye = {0.25, -2.2, 0.75};

  std::vector<Track> tracks;
  const auto keep = [&](const std::optional<Track>& track) {
    if (track) tracks.push_back(*track);
  };
  keep(tracked<Quat>(
      {"exponential map", {-1.15, 0.0, 1.2}, {palette::sky, palette::blue}, {}}, Quat::Identity(),
      0.5, [](const Quat& q, const Vec3& w) { return step_exponential(q, w, dt); }, film.missing));
  keep(tracked<Mat3>(
      {"Euler on R", {1.25, 0.0, 1.2}, {palette::orange, palette::vermilion}, {}}, Mat3::Identity(),
      0.0, [](const Mat3& R, const Vec3& w) { return step_matrix_euler(R, w, dt); }, film.missing));
  if (tracks.empty()) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(tracks);
  film.scene_at = [tracks](double time) {
    render::Scene scene;
    for (const Track& track : tracks) add_box(scene, track, time);
    return scene;
  };
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }

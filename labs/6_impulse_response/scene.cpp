// On the left, ten thousand particles pour on the cylinder, stepped by option 2. On the right, a
// brick hits the top with one corner and tumbles away, which shows the impulse of an impact between
// two rigid bodies.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "render/film/film.hpp"
#include "scene_brick.hpp"

using namespace lab::impulse_response;
namespace palette = render::palette;

namespace {

constexpr double grain_radius = 0.042;
constexpr double slides = 0.3 * particle_mass;  // no impact is weaker, no step of sliding as hard
constexpr double hits_hard = 3.0 * particle_mass;
constexpr std::size_t simulated_for_one_drawn = 6;
constexpr double foot = -1.5;
const Vec3 towards_eye(0.25, -2.2, 0.75);

void add_cylinder(render::Scene& scene) {
  scene.cylinders.push_back({{{-0.1, 0.0, 0.0}, render::z_along_x},
                             cylinder.radius,
                             3.0,
                             {palette::grey, palette::grey, 0.55F}});
}

render::Colour colour_of(const Grain& grain) {
  if (grain.impulse == 0.0) return palette::grey;
  if (grain.impulse < slides) return palette::sky;
  return grain.impulse < hits_hard ? palette::orange : palette::vermilion;
}

/// Adds a dome towards the eye, whose outline is round. Ten thousand spheres would have ten times
/// the triangles, half of them on the far side.
void add_grain(render::Mesh& mesh, const Vec3& position) {
  static const Mat3 turn = render::z_axis_towards(towards_eye);
  constexpr int sides = 8;
  const int apex = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(position + grain_radius * turn.col(2));
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    mesh.vertices.emplace_back(
        position + grain_radius * (std::cos(angle) * turn.col(0) + std::sin(angle) * turn.col(1)));
    mesh.triangles.push_back({apex, apex + 1 + i, apex + 1 + (i + 1) % sides});
  }
}

/// Adds one mesh of each colour.
void add_grains(render::Scene& scene, const Pour& pour, std::size_t frame) {
  for (const render::Colour& colour :
       {palette::grey, palette::sky, palette::orange, palette::vermilion}) {
    render::Mesh mesh;
    mesh.smooth = true;
    mesh.paint = {colour, colour, colour.red == palette::grey.red ? 0.4F : 0.0F};
    for (std::size_t i = 0; i < pour.frames[frame].size(); i += simulated_for_one_drawn) {
      const Grain& grain = pour.frames[frame][i];
      if (!grain.position.allFinite()) continue;  // a wrong answer's
      const render::Colour own = colour_of(grain);
      if (own.red == colour.red && own.blue == colour.blue) add_grain(mesh, grain.position);
    }
    if (!mesh.vertices.empty()) scene.meshes.push_back(mesh);
  }
}

/// Draws the brick, paler poses every 0.4 s, its path, and the cylinder's hard impulses so far.
void add_brick(render::Scene& scene, const Tumble& tumble, std::size_t frame) {
  const auto add_pose = [&](const BrickPose& pose, float paleness) {
    scene.boxes.push_back({{pose.position, pose.attitude},
                           half_extents,
                           {palette::green, palette::yellow, paleness}});
  };
  constexpr std::size_t between_ghosts = 10;
  render::Trail path{{}, palette::green, 3.0};
  for (std::size_t i = 0; i <= frame; ++i) {
    path.points.push_back(tumble.frames[i].position);
    if (i % between_ghosts == 0 && i + 4 < frame) add_pose(tumble.frames[i], 0.72F);
  }
  scene.trails.push_back(path);
  add_pose(tumble.frames[frame], 0.0F);
  constexpr double least_drawn = 1.0;  // [N s]
  for (const BrickImpact& impact : tumble.impacts) {
    const double size = impact.impulse.norm();
    const bool is_past = impact.time <= static_cast<double>(frame) * frame_time;
    if (!is_past || !impact.on_cylinder || size < least_drawn) continue;
    scene.contacts.push_back(
        {impact.contact.point, impact.impulse / size, 0.22 * size, palette::purple});
  }
}

std::string measured(const std::optional<Pour>& pour, const std::optional<Tumble>& tumble) {
  std::string text;
  char line[200];
  if (pour) {
    std::snprintf(line, sizeof line, "%.1f million particle-steps, none ends ",
                  1e-6 * static_cast<double>(pour->steps));
    text += line;
    std::snprintf(line, sizeof line, "more than %.1g m inside", pour->deepest);
    text += pour->deepest > 0.0 ? line : "inside";
  }
  if (tumble && !tumble->impacts.empty()) {
    std::snprintf(
        line, sizeof line,
        "%sbrick: first hit %.1f N s, energy %.1f → %.1f J, |ΔL|/|L| about the contact %.0e",
        text.empty() ? "" : ";  ", tumble->impacts.front().impulse.norm(),
        tumble->first_energy_before, tumble->first_energy_after, tumble->momentum_error);
    text += line;
  }
  return text;
}

render::Film make_film() {
  render::Film film;
  film.title = "Impulses: particles and a brick";
  film.subtitle =
      "grey: in flight, blue: at rest or sliding, orange and red: hits; pink: the brick's impulse";
  film.parameters =
      "10,000 particles, a sixth drawn; R = 1 m, e = 0.4, μ = 0.5, dt = 4 ms; brick 2 kg, e = 0.4, "
      "μ = 0.3";
  film.duration = duration;
  film.strip_times = {0.6, 1.2, 2.0, 3.2};
  film.bounds = {{-3.0, -2.3, -1.5}, {2.8, 0.9, 2.9}};
  film.towards_eye = towards_eye;

  const std::optional<Pour> pour = poured(film.missing);
  const std::optional<Tumble> tumble = tumbled(film.missing);
  if (!pour && !tumble) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(pour, tumble);
  film.scene_at = [=](double time) {
    const auto frame = static_cast<std::size_t>(std::lround(time / frame_time));
    render::Scene scene;
    scene.ground_height = foot;
    add_cylinder(scene);
    if (pour) add_grains(scene, *pour, frame);
    if (tumble) add_brick(scene, *tumble, frame);
    return scene;
  };
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }

// Is it enough to check the particles of a cloth? Two equal sheets fall on the cylinder. The left
// one's particles are kept out, and the right one's triangles. Beside them fast particles are shot
// across, and sampled only a few times.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/film/film.hpp"
#include "scene_motions.hpp"

using namespace lab::discrete_particle_cylinder;
using common::Mat3;
namespace palette = render::palette;

namespace {

constexpr double foot = -0.95;  // height of the names [m]

void add_cylinder(render::Scene& scene) {
  scene.cylinders.push_back({{{-0.2, 0.0, 0.0}, render::z_along_x},
                             cylinder.radius,
                             1.95,
                             {palette::grey, palette::grey, 0.55F}});
}

/// Draws a line along an edge. The part that the cylinder hides is marked on the surface above.
void add_edge(render::Scene& scene, const Vec3& a, const Vec3& b, bool is_sunk) {
  constexpr int pieces = 16;
  const double least_distance = is_sunk ? 1.02 * cylinder.radius : 0.0;
  render::Trail line{{}, is_sunk ? palette::vermilion : palette::blue, is_sunk ? 6.0 : 4.0};
  for (int i = -pieces; i <= pieces; ++i) {  // to and fro: the fading start lies under the end
    Vec3 point = a + std::abs(i) / static_cast<double>(pieces) * (b - a);
    const double distance = std::hypot(point.y(), point.z());
    if (distance < least_distance) point.tail<2>() *= least_distance / distance;
    line.points.push_back(point);
  }
  scene.trails.push_back(line);
}

/// Draws the triangles flat, as they are, and visible from both sides.
void add_triangles(render::Scene& scene, const Sheet& sheet) {
  render::Mesh mesh{{}, sheet.positions, {}, false, {palette::sky, palette::blue}, {}};
  for (const auto& corners : sheet.triangles) {
    const auto [a, b, c] = std::array{static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                                      static_cast<int>(corners[2])};
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, b});
    mesh.lit.push_back(false);
    mesh.lit.push_back(true);
  }
  scene.meshes.push_back(mesh);
}

void add_sheet(render::Scene& scene, const Fall& fall, std::size_t frame) {
  const auto& [sheet, sunk] = fall.moments[frame];
  add_triangles(scene, sheet);
  for (std::size_t i = 0; i < sheet.edges.size(); ++i) {
    const Vec3& a = sheet.positions[sheet.edges[i][0]];
    const Vec3& b = sheet.positions[sheet.edges[i][1]];
    add_edge(scene, a, b, std::binary_search(sunk.begin(), sunk.end(), i));
  }
  scene.labels.push_back(
      {{fall.x - 0.5, -0.4, foot}, fall.name + std::string(" kept out"), palette::ink, 22.0});
}

render::Colour colour_of(const Shot& shot, double time, const Vec3& position) {
  if (shot.contact && time >= shot.contact->time) return palette::green;
  return !shot.contact && position.y() > 0.5 * chord ? palette::vermilion : palette::orange;
}

void add_shot(render::Scene& scene, const Shot& shot, double film_time) {
  const double end = shot.contact ? shot.contact->time : flight;
  const double time = std::clamp(film_time - shot.launch, 0.0, end);
  const auto at = [&](double t) -> Vec3 { return shot.path.position + t * shot.path.velocity; };
  const Vec3 now = at(time);
  const render::Colour colour = colour_of(shot, time, now);
  for (int k = 0; k <= samples && k * flight / samples < time; ++k) {
    scene.spheres.push_back(
        {{at(k * flight / samples), Mat3::Identity()}, shot_radius, {colour, colour, 0.6F}});
  }
  scene.spheres.push_back({{now, Mat3::Identity()}, shot_radius, {colour, colour}});
  if (time > 0.0) scene.trails.push_back({{at(0.0), 0.5 * (at(0.0) + now), now}, colour, 3.0});
  if (shot.contact && time >= end) {
    scene.contacts.push_back(
        {shot.contact->point_on_cylinder, shot.contact->normal, 0.3, palette::green});
  }
}

/// Returns the depth of the deepest sunk edge, and by theory that of an edge that is as long across
/// the axis and whose ends both touch: ρ − √(ρ² − l²/4) [m].
std::pair<double, double> deepest_sink(const Moment& moment) {
  const Sheet& sheet = moment.sheet;
  const double rho = cylinder.radius + sheet.particle_radius;
  std::pair<double, double> deepest(0.0, 0.0);
  for (const std::size_t i : moment.sunk) {
    const Vec3& a = sheet.positions[sheet.edges[i][0]];
    const Vec3& b = sheet.positions[sheet.edges[i][1]];
    const double sink = -edge_gap(a, b, sheet.particle_radius, cylinder).gap;
    const double half = 0.5 * std::hypot(b.y() - a.y(), b.z() - a.z());
    if (sink > deepest.first) deepest = {sink, rho - std::sqrt(rho * rho - half * half)};
  }
  return deepest;
}

/// Returns the foot of the strip: what has sunk at the end, and what tunnels.
std::string measured(const std::vector<Fall>& falls,
                     const std::optional<std::vector<Shot>>& all_shots) {
  std::string text;
  char line[160];
  const auto add = [&] { text += (text.empty() ? "" : ";  ") + std::string(line); };
  for (const Fall& fall : falls) {
    const Moment& last = fall.moments.back();
    const auto [sink, theory] = deepest_sink(last);
    std::snprintf(line, sizeof line, "%s: %zu edges sunk", fall.name, last.sunk.size());
    add();
    std::snprintf(line, sizeof line, " %.1f cm (ρ − √(ρ² − l²/4) = %.1f)", 100.0 * sink,
                  100.0 * theory);
    if (!last.sunk.empty()) text += line;
  }
  if (all_shots) {
    const auto missed = std::count_if(all_shots->begin(), all_shots->end(),
                                      [](const Shot& shot) { return !shot.contact; });
    std::snprintf(line, sizeof line, "shots: %td of %d missed (1 − c/s = 1/3)", missed, shot_count);
    add();
  }
  return text;
}

render::Film make_film() {
  render::Film film;
  film.title = "Is it enough to check the particles?";
  film.subtitle =
      "no particle of the left cloth is inside, but its edges (red) are; a third of the shots "
      "tunnel";
  film.parameters = "R = 35 cm, cloth 2 cm thick, cells of 30 cm";
  film.duration = duration;
  film.strip_times = {0.2, 0.5, 1.4, 3.2};
  film.bounds = {{-2.05, -0.7, -0.8}, {1.65, 0.8, 0.6}};
  film.towards_eye = {0.3, -2.2, 0.95};

  std::vector<Fall> falls;
  const auto keep = [&](const std::optional<Fall>& fall) {
    if (fall) falls.push_back(*fall);
  };
  keep(fallen({"particles", -1.45, {}}, push_particles_out, film.missing));
  keep(fallen({"triangles", -0.1, {}}, push_triangles_out, film.missing));
  const std::optional<std::vector<Shot>> all_shots = shots(film.missing);
  if (falls.empty() && !all_shots) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(falls, all_shots);
  film.scene_at = [=](double time) {
    const auto frame = static_cast<std::size_t>(std::lround(time / frame_time));
    render::Scene scene;
    scene.ground = false;  // its shadows would crowd the picture
    add_cylinder(scene);
    for (const Fall& fall : falls) add_sheet(scene, fall, frame);
    if (!all_shots) return scene;
    for (const Shot& shot : *all_shots) add_shot(scene, shot, time);
    scene.labels.push_back({{0.8, -0.4, foot}, "shots, sampled", palette::ink, 22.0});
    return scene;
  };
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }

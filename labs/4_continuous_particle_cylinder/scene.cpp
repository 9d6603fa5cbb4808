// Bullets fly at a cylinder that is cut open in the plane of their flight. One group is sampled
// only three times, the other is stopped at its times of impact. Beside them is an edge whose ends
// pass by on both sides.
#include <algorithm>
#include <cstdio>

#include "render/film/film.hpp"
#include "scene_motions.hpp"

using namespace lab::continuous_particle_cylinder;
using common::Mat3;
namespace palette = render::palette;

namespace {

constexpr double ground_height = -1.35;
constexpr double edge_shift = 2.15;

/// Draws the cylinder open just behind x = 0, the plane in which everything flies.
void add_cylinder(render::Scene& scene, const char* name, double shift) {
  constexpr double half_length = 0.28;
  scene.cylinders.push_back({{{-half_length - 0.02, shift, 0.0}, render::z_along_x},
                             cylinder.radius,
                             half_length,
                             {palette::grey, palette::sky, 0.55F}});
  scene.labels.push_back({{0.4, shift - 0.3, ground_height}, name, palette::ink, 22.0});
}

void add_ball(render::Scene& scene, const Vec3& place, const render::Colour& colour,
              float paleness) {
  scene.spheres.push_back({{place, Mat3::Identity()}, bullet_radius, {colour, colour, paleness}});
}

void add_mark(render::Scene& scene, const ParticleContact& contact, const Vec3& shift) {
  const Vec3 inside = contact.point_on_particle + shift;
  const Vec3 outside = contact.point_on_cylinder + shift;
  if (contact.gap < -0.01) {
    scene.trails.push_back({{outside, inside, outside}, palette::ink, 3.0});
  }
  scene.contacts.push_back(
      {contact.point_on_cylinder + shift, contact.normal, 0.28, palette::green});
}

render::Colour colour_of(const Shot& shot, double time) {
  if (!does_hit(shot.particle)) return palette::grey;
  if (shot.contact && time >= shot.contact->time) return palette::green;
  const bool is_through = position_at(shot.particle, time).z() < 0.0;
  return !shot.contact && is_through ? palette::vermilion : palette::orange;
}

void add_shot(render::Scene& scene, const Group& group, const Shot& shot, double film_time) {
  const double end = shot.contact ? shot.contact->time : flight;
  const double time = std::min(film_time, end);
  const Vec3 shift(0.0, group.shift, 0.0);
  const Vec3 start = shot.particle.position + shift;
  const Vec3 now = position_at(shot.particle, time) + shift;
  const render::Colour colour = colour_of(shot, time);
  for (int k = 0; k <= samples && k * flight / samples < time; ++k) {
    if (k > 0 && !group.has_samples) break;
    add_ball(scene, position_at(shot.particle, k * flight / samples) + shift, colour, 0.6F);
  }
  add_ball(scene, now, colour, 0.0F);
  if (time > 0.0) scene.trails.push_back({{start, 0.5 * (start + now), now}, colour, 3.0});
  if (shot.contact && film_time >= end) add_mark(scene, *shot.contact, shift);
}

void add_edge(render::Scene& scene, double time, const render::Colour& colour, float paleness) {
  const MovingEdge edge = falling_edge();
  const Vec3 shift(0.0, edge_shift, 0.0);
  const Vec3 a = edge.a + time * edge.velocity_a + shift;
  const Vec3 b = edge.b + time * edge.velocity_b + shift;
  const Mat3 along = render::z_axis_towards(b - a);
  scene.capsules.push_back(
      {{0.5 * (a + b), along}, edge.radius, 0.5 * (b - a).norm(), {colour, colour, paleness}});
  if (!(time > 0.0)) return;
  for (const auto& [start, now] : {std::pair{edge.a, a}, std::pair{edge.b, b}}) {
    const Vec3 from = start + shift;
    scene.trails.push_back({{from, 0.5 * (from + now), now}, colour, 3.0});
  }
}

/// Draws the edge stopped at its impact, and as a check of only its ends sees it.
void add_edges(render::Scene& scene, const EdgeImpact& impact, double film_time) {
  add_cylinder(scene, "an edge", edge_shift);
  const double time = std::min(film_time, flight);
  const double stop = impact.contact ? std::min(time, impact.contact->time) : time;
  if (stop < time && !impact.has_end_contact) add_edge(scene, time, palette::vermilion, 0.0F);
  add_edge(scene, 0.0, palette::grey, 0.6F);
  add_edge(scene, stop, stop < time ? palette::green : palette::orange, 0.0F);
  if (stop < time) add_mark(scene, *impact.contact, {0.0, edge_shift, 0.0});
}

/// Returns the foot of the strip.
std::string measured(const std::vector<Group>& groups, const std::optional<EdgeImpact>& edge) {
  std::string text;
  char line[160];
  const auto add = [&] { text += (text.empty() ? "" : ";  ") + std::string(line); };
  const auto hits = std::count_if(lanes.begin(), lanes.end(),
                                  [](const Lane& lane) { return does_hit(bullet(lane)); });
  for (const Group& group : groups) {
    std::ptrdiff_t found = 0;
    double deepest = 0.0;
    for (const Shot& shot : group.shots) {
      if (!shot.contact) continue;
      ++found;
      deepest = std::max(deepest, std::abs(shot.contact->gap));
    }
    std::snprintf(line, sizeof line, "%s: %td of %td, |φ| to %.1g m", group.name, found, hits,
                  deepest);
    add();
  }
  if (edge && edge->contact) {
    std::snprintf(line, sizeof line, "edge: t* = %.3f s, ends: %s", edge->contact->time,
                  edge->has_end_contact ? "a hit" : "none");
    add();
  }
  return text;
}

render::Film make_film() {
  render::Film film;
  film.title = "Bullets at a cylinder";
  film.subtitle = "samples miss (red) or are late, once on the far side; t* is on the surface";
  film.parameters = "R = 0.5 m, r = 5/64 m, 1 m/s, samples 1.1 s apart";
  film.duration = 2.4;
  film.strip_times = {0.3, 0.8, 1.3, 2.3};
  film.bounds = {{-0.9, -2.75, ground_height}, {0.1, 2.95, 1.7}};
  film.towards_eye = {2.2, 0.0, 0.45};

  std::vector<Group> groups;
  const auto keep = [&](const std::optional<Group>& group) {
    if (group) groups.push_back(*group);
  };
  keep(watched({"samples", -2.0, true, {}}, first_sampled_time, film.missing));
  keep(watched({"time of impact", 0.0, false, {}}, exact_time, film.missing));
  const std::optional<EdgeImpact> edge = edge_impact(film.missing);
  if (groups.empty() && !edge) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(groups, edge);
  film.scene_at = [=](double time) {
    render::Scene scene;
    scene.ground_height = ground_height;
    for (const Group& group : groups) {
      add_cylinder(scene, group.name, group.shift);
      for (const Shot& shot : group.shots) add_shot(scene, group, shot, time);
    }
    if (edge) add_edges(scene, *edge, time);
    return scene;
  };
  return film;
}

}  // namespace

int main(int argc, char** argv) { return render::film_main(argc, argv, make_film); }

// Two bumpy tori change places and pass through each other. The triangles that meet are lit, and
// the boxes of one level of the trees that hold them are drawn. With --mesh FILE.obj, once or
// twice, your meshes replace the tori.
#include <array>
#include <cstdio>
#include <optional>

#include "common/course/if_written.hpp"
#include "own_meshes.hpp"
#include "render/film/film.hpp"
#include "scene_motion.hpp"

using namespace lab::bvh_traversal;
namespace palette = render::palette;

namespace {

/// A torus with its tree and its look.
struct Torus {
  TriangleMesh mesh;
  Bvh bvh;
  Level level;
  render::Paint paint;
  render::Colour line;
};

Torus torus_of(const TriangleMesh& mesh, const render::Paint& paint, const render::Colour& line) {
  const Bvh bvh = build_median(mesh, leaf_size);
  return {mesh, bvh, level_of(bvh, mesh.triangles.size()), paint, line};
}

/// Draws the twelve edges to and fro, so that each line's fading start lies under its end.
void add_wires(render::Scene& scene, const Box& box, const RigidTransform& pose,
               const render::Colour& colour) {
  if (!box.low.allFinite() || !box.high.allFinite()) return;  // a wrong answer's box
  const auto corner = [&](int bits) {
    Vec3 point;
    for (int i = 0; i < 3; ++i) point[i] = (bits >> i & 1) != 0 ? box.high[i] : box.low[i];
    return common::transformed(pose, point);
  };
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if ((from & axis) != 0) continue;
      const Vec3 a = corner(from);
      const Vec3 b = corner(from | axis);
      scene.trails.push_back({{b, a, b}, colour, 2.5});
    }
  }
}

/// `lit` is by triangle. A box is drawn if a triangle in it is lit.
void add_torus(render::Scene& scene, const Torus& torus, const RigidTransform& pose,
               const std::vector<bool>& lit) {
  render::Mesh mesh{
      {pose.translation, pose.rotation}, torus.mesh.vertices, {}, false, torus.paint, lit};
  for (const auto& corners : torus.mesh.triangles) {
    mesh.triangles.push_back(
        {static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2])});
  }
  scene.meshes.push_back(mesh);
  std::vector<bool> drawn(torus.level.boxes.size() + 1, false);
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (lit[i]) drawn[torus.level.box_of_triangle[i]] = true;
  }
  for (std::size_t i = 0; i < torus.level.boxes.size(); ++i) {
    if (drawn[i]) add_wires(scene, torus.level.boxes[i], pose, torus.line);
  }
}

using Tori = std::array<Torus, 2>;

std::optional<Intersections> found(const Tori& tori, double time,
                                   std::vector<std::string>& missing) {
  return common::if_written(
      missing, [&] { return find_intersections_moved(tori[0].bvh, tori[1].bvh, a_from_b(time)); });
}

render::Scene scene_of(const Tori& tori, double time) {
  render::Scene scene;
  scene.ground = false;  // shadows and grid would hide among the boxes
  std::array<std::vector<bool>, 2> lit{std::vector<bool>(tori[0].mesh.triangles.size(), false),
                                       std::vector<bool>(tori[1].mesh.triangles.size(), false)};
  std::vector<std::string> missing;
  char line[80] = "shapes without a query";
  if (const std::optional<Intersections> query = found(tori, time, missing)) {
    for (const TrianglePair& pair : query->pairs) {
      if (pair.a < lit[0].size()) lit[0][pair.a] = true;
      if (pair.b < lit[1].size()) lit[1][pair.b] = true;
    }
    std::snprintf(line, sizeof line, "%zu pairs meet", query->pairs.size());
  }
  add_torus(scene, tori[0], world_from_a(time), lit[0]);
  add_torus(scene, tori[1], world_from_b(time), lit[1]);
  scene.labels.push_back({{-0.55, -0.9, -1.45}, line, palette::ink, 26.0});
  return scene;
}

/// Returns the foot of the strip: the query with most pairs.
std::string measured(const Tori& tori, std::vector<std::string>& missing) {
  constexpr int looks = 100;
  Intersections most;
  for (int i = 0; i <= looks; ++i) {
    const std::optional<Intersections> query = found(tori, i * duration / looks, missing);
    if (!query) return "";
    if (query->pairs.size() >= most.pairs.size()) most = *query;
  }
  const auto pairs =
      static_cast<double>(tori[0].mesh.triangles.size() * tori[1].mesh.triangles.size());
  char line[160];
  std::snprintf(line, sizeof line,
                "most: %zu pairs meet, of %.1f million; %llu box tests, %llu triangle tests",
                most.pairs.size(), 1e-6 * pairs, static_cast<unsigned long long>(most.box_tests),
                static_cast<unsigned long long>(most.triangle_tests));
  return line;
}

render::Film make_film(const OwnMeshes& own) {
  render::Film film;
  film.title = "Two tori pass through each other";
  film.subtitle =
      "orange: triangles that meet; lines: the boxes of level 5 that hold them; linked rings do "
      "not meet";
  film.duration = duration;
  film.strip_times = {0.4, 1.25, 2.0};
  film.bounds = {{-2.45, -0.75, -1.2}, {2.45, 0.75, 1.2}};
  film.towards_eye = {0.25, -2.2, 0.75};

  std::array<TriangleMesh, 2> meshes{common::bumpy_torus(triangles_of),
                                     common::bumpy_torus(triangles_of)};
  if (!own.files.empty()) {
    for (std::size_t i = 0; i < 2; ++i) meshes[i] = own.fitted(i, 1.15);
    film.title = own.name(0) + " and " + own.name(1) + " pass through each other";
    film.subtitle = "orange: triangles that meet; lines: the boxes of level 5 that hold them";
    film.bounds = {{-2.45, -1.15, -1.15}, {2.45, 1.15, 1.15}};
  }
  const std::optional<Tori> tori = common::if_written(film.missing, [&] {
    return Tori{torus_of(meshes[0], {palette::sky, palette::vermilion}, palette::blue),
                torus_of(meshes[1], {palette::yellow, palette::vermilion}, palette::ink)};
  });
  if (!tori) return film;  // nothing to show: film_main says what is missing
  film.measured = measured(*tori, film.missing);
  char line[100];
  std::snprintf(line, sizeof line, "%zu and %zu triangles, leaves of %d, built once by halves",
                meshes[0].triangles.size(), meshes[1].triangles.size(), leaf_size);
  film.parameters = line;
  film.scene_at = [tori = *tori](double time) { return scene_of(tori, time); };
  return film;
}

}  // namespace

int main(int argc, char** argv) {
  OwnMeshes own;
  own.take_from(argc, argv);
  return render::film_main(argc, argv, [&] { return make_film(own); });
}

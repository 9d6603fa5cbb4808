#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "planes.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::Item;
using tests::Shape;
using tests::Sides;
using tests::Trial;
using tests::Weight;

namespace {

const std::string dearer =
    "a plane between bins is cheaper than the cut: choose the least sum of A N of both sides";
const std::string halved =
    "this cuts at the median: cut where the sum of A N of both sides is least";
const std::string by_volume =
    "this weighs the sides by the volumes of their boxes: use the surface areas";
const std::string without_numbers =
    "this weighs the sides by their surfaces alone: multiply by their numbers of triangles";
const std::string one_axis =
    "only the axis of the widest spread is tried: try planes across all three axes";

const std::string without_last =
    "the last plane is left out: between the bins there are bins - 1 planes";
const std::string without_first = "the first plane is left out: a side may have only one bin";

/// The planes across each axis at a node, and what the tree took instead.
struct Choice {
  std::vector<std::vector<Sides>> axes;
  Eigen::Index widest = 0;
  Sides taken;

  [[nodiscard]] double best() const { return tests::cost_of_choice(axes, Weight::area_and_number); }
  [[nodiscard]] double got() const { return tests::cost(taken, Weight::area_and_number); }
  [[nodiscard]] bool is_wrong() const {
    return !std::isinf(best()) && got() > best() * (1.0 + 1e-12);
  }
};

Choice choice_at(const Bvh& bvh, const Shape& shape, std::size_t i, int bins) {
  const std::vector<Item> items = tests::items_below(bvh, shape, i);
  Choice choice;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    choice.axes.push_back(tests::planes(items, axis, bins));
  }
  choice.widest = tests::widest_axis(items);
  const BvhNode& node = bvh.nodes[i];
  choice.taken = {bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box,
                  static_cast<double>(shape.below[node.first]),
                  static_cast<double>(shape.below[node.first + 1])};
  return choice;
}

/// What the choice would cost with one plane of each axis left out; where no other is left, none.
double cost_without(const Choice& choice, std::size_t plane) {
  std::vector<std::vector<Sides>> axes = choice.axes;
  for (std::vector<Sides>& axis : axes) {
    std::erase_if(axis, [&](const Sides& s) { return s.plane == plane; });
  }
  return tests::cost_of_choice(axes, Weight::area_and_number);
}

bool is_halved(const Choice& choice) {
  return std::abs(choice.taken.in_left - choice.taken.in_right) <= 1.0;
}

bool fits(const std::string& story, const Choice& choice, int bins) {
  double other = 0.0;
  if (story == halved) return is_halved(choice);
  if (story == by_volume) other = tests::cost_of_choice(choice.axes, Weight::volume_and_number);
  if (story == without_numbers) other = tests::cost_of_choice(choice.axes, Weight::area);
  if (story == one_axis) {
    other = tests::cost_of_choice({choice.axes[static_cast<std::size_t>(choice.widest)]},
                                  Weight::area_and_number);
  }
  if (story == without_last) other = cost_without(choice, static_cast<std::size_t>(bins) - 1);
  if (story == without_first) other = cost_without(choice, 1);
  return std::isinf(other) ? is_halved(choice) : std::abs(choice.got() - other) <= 1e-12 * other;
}

/// Whether the cut is at a plane between bins, though not at the best.
bool is_at_plane(const Choice& choice) {
  for (const std::vector<Sides>& axis : choice.axes) {
    for (const Sides& plane : axis) {
      const double other = tests::cost(plane, Weight::area_and_number);
      if (std::abs(choice.got() - other) <= 1e-12 * other) return true;
    }
  }
  return false;
}

/// The one story that tells of all wrong cuts of a tree.
std::string likely_cut(const Bvh& bvh, const Shape& shape, int bins) {
  std::vector<std::string> stories{halved,   by_volume,    without_numbers,
                                   one_axis, without_last, without_first};
  bool at_planes = true;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    if (tests::is_leaf(bvh.nodes[i]) || shape.depth[i] >= 32) continue;
    const Choice choice = choice_at(bvh, shape, i, bins);
    if (!choice.is_wrong()) continue;
    std::erase_if(stories, [&](const auto& story) { return !fits(story, choice, bins); });
    at_planes = at_planes && is_at_plane(choice);
  }
  if (stories.size() == 1) return stories.front();
  return stories.empty() && at_planes ? dearer : "";
}

/// Requires that no plane is cheaper than the cut of a node.
void expect_cut(const Trial& trial, const Bvh& bvh, const Shape& shape, std::size_t i, int bins) {
  const Choice choice = choice_at(bvh, shape, i, bins);
  if (!choice.is_wrong()) return;
  trial.of("the cut of node " + std::to_string(i))
      .expect_small("A N of both sides minus that of the cheapest plane",
                    choice.got() - choice.best(), {1e-12 * choice.best(), "rounding of the areas"},
                    likely_cut(bvh, shape, bins));
}

struct Built {
  Bvh bvh;
  Shape shape;
};

Built expect_sah(const common::TriangleMesh& mesh, int leaf_size, int bins, int index, int count) {
  const Trial trial = Trial("5.6 build_sah", index, count)
                          .given("mesh", code(mesh))
                          .given("leaf_size", static_cast<double>(leaf_size))
                          .given("bins", static_cast<double>(bins));
  Built built;
  built.bvh = trial.returned([&] { return build_sah(mesh, leaf_size, bins); });
  built.shape = tests::expect_structure(trial, built.bvh, mesh, leaf_size);
  for (std::size_t i = 0; i < built.bvh.nodes.size(); ++i) {
    const BvhNode& node = built.bvh.nodes[i];
    if (tests::is_leaf(node)) continue;
    if (built.shape.depth[i] < 32) {
      expect_cut(trial, built.bvh, built.shape, i, bins);
      continue;
    }
    trial.of("the cut of node " + std::to_string(i) + " at depth 32 or below")
        .expect_small("difference of the numbers in its halves",
                      std::abs(static_cast<double>(built.shape.below[node.first]) -
                               static_cast<double>(built.shape.below[node.first + 1])),
                      {1.0, "from depth 32 on, a node is halved by number"});
  }
  return built;
}

/// Triangles of very different sizes, off any regular place.
common::TriangleMesh uneven_soup(tests::Random& random, int triangles) {
  common::TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const double size = std::pow(10.0, random.uniform(-2.0, 0.0));
    const Vec3 place = std::pow(random.uniform(0.0, 1.0), 3.0) * random.vector(4.0);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(place + random.vector(size));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

}  // namespace

TEST_CASE("A cluster is separated from triangles far off", "[5.6]") {
  // Nine small triangles near the origin and one far away: half and half would stretch a box.
  common::TriangleMesh mesh;
  for (int i = 0; i < 10; ++i) {
    const Vec3 place = i == 9 ? Vec3(100.0, 0.0, 0.0) : Vec3(0.3 * i, 0.1 * (i % 3), 0.2 * (i % 2));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1)}) {
      mesh.vertices.push_back(place + p);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const Built built = expect_sah(mesh, 9, 8, 1, 1);
  const BvhNode& root = built.bvh.nodes[0];
  const std::size_t smaller =
      std::min(built.shape.below[root.first], built.shape.below[root.first + 1]);
  Trial("5.6 build_sah")
      .given("mesh", code(mesh))
      .of("the smaller side of the root")
      .expect(static_cast<double>(smaller), 1.0, tests::exactly, {{5.0, halved}});
}

TEST_CASE("No plane between bins is cheaper than a cut on random soups", "[5.6]") {
  tests::Random random(71);
  for (int i = 1; i <= 24; ++i) {
    const int triangles = static_cast<int>(random.uniform(2.0, 80.0));
    expect_sah(uneven_soup(random, triangles), 1 + i % 4, 2 + i % 16, i, 24);
  }
}

TEST_CASE("No plane between bins is cheaper than a cut on smooth meshes", "[5.6]") {
  common::TriangleMesh sphere = common::bumpy_sphere(800);
  common::TriangleMesh torus = common::bumpy_torus(600);
  expect_sah(sphere, 4, 16, 1, 2);
  expect_sah(torus, 2, 8, 2, 2);
}

TEST_CASE("Meshes of any size are cut alike by the heuristic", "[5.6]") {
  const common::TriangleMesh torus = common::bumpy_torus(400);
  int index = 0;
  for (const double size : {1e60, 1e-60}) {
    expect_sah(common::scaled(torus, Vec3::Constant(size)), 3, 12, ++index, 2);
  }
}

TEST_CASE("If no plane separates the centroids the triangles are halved", "[5.6]") {
  const std::vector<std::array<std::uint32_t, 3>> many(700, {0, 1, 2});
  const common::TriangleMesh same{{Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 4)}, many};
  const common::TriangleMesh points{{Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)}, many};
  int index = 0;
  for (const common::TriangleMesh& mesh : {same, points}) {
    const Built built = expect_sah(mesh, 1, 16, ++index, 2);
    const int deepest = *std::max_element(built.shape.depth.begin(), built.shape.depth.end());
    Trial("5.6 build_sah", index, 2)
        .given("mesh", code(mesh))
        .expect_small("levels more than halving needs",
                      std::max(0, deepest - tests::levels_of_halving(many.size(), 1)),
                      tests::exactly, tests::too_deep);
  }
}

TEST_CASE("Clusters that halve in size do not make the tree deeper than its limit", "[5.6]") {
  // Each plane parts off a few clusters only; from depth 32 on halving bounds the depth.
  expect_sah(common::clusters(16 * 150), 1, 2, 1, 2);
  expect_sah(common::clusters(16 * 150), 2, 3, 2, 2);
}

TEST_CASE("A huge triangle and very thin ones still give a tree", "[5.6]") {
  expect_sah(common::with_huge_triangle(common::bumpy_sphere(300)), 2, 16, 1, 3);
  expect_sah(common::diagonal_slivers(200), 2, 16, 2, 3);
  expect_sah(common::flat_grid(9), 3, 7, 3, 3);
}

TEST_CASE("A broken mesh or a leaf size below one or a single bin is refused", "[5.6]") {
  tests::expect_refusals("5.6 build_sah", [](const common::TriangleMesh& mesh, int leaf_size) {
    return build_sah(mesh, leaf_size, 16);
  });
  int index = 0;
  for (const int bins : {1, 0, -3}) {
    const common::TriangleMesh mesh = common::bumpy_torus(36);
    Trial("5.6 build_sah", ++index, 3)
        .given("bins", static_cast<double>(bins))
        .expect_throw([&] { return tests::Tree{build_sah(mesh, 4, bins)}; }, "bins is below 2");
  }
}

#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "oracle.hpp"

using namespace lab::bvh_traversal;
using common::TriangleMesh;
using tests::code;
using tests::exactly;
using tests::Pairs;
using tests::Trial;

namespace {

struct Meshes {
  std::string name;
  TriangleMesh a;
  TriangleMesh b;
};

/// Pairs as by brute force. Returns their number, so that a test can say that there are some.
std::size_t expect_brute_force(const Meshes& meshes, std::size_t leaf_size, int index, int count) {
  const Bvh a = tests::tree_of(meshes.a, leaf_size);
  const Bvh b = tests::tree_of(meshes.b, leaf_size);
  const Trial trial = Trial("5.5 find_intersections", index, count)
                          .given("case", tests::Code{meshes.name})
                          .given("mesh a", code(meshes.a))
                          .given("mesh b", code(meshes.b));
  const Intersections found = trial.returned([&] { return find_intersections(a, b); });
  const Pairs wanted = tests::brute_force(meshes.a, meshes.b);
  tests::expect_pairs(trial, found, wanted, a, b, [] { return tests::PairSuspects{}; });
  return wanted.pairs.size();
}

/// The counts where every area is exact, so that the bigger node is beyond doubt.
void expect_counts(const TriangleMesh& mesh_a, const TriangleMesh& mesh_b, std::size_t leaf_size,
                   int index, int count) {
  const Bvh a = tests::tree_of(mesh_a, leaf_size);
  const Bvh b = tests::tree_of(mesh_b, leaf_size);
  const Trial trial = Trial("5.5 find_intersections", index, count)
                          .given("mesh a", code(mesh_a))
                          .given("mesh b", code(mesh_b));
  const Intersections found = trial.returned([&] { return find_intersections(a, b); });
  const tests::Walker walker(a, b);
  double triangle_tests = 0.0;
  for (const tests::Indices& pair : walker.ends.pairs) {
    triangle_tests +=
        static_cast<double>(a.nodes[pair[0]].count) * static_cast<double>(b.nodes[pair[1]].count);
  }
  trial.of("box_tests")
      .expect(static_cast<double>(found.box_tests), static_cast<double>(walker.box_tests), exactly);
  trial.of("triangle_tests")
      .expect(static_cast<double>(found.triangle_tests), triangle_tests,
              {0.0, "all triangles of one leaf with all of the other leaf"},
              {{static_cast<double>(walker.ends.pairs.size()),
                "this is the number of pairs of leaves: count the pairs of triangles in them"}});
}

TriangleMesh turned_torus(std::size_t triangles) {
  TriangleMesh torus = common::bumpy_torus(triangles);
  for (Vec3& v : torus.vertices) v = Vec3(v.x() + 0.9, v.z() + 0.05, v.y() + 0.1 * v.x() + 0.3);
  return torus;
}

TriangleMesh turned_sphere(std::size_t triangles) {
  TriangleMesh sphere = common::bumpy_sphere(triangles);
  const common::Mat3 R = Eigen::AngleAxisd(2.1, Vec3(0.6, 0.0, 0.8)).toRotationMatrix();
  for (Vec3& v : sphere.vertices) v = R * v;
  return sphere;
}

}  // namespace

TEST_CASE("Two triangles that cross are the pair of their meshes", "[5.5]") {
  TriangleMesh a{
      {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(50, 0, 0), Vec3(51, 0, 0), Vec3(50, 1, 0)},
      {{3, 4, 5}, {0, 1, 2}}};
  TriangleMesh b{{Vec3(1, 1, -1), Vec3(1, 1, 3), Vec3(5, 5, 1), Vec3(-9, 0, 0), Vec3(-8, 0, 0),
                  Vec3(-9, 0, 1)},
                 {{3, 4, 5}, {3, 5, 4}, {0, 1, 2}}};
  const std::size_t pairs =
      expect_brute_force({"triangle 1 of a meets triangle 2 of b", a, b}, 1, 1, 1);
  CHECK(pairs == 1);
}

TEST_CASE("A thousand small soups give the pairs of brute force", "[5.5]") {
  tests::Random random(61);
  std::size_t pairs = 0;
  for (int i = 1; i <= 1000; ++i) {
    const int n = static_cast<int>(random.uniform(1.0, 6.0));
    const TriangleMesh a = tests::soup(random, n, 2 + i % 3);
    const TriangleMesh b = tests::soup(random, 6 - n, 2 + i % 3);
    pairs += expect_brute_force({"soup", a, b}, static_cast<std::size_t>(1 + i % 3), i, 1000);
  }
  CHECK(pairs > 0);
}

TEST_CASE("Smooth meshes give the pairs of brute force", "[5.5]") {
  const std::size_t of_tori =
      expect_brute_force({"tori", common::bumpy_torus(900), turned_torus(1600)}, 4, 1, 3);
  CHECK(of_tori > 20);
  const std::size_t of_spheres =
      expect_brute_force({"spheres", common::bumpy_sphere(1000), turned_sphere(700)}, 4, 2, 3);
  CHECK(of_spheres > 100);
  const std::size_t of_grid = expect_brute_force(
      {"a sphere and a grid", turned_sphere(1000),
       common::scaled(common::flat_grid(12), Vec3::Constant(0.3), Vec3(-2.0, -2.0, 0.1))},
      3, 3, 3);
  CHECK(of_grid > 20);
}

TEST_CASE("Meshes that share a plane or corners give the pairs of brute force", "[5.5]") {
  const TriangleMesh grid = common::flat_grid(6);
  const auto moved = [&](const Vec3& offset) { return common::scaled(grid, Vec3::Ones(), offset); };
  const auto standing = [&](const Vec3& offset) {
    TriangleMesh wall = grid;
    for (Vec3& v : wall.vertices) v = Vec3(v.x(), 0.0, v.y()) + offset;
    return wall;
  };
  const TriangleMesh sphere = common::bumpy_sphere(200);
  const std::vector<Meshes> cases{
      {"a mesh and itself", sphere, sphere},
      {"a grid and itself", grid, grid},
      {"two grids in one plane", grid, moved(Vec3(0.5, 0.25, 0.0))},
      {"two grids in one plane that share an edge", grid, moved(Vec3(6.0, 0.0, 0.0))},
      {"a wall on a floor from edge to edge", grid, standing(Vec3(0.0, 4.0, 0.0))},
      {"a wall whose corners touch the floor", grid, standing(Vec3(0.5, 4.5, 0.0))},
      {"a wall through the floor", grid, standing(Vec3(0.5, 4.5, -1.0))}};
  int index = 0;
  for (const Meshes& meshes : cases) {
    const std::size_t pairs =
        expect_brute_force(meshes, 4, ++index, static_cast<int>(cases.size()));
    CHECK(pairs > 0);
  }
}

TEST_CASE("Meshes in one tilted plane give the pairs of brute force", "[5.5]") {
  // Corners i u + j v + w of whole numbers are exact, and so they are in one plane; but n·x of a
  // normal n has too many digits, so planes through the corners seem to differ: for most pairs of
  // triangles, so that each plane need have some hundred of them only.
  tests::Random random(63);
  for (int index = 1; index <= 10; ++index) {
    const auto whole = [&] { return std::round(random.uniform(-1.0, 1.0) * 0x1p24); };
    const Vec3 u(whole(), whole(), whole());
    const Vec3 v(whole(), whole(), whole());
    const Vec3 w(whole(), whole(), whole());
    const auto tilted = [&](double i, double j) {
      TriangleMesh mesh = common::flat_grid(3);
      for (Vec3& x : mesh.vertices) x = (x.x() + i) * u + (x.y() + j) * v + w;
      return mesh;
    };
    const Meshes meshes{"one tilted plane", tilted(0.0, 0.0), tilted(index % 3 + 0.25, 1.5)};
    const std::size_t pairs =
        expect_brute_force(meshes, static_cast<std::size_t>(1 + index % 3), index, 10);
    CHECK(pairs > 0);
  }
}

TEST_CASE("Meshes with a very small gap give no pair", "[5.5]") {
  const TriangleMesh grid = common::flat_grid(8);
  const TriangleMesh raised = common::scaled(grid, Vec3::Ones(), Vec3(0.3, 0.2, 1.0));
  int index = 0;
  for (const double gap : {1e-9, 1e-15}) {
    const TriangleMesh above = common::scaled(grid, Vec3::Ones(), Vec3(0.0, 0.0, 1.0 + gap));
    const std::size_t pairs =
        expect_brute_force({"a gap of " + tests::text(gap), raised, above}, 4, ++index, 2);
    CHECK(pairs == 0);
  }
}

TEST_CASE("Thin and tiny and far meshes give the pairs of brute force", "[5.5]") {
  const TriangleMesh a = common::bumpy_sphere(400);
  const TriangleMesh b = turned_sphere(300);
  const auto both = [&](const std::string& name, const Vec3& factors, const Vec3& offset) {
    return Meshes{name, common::scaled(a, factors, offset), common::scaled(b, factors, offset)};
  };
  const std::vector<Meshes> cases{both("slivers of 1e-7", Vec3(1.0, 1.0, 1e-7), Vec3::Zero()),
                                  both("meshes of 1e-12", Vec3::Constant(1e-12), Vec3::Zero()),
                                  both("meshes of 1e-60", Vec3::Constant(1e-60), Vec3::Zero()),
                                  both("meshes of 1e60", Vec3::Constant(1e60), Vec3::Zero()),
                                  both("an offset of 1e6", Vec3::Ones(), Vec3::Constant(1e6)),
                                  both("an offset of 1e9", Vec3::Ones(), Vec3(1e9, -1e9, 1e9))};
  int index = 0;
  for (const Meshes& meshes : cases) {
    const std::size_t pairs =
        expect_brute_force(meshes, 4, ++index, static_cast<int>(cases.size()));
    CHECK(pairs > 20);
  }
}

TEST_CASE("If boxes separate badly the pairs are those of brute force", "[5.5]") {
  TriangleMesh slivers = common::diagonal_slivers(60);
  for (Vec3& v : slivers.vertices) v = Vec3(1.0 - v.x(), v.y(), v.z());
  const std::vector<Meshes> cases{
      {"clusters", common::clusters(200), common::clusters(100)},
      {"a huge triangle", common::with_huge_triangle(common::bumpy_sphere(200)),
       turned_sphere(200)},
      {"diagonal slivers", common::diagonal_slivers(60), slivers}};
  int index = 0;
  for (const Meshes& meshes : cases) expect_brute_force(meshes, 4, ++index, 3);
}

TEST_CASE("A mesh inside another and a shell around it give no pair", "[5.5]") {
  const TriangleMesh sphere = common::bumpy_sphere(600);
  const TriangleMesh small = common::scaled(turned_sphere(300), Vec3::Constant(0.5));
  const std::size_t inside = expect_brute_force({"a sphere inside", sphere, small}, 4, 1, 2);
  CHECK(inside == 0);
  const std::size_t around =
      expect_brute_force({"a shell", sphere, common::inflated(sphere, 0.05)}, 4, 2, 2);
  CHECK(around == 0);
}

TEST_CASE("The counts of a query are those of its traversal", "[5.5]") {
  tests::Random random(62);
  for (int i = 1; i <= 30; ++i) {
    const TriangleMesh a = tests::spread(random, 30, 8);
    const TriangleMesh b = tests::spread(random, 40, 8);
    expect_counts(a, b, static_cast<std::size_t>(1 + i % 4), i, 30);
  }
}

TEST_CASE("The tests of a query grow more slowly than its meshes except on shells", "[5.5]") {
  // From n to 16 n triangles; the counts of a traversal are its own, so the exponent is, too.
  const auto exponent = [](bool shells) {
    double tests_made[2] = {0.0, 0.0};
    int k = 0;
    for (const std::size_t n : {300U, 4800U}) {
      const TriangleMesh mesh = shells ? common::bumpy_sphere(n) : common::bumpy_torus(n);
      const double edge = std::sqrt(12.0 / static_cast<double>(n));
      const Bvh a = tests::tree_of(mesh, 4);
      const Bvh b =
          tests::tree_of(shells ? common::inflated(mesh, 0.3 * edge) : turned_torus(n), 4);
      const Intersections found =
          Trial("5.5 find_intersections").given("mesh a", code(mesh)).returned([&] {
            return find_intersections(a, b);
          });
      tests_made[k++] = static_cast<double>(found.box_tests + found.triangle_tests);
    }
    return std::log(tests_made[1] / tests_made[0]) / std::log(16.0);
  };
  Trial("5.5 find_intersections")
      .given("meshes", tests::Code{"two tori, 300 and 4800 triangles"})
      .expect_small("exponent of the tests over the triangles", exponent(false),
                    {0.8, "the meshes meet along curves"});
  Trial("5.5 find_intersections")
      .given("meshes", tests::Code{"two shells, 300 and 4800 triangles"})
      .expect_small("distance of the exponent from 1", std::abs(exponent(true) - 1.0),
                    {0.15, "the boxes overlap everywhere"});
}

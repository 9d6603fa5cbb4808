#include "catch.hpp"
#include "common/geometry/meshes.hpp"
#include "oracle.hpp"

using namespace lab::bvh_traversal;
using common::Mat3;
using common::TriangleMesh;
using tests::code;
using tests::Pairs;
using tests::Trial;

namespace {

const std::string inverse =
    "b is moved by the inverse, or a is moved instead: a_from_b leads from b's frame to a's";
const std::string at_rest = "nothing is moved: move b by a_from_b";
const std::string rotation_only = "b is turned but not shifted: add the translation";

TriangleMesh moved(TriangleMesh mesh, const RigidTransform& transform) {
  for (Vec3& vertex : mesh.vertices) {
    const Mat3& R = transform.rotation;
    Vec3 p;
    for (Eigen::Index i = 0; i < 3; ++i) {
      // One rounding at a time, as the contract says, whatever the compiler may fuse.
      const volatile double x = R(i, 0) * vertex.x();
      const volatile double y = R(i, 1) * vertex.y();
      const volatile double z = R(i, 2) * vertex.z();
      const volatile double xy = x + y;
      const volatile double xyz = xy + z;
      p[i] = xyz + transform.translation[i];
    }
    vertex = p;
  }
  return mesh;
}

RigidTransform inverted(const RigidTransform& t) {
  return {t.rotation.transpose(), -(t.rotation.transpose() * t.translation)};
}

Trial trial_of(const TriangleMesh& a, const TriangleMesh& b, const RigidTransform& a_from_b,
               int index, int count) {
  return Trial("5.7 find_intersections_moved", index, count)
      .given("mesh a", code(a))
      .given("mesh b", code(b))
      .given("a_from_b.rotation", a_from_b.rotation)
      .given("a_from_b.translation", a_from_b.translation);
}

std::size_t expect_moved(const TriangleMesh& a, const TriangleMesh& b,
                         const RigidTransform& a_from_b, std::size_t leaf_size, int index,
                         int count) {
  const Bvh tree_a = tests::tree_of(a, leaf_size);
  const Bvh tree_b = tests::tree_of(b, leaf_size);
  const Trial trial = trial_of(a, b, a_from_b, index, count);
  const Intersections found =
      trial.returned([&] { return find_intersections_moved(tree_a, tree_b, a_from_b); });
  const Pairs wanted = tests::brute_force(a, moved(b, a_from_b));
  tests::expect_pairs(trial, found, wanted, tree_a, tree_b, [&] {
    tests::PairSuspects suspects{
        {tests::brute_force(a, moved(b, inverted(a_from_b))), inverse},
        {tests::brute_force(a, b), at_rest},
        {tests::brute_force(a, moved(b, {a_from_b.rotation, Vec3::Zero()})), rotation_only}};
    // An empty list is what many mistakes return.
    std::erase_if(suspects, [](const auto& suspect) { return suspect.value.pairs.empty(); });
    return suspects;
  });
  return wanted.pairs.size();
}

RigidTransform random_transform(tests::Random& random, double distance) {
  return {random.attitude().toRotationMatrix(), random.vector(distance)};
}

/// The box around the moved box, without a margin.
Box box_around_moved(const Box& box, const RigidTransform& t) {
  const Vec3 center = t.rotation * (0.5 * (box.low + box.high)) + t.translation;
  const Vec3 half = t.rotation.cwiseAbs() * (0.5 * (box.high - box.low));
  return {center - half, center + half};
}

}  // namespace

TEST_CASE("A quarter turn brings two triangles together", "[5.7]") {
  const TriangleMesh a{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}, {{0, 1, 2}}};
  // In b's frame along x; turned about z and shifted it stands in the middle of a.
  const TriangleMesh b{{Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(9, 0, 0)}, {{0, 1, 2}}};
  RigidTransform a_from_b;
  a_from_b.rotation << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  a_from_b.translation = Vec3(1.0, 1.0, 0.0);
  const std::size_t together = expect_moved(a, b, a_from_b, 1, 1, 2);
  CHECK(together == 1);
  a_from_b.translation = Vec3(5.0, -1.0, 0.0);
  const std::size_t apart = expect_moved(a, b, a_from_b, 1, 2, 2);
  CHECK(apart == 0);
}

TEST_CASE("Without a motion the pairs are those of the meshes at rest", "[5.7]") {
  tests::Random random(81);
  for (int i = 1; i <= 20; ++i) {
    expect_moved(tests::soup(random, 8, 3), tests::soup(random, 8, 3), {}, 2, i, 20);
  }
}

TEST_CASE("Soups under exact quarter turns touch as they do at rest", "[5.7]") {
  tests::Random random(82);
  for (int i = 1; i <= 60; ++i) {
    RigidTransform turn;
    turn.rotation << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
    if (i % 2 == 0) turn.rotation << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0;
    for (double& x : turn.translation) x = std::floor(random.uniform(-2.0, 3.0));
    expect_moved(tests::soup(random, 8, 3), tests::soup(random, 8, 3), turn, 2, i, 60);
  }
}

TEST_CASE("Smooth meshes under random motions give the pairs of brute force", "[5.7]") {
  tests::Random random(83);
  const TriangleMesh torus = common::bumpy_torus(400);
  const TriangleMesh sphere = common::bumpy_sphere(300);
  for (int i = 1; i <= 6; ++i) {
    expect_moved(torus, i % 2 == 0 ? torus : sphere, random_transform(random, 0.7),
                 static_cast<std::size_t>(1 + i % 4), i, 6);
  }
}

TEST_CASE("Long triangles are not lost when boxes are turned", "[5.7]") {
  // A box that is moved by two of its corners alone misses what its other corners reach.
  tests::Random random(84);
  for (int i = 1; i <= 40; ++i) {
    TriangleMesh a;
    TriangleMesh b;
    for (TriangleMesh* mesh : {&a, &b}) {
      for (std::uint32_t k = 0; k < 6; ++k) {
        const Vec3 along = random.direction();
        mesh->vertices.push_back(-2.0 * along + random.vector(0.1));
        mesh->vertices.push_back(2.0 * along + random.vector(0.1));
        mesh->vertices.push_back(random.vector(0.5));
        mesh->triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
      }
    }
    expect_moved(a, b, random_transform(random, 0.5), 1, i, 40);
  }
}

TEST_CASE("Moved corners that touch only by rounding are compared as rounded", "[5.7]") {
  // Corners of a at the rounded places of corners of b: they meet in one point, on the faces of all
  // boxes, so that a moved box needs its margin: for what is rounded where b is, on the way, and
  // where it arrives.
  struct Place {
    double size;         // of b [m]
    double from_origin;  // of b in its frame [m]
    double shift;        // [m]
    bool returns;        // the motion leads b's place to the origin
  };
  const std::array<Place, 10> places{{{1.0, 0.0, 1.0, false},
                                      {1.0, 0.0, 1e6, false},
                                      {1.0, 0.0, 1e9, false},
                                      {1.0, 1.0, 0.0, false},
                                      {1.0, 1e3, 0.0, false},
                                      {1.0, 1e6, 0.0, false},
                                      {1.0, 1e6, 0.0, true},
                                      {1e9, 0.0, 0.0, false},
                                      {1e9, 0.0, 1.0, false},
                                      {1e-9, 1.0, 0.0, false}}};
  tests::Random random(85);
  int index = 0;
  for (const Place& place : places) {
    for (int i = 0; i < 120; ++i) {
      RigidTransform t = random_transform(random, place.shift);
      const Vec3 centre = random.vector(place.from_origin);
      if (place.returns) t.translation = -(t.rotation * centre);
      TriangleMesh b;
      for (int k = 0; k < 3; ++k) b.vertices.push_back(centre + random.vector(place.size));
      b.triangles = {{0, 1, 2}};
      const TriangleMesh there = moved(b, t);
      // The corner of b that is furthest along an axis, and a triangle beyond it.
      const Eigen::Index axis = i % 3;
      const double sign = i % 2 == 0 ? 1.0 : -1.0;
      Vec3 tip = there.vertices[0];
      for (const Vec3& v : there.vertices) {
        if (sign * v[axis] > sign * tip[axis]) tip = v;
      }
      const auto beyond = [&](double y, double z) {
        Vec3 d;
        d[axis] = sign;
        d[(axis + 1) % 3] = y;
        d[(axis + 2) % 3] = z;
        return Vec3(tip + place.size * d);
      };
      const TriangleMesh a{{tip, beyond(0.3, 0.1), beyond(-0.2, 0.4)}, {{0, 1, 2}}};
      const std::size_t pairs = expect_moved(a, b, t, 1, ++index, 1200);
      CHECK(pairs == 1);
    }
  }
}

TEST_CASE("A query of moved meshes costs no more than boxes around the moved boxes", "[5.7]") {
  tests::Random random(86);
  const TriangleMesh torus = common::bumpy_torus(1600);
  const Bvh tree = tests::tree_of(torus, 4);
  for (int i = 1; i <= 3; ++i) {
    const RigidTransform t = random_transform(random, 0.7);
    const Intersections found = trial_of(torus, torus, t, i, 3).returned([&] {
      return find_intersections_moved(tree, tree, t);
    });
    Bvh around = tree;
    for (BvhNode& node : around.nodes) node.box = box_around_moved(node.box, t);
    const tests::Walker walker(tree, around);
    // Which node is bigger may be seen in either frame, which is worth some tests.
    trial_of(torus, torus, t, i, 3)
        .of("box_tests")
        .expect_small("box tests, divided by those with boxes around the moved boxes",
                      static_cast<double>(found.box_tests) /
                          static_cast<double>(std::max<std::uint64_t>(walker.box_tests, 1)),
                      {1.5, "moved boxes must not be larger"});
  }
}

TEST_CASE("A motion that is not finite is refused", "[5.7]") {
  const Bvh tree = tests::tree_of(common::bumpy_torus(36), 4);
  int index = 0;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RigidTransform turned;
    turned.rotation(1, 2) = bad;
    RigidTransform shifted;
    shifted.translation.z() = bad;
    for (const RigidTransform& t : {turned, shifted}) {
      Trial("5.7 find_intersections_moved", ++index, 4)
          .given("a_from_b.rotation", t.rotation)
          .given("a_from_b.translation", t.translation)
          .expect_throw(
              [&] { return tests::pairs_of(find_intersections_moved(tree, tree, t).pairs); },
              "a_from_b is not finite");
    }
  }
}

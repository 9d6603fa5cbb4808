#include "catch.hpp"
#include "judged.hpp"
#include "random.hpp"

using namespace lab::bvh_traversal;
using tests::code;
using tests::Corners;
using tests::Decision;
using tests::eps;
using tests::Trial;

namespace {

const std::string touching_boxes = "touching boxes are taken for apart: compare with <=, not <";
const std::string one_axis_is_enough =
    "an overlap in one coordinate is enough: require it in all three";
const std::string half_is_missing =
    "half of the test is missing: each box must begin before the other ends, in all three "
    "coordinates";
const std::string corner_inside =
    "this looks for a corner of one box in the other, which crossing plates lack: compare "
    "intervals";

/// Lengths may be so small and so large, by the contract [m].
constexpr std::array<double, 5> sizes{1.0, 1e60, 1e-60, 1e-9, 1e9};

void expect_box_of(const Triangle& t, int index, int count) {
  Corners wanted;
  for (Eigen::Index i = 0; i < 3; ++i) {
    wanted.box.low[i] = std::min(std::min(t[0][i], t[1][i]), t[2][i]);
    wanted.box.high[i] = std::max(std::max(t[0][i], t[1][i]), t[2][i]);
  }
  const Corners of_two{{t[0].cwiseMin(t[1]), t[0].cwiseMax(t[1])}};
  const Corners unsorted{{t[0], t[2]}};
  Trial("5.1 box_of", index, count)
      .given("triangle", code(t))
      .expect(
          Corners{box_of(t)}, wanted, {0.0, "coordinates are copied, not computed"},
          {{of_two, "the third corner is left out: take all three"},
           {unsorted,
            "the corners are copied as they are: take the least and greatest of each coordinate"}});
}

Box random_box(tests::Random& random) {
  const Vec3 a = random.vector(2.0);
  const Vec3 b = random.vector(2.0);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

void expect_merged(const Box& a, const Box& b, const Box& wanted, int index, int count) {
  const Corners common_part{{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)}};
  Trial("5.1 merged", index, count)
      .given("a", code(a))
      .given("b", code(b))
      .expect(
          Corners{merged(a, b)}, Corners{wanted}, {0.0, "coordinates are copied, not computed"},
          {{common_part, "this is what the boxes have in common: return the box that holds both"},
           {Corners{a}, "the second box is left out: take both"},
           {Corners{b}, "the first box is left out: take both"}});
}

bool overlap_by(const Box& a, const Box& b, bool any) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    if ((a.low[i] <= b.high[i] && b.low[i] <= a.high[i]) == any) return any;
  }
  return !any;
}

bool begins_before_end(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all();
}

bool has_corner_in(const Box& a, const Box& b) {
  for (int k = 0; k < 8; ++k) {
    bool inside = true;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double x = (k >> i) % 2 == 0 ? a.low[i] : a.high[i];
      inside = inside && b.low[i] <= x && x <= b.high[i];
    }
    if (inside) return true;
  }
  return false;
}

bool overlap_strictly(const Box& a, const Box& b) {
  return (a.low.array() < b.high.array()).all() && (b.low.array() < a.high.array()).all();
}

void expect_overlap(const Box& a, const Box& b, int index, int count) {
  for (const bool swapped : {false, true}) {
    const Box& first = swapped ? b : a;
    const Box& second = swapped ? a : b;
    const Trial trial =
        Trial("5.1 overlap", index, count).given("a", code(first)).given("b", code(second));
    const bool got = trial.returned([&] { return overlap(first, second); });
    const bool wanted = overlap_by(first, second, false);
    trial.expect(
        Decision{got}, Decision{wanted}, tests::exactly,
        {{Decision{overlap_strictly(first, second)}, touching_boxes},
         {Decision{overlap_by(first, second, true)}, one_axis_is_enough},
         {Decision{begins_before_end(first, second)}, half_is_missing},
         {Decision{begins_before_end(second, first)}, half_is_missing},
         {Decision{has_corner_in(first, second) || has_corner_in(second, first)}, corner_inside}});
  }
}

double area_of(const Vec3& s) { return 2.0 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()); }

/// What a box without a volume is taken for, by what the function says of the brick that is worked
/// by hand: there no one can take the surface for the volume.
std::string why_flat_is_nothing() {
  const double brick = surface_area({Vec3(1.0, 1.0, 1.0), Vec3(3.0, 4.0, 5.0)});
  return brick == 24.0 ? "this is the volume: return the surface area"
         : brick == 52.0
             ? "a flat box has two faces: only an empty box, a line or a point has no surface"
             : "";
}

void expect_area(const Box& box, double wanted, int index, int count) {
  const Vec3 s = box.high - box.low;
  Trial("5.1 surface_area", index, count)
      .given("box", code(box))
      .expect(surface_area(box), wanted, {16.0 * eps * wanted, "a few rounded operations"},
              {{s.prod(), s.prod() > 0.0 ? "this is the volume: return the surface area"
                                         : why_flat_is_nothing()},
               {0.5 * wanted, "the factor 2 is missing: each face has an opposite one"},
               {s.norm(), "this is the diagonal: return the surface area"}});
}

}  // namespace

TEST_CASE("The box of a triangle takes each coordinate of any corner", "[5.1]") {
  expect_box_of({Vec3(1.0, 2.0, 3.0), Vec3(-1.0, 5.0, 0.0), Vec3(0.0, 3.0, 9.0)}, 1, 1);
}

TEST_CASE("The box of random triangles is exact", "[5.1]") {
  tests::Random random(1);
  for (int i = 1; i <= 100; ++i) {
    const double size = sizes[static_cast<std::size_t>(i) % sizes.size()];
    expect_box_of({random.vector(size), random.vector(size), random.vector(size)}, i, 100);
  }
}

TEST_CASE("A triangle that is a point has a box that is that point", "[5.1]") {
  const Vec3 p(0.1, -2.0, 1e-60);
  expect_box_of({p, p, p}, 1, 1);
}

TEST_CASE("Two boxes merged hold both and no more", "[5.1]") {
  tests::Random random(2);
  for (int i = 1; i <= 100; ++i) {
    const Box a = random_box(random);
    const Box b = random_box(random);
    expect_merged(a, b, {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}, i, 100);
  }
}

TEST_CASE("An empty box adds nothing to another", "[5.1]") {
  const Box box{Vec3(-3.0, 1.0, 2.0), Vec3(-2.0, 1.0, 5.0)};
  expect_merged(box, Box{}, box, 1, 2);
  expect_merged(Box{}, box, box, 2, 2);
}

TEST_CASE("A point and a line have no surface and yet are merged", "[5.1]") {
  const Box box{Vec3(-3.0, 1.0, 2.0), Vec3(-2.0, 2.0, 5.0)};
  const Box point{Vec3(1.0, 1.0, 1.0), Vec3(1.0, 1.0, 1.0)};
  const Box line{Vec3(-5.0, 1.0, 3.0), Vec3(-5.0, 4.0, 3.0)};
  int index = 0;
  for (const auto& [a, b] : {std::pair{box, point}, {point, line}, {line, box}}) {
    const Box both{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
    expect_merged(a, b, both, ++index, 6);
    expect_merged(b, a, both, ++index, 6);
  }
}

TEST_CASE("Boxes that touch at a face an edge or a corner overlap", "[5.1]") {
  const Box unit{Vec3::Zero(), Vec3::Ones()};
  int index = 0;
  for (const Vec3& shift : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0),
                            Vec3(0, 1, -1), Vec3(1, -1, 1), Vec3(1, 1, 1)}) {
    expect_overlap(unit, {unit.low + shift, unit.high + shift}, ++index, 7);
  }
}

TEST_CASE("Boxes apart along two axes or all three do not overlap", "[5.1]") {
  const Box unit{Vec3::Zero(), Vec3::Ones()};
  int index = 0;
  for (const Vec3& shift : {Vec3(3, -3, 0), Vec3(0, 3, -3), Vec3(-3, 0, 3), Vec3(3, 3, 3)}) {
    expect_overlap(unit, {unit.low + shift, unit.high + shift}, ++index, 4);
  }
}

TEST_CASE("At rounded places the last bit decides whether boxes touch", "[5.1]") {
  tests::Random random(5);
  for (int i = 1; i <= 200; ++i) {
    const Box a = random_box(random);
    Box b{a.low - random.vector().cwiseAbs(), a.high + random.vector().cwiseAbs()};
    const Eigen::Index axis = i % 3;
    const double end = a.high[axis];
    b.low[axis] = i % 2 == 0 ? end : std::nextafter(end, std::numeric_limits<double>::max());
    b.high[axis] = b.low[axis] + random.uniform(0.0, 2.0);
    expect_overlap(a, b, i, 200);
  }
}

TEST_CASE("Boxes that are apart along one axis do not overlap", "[5.1]") {
  const Box unit{Vec3::Zero(), Vec3::Ones()};
  int index = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double distance : {-3.0, -1.0 - 1e-15, 1.0 + 1e-15, 3.0}) {
      const Vec3 shift = distance * Vec3::Unit(axis);
      expect_overlap(unit, {unit.low + shift, unit.high + shift}, ++index, 12);
    }
  }
}

TEST_CASE("Plates that cross overlap without a corner in each other", "[5.1]") {
  const Box flat{Vec3(-3.0, -3.0, -0.1), Vec3(3.0, 3.0, 0.1)};
  const Box high{Vec3(-0.1, -1.0, -4.0), Vec3(0.1, 1.0, 4.0)};
  expect_overlap(flat, high, 1, 1);
}

TEST_CASE("Whether random boxes overlap is decided by all three coordinates", "[5.1]") {
  tests::Random random(3);
  for (int i = 1; i <= 200; ++i) expect_overlap(random_box(random), random_box(random), i, 200);
}

TEST_CASE("An empty box overlaps nothing", "[5.1]") {
  expect_overlap(Box{}, {Vec3::Constant(-1e60), Vec3::Constant(1e60)}, 1, 2);
  expect_overlap(Box{}, Box{}, 2, 2);
}

TEST_CASE("The surface of a brick is worked by hand", "[5.1]") {
  expect_area({Vec3(1.0, 1.0, 1.0), Vec3(3.0, 4.0, 5.0)}, 52.0, 1, 1);
}

TEST_CASE("A flat box has two faces and a line or an empty box has none", "[5.1]") {
  expect_area({Vec3(0.0, 0.0, 7.0), Vec3(2.0, 3.0, 7.0)}, 12.0, 1, 4);
  expect_area({Vec3(0.0, 1.0, 7.0), Vec3(2.0, 1.0, 7.0)}, 0.0, 2, 4);
  expect_area({Vec3(4.0, 1.0, 7.0), Vec3(4.0, 1.0, 7.0)}, 0.0, 3, 4);
  Trial("5.1 surface_area", 4, 4)
      .given("box", tests::Code{"{}"})
      .expect(surface_area(Box{}), 0.0, {0.0, "an empty box has no surface"});
}

TEST_CASE("The surface of random bricks is right to a few ulp", "[5.1]") {
  tests::Random random(4);
  for (int i = 1; i <= 100; ++i) {
    const double size = sizes[static_cast<std::size_t>(i) % sizes.size()];
    const Box unscaled = random_box(random);
    const Box box{size * unscaled.low, size * unscaled.high};
    expect_area(box, area_of(box.high - box.low), i, 100);
  }
}

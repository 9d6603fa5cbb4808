#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::around_axis;
using tests::expect_triangle;
using tests::Triangle;

namespace {

Triangle random_triangle(tests::Random& random) {
  return {{random.vector(2.0), random.vector(2.0), random.vector(2.0)},
          random.uniform(0.05, 0.5),
          tests::random_cylinder(random)};
}

/// With the axis inside: its corners' directions are no half turn apart.
Triangle random_pierced(tests::Random& random) {
  Triangle t = random_triangle(random);
  const double start = tests::random_angle(random);
  for (std::size_t i = 0; i < 3; ++i) {
    t.p[i] = around_axis(random.uniform(-2.0, 2.0), random.uniform(0.2, 3.0),
                         start + 2.1 * static_cast<double>(i) + random.uniform(-0.4, 0.4));
  }
  return t;
}

double gap_of(const Triangle& t) {
  return triangle_gap(t.p[0], t.p[1], t.p[2], t.particle_radius, t.cylinder).gap;
}

tests::Trial triangle_trial(const Triangle& t, int index = 1, int count = 1) {
  return tests::shape_trial("3.5 triangle_gap", t, index, count);
}

}  // namespace

TEST_CASE("The axis goes through a triangle with weights one half and two quarters", "[3.5]") {
  const Triangle t{
      {Vec3(0.0, -1.0, -1.0), Vec3(1.0, 3.0, -1.0), Vec3(2.0, -1.0, 3.0)}, 0.25, {0.5}};
  expect_triangle(t);
  const TriangleGap got = triangle_gap(t.p[0], t.p[1], t.p[2], t.particle_radius, t.cylinder);
  triangle_trial(t).of("the gap").expect(got.gap, -0.75, tests::few_ulp(0.75));
  triangle_trial(t)
      .of("the weights")
      .expect(got.weights, Vec3(0.5, 0.25, 0.25), tests::on_shape(1.0));
}

TEST_CASE("A triangle beside the axis is nearest on its nearest edge", "[3.5]") {
  // The edge from c to a is two from the axis, a quarter of its way along.
  const Triangle t{{Vec3(0.0, 2.0, 3.0), Vec3(1.0, 7.0, 1.0), Vec3(2.0, 2.0, -1.0)}, 0.5, {1.0}};
  expect_triangle(t);
  const TriangleGap got = triangle_gap(t.p[0], t.p[1], t.p[2], t.particle_radius, t.cylinder);
  triangle_trial(t).of("the gap").expect(got.gap, 0.5, tests::on_shape(t.size()));
  triangle_trial(t)
      .of("the weights")
      .expect(got.weights, Vec3(0.25, 0.0, 0.75), tests::on_shape(t.size()),
              {{Vec3(0.75, 0.0, 0.25),
                "the edge's fraction is counted from its other end: use 1 minus the fraction"}});
}

TEST_CASE("Gaps of triangles agree with a hundred digits", "[3.5]") {
  tests::Random random(361);
  for (int i = 1; i <= 200; ++i) {
    expect_triangle(i % 2 == 0 ? random_triangle(random) : random_pierced(random), i, 200);
  }
}

TEST_CASE("A triangle has the same gap in any order of its corners", "[3.5]") {
  tests::Random random(362);
  for (int i = 1; i <= 20; ++i) {
    Triangle t = i % 2 == 0 ? random_triangle(random) : random_pierced(random);
    for (int order = 0; order < 6; ++order) {
      std::swap(t.p[order % 2 == 0 ? 0 : 2], t.p[1]);
      expect_triangle(t, 6 * (i - 1) + order + 1, 120);
    }
  }
}

TEST_CASE("A triangle that is a segment in the yz-plane is like its edges", "[3.5]") {
  tests::Random random(363);
  for (int i = 1; i <= 100; ++i) {
    // On a line through the axis, on either side of it or on both; rounding bends it a little.
    Triangle t = random_triangle(random);
    const double angle = tests::random_angle(random);
    const double low = i % 3 == 0 ? -2.0 : 0.5;
    for (Vec3& corner : t.p) {
      corner = around_axis(random.uniform(-2.0, 2.0), random.uniform(low, 3.0), angle);
    }
    expect_triangle(t, i, 100);
  }
  // Beside the axis, exactly straight; with equal corners; and standing along x.
  expect_triangle({{Vec3(0.0, 2.0, -1.0), Vec3(1.0, 2.0, 4.0), Vec3(2.0, 2.0, 1.0)}});
  expect_triangle({{Vec3(0.0, 2.0, -1.0), Vec3(0.0, 2.0, -1.0), Vec3(2.0, -1.0, 1.0)}});
  expect_triangle({{Vec3(0.0, -1.0, 0.0), Vec3(1.0, 1.0, 0.0), Vec3(2.0, 3.0, 0.0)}});
}

TEST_CASE("A triangle that is a point in the yz-plane is like a particle", "[3.5]") {
  expect_triangle({{Vec3(0.0, 2.0, -1.0), Vec3(1.0, 2.0, -1.0), Vec3(3.0, 2.0, -1.0)}});
  expect_triangle({{Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)}});
}

TEST_CASE("The axis may meet a triangle in a corner or on an edge", "[3.5]") {
  tests::Random random(364);
  for (int i = 1; i <= 30; ++i) {
    Triangle t = random_triangle(random);
    if (i % 2 == 0) {
      t.p[2] = -0.5 * t.p[0];
    } else {
      t.p[1] = Vec3(random.uniform(-1.0, 1.0), 0.0, 0.0);
    }
    std::rotate(t.p.begin(), t.p.begin() + i % 3, t.p.end());
    expect_triangle(t, i, 30);
    triangle_trial(t, i, 30).of("the gap").expect(gap_of(t), -t.radii(), tests::on_shape(t.size()));
  }
}

TEST_CASE("Very thin triangles far off and across the axis keep the digits of their gap", "[3.5]") {
  tests::Random random(365);
  for (int i = 1; i <= 100; ++i) {
    Triangle t = random_triangle(random);
    const double width = std::pow(10.0, random.uniform(-16.0, -1.0));
    const double far = i % 2 == 0 ? 0.0 : std::pow(10.0, random.uniform(0.0, 8.0));
    const double angle = tests::random_angle(random);
    for (Vec3& corner : t.p) {
      corner = tests::rolled(Vec3(random.uniform(-1.0, 1.0), far + random.uniform(-1.0, 1.0),
                                  width * random.uniform(-1.0, 1.0)),
                             angle);
    }
    expect_triangle(t, i, 100);
  }
}

TEST_CASE("The axis goes through even a very thin triangle", "[3.5]") {
  int index = 0;
  for (const double width : {1e-6, 1e-9, 1e-11, 1e-13}) {
    const Triangle t{{Vec3(0.0, 1.0, width), Vec3(0.0, -1.0, width), Vec3(0.0, 0.0, -2.0 * width)},
                     0.5 * width,
                     {0.5 * width}};
    expect_triangle(t, ++index, 4);
    triangle_trial(t, index, 4).of("the gap").expect(gap_of(t), -width, tests::few_ulp(width), [&] {
      return std::vector<tests::Suspect<double>>{
          {0.0,
           "a thin triangle is taken for a segment: test only whether all areas are exactly zero"}};
    });
  }
}

TEST_CASE("Triangles of any size have their gap", "[3.5]") {
  tests::Random random(366);
  int index = 0;
  for (const double size : {1e-300, 1e-200, 1e-100, 1e100, 1e200, 1e300}) {
    for (int i = 0; i < 10; ++i) {
      Triangle t = i % 2 == 0 ? random_triangle(random) : random_pierced(random);
      for (Vec3& corner : t.p) corner *= 0.25 * size;
      t.particle_radius *= size;
      t.cylinder.radius *= size;
      expect_triangle(t, ++index, 60);
    }
  }
}

TEST_CASE("A large equilateral triangle hides the axis from its edges", "[3.5]") {
  tests::Random random(367);
  int index = 0;
  for (const double share : {0.5, 0.9, 1.1, 2.0}) {  // h/(2 √3 ρ)
    Triangle t;
    t.cylinder = tests::random_cylinder(random);
    t.particle_radius = random.uniform(0.05, 0.5);
    const double rho = t.radii();
    const double h = share * 2.0 * std::sqrt(3.0) * rho;
    const double angle = tests::random_angle(random);
    for (std::size_t i = 0; i < 3; ++i) {
      const double third = 4.0 * std::acos(0.0) / 3.0 * static_cast<double>(i);
      t.p[i] = around_axis(1.0, h / std::sqrt(3.0), angle + third);
    }
    const tests::Edge e{{t.p[0], t.p[1]}, t.particle_radius, t.cylinder};
    const double of_edge = edge_gap(t.p[0], t.p[1], t.particle_radius, t.cylinder).gap;
    tests::shape_trial("3.5 edge_gap", e, ++index, 4)
        .of("the edge's gap")
        .expect(of_edge, h / (2.0 * std::sqrt(3.0)) - rho, tests::on_shape(2.0 * t.size()),
                [&] { return tests::suspects_of_edge(e); });
    tests::shape_trial("3.5 edge_gap", e, index, 4)
        .expect_small("1 if the edge is free but should touch, or touches but should be free",
                      (of_edge > 0.0) == (share > 1.0) ? 0.0 : 1.0,
                      {0.0, "h is a tenth away from the limit"});
    triangle_trial(t, index, 4)
        .of("the gap")
        .expect(gap_of(t), -rho, tests::on_shape(t.size()),
                [&] { return tests::suspects_of_triangle(t); });
  }
}

TEST_CASE("A triangle refuses corners that are not finite and radii not above zero", "[3.5]") {
  const Vec3 a(1.0, 2.0, 3.0);
  const Vec3 b(-1.0, -2.0, 2.0);
  const char* const function = "3.5 triangle_gap";
  tests::expect_radii_checked(function, [&](double r, const Cylinder& c) {
    return triangle_gap(a, b, Vec3::Zero(), r, c).gap;
  });
  tests::expect_position_checked(function, "a", [&](const Vec3& bad) {
    return triangle_gap(bad, a, b, 0.5, Cylinder{1.0}).gap;
  });
  tests::expect_position_checked(function, "b", [&](const Vec3& bad) {
    return triangle_gap(a, bad, b, 0.5, Cylinder{1.0}).gap;
  });
  tests::expect_position_checked(function, "c", [&](const Vec3& bad) {
    return triangle_gap(a, b, bad, 0.5, Cylinder{1.0}).gap;
  });
}

#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::around_axis;
using tests::Edge;
using tests::eps;
using tests::expect_edge;

namespace {

Edge random_edge(tests::Random& random) {
  return {{random.vector(2.0), random.vector(2.0)},
          random.uniform(0.05, 0.5),
          tests::random_cylinder(random)};
}

/// Across the axis, both ends `distance` from it: the middle is nearest.
Edge chord(tests::Random& random, double length, double distance) {
  const double middle = std::sqrt(distance * distance - 0.25 * length * length);
  const double angle = tests::random_angle(random);
  const double x = random.uniform(-2.0, 2.0);
  return {{tests::rolled(Vec3(x, middle, -0.5 * length), angle),
           tests::rolled(Vec3(x, middle, 0.5 * length), angle)}};
}

tests::Trial edge_trial(const Edge& e, int index = 1, int count = 1) {
  return tests::shape_trial("3.5 edge_gap", e, index, count);
}

double gap_of(const Edge& e) { return edge_gap(e.p[0], e.p[1], e.particle_radius, e.cylinder).gap; }

}  // namespace

TEST_CASE("An edge three above the axis is nearest a fifth of its way along", "[3.5]") {
  const Edge e{{Vec3(0.0, 3.0, -1.0), Vec3(5.0, 3.0, 4.0)}, 0.5, {1.0}};
  expect_edge(e);
  const EdgeGap got = edge_gap(e.p[0], e.p[1], e.particle_radius, e.cylinder);
  edge_trial(e).of("the gap").expect(got.gap, 1.5, tests::on_shape(e.size()));
  edge_trial(e)
      .of("the fraction")
      .expect(got.fraction, 0.2, {16.0 * eps, "a few roundings"},
              {{0.8, "the fraction is counted from b: count it from a"},
               {1.0, "it is a length: divide it by the length of the edge"}});
}

TEST_CASE("An edge that points away from the axis is nearest at its end", "[3.5]") {
  const Vec3 near(0.0, 3.0, 1.0);
  const Vec3 far(2.0, 3.5, 5.0);
  expect_edge({{near, far}, 0.5, {1.0}});
  expect_edge({{far, near}, 0.5, {1.0}});
}

TEST_CASE("Gaps of edges agree with a hundred digits", "[3.5]") {
  tests::Random random(351);
  for (int i = 1; i <= 200; ++i) expect_edge(random_edge(random), i, 200);
}

TEST_CASE("An edge without length in the yz-plane is like a particle", "[3.5]") {
  tests::Random random(352);
  for (int i = 1; i <= 20; ++i) {
    Edge e = random_edge(random);
    e.p[1] = e.p[0];
    if (i % 2 == 0) e.p[1].x() += random.uniform(-3.0, 3.0);
    expect_edge(e, i, 20);
  }
  expect_edge({{Vec3(-1.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0)}, 0.5, {1.0}});
}

TEST_CASE("The gap keeps its digits for long and short and far and near edges", "[3.5]") {
  tests::Random random(353);
  int index = 0;
  for (const double size : {1e-300, 1e-200, 1e-20, 1.0, 1e20, 1e200, 1e300}) {
    for (const double length : {1e-300, 1e-200, 1e-20, 1e-6, 1.0, 1e6, 1e20, 1e200}) {
      Edge e = random_edge(random);
      e.p[0] *= 0.25 * size;
      e.p[1] = e.p[0] + length * random.vector();
      e.particle_radius *= size;
      e.cylinder.radius *= size;
      expect_edge(e, ++index, 56);
    }
  }
}

TEST_CASE("An edge across the axis has a gap of minus both radii", "[3.5]") {
  tests::Random random(354);
  for (int i = 1; i <= 20; ++i) {
    Edge e = random_edge(random);
    e.p[1] = -0.5 * e.p[0];  // exactly, as is twice the half
    e.p[1].x() = random.uniform(-2.0, 2.0);
    expect_edge(e, i, 20);
    edge_trial(e, i, 20).of("the gap").expect(gap_of(e), -e.radii(), tests::on_shape(e.size()));
  }
}

TEST_CASE("An edge has the same gap with its ends swapped", "[3.5]") {
  tests::Random random(355);
  for (int i = 1; i <= 50; ++i) {
    const Edge e = random_edge(random);
    const Edge turned{{e.p[1], e.p[0]}, e.particle_radius, e.cylinder};
    edge_trial(turned, i, 50)
        .of("the gap")
        .expect(gap_of(turned), gap_of(e), tests::on_shape(2.0 * e.size()));
    expect_edge(turned, i, 50);
  }
}

TEST_CASE("An edge whose ends touch sinks by a closed form of its length", "[3.5]") {
  tests::Random random(356);
  int index = 0;
  for (const double share : {1e-3, 0.1, 0.5, 1.0, 1.5, 1.9}) {  // h/ρ
    const Cylinder cylinder = tests::random_cylinder(random);
    const double r = random.uniform(0.05, 0.5);
    const double rho = cylinder.radius + r;
    const double h = share * rho;
    Edge e = chord(random, h, rho);
    e.particle_radius = r;
    e.cylinder = cylinder;
    const double sunk = rho - std::sqrt(rho * rho - 0.25 * h * h);
    edge_trial(e, ++index, 6)
        .of("the gap")
        .expect(gap_of(e), -sunk, tests::on_shape(4.0 * e.size()),
                [&] { return tests::suspects_of_edge(e); });
    expect_edge(e, index, 6);
  }
}

TEST_CASE("An edge whose ends are held at the root of both squares touches", "[3.5]") {
  tests::Random random(357);
  int index = 0;
  for (const double share : {1e-3, 0.1, 1.0, 2.0, 3.0, 30.0}) {  // h/ρ
    const Cylinder cylinder = tests::random_cylinder(random);
    const double r = random.uniform(0.05, 0.5);
    const double rho = cylinder.radius + r;
    Edge e = chord(random, share * rho, std::hypot(rho, 0.5 * share * rho));
    e.particle_radius = r;
    e.cylinder = cylinder;
    // The middle is a root of what is left of two squares: h²/ρ² tells what rounding gains.
    const double size = 4.0 * e.size() * (1.0 + share * share);
    edge_trial(e, ++index, 6).of("the gap").expect(gap_of(e), 0.0, tests::on_shape(size), [&] {
      return tests::suspects_of_edge(e);
    });
    expect_edge(e, index, 6);
  }
}

TEST_CASE("An edge refuses ends that are not finite and radii not above zero", "[3.5]") {
  const Vec3 a(1.0, 2.0, 3.0);
  const char* const function = "3.5 edge_gap";
  tests::expect_radii_checked(
      function, [&](double r, const Cylinder& c) { return edge_gap(a, Vec3::Zero(), r, c).gap; });
  tests::expect_position_checked(
      function, "a", [&](const Vec3& bad) { return edge_gap(bad, a, 0.5, Cylinder{1.0}).gap; });
  tests::expect_position_checked(
      function, "b", [&](const Vec3& bad) { return edge_gap(a, bad, 0.5, Cylinder{1.0}).gap; });
}

#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "judgement.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::eps;
using tests::few_ulp;
using tests::Meeting;
using tests::Trial;
namespace story = tests::story;

namespace {

double gap_of(const Meeting& m) { return gap(m.position, m.particle_radius, m.cylinder); }

std::string why_up() {
  return tests::why_zero([] {
    const Vec3 gradient = gap_gradient(Vec3(0.0, 3e-100, 4e-100));
    return tests::difference(gradient, Vec3(0.0, 0.6, 0.8)) > 1e-12;
  });
}

std::vector<tests::Suspect<Vec3>> suspects_of_gradient(const Vec3& p) {
  const Vec3 right = tests::exact_gradient(p);
  return {
      {Vec3(-right), "it points to the axis: change its sign, because the gap grows outwards"},
      {Vec3(p / tests::length(p)), story::keeps_x},
      {Vec3(0.0, p.y(), p.z()), "it is not divided by the distance: this gradient has length 1"},
      {Vec3(0.0, right.z(), right.y()), "y and z are swapped: exchange them"},
      {Vec3(Vec3::UnitY()), why_up()}};
}

/// From 1e-300 to 1e300, and each decade in between that ends in a nought.
double scale_of(int index) { return std::pow(10.0, 10.0 * (index - 31)); }
constexpr int scales = 61;

/// A right angle's two sides and its hypotenuse in lengths of that size.
Meeting of_size(double size) {
  Meeting m;
  m.position = Vec3(0.75 * size, -3.0 * size, 4.0 * size);
  m.particle_radius = 0.5 * size;
  m.cylinder.radius = size;
  return m;
}

}  // namespace

TEST_CASE("A particle three across and four up is five from the axis", "[3.1]") {
  const Meeting m{Vec3(7.0, 3.0, 4.0), 0.5, {2.0}, 0.0};
  tests::trial_of("3.1 gap", m).expect(gap_of(m), 2.5, few_ulp(7.5), [&] {
    return tests::suspects_of_gap(m);
  });
}

TEST_CASE("The gap agrees with a hundred digits outside and inside", "[3.1]") {
  tests::Random random(311);
  for (int i = 1; i <= 200; ++i) {
    const Meeting m = tests::random_meeting(random, random.uniform(0.0, 3.0));
    tests::trial_of("3.1 gap", m, i, 200).expect(gap_of(m), m.gap(), few_ulp(m.size()), [&] {
      return tests::suspects_of_gap(m);
    });
  }
}

TEST_CASE("No length is too great or too small for the gap", "[3.1]") {
  for (int i = 1; i <= scales; ++i) {
    const Meeting m = of_size(scale_of(i));
    tests::trial_of("3.1 gap", m, i, scales).expect(gap_of(m), m.gap(), few_ulp(m.size()), [&] {
      return tests::suspects_of_gap(m);
    });
  }
}

TEST_CASE("On the axis the gap is minus both radii", "[3.1]") {
  const Meeting m{Vec3(3.0, 0.0, -0.0), 0.25, {1.5}, 0.0};
  tests::trial_of("3.1 gap", m)
      .expect(gap_of(m), -1.75, few_ulp(1.75),
              {{-1.5, story::no_r}, {0.0, story::no_radii}, {1.25, story::keeps_x}});
}

TEST_CASE("Three across and four up the gap grows along three fifths and four fifths", "[3.1]") {
  const Vec3 p(7.0, 3.0, 4.0);
  Trial("3.1 gap_gradient")
      .given("position", p)
      .expect(gap_gradient(p), Vec3(0.0, 0.6, 0.8), few_ulp(1.0), suspects_of_gradient(p));
}

TEST_CASE("The gradient agrees with a hundred digits at every size", "[3.1]") {
  tests::Random random(312);
  for (int i = 1; i <= scales; ++i) {
    const double size = scale_of(i);
    const Vec3 p(size * random.uniform(0.5, 2.0), size * random.uniform(0.5, 1.0),
                 size * random.uniform(-1.0, -0.5));
    Trial("3.1 gap_gradient", i, scales)
        .given("position", p)
        .expect(gap_gradient(p), tests::exact_gradient(p), few_ulp(1.0), suspects_of_gradient(p));
  }
}

TEST_CASE("A step along the gradient adds its length to the gap", "[3.1]") {
  tests::Random random(313);
  for (int i = 1; i <= 50; ++i) {
    const Meeting m = tests::random_meeting(random, random.uniform(0.2, 3.0));
    Meeting moved = m;
    const double way = random.uniform(0.1, 1.0);
    moved.position += way * tests::exact_gradient(m.position);
    tests::trial_of("3.1 gap", moved, i, 50)
        .expect(gap_of(moved) - gap_of(m), way,
                {16.0 * eps * (moved.size() + m.size()), "two gaps and the step between them"});
    const Vec3 gradient = gap_gradient(m.position);
    tests::trial_of("3.1 gap_gradient", m, i, 50)
        .expect(gradient, tests::exact_gradient(m.position), few_ulp(1.0),
                suspects_of_gradient(m.position));
  }
}

TEST_CASE("On the axis the gradient points up as the contract says", "[3.1]") {
  for (const double x : {0.0, 2.0, -1e200}) {
    const Vec3 p(x, 0.0, x > 0.0 ? -0.0 : 0.0);
    Trial("3.1 gap_gradient")
        .given("position", p)
        .expect(gap_gradient(p), Vec3(Vec3::UnitY()), {0.0, "the contract fixes this vector"},
                {{Vec3(Vec3::Zero()), "it is zero on the axis: return +y there"},
                 {Vec3(Vec3::UnitZ()), "it is +z on the axis: return +y there"}});
  }
}

TEST_CASE("The gap refuses positions that are not finite and radii not above zero", "[3.1]") {
  const Vec3 p(1.0, 2.0, 3.0);
  tests::expect_radii_checked("3.1 gap", [&](double r, const Cylinder& c) { return gap(p, r, c); });
  tests::expect_position_checked("3.1 gap", "position",
                                 [](const Vec3& bad) { return gap(bad, 0.5, Cylinder{1.0}); });
  tests::expect_position_checked("3.1 gap_gradient", "position",
                                 [](const Vec3& bad) { return gap_gradient(bad); });
}

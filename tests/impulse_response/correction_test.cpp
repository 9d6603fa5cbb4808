#include "catch.hpp"
#include "likely.hpp"
#include "particle_cases.hpp"

using namespace lab::impulse_response;
using tests::CorrectionCase;
using tests::eps;

namespace {

void expect_out(double gap, const Vec3& normal, int index = 1, int count = 1) {
  tests::trial_of("6.3 normal_correction", index, count)
      .given("gap", gap)
      .given("normal", normal)
      .expect(normal_correction(gap, normal), tests::exact_depth({gap, normal}),
              {2.0 * eps * std::abs(gap), "one product"});
}

void expect_back(const CorrectionCase& c, const tests::Bound& bound, int index = 1, int count = 1) {
  tests::trial_of("6.3 tangential_correction", index, count)
      .given("displacement", c.displacement)
      .given("normal", c.normal)
      .given("normal_length", c.normal_length)
      .given("friction", c.friction)
      .expect(tangential_correction(c.displacement, c.normal, c.normal_length, c.friction),
              tests::exact_correction(c), bound);
}

}  // namespace

TEST_CASE("A particle inside is moved out by its depth", "[6.3]") {
  expect_out(-0.25, Vec3::UnitZ(), 1, 2);
  expect_out(-2.0, Vec3(0.0, 0.6, -0.8), 2, 2);
}

TEST_CASE("A particle outside or on the surface stays", "[6.3]") {
  int index = 0;
  for (const double gap : {0.5, 0.0, 1e-9, 1e-12, 1e-15, 1e-100}) {
    expect_out(gap, Vec3::UnitX(), ++index, 6);
  }
}

TEST_CASE("A particle that is hardly inside is moved out", "[6.3]") {
  int index = 0;
  for (const double depth : {1e-3, 1e-9, 1e-12, 1e-15, 1e-100}) {
    expect_out(-depth, Vec3::UnitX(), ++index, 5);
  }
}

TEST_CASE("The normal correction is minus phi n at any depth", "[6.3]") {
  tests::Random random(641);
  for (int i = 1; i <= 40; ++i) {
    const double depth = std::pow(10.0, random.uniform(-15.0, 3.0));
    expect_out(i % 2 == 0 ? -depth : depth, random.direction(), i, 40);
  }
}

TEST_CASE("Sliding is undone up to mu times the depth", "[6.3]") {
  // d_t = (3, 4, 0), of length 5: the cone allows 0.5 · 4 = 2, and 0.5 · 40 = 20.
  expect_back({Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 4.0, 0.5}, {16.0 * eps, "a root, a division"},
              1, 2);
  expect_back({Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 40.0, 0.5}, {40.0 * eps, "a root, a division"},
              2, 2);
}

TEST_CASE("The tangential correction is the friction rule on positions", "[6.3]") {
  tests::Random random(642);
  for (int i = 1; i <= 100; ++i) {
    CorrectionCase c{random.vector(0.3), random.direction(), 0.0, random.uniform(0.2, 0.9)};
    const double share = i % 2 == 0 ? random.uniform(0.05, 0.95) : random.uniform(1.05, 4.0);
    c.normal_length = share * static_cast<double>(tests::slip(c).norm()) / c.friction;
    expect_back(c,
                {32.0 * eps * c.displacement.norm(),
                 "d_t errs by 3 eps |d|, and its direction by as much over |d_t|"},
                i, 100);
  }
}

TEST_CASE("Without slip or depth or friction nothing slides back", "[6.3]") {
  const tests::Bound none{0.0, "one factor is zero"};
  expect_back({Vec3(0.0, 0.0, -3.0), Vec3::UnitZ(), 9.0, 0.5}, none, 1, 4);
  expect_back({Vec3::Zero(), Vec3::UnitZ(), 9.0, 0.5}, none, 2, 4);
  expect_back({Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 0.0, 0.5}, none, 3, 4);
  expect_back({Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 9.0, 0.0}, none, 4, 4);
}

TEST_CASE("A very small depth or friction still moves it back by mu d_n", "[6.3]") {
  int index = 0;
  for (const double small : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    const tests::Bound bound{8.0 * eps * small, "a root, a division and products"};
    const Vec3 d(3.0, 4.0, -1.0);
    expect_back({d, Vec3::UnitZ(), small, 0.5}, bound, ++index, 10);
    expect_back({d, Vec3::UnitZ(), 0.5, small}, bound, ++index, 10);
  }
}

TEST_CASE("Just inside the disc all slip is undone and just outside the rest remains", "[6.3]") {
  int index = 0;
  for (const double share : {1.0 - 1e-9, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.0 + 1e-9}) {
    expect_back({Vec3(3.0, 4.0, -1.0), Vec3::UnitZ(), 10.0 * share, 0.5},
                {8.0 * eps * 5.0, "a root and a division"}, ++index, 5);
  }
}

TEST_CASE("Straight in nothing slides back at any friction", "[6.3]") {
  int index = 0;
  for (const double mu : {0.0, 0.5}) {
    for (const double depth : {0.0, 3.0}) {
      for (const double way : {0.0, -2.0}) {
        expect_back({Vec3(0.0, 0.0, way), Vec3::UnitZ(), depth, mu},
                    {0.0, "d_t is zero, and has no direction"}, ++index, 8);
      }
    }
  }
}

#include "catch.hpp"
#include "oracle.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

void expect_out(double gap, const Vec3& normal, int index = 1, int count = 1) {
  const Vec3 wanted = gap < 0.0 ? Vec3(-gap * normal) : Vec3(Vec3::Zero());
  Trial("6.3 normal_correction", index, count)
      .given("gap", gap)
      .given("normal", normal)
      .expect(normal_correction(gap, normal), wanted, {2.0 * eps * std::abs(gap), "one product"},
              {{Vec3(std::min(gap, 0.0) * normal), "the particle is pushed inwards: +phi n"},
               {Vec3(-gap * normal), "a particle outside is pulled to the surface"}});
}

struct CorrectionCase {
  Vec3 displacement;
  Vec3 normal;
  double normal_length;
  double friction;
};

VecL slip(const CorrectionCase& c) {
  return tests::tangential(wide(c.displacement), wide(c.normal));
}

Vec3 exact_correction(const CorrectionCase& c) {
  return tests::narrow(tests::braked(slip(c), wide(c.friction) * wide(c.normal_length)));
}

std::vector<tests::Suspect<Vec3>> correction_suspects(const CorrectionCase& c) {
  const VecL d_t = slip(c);
  const VecL unit = d_t.norm() == 0 ? VecL(VecL::Zero()) : VecL(d_t.normalized());
  const tests::Real cone = wide(c.friction) * wide(c.normal_length);
  return {{-exact_correction(c), "the correction is along the slip: it slides on"},
          {tests::narrow(-d_t), "all of the motion is undone: it may not be more than mu d_n"},
          {tests::narrow(-cone * unit), "it is always mu d_n: never more than the slip itself"},
          {tests::narrow(tests::braked(d_t, wide(c.normal_length))), "mu is missing"},
          {tests::narrow(tests::braked(wide(c.displacement), cone)),
           "the whole displacement is undone, not its tangential part"},
          {Vec3::Zero(), "there is no tangential correction"}};
}

void expect_back(const CorrectionCase& c, const tests::Bound& bound, int index = 1, int count = 1) {
  Trial("6.3 tangential_correction", index, count)
      .given("displacement", c.displacement)
      .given("normal", c.normal)
      .given("normal_length", c.normal_length)
      .given("friction", c.friction)
      .expect(tangential_correction(c.displacement, c.normal, c.normal_length, c.friction),
              exact_correction(c), bound, correction_suspects(c));
}

}  // namespace

TEST_CASE("A particle inside is moved out by its depth", "[6.3]") {
  expect_out(-0.25, Vec3::UnitZ(), 1, 2);
  expect_out(-2.0, Vec3(0.0, 0.6, -0.8), 2, 2);
}

TEST_CASE("A particle outside or on the surface stays", "[6.3]") {
  expect_out(0.5, Vec3::UnitZ(), 1, 3);
  expect_out(0.0, Vec3::UnitZ(), 2, 3);
  expect_out(1e-12, Vec3::UnitX(), 3, 3);
}

TEST_CASE("The normal correction is minus phi n however deep it is", "[6.3]") {
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
    c.normal_length = share * static_cast<double>(slip(c).norm()) / c.friction;
    expect_back(c,
                {32.0 * eps * c.displacement.norm(),
                 "d_t errs by 3 eps |d|, and its direction by as much over |d_t|"},
                i, 100);
  }
}

TEST_CASE("Without slip or depth or roughness nothing slides back", "[6.3]") {
  const tests::Bound none{0.0, "one factor is zero"};
  expect_back({Vec3(0.0, 0.0, -3.0), Vec3::UnitZ(), 9.0, 0.5}, none, 1, 4);
  expect_back({Vec3::Zero(), Vec3::UnitZ(), 9.0, 0.5}, none, 2, 4);
  expect_back({Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 0.0, 0.5}, none, 3, 4);
  expect_back({Vec3(1.0, 2.0, -3.0), Vec3::UnitZ(), 9.0, 0.0}, none, 4, 4);
}

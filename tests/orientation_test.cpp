#include "common/exact/orientation.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include "catch.hpp"
#include "random.hpp"

using namespace common;
using Rational = boost::multiprecision::cpp_rational;

namespace {

int sign_of(const Rational& value) { return value.sign(); }

int exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto x = [&](const Vec3& p, Eigen::Index i) { return Rational(p[i]) - Rational(a[i]); };
  return sign_of((x(b, 1) * x(c, 2) - x(b, 2) * x(c, 1)) * x(d, 0) +
                 (x(b, 2) * x(c, 0) - x(b, 0) * x(c, 2)) * x(d, 1) +
                 (x(b, 0) * x(c, 1) - x(b, 1) * x(c, 0)) * x(d, 2));
}

int exact(const Vec2& a, const Vec2& b, const Vec2& c) {
  const auto x = [&](const Vec2& p, Eigen::Index i) { return Rational(p[i]) - Rational(a[i]); };
  return sign_of(x(b, 0) * x(c, 1) - x(b, 1) * x(c, 0));
}

Vec2 flat(const Vec3& p) { return {p.x(), p.y()}; }

}  // namespace

TEST_CASE("Above is where the corners turn to the left", "[orientation]") {
  CHECK(orientation(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()) == 1);
  CHECK(orientation(Vec3::Zero(), Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()) == -1);
  CHECK(orientation(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3(3, 4, 0)) == 0);
  CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(5, 1)) == 1);
  CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(5, -1)) == -1);
  CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(5, 0)) == 0);
}

TEST_CASE("Orientations of points near a plane are those of rational arithmetic", "[orientation]") {
  tests::Random random(1);
  int near = 0;
  for (int i = 0; i < 3000; ++i) {
    const double size = std::pow(10.0, random.uniform(-60.0, 60.0));
    const Vec3 offset = i % 3 == 0 ? Vec3(size * 1e6 * random.vector()) : Vec3(Vec3::Zero());
    const Vec3 a = size * random.vector() + offset;
    const Vec3 b = size * random.vector() + offset;
    const Vec3 c = size * random.vector() + offset;
    const Vec3 d = a + random.uniform(-1.0, 1.0) * (b - a) + random.uniform(-1.0, 1.0) * (c - a);
    CHECK(orientation(a, b, c, d) == exact(a, b, c, d));
    const Vec2 e = flat(a) + random.uniform(-1.0, 1.0) * (flat(b) - flat(a));
    CHECK(orientation(flat(a), flat(b), e) == exact(flat(a), flat(b), e));
    near += exact(a, b, c, d) == 0 ? 0 : 1;
  }
  CHECK(near > 1000);
}

TEST_CASE("Orientations on a small grid are those of rational arithmetic", "[orientation]") {
  tests::Random random(2);
  for (int i = 0; i < 3000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& v : p) {
      for (double& x : v) x = 0.1 * std::floor(random.uniform(0.0, 4.0));
    }
    CHECK(orientation(p[0], p[1], p[2], p[3]) == exact(p[0], p[1], p[2], p[3]));
    CHECK(orientation(flat(p[0]), flat(p[1]), flat(p[2])) ==
          exact(flat(p[0]), flat(p[1]), flat(p[2])));
  }
}

TEST_CASE("Orientations hold at the ends of the range of doubles", "[orientation]") {
  tests::Random random(3);
  for (const double size : {1e-308, 1e-200, 1e-105, 1e150, 1e307}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 a = size * random.vector();
      const Vec3 b = size * random.vector();
      const Vec3 c = size * random.vector();
      const Vec3 d = i % 2 == 0 ? Vec3(0.5 * a + 0.5 * b) : Vec3(size * random.vector());
      CHECK(orientation(a, b, c, d) == exact(a, b, c, d));
      CHECK(orientation(flat(a), flat(b), flat(d)) == exact(flat(a), flat(b), flat(d)));
    }
  }
}

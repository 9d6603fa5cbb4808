#include "common/contact/obstacle.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <utility>

#include "catch.hpp"
#include "random.hpp"
#include "values.hpp"

using common::Cylinder;
using common::Flight;
using common::Obstacle;
using common::Plane;
using common::time_of_impact;
using common::Vec3;
using tests::eps;

namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Coefficients = std::array<Real, 5>;  // of 1, t, …, t⁴

using Wide = std::array<Real, 3>;
Wide wide(const Vec3& v) { return {Real(v.x()), Real(v.y()), Real(v.z())}; }
Real dot(const Wide& u, const Wide& v, std::size_t first) {
  Real sum = 0;
  for (std::size_t i = first; i < 3; ++i) sum += u[i] * v[i];
  return sum;
}

/// What has the sign of the gap, in 100 digits.
Coefficients gap_of(const Obstacle& obstacle, const Flight& flight) {
  Wide x = wide(flight.position);
  const Wide v = wide(flight.velocity);
  const Wide a = wide(flight.acceleration);
  if (const auto* plane = std::get_if<Plane>(&obstacle)) {
    const Wide n = wide(plane->normal);
    for (std::size_t i = 0; i < 3; ++i) x[i] -= Real(plane->point[static_cast<int>(i)]);
    return {dot(n, x, 0), dot(n, v, 0), dot(n, a, 0) / 2, 0, 0};
  }
  const Real R(std::get<Cylinder>(obstacle).radius);
  return {dot(x, x, 1) - R * R, 2 * dot(x, v, 1), dot(v, v, 1) + dot(x, a, 1), dot(v, a, 1),
          dot(a, a, 1) / 4};
}

Coefficients derivative(const Coefficients& c) {
  return {c[1], 2 * c[2], 3 * c[3], 4 * c[4], Real(0)};
}

/// The polynomial lies within its Bernstein coefficients on [low, low + width]: (least, largest).
std::pair<Real, Real> range(Coefficients c, const Real& low, const Real& width) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 3; k + 1 > i; --k) c[k] += low * c[k + 1];
  }
  Real power = 1;
  for (Real& entry : c) {
    entry *= power;
    power *= width;
  }
  constexpr int choose[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  std::pair<Real, Real> bounds(c[0], c[0]);
  for (std::size_t i = 1; i < 5; ++i) {
    Real b = 0;
    for (std::size_t k = 0; k <= i; ++k) b += c[k] * choose[i][k] / choose[4][k];
    if (b < bounds.first) bounds.first = b;
    if (b > bounds.second) bounds.second = b;
  }
  return bounds;
}

/// The first t of [low, low + width] where the gap may be zero or below while it falls, by halving
/// all that cannot be ruled out.
std::optional<Real> first_entry(const Coefficients& gap, const Coefficients& rate, const Real& low,
                                const Real& width, int depth = 0) {
  if (range(gap, low, width).first > 0 || range(rate, low, width).first > 0) return std::nullopt;
  if (depth == 110) return low;
  const Real half = width / 2;
  if (auto t = first_entry(gap, rate, low, half, depth + 1)) return t;
  return first_entry(gap, rate, low + half, half, depth + 1);
}

std::string text(const Obstacle& obstacle, const Flight& flight) {
  return (std::holds_alternative<Plane>(obstacle) ? "plane " : "cylinder ") +
         tests::text(flight.position) + tests::text(flight.velocity) +
         tests::text(flight.acceleration);
}

/// Requires hit or miss as in 100 digits, and the time to an ulp; says whether it is a hit.
bool check(const Obstacle& obstacle, const Flight& flight, double dt) {
  const Coefficients gap = gap_of(obstacle, flight);
  const std::optional<Real> wanted = first_entry(gap, derivative(gap), Real(0), Real(dt));
  const std::optional<double> got = time_of_impact(obstacle, flight, dt);
  INFO(text(obstacle, flight));
  REQUIRE(got.has_value() == wanted.has_value());
  if (!wanted) return false;
  const Real error = *got - *wanted;
  CHECK(std::abs(static_cast<double>(error)) <= eps * static_cast<double>(*wanted) + 1e-24 * dt);
  return true;
}

Flight random_flight(tests::Random& random) {
  const Vec3 position = random.vector(3.0);
  const Vec3 velocity = random.vector(3.0);
  return {position, velocity, random.vector(6.0)};
}

/// A flight that at `time` passes the surface of the unit cylinder along it, `lift` above.
Flight grazing_flight(tests::Random& random, double time, double lift) {
  Flight there = random_flight(random);
  const Vec3 n = Vec3(0.0, there.position.y(), there.position.z()).normalized();
  there.velocity -= n.dot(there.velocity) * n;
  there.position = (1.0 + lift) * n;
  return {position_at(there, -time), velocity_at(there, -time), there.acceleration};
}

}  // namespace

TEST_CASE("The gap and its gradient agree with differences") {
  tests::Random random(611);
  for (int i = 0; i < 50; ++i) {
    const Vec3 n = random.direction();
    const Obstacle obstacle = i % 2 == 0 ? Obstacle(Plane{random.vector(), n}) : Cylinder{0.7};
    const Vec3 x = random.vector(2.0);
    const Vec3 u = random.direction();
    const double slope =
        (gap(obstacle, x + 1e-6 * u) - gap(obstacle, x - 1e-6 * u)) / 2e-6;  // to 1e-9
    CHECK(std::abs(slope - u.dot(outward_normal(obstacle, x))) < 1e-8);
    CHECK(std::abs(outward_normal(obstacle, x).norm() - 1.0) < 4.0 * eps);
  }
  CHECK(gap(Cylinder{2.0}, {7.0, 3.0, 4.0}) == 3.0);
  CHECK(gap(Plane{{0.0, 0.0, 1.0}, Vec3::UnitZ()}, {7.0, 3.0, 4.0}) == 3.0);
  CHECK(outward_normal(Cylinder{2.0}, {5.0, 0.0, 0.0}) == Vec3::UnitY());
  CHECK(outward_normal(Cylinder{2.0}, {5.0, 3e-200, 4e-200}) == Vec3(0.0, 0.6, 0.8));
}

TEST_CASE("Times of impact are those of 100 digits") {
  tests::Random random(612);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Obstacle obstacle =
        i % 2 == 0 ? Obstacle(Plane{random.vector(), random.direction()}) : Cylinder{1.0};
    hits += check(obstacle, random_flight(random), 1.5) ? 1 : 0;
  }
  CHECK(hits > 80);
  CHECK(hits < 320);
}

TEST_CASE("A flight that grazes the cylinder is decided rightly") {
  tests::Random random(613);
  int hits = 0;
  int misses = 0;
  for (const double lift : {1e-6, 1e-10, 1e-14, 0.0, -1e-14, -1e-10, -1e-6}) {
    for (int i = 0; i < 20; ++i) {
      const Flight flight = grazing_flight(random, random.uniform(0.2, 0.8), lift);
      (check(Cylinder{1.0}, flight, 1.0) ? hits : misses) += 1;
    }
  }
  CHECK(hits > 30);
  CHECK(misses > 10);
}

TEST_CASE("What starts on the surface and parts comes back in twice v over g") {
  const Obstacle ground = Plane{};
  for (const double speed : {1e-12, 0.1, 0.7, 3.0}) {
    for (const double g : {9.81, 10.0, 1.62}) {
      const Flight flight{{1.0, 2.0, 0.0}, {0.3, 0.0, speed}, {0.0, 0.0, -g}};
      REQUIRE(time_of_impact(ground, flight, 10.0).has_value());
      CHECK(*time_of_impact(ground, flight, 10.0) == 2.0 * speed / g);
      CHECK_FALSE(time_of_impact(ground, flight, 1.99 * speed / g).has_value());
    }
  }
}

TEST_CASE("Contact at the start counts where the flight goes inwards") {
  const Vec3 up = Vec3::UnitZ();
  const Vec3 none = Vec3::Zero();
  for (const Obstacle& obstacle : {Obstacle(Plane{}), Obstacle(Cylinder{2.0})}) {
    const Vec3 touching = std::holds_alternative<Plane>(obstacle) ? none : Vec3(2.0 * up);
    for (const double depth : {0.0, 0.5}) {
      const Vec3 x = touching - depth * up;
      CHECK(time_of_impact(obstacle, {x, -up, none}, 1.0) == 0.0);
      CHECK(time_of_impact(obstacle, {x, none, -up}, 1.0) == 0.0);
      CHECK(time_of_impact(obstacle, {x, -up, 9.0 * up}, 0.0) == 0.0);
      CHECK_FALSE(time_of_impact(obstacle, {x, up, none}, 1.0).has_value());
      CHECK_FALSE(time_of_impact(obstacle, {x, none, up}, 1.0).has_value());
      CHECK_FALSE(time_of_impact(obstacle, {x, none, none}, 1.0).has_value());
    }
    CHECK(time_of_impact(obstacle, {touching - 0.5 * up, 0.25 * up, -up}, 1.0) == 0.25);
    CHECK(time_of_impact(obstacle, {touching + up, -up, none}, 1.0) == 1.0);
    CHECK_FALSE(time_of_impact(obstacle, {touching + up, -up, none}, 0.999).has_value());
  }
  // Past the top of the cylinder and past a plane: it touches and is never inside.
  CHECK_FALSE(time_of_impact(Cylinder{1.0}, {{0.0, -2.0, 1.0}, Vec3::UnitY(), none}, 4.0));
  CHECK_FALSE(time_of_impact(Plane{}, {up, -2.0 * up, 2.0 * up}, 4.0).has_value());
}

TEST_CASE("An invalid obstacle is refused") {
  const double nan = std::nan("");
  for (const double radius : {0.0, -1.0, nan, HUGE_VAL}) {
    CHECK_THROWS_AS(common::require_valid(Cylinder{radius}), std::invalid_argument);
  }
  for (const Vec3& normal : {Vec3(0, 0, 0), Vec3(0, 0, 1.001), Vec3(nan, 0, 1)}) {
    CHECK_THROWS_AS(common::require_valid(Plane{Vec3::Zero(), normal}), std::invalid_argument);
  }
  CHECK_THROWS_AS(common::require_valid(Plane{Vec3(nan, 0, 0), Vec3::UnitZ()}),
                  std::invalid_argument);
  CHECK_NOTHROW(common::require_valid(Plane{}));
  CHECK_NOTHROW(common::require_valid(Cylinder{1e-9}));
}

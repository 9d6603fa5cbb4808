#include <boost/multiprecision/cpp_bin_float.hpp>

#include "catch.hpp"
#include "coning.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::product;
using tests::Trial;
using Exact = boost::multiprecision::cpp_bin_float_50;

namespace {

/// eq. (11) with `share` of the angle in the quaternion, in 50 digits.
Quat exact_exponential(const Vec3& a, double share = 0.5) {
  const Exact x = a.x();
  const Exact y = a.y();
  const Exact z = a.z();
  const Exact angle = sqrt(x * x + y * y + z * z);
  if (angle == 0) return Quat::Identity();
  const Exact s = sin(share * angle) / angle;
  return {static_cast<double>(cos(share * angle)), static_cast<double>(s * x),
          static_cast<double>(s * y), static_cast<double>(s * z)};
}

std::vector<tests::Suspect<Quat>> suspects_of_map(const Vec3& a) {
  const Quat linear(1.0, 0.5 * a.x(), 0.5 * a.y(), 0.5 * a.z());
  const Quat exact = exact_exponential(a);
  const Vec3 swapped = a.normalized() * exact.w();
  const Vec3 long_axis = exact.vec() * a.norm();
  return {{exact_exponential(a, 1.0), "the whole angle is in the quaternion: use half the angle"},
          {exact_exponential(-a), "it turns the wrong way: use a, not -a"},
          {{exact.vec().norm(), swapped.x(), swapped.y(), swapped.z()},
           "sine and cosine are swapped: the cosine is the real part"},
          {{exact.w(), long_axis.x(), long_axis.y(), long_axis.z()},
           "the axis is a: divide a by its length"},
          {{exact.x(), exact.y(), exact.z(), exact.w()},
           "the coefficients are in the wrong order: Quat's constructor takes (w, x, y, z)"},
          {{std::abs(exact.w()), exact.x(), exact.y(), exact.z()},
           "the sign of the cosine is lost, as in a root of 1 - sin^2: use std::cos"},
          {linear, "the series is cut after the linear term, as in step 1.5: use sine and cosine"},
          {linear.normalized(),
           "this is the Euler step of 1.5, which turns by 2 atan(theta/2): use sine and cosine"}};
}

Trial map_trial(const Vec3& a, int index = 1, int count = 1) {
  return Trial("1.6 exponential_map", index, count).given("rotation_vector", a);
}

Trial exponential_trial(const Quat& q, const Vec3& omega, double dt, int index = 1, int count = 1) {
  return Trial("1.6 step_exponential", index, count)
      .given("world_from_body", q)
      .given("angular_velocity", omega)
      .given("dt", dt);
}

std::vector<tests::Suspect<Quat>> suspects_of_step(const Quat& q, const Vec3& omega, double dt) {
  const Vec3 a = omega * dt;
  const Quat linear(1.0, 0.5 * a.x(), 0.5 * a.y(), 0.5 * a.z());
  return {
      {product(q, exact_exponential(a)),
       "the turn stands on the right of q, which suits omega in the body frame: put it on the "
       "left"},
      {product(exact_exponential(-a), q), "it turns the wrong way: use omega dt, not -omega dt"},
      {product(exact_exponential(omega), q), "dt is missing: multiply omega by dt"},
      {q,
       "nothing turns: small spins are dropped by a guard that is too wide; test only for exactly "
       "zero"},
      {product(linear.normalized(), q),
       "this is the Euler step of 1.5, which turns by 2 atan(theta/2): use exponential_map"},
      {exact_exponential(a), "q is missing: multiply this step's turn by q"}};
}

}  // namespace

TEST_CASE("A third of a turn about z has the parts one half and the root of three quarters",
          "[1.6]") {
  const Vec3 a(0.0, 0.0, 4.0 * std::acos(0.0) / 3.0);
  map_trial(a).expect(exponential_map(a), Quat(0.5, 0.0, 0.0, std::sqrt(0.75)),
                      {8.0 * eps, "a sine, a cosine and the rounding of the angle"},
                      suspects_of_map(a));
}

TEST_CASE("The exponential map agrees with fifty digits at every angle", "[1.6]") {
  tests::Random random(61);
  for (int i = 1; i <= 200; ++i) {
    const double angle = std::pow(10.0, random.uniform(-3.0, 3.0));
    const Vec3 a = angle * random.direction();
    map_trial(a, i, 200).expect(
        exponential_map(a), exact_exponential(a),
        {(8.0 + angle) * eps, "a few roundings, and half the angle's own rounding"},
        suspects_of_map(a));
  }
}

TEST_CASE("Small angles keep all their digits", "[1.6]") {
  // Below 1e-8 the vector part is a/2 to the last bit, and the real part is 1.
  tests::Random random(62);
  for (int i = 1; i <= 100; ++i) {
    // From 1e-2 down to 1e-300, so that the first failure shows where digits are lost.
    const double angle = std::pow(10.0, 1.0 - 3.0 * i - random.uniform(0.0, 1.0));
    const Vec3 a = angle * random.direction();
    Quat got = exponential_map(a);
    if (got.w() < 0.0) got.coeffs() *= -1.0;  // q and -q are one attitude
    const Quat wanted = exact_exponential(a);
    const Trial trial = map_trial(a, i, 100);
    trial.expect(
        Vec3(got.vec()), Vec3(wanted.vec()),
        {8.0 * eps * 0.5 * angle, "a few roundings, each relative to the small angle itself"},
        {{Vec3(Vec3::Zero()), angle > 1e-150 || angle < 1e-168
                                  ? "small angles are dropped: the guard for zero is too wide, so "
                                    "test only for exactly zero"
                                  : "the length underflows, because norm() squares and 1e-162 "
                                    "squared is 0: use std::hypot"},
         {Vec3(a), "the whole angle is in the quaternion: use half the angle"}});
    trial.expect(got.w(), wanted.w(), {2.0 * eps, "a cosine near 1"});
  }
}

TEST_CASE("Up to 1e300 every turn is a unit quaternion", "[1.6]") {
  // Along an axis the angle is exact, and sine and cosine take every double as it is.
  int index = 0;
  for (const double angle : {1e8, 1e100, 1e155, 1e300}) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = angle * Vec3::Unit(i);
      Quat wanted(std::cos(0.5 * angle), 0.0, 0.0, 0.0);
      wanted.vec()[i] = std::sin(0.5 * angle);
      map_trial(a, ++index, 24).expect(exponential_map(a), wanted, {8.0 * eps, "sine and cosine"});
      const Vec3 skewed = angle * Vec3(0.48, 0.6, 0.64);
      const Quat turn = exponential_map(skewed);
      map_trial(skewed, ++index, 24)
          .expect_small("||q| - 1|", std::abs(turn.norm() - 1.0), {8.0 * eps, "to an ulp"});
      map_trial(skewed, index, 24)
          .expect_small("|axis x a|/|a|", turn.vec().cross(Vec3(0.48, 0.6, 0.64)).norm(),
                        {8.0 * eps, "the axis is a"});
    }
  }
}

TEST_CASE("The map of a zero vector is the identity", "[1.6]") {
  map_trial(Vec3::Zero())
      .expect(exponential_map(Vec3::Zero()), Quat(Quat::Identity()), {0.0, "cos 0 = 1, exactly"});
}

TEST_CASE("A turn and the same turn back cancel and every turn is a unit quaternion", "[1.6]") {
  tests::Random random(63);
  for (int i = 1; i <= 50; ++i) {
    const Vec3 a = random.vector(4.0);
    const Quat there = exponential_map(a);
    const Quat back = exponential_map(-a);
    map_trial(a, i, 50).expect_small("||q| - 1|", std::abs(there.norm() - 1.0),
                                     {8.0 * eps, "sine and cosine to an ulp"});
    map_trial(a, i, 50).expect(product(there, back), Quat(Quat::Identity()),
                               {16.0 * eps, "the same sine and cosine twice"});
    // The identity would pass both.
    map_trial(a, i, 50).expect(there, exact_exponential(a),
                               {(8.0 + a.norm()) * eps, "fifty digits"}, suspects_of_map(a));
  }
}

TEST_CASE("A step turns the world side of the attitude", "[1.6]") {
  tests::Random random(64);
  for (int i = 1; i <= 100; ++i) {
    const Quat q = random.attitude();
    const Vec3 omega = random.vector(5.0);
    const double dt = random.uniform(-0.5, 0.5);
    exponential_trial(q, omega, dt, i, 100)
        .expect(step_exponential(q, omega, dt), product(exact_exponential(omega * dt), q),
                {(16.0 + omega.norm() * std::abs(dt)) * eps, "the map's rounding and one product"},
                suspects_of_step(q, omega, dt));
  }
}

TEST_CASE("A step turns by the spin even if it is very slow", "[1.6]") {
  for (const double speed : {1e-6, 1e-9, 1e-100}) {
    const Vec3 omega(2.0 * speed, -3.0 * speed, 6.0 * speed);
    Quat q = step_exponential(Quat::Identity(), omega, 0.5);
    if (q.w() < 0.0) q.coeffs() *= -1.0;
    exponential_trial(Quat::Identity(), omega, 0.5)
        .of("the vector part")
        .expect(
            Vec3(q.vec()), Vec3(0.25 * omega),
            {8.0 * eps * speed * 1.75 + std::pow(speed, 3) * 8.0,
             "a few roundings relative to the vector; sin t = t up to t^3/6"},
            {{Vec3(Vec3::Zero()),
              "small spins are dropped by a guard that is too wide: test only for exactly zero"}});
  }
}

TEST_CASE("At any size of omega and of dt a step turns by their product", "[1.6]") {
  tests::Random random(66);
  int index = 0;
  for (const double size : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
    const Quat q = random.attitude();
    const Vec3 omega(2.0 * size, 3.0 * size, 6.0 * size);
    const double dt = 0.25 / size;
    exponential_trial(q, omega, dt, ++index, 5)
        .expect(step_exponential(q, omega, dt), product(exact_exponential({0.5, 0.75, 1.5}), q),
                {18.0 * eps, "the map's rounding and one product"}, suspects_of_step(q, omega, dt));
  }
  // The end of the range: 2^996 = 6.7e299, a product of powers of two.
  const Quat q = random.attitude();
  const Vec3 omega(0x1p600, 0.0, 0.0);
  const Quat turn(std::cos(0x1p995), std::sin(0x1p995), 0.0, 0.0);
  exponential_trial(q, omega, 0x1p396, ++index, 5)
      .expect(step_exponential(q, omega, 0x1p396), product(turn, q),
              {16.0 * eps, "sine, cosine and one product"});
}

TEST_CASE("A constant spin is exact at any step size", "[1.6]") {
  tests::Random random(65);
  int index = 0;
  for (const double x : {1e-9, 0.1, 3.0, 10.0, 1000.0}) {
    const Quat start = random.attitude();
    const Vec3 axis = random.direction();
    Quat q = start;
    const int steps = 50;
    for (int i = 0; i < steps; ++i) q = step_exponential(q, axis, x);
    const Exact length =
        sqrt(Exact(axis.x()) * axis.x() + Exact(axis.y()) * axis.y() + Exact(axis.z()) * axis.z());
    const Exact total = steps * x * length;
    const Exact share = sin(total / 2) / length;
    const Quat turn(static_cast<double>(cos(total / 2)), static_cast<double>(share * axis.x()),
                    static_cast<double>(share * axis.y()), static_cast<double>(share * axis.z()));
    exponential_trial(start, axis, x, ++index, 5)
        .expect(
            q, product(turn, start),
            {steps * (16.0 + x) * eps, "50 steps, each with the map's rounding and one product"});
  }
}

TEST_CASE("With omega from the middle of the step it has order two on a coning motion", "[1.6]") {
  const auto step = [](const common::ConingMotion& motion, const Quat& q, double t, double dt) {
    return step_exponential(q, angular_velocity(motion, t + 0.5 * dt), dt);
  };
  tests::expect_order(Trial("1.6 step_exponential"), tests::coning_motion().world_from_body, step,
                      2.0);
}

TEST_CASE("With omega from the start of the step it has only order one", "[1.6]") {
  const auto step = [](const common::ConingMotion& motion, const Quat& q, double t, double dt) {
    return step_exponential(q, angular_velocity(motion, t), dt);
  };
  tests::expect_order(Trial("1.6 step_exponential"), tests::coning_motion().world_from_body, step,
                      1.0);
}

TEST_CASE("If omega is sampled once per turn the midpoint rule sees a constant spin", "[1.6]") {
  // Where omega itself turns by x = rate dt a step, the turn it misses is of order x²: at a whole
  // turn every sample is the same, and the result is a steady spin about a wrong axis.
  const common::ConingMotion motion = tests::coning_motion();
  const double dt = 4.0 * std::acos(0.0) / motion.rate;
  const Quat start = motion.world_from_body;
  Quat q = start;
  for (int i = 0; i < 5; ++i) {
    q = step_exponential(q, angular_velocity(motion, (i + 0.5) * dt), dt);
  }
  const Vec3 sampled = angular_velocity(motion, 0.5 * dt);
  exponential_trial(start, sampled, dt)
      .expect(q, product(exact_exponential(5.0 * dt * sampled), start),
              {200.0 * eps, "five products, and five samples that differ by the rounding of pi"},
              suspects_of_step(start, sampled, 5.0 * dt));
  exponential_trial(start, sampled, dt)
      .expect_small("1 - angle to the true attitude",
                    1.0 - common::angle_between(q, attitude(motion, 5.0 * dt)),
                    {0.0, "the true attitude differs by more than a radian"});
}

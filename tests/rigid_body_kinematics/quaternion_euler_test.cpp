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

namespace {

const std::string half_is_zero = "nothing turns, because 1/2 is 0 in whole numbers: write 0.5";

Quat pure(const Vec3& v) { return {0.0, v.x(), v.y(), v.z()}; }

Quat sum(const Quat& q, double factor, const Quat& rate) {
  return Quat(Eigen::Vector4d(q.coeffs() + factor * rate.coeffs()));
}

std::vector<tests::Suspect<Quat>> suspects_of(const Quat& q, const Vec3& omega, double dt) {
  const Quat left = product(pure(omega), q);
  const Quat right = product(q, pure(omega));
  const double x = omega.norm() * dt;
  return {
      {sum(q, dt, left).normalized(),
       "the factor 1/2 is missing, so it turns twice as far: multiply by 0.5"},
      {sum(q, 0.5 * dt, right).normalized(),
       "omega stands on the right of q, which suits omega in the body frame: put it on the left"},
      {sum(q, 0.5 * dt, left), "the quaternion is not normalised: divide it by its length"},
      {sum(q, 0.5, left).normalized(), "dt is missing: multiply omega by dt"},
      {sum(q, 0.5 * dt, product(pure(omega), sum(q, 0.25 * dt, left))).normalized(),
       "this is the midpoint rule: return the plain Euler step"},
      {q, half_is_zero},
      {sum(q, -0.5 * dt, left).normalized(), "it turns the wrong way: change the sign of omega"},
      {sum(q, 0.5 * dt, pure(omega)).normalized(), "q is missing: multiply omega by q"},
      {sum(q, 0.5 * dt, product({omega.x(), omega.y(), omega.z(), 0.0}, q)).normalized(),
       "the coefficients are in the wrong order: Quat's constructor takes (w, x, y, z)"},
      {sum(q, 0.5 * dt, product({omega.z(), 0.0, omega.x(), omega.y()}, q)).normalized(),
       "the coefficients are in the wrong order: a Vector4d for Quat is (x, y, z, w)"},
      {product(tests::rotation(x, omega.normalized()), q),
       "this is the exact turn of step 1.6: return the Euler step"}};
}

Trial step_trial(const Quat& q, const Vec3& omega, double dt, int index = 1, int count = 1) {
  return Trial("1.5 step_quaternion_euler", index, count)
      .given("world_from_body", q)
      .given("angular_velocity", omega)
      .given("dt", dt);
}

/// Why an attitude stays where the spin is slow: if it does where the spin is not, it is no guard.
std::string why_nothing_turns() {
  const Quat q = step_quaternion_euler(Quat::Identity(), {2.0, 3.0, 6.0}, 0.25);
  return q.vec().isZero()
             ? half_is_zero
             : "small spins are dropped by a guard that is too wide: test only for exactly zero";
}

/// How far a step of x = omega dt about z lags behind x, as a fraction of x.
double lag(double x) {
  const Quat q = step_quaternion_euler(Quat::Identity(), Vec3::UnitZ(), x);
  return 1.0 - common::angle_between(Quat::Identity(), q) / x;
}

}  // namespace

TEST_CASE("At two radians a step Euler turns a quarter turn", "[1.5]") {
  // q = (1, n)/sqrt2: 2 atan(x/2) at x = 2.
  const Vec3 omega(2.0, 3.0, 6.0);  // of length 7
  const double dt = 2.0 / 7.0;
  const Quat q = Quat::Identity();
  const double share = std::sqrt(0.5) / 7.0;
  step_trial(q, omega, dt)
      .expect(step_quaternion_euler(q, omega, dt),
              Quat(std::sqrt(0.5), 2.0 * share, 3.0 * share, 6.0 * share),
              {4.0 * eps, "a root and a division"}, suspects_of(q, omega, dt));
  const Vec3 about_z(0.0, 0.0, 8.0);
  step_trial(q, about_z, 0.25)
      .expect(step_quaternion_euler(q, about_z, 0.25),
              Quat(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)), {4.0 * eps, "a root and a division"},
              suspects_of(q, about_z, 0.25));
}

TEST_CASE("A quaternion step goes along half of omega q and is normalised", "[1.5]") {
  tests::Random random(51);
  for (int i = 1; i <= 100; ++i) {
    const Quat q = random.attitude();
    const Vec3 omega = random.vector(5.0);
    const double dt = random.uniform(-0.3, 0.3);
    const Quat wanted = sum(q, 0.5 * dt, product(pure(omega), q)).normalized();
    step_trial(q, omega, dt, i, 100)
        .expect(
            step_quaternion_euler(q, omega, dt), wanted,
            {16.0 * eps, "some 30 operations; the sum is at least as long as q, so none cancels"},
            suspects_of(q, omega, dt));
  }
}

TEST_CASE("The attitude stays a unit quaternion over many steps", "[1.5]") {
  tests::Random random(52);
  Quat q = random.attitude();
  for (int i = 1; i <= 200; ++i) {
    const Vec3 omega = random.vector(5.0);
    const Quat before = q;
    q = step_quaternion_euler(q, omega, 0.1);
    step_trial(before, omega, 0.1, i, 200)
        .expect_small("||q| - 1| minus that of the step before",
                      std::abs(q.norm() - 1.0) - std::abs(before.norm() - 1.0),
                      {4.0 * eps, "normalised to a few ulp"},
                      "the quaternion is not normalised: divide it by its length");
    if (i == 1) {
      step_trial(before, omega, 0.1)
          .expect_small("0.01 - angle turned", 0.01 - common::angle_between(before, q),
                        {0.0, "a unit quaternion that never turns is not a step"});
    }
  }
}

TEST_CASE("Without a spin or a step the attitude does not change", "[1.5]") {
  tests::Random random(53);
  const Quat q = random.attitude();
  const tests::Bound rounding{4.0 * eps, "only the normalisation rounds"};
  step_trial(q, Vec3::Zero(), 0.1).expect(step_quaternion_euler(q, Vec3::Zero(), 0.1), q, rounding);
  step_trial(q, Vec3::UnitX(), 0.0)
      .expect(step_quaternion_euler(q, Vec3::UnitX(), 0.0), q, rounding);
}

TEST_CASE("The quaternion turns by the spin even if it is very slow", "[1.5]") {
  for (const double speed : {1e-6, 1e-9, 1e-100}) {
    const Vec3 omega(2.0 * speed, -3.0 * speed, 6.0 * speed);
    const Quat q = step_quaternion_euler(Quat::Identity(), omega, 0.5);
    step_trial(Quat::Identity(), omega, 0.5)
        .of("the vector part")
        .expect(Vec3(q.vec()), Vec3(0.25 * omega),
                {8.0 * eps * speed * 1.75 + 0.5 * std::pow(speed, 3) * 8.0,
                 "a few roundings relative to the vector, and the length that (10) divides by"},
                {{Vec3(Vec3::Zero()), why_nothing_turns()}});
  }
}

TEST_CASE("A quaternion step turns by twice the arc tangent of theta over 2", "[1.5]") {
  tests::Random random(54);
  int index = 0;
  for (const double x : {1e-6, 0.1, 0.6, 1.0, 3.0, 10.0, 1e6}) {
    const Vec3 axis = random.direction();
    const Quat q = step_quaternion_euler(Quat::Identity(), axis, x);
    step_trial(Quat::Identity(), axis, x, ++index, 7)
        .expect(common::angle_between(Quat::Identity(), q), 2.0 * std::atan(0.5 * x),
                {16.0 * eps, "a few roundings; the angle is read without cancellation"},
                {{2.0 * std::atan(x),
                  "the factor 1/2 is missing, so it turns twice as far: multiply by 0.5"}});
  }
}

TEST_CASE("Even a very large step turns by at most half a turn", "[1.5]") {
  for (const double x : {4.0, 100.0, 1e8, 0.99e100}) {
    const Quat q = step_quaternion_euler(Quat::Identity(), Vec3::UnitX(), x);
    const Trial trial = step_trial(Quat::Identity(), Vec3::UnitX(), x);
    trial.expect(q, Quat(2.0 / std::hypot(2.0, x), x / std::hypot(2.0, x), 0.0, 0.0),
                 {8.0 * eps, "(2, theta)/sqrt(4 + theta^2): its real part is never below zero"},
                 suspects_of(Quat::Identity(), Vec3::UnitX(), x));
  }
}

TEST_CASE("At any size of omega and of dt a quaternion step turns by their product", "[1.5]") {
  int index = 0;
  for (const double size : {0x1p-900, 0x1p-300, 0x1p300, 0x1p900}) {
    const Vec3 omega(2.0 * size, 3.0 * size, 6.0 * size);
    const double dt = 0.25 / size;
    step_trial(Quat::Identity(), omega, dt, ++index, 4)
        .expect(step_quaternion_euler(Quat::Identity(), omega, dt),
                sum(Quat::Identity(), 0.125, pure({2.0, 3.0, 6.0})).normalized(),
                {8.0 * eps, "omega dt is (1/2, 3/4, 3/2)"},
                {{Quat::Identity(), size < 1.0 ? why_nothing_turns() : half_is_zero},
                 {sum(Quat::Identity(), 0.5, pure(omega)).normalized(),
                  "dt is missing: multiply omega by dt"}});
  }
}

TEST_CASE("The lag passes one per cent at the step size of the formula", "[1.5]") {
  // x − 2 atan(x/2) = x/100, by bisection: x = 0.3496.
  double low = 0.1;
  double high = 1.0;
  while (high - low > 1e-15) {
    const double middle = 0.5 * (low + high);
    (1.0 - 2.0 * std::atan(0.5 * middle) / middle < 0.01 ? low : high) = middle;
    if (middle == low && middle == high) break;
  }
  const Trial trial = Trial("1.5 step_quaternion_euler").given("threshold of omega dt", low);
  trial.expect_small("lag at 0.9 of the threshold", std::abs(lag(0.9 * low)),
                     {0.01, "the closed form"});
  trial.expect_small("0.01 - lag at 1.1 of the threshold", 0.01 - lag(1.1 * low),
                     {0.0, "by the closed form the lag is above one per cent here"});
}

TEST_CASE("Euler on the quaternion converges with order one on a coning motion", "[1.5]") {
  const auto step = [](const common::ConingMotion& motion, const Quat& q, double t, double dt) {
    return step_quaternion_euler(q, angular_velocity(motion, t), dt);
  };
  tests::expect_order(Trial("1.5 step_quaternion_euler"), tests::coning_motion().world_from_body,
                      step, 1.0);
}

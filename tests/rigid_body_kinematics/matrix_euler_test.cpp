#include "catch.hpp"
#include "coning.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::Trial;

namespace {

const std::string repaired_already =
    "the result is repaired already: leave that to nearest_rotation";

Mat3 cross_matrix(const Vec3& w) {
  return Mat3{{0.0, -w.z(), w.y()}, {w.z(), 0.0, -w.x()}, {-w.y(), w.x(), 0.0}};
}

std::vector<tests::Suspect<Mat3>> suspects_of_step(const Mat3& R, const Vec3& omega, double dt) {
  const Mat3 W = cross_matrix(omega);
  const double angle = omega.norm() * dt;
  const Mat3 exact = tests::rotation(angle, omega.normalized()).toRotationMatrix() * R;
  return {{R + dt * R * W,
           "[omega]x stands on the right, which suits omega in the body frame: put it on the left"},
          {R - dt * W * R, "it turns the wrong way: use [omega]x, not its transpose"},
          {R + dt * W, "R is missing: multiply [omega]x by R"},
          {dt * W * R, "only the change is returned: R + is missing, so add R"},
          {R + W * R, "dt is missing: multiply omega by dt"},
          {R, "nothing turns: add the change, however slow the spin"},
          {exact, "this is the exact turn of step 1.6: return the plain Euler step"}};
}

Trial step_trial(const Mat3& R, const Vec3& omega, double dt, int index = 1, int count = 1) {
  return Trial("1.4 step_matrix_euler", index, count)
      .given("world_from_body", R)
      .given("angular_velocity", omega)
      .given("dt", dt);
}

/// `steps` steps of x = omega dt each about `axis`, from the identity.
Mat3 after_steps(const Vec3& axis, double x, int steps) {
  Mat3 R = Mat3::Identity();
  for (int i = 0; i < steps; ++i) R = step_matrix_euler(R, axis, x);
  return R;
}

double departure(const Mat3& R) { return (R.transpose() * R - Mat3::Identity()).norm(); }

}  // namespace

TEST_CASE("One Euler step from the identity about z worked by hand", "[1.4]") {
  const Vec3 omega(0.0, 0.0, 2.0);
  const Mat3 wanted{{1.0, -0.5, 0.0}, {0.5, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const Mat3 R = Mat3::Identity();
  step_trial(R, omega, 0.25)
      .expect(step_matrix_euler(R, omega, 0.25), wanted, {0.0, "powers of two are exact"},
              suspects_of_step(R, omega, 0.25));
}

TEST_CASE("An Euler step adds dt omega cross every column", "[1.4]") {
  tests::Random random(41);
  for (int i = 1; i <= 100; ++i) {
    const Mat3 R = tests::matrix_of(random.attitude()).cast<double>();
    const Vec3 omega = random.vector(5.0);
    const double dt = random.uniform(-0.2, 0.2);
    Mat3 wanted = R;
    for (int c = 0; c < 3; ++c) wanted.col(c) += dt * (cross_matrix(omega) * R.col(c));
    step_trial(R, omega, dt, i, 100)
        .expect(step_matrix_euler(R, omega, dt), wanted,
                {16.0 * eps * (R.norm() + std::abs(dt) * omega.norm() * R.norm()),
                 "a product of 3 x 3 matrices and a sum"},
                suspects_of_step(R, omega, dt));
  }
}

TEST_CASE("A body that does not spin keeps its attitude exactly", "[1.4]") {
  const Mat3 R = tests::matrix_of(Quat(0.8, 0.0, 0.6, 0.0)).cast<double>();
  const tests::Bound exact{0.0, "zero is added"};
  step_trial(R, Vec3::Zero(), 0.1).expect(step_matrix_euler(R, Vec3::Zero(), 0.1), R, exact);
  step_trial(R, Vec3::UnitX(), 0.0).expect(step_matrix_euler(R, Vec3::UnitX(), 0.0), R, exact);
}

TEST_CASE("The matrix changes by the spin even if it is very slow", "[1.4]") {
  for (const double speed : {1e-6, 1e-9, 1e-100}) {
    const Vec3 omega(2.0 * speed, -3.0 * speed, 6.0 * speed);
    const Mat3 R = Mat3::Identity();
    const Mat3 next = step_matrix_euler(R, omega, 0.5);
    const Vec3 got(next(2, 1), next(0, 2), next(1, 0));
    step_trial(R, omega, 0.5)
        .expect(
            got, Vec3(0.5 * omega),
            {4.0 * eps * speed * 3.5, "a product, relative to its own size"},
            {{Vec3(Vec3::Zero()),
              "small spins are dropped by a guard that is too wide: test only for exactly zero"}});
  }
}

TEST_CASE("Euler on the matrix converges with order one on a coning motion", "[1.4]") {
  const auto step = [](const common::ConingMotion& motion, const Mat3& R, double t, double dt) {
    return step_matrix_euler(R, angular_velocity(motion, t), dt);
  };
  const Mat3 start = tests::coning_motion().world_from_body.toRotationMatrix();
  tests::expect_order(Trial("1.4 step_matrix_euler"), start, step, 1.0);
}

TEST_CASE("Each Euler step stretches R across omega by sqrt of 1 plus theta squared", "[1.4]") {
  tests::Random random(42);
  for (const double x : {0.001, 0.01, 0.1, 1.0}) {
    const Vec3 axis = random.direction();
    for (const int steps : {1, 10, 100}) {
      const Mat3 R = after_steps(axis, x, steps);
      const double swell = std::pow(1.0 + x * x, steps) - 1.0;
      Trial("1.4 step_matrix_euler")
          .given("angular_velocity", axis)
          .given("dt", x)
          .given("steps", static_cast<double>(steps))
          .expect(departure(R), std::sqrt(2.0) * swell,
                  {32.0 * eps * steps * (1.0 + swell), "each step rounds |R| by a few ulp"},
                  {{0.0, repaired_already}});
      Trial("1.4 step_matrix_euler")
          .given("angular_velocity", axis)
          .given("dt", x)
          .expect(
              Vec3(R * axis), axis,
              {16.0 * eps * steps * std::sqrt(1.0 + swell),
               "omega x omega = 0, so the axis keeps its length up to roundings of the size of R"});
    }
  }
}

TEST_CASE("The stretch passes one per cent at the step size of the formula", "[1.4]") {
  // sqrt2 ((1 + x²)^n − 1) = 0.01.
  const double x = 0.01;
  const double threshold = std::log1p(0.01 / std::sqrt(2.0)) / std::log1p(x * x);
  const double before = departure(after_steps(Vec3::UnitY(), x, static_cast<int>(0.9 * threshold)));
  const double after =
      departure(after_steps(Vec3::UnitY(), x, static_cast<int>(1.1 * threshold) + 1));
  const Trial trial = Trial("1.4 step_matrix_euler").given("dt * angular_velocity", 0.01);
  trial.expect_small("|R^T R - 1| at 0.9 of the threshold", before, {0.01, "the closed form"});
  trial.expect_small("0.01 - |R^T R - 1| at 1.1 of the threshold", 0.01 - after,
                     {0.0, "by the closed form it is above one per cent here"},
                     after < 32.0 * eps * threshold ? repaired_already : "");
}

#include "common/rotation/moser_veselov_correction.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "common/rotation/attitude.hpp"
#include "common/rotation/free_rotation.hpp"
#include "free_rotation_cases.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;

namespace {

/// The discrete Moser-Veselov step with given moments, solved by iteration; m is the momentum in
/// the body.
void step(const Vec3& I, double dt, Quat& q, Vec3& m) {
  const Vec3 differences(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());
  Vec3 p = 0.5 * dt * m.cwiseQuotient(I);
  for (int i = 0; i < 2000; ++i) {
    const double p_0 = std::sqrt(1.0 - p.squaredNorm());
    const Vec3 products(p.y() * p.z(), p.z() * p.x(), p.x() * p.y());
    const Vec3 next = (0.5 * dt * m - differences.cwiseProduct(products)).cwiseQuotient(I) / p_0;
    const double change = (next - p).norm();
    p = next;
    if (change < 1e-16) break;
  }
  Quat turn;
  turn.w() = std::sqrt(1.0 - p.squaredNorm());
  turn.vec() = p;
  q = q * turn;
  m = turn.conjugate() * m;
}

/// The angle to the closed form after some steps of a corrected method.
double angle_after(const Vec3& moments, const Spin& start, double dt, int steps, int order) {
  const auto [scale, shift] = moser_veselov_correction(moments, start, dt, order);
  const Vec3 inverse = (1.0 + scale) * moments.cwiseInverse() + Vec3::Constant(shift);
  Quat q = start.world_from_body;
  Vec3 m = moments.cwiseProduct(start.angular_velocity_body);
  for (int i = 0; i < steps; ++i) step(inverse.cwiseInverse(), dt, q, m);
  return angle_between(q, FreeRotation(moments, start).at(dt * steps).world_from_body);
}

/// How the angle falls when the step is halved, as a power of two.
double measured_order(const Vec3& moments, const Spin& start, double dt, int order) {
  const double coarse = angle_after(moments, start, dt, 8, order);
  const double fine = angle_after(moments, start, 0.5 * dt, 16, order);
  CHECK(fine > 1e-13);  // above the rounding, or the ratio would say nothing
  return std::log2(coarse / fine);
}

void check_orders(const Vec3& moments, const Vec3& omega) {
  const Spin start{Quat(0.5, 0.5, -0.5, 0.5), omega};
  for (const int order : {2, 4, 6, 8, 10}) {
    INFO("order " << order);
    // The next term of the error is dt^2 ~ 0.1 of the leading one; at half the step a quarter.
    CHECK(std::abs(measured_order(moments, start, 0.3, order) - order) < 0.5);
  }
}

/// What the step turns in a principal spin by x = ω dt.
double principal_turn(const Vec3& moments, int axis, double x, int order) {
  const Spin start{Quat::Identity(), x * Vec3::Unit(axis)};
  const auto [scale, shift] = moser_veselov_correction(moments, start, 1.0, order);
  // dt m = 2 p₀ p Ĩ = Ĩ sin(turn)
  return std::asin(x * moments[axis] * ((1.0 + scale) / moments[axis] + shift));
}

}  // namespace

TEST_CASE("Each correction has the order that it promises for a general body",
          "[moser_veselov_correction]") {
  check_orders({1.0, 2.0, 3.0}, {1.0, 1.2, 0.9});
  check_orders({3.0, 1.5, 2.0}, {1.0, 1.2, -0.9});
}

TEST_CASE("Each correction has the order that it promises for equal moments",
          "[moser_veselov_correction]") {
  check_orders({1.0, 1.0, 1.8}, {1.0, 1.2, 1.1});
  check_orders({1.7, 1.0, 1.7}, {1.0, 1.2, 1.1});
  check_orders({1.0, 1.0, 1.0}, {1.5, 1.2, 1.4});
}

TEST_CASE("The correction of order four is that of Hairer and Vilmart",
          "[moser_veselov_correction]") {
  // E = (1 + 2 + 3) / 2 = 3, |L|^2 / 2 = (1 + 4 + 9) / 2 = 7, dt = 0.1:
  // scale = 0.01 (-(1/3)(11/6) 3 + (6/36) 7), shift = 0.01 ((6/36) 3 - 7/18).
  const Spin spin{Quat::Identity(), Vec3(1.0, 1.0, 1.0)};
  const auto [scale, shift] = moser_veselov_correction({1.0, 2.0, 3.0}, spin, 0.1, 4);
  CHECK(std::abs(scale - 0.01 * (-11.0 / 6.0 + 7.0 / 6.0)) < 1e-17);
  CHECK(std::abs(shift - 0.01 * (0.5 - 7.0 / 18.0)) < 1e-17);
}

TEST_CASE("A principal spin turns by its angle to the order", "[moser_veselov_correction]") {
  const Vec3 moments(1.0, 2.0, 2.5);
  for (int axis = 0; axis < 3; ++axis) {
    // The turn is asin of Taylor's polynomial of the sine; its next term is x^(order + 1).
    for (const int order : {2, 4, 6, 8, 10}) {
      double sine = 0.0;
      double term = 0.5;
      for (int power = 1; power < order; power += 2) {
        sine += term;
        term *= -0.25 / ((power + 1) * (power + 2));
      }
      CHECK(std::abs(principal_turn(moments, axis, 0.5, order) - std::asin(sine)) < 1e-15);
    }
    CHECK(std::abs(principal_turn(moments, axis, 1.5, 10) - 1.500030) < 5e-7);
  }
}

TEST_CASE("Order two leaves the moments and rest leaves them at every order",
          "[moser_veselov_correction]") {
  const Vec3 moments(1.0, 2.0, 2.5);
  const Spin spin{Quat::Identity(), Vec3(1.0, 2.0, 3.0)};
  const auto [scale, shift] = moser_veselov_correction(moments, spin, 0.1, 2);
  CHECK((scale == 0.0 && shift == 0.0));
  for (const int order : {2, 4, 6, 8, 10}) {
    const Spin rest{Quat::Identity(), Vec3::Zero()};
    const auto [no_scale, no_shift] = moser_veselov_correction(moments, rest, 0.1, order);
    CHECK((no_scale == 0.0 && no_shift == 0.0));
  }
}

TEST_CASE("The correction is the same all along a motion", "[moser_veselov_correction]") {
  const FreeRotation rotation({1.0, 2.0, 2.5}, {Quat::Identity(), Vec3(1.0, 2.0, 0.5)});
  const MomentCorrection first =
      moser_veselov_correction({1.0, 2.0, 2.5}, rotation.at(0.0), 0.3, 10);
  const MomentCorrection later =
      moser_veselov_correction({1.0, 2.0, 2.5}, rotation.at(1.7), 0.3, 10);
  CHECK(first.scale != 0.0);
  CHECK(std::abs(first.scale - later.scale) < 1e-15);
  CHECK(std::abs(first.shift - later.shift) < 1e-15);
}

TEST_CASE("An order that does not exist is refused", "[moser_veselov_correction]") {
  for (const int order : {-2, 0, 1, 3, 12}) {
    CHECK_THROWS_AS(moser_veselov_correction({1.0, 2.0, 2.5}, Spin{}, 0.1, order),
                    std::invalid_argument);
  }
  CHECK_THROWS_AS(moser_veselov_correction({1.0, 2.0, 3.5}, Spin{}, 0.1, 4), std::invalid_argument);
}

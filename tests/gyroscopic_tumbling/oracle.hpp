#pragma once

#include <algorithm>
#include <cmath>

#include "gyroscopic_tumbling.hpp"
#include "likely.hpp"
#include "random.hpp"
#include "trial.hpp"

/// The steps of the lab once more, in extended precision, with what students get wrong as switches:
/// one formula serves as the oracle and as the list of suspects.
namespace tests {

using common::Spin;
using Real = long double;
using VecL = Eigen::Matrix<Real, 3, 1>;
using MatL = Eigen::Matrix<Real, 3, 3>;
using QuatL = Eigen::Quaternion<Real>;

inline Real wide(double x) { return static_cast<Real>(x); }
inline VecL wide(const common::Vec3& v) { return v.cast<Real>(); }
inline QuatL wide(const common::Quat& q) { return q.cast<Real>(); }
inline common::Vec3 narrow(const VecL& v) { return v.cast<double>(); }
inline common::Quat narrow(const QuatL& q) { return q.cast<double>(); }

inline QuatL pure(const VecL& v) { return {0, v.x(), v.y(), v.z()}; }
inline VecL times(const VecL& moments, const VecL& v) { return moments.cwiseProduct(v); }

/// q of any length plus a multiple of a rate.
inline QuatL sum(const QuatL& q, Real factor, const QuatL& rate) {
  return QuatL(Eigen::Matrix<Real, 4, 1>(q.coeffs() + factor * rate.coeffs()));
}

/// The rotation by |a| about a.
inline QuatL turn(const VecL& a) {
  const Real angle = a.norm();
  return angle == 0 ? QuatL::Identity() : QuatL(Eigen::AngleAxis<Real>(angle, VecL(a / angle)));
}

/// Euler's equations in body axes with the gyroscopic term times `sign`: 1 is right, 0 forgets it.
inline VecL euler_rate(const VecL& moments, const VecL& omega, Real sign = 1) {
  return times(moments, omega).cross(omega).cwiseQuotient(moments) * sign;
}

/// A Spin as one value of a trial: attitude and angular velocity are judged together, the latter
/// in units of `speed`.
struct SpinValue {
  common::Spin spin;
  double speed = 1.0;
};

inline bool is_finite(const SpinValue& value) {
  return is_finite(value.spin.world_from_body) && is_finite(value.spin.angular_velocity_body);
}
inline double length(const SpinValue& value) {
  return std::max(length(value.spin.world_from_body),
                  length(value.spin.angular_velocity_body) / value.speed);
}
inline double difference(const SpinValue& a, const SpinValue& b) {
  return std::max(difference(a.spin.world_from_body, b.spin.world_from_body),
                  difference(a.spin.angular_velocity_body, b.spin.angular_velocity_body) / b.speed);
}
inline std::string text(const SpinValue& value) {
  return "Spin{" + text(value.spin.world_from_body) + ", " +
         text(value.spin.angular_velocity_body) + "}";
}

struct SpinL {
  QuatL q;
  VecL omega;
};

inline SpinL wide(const common::Spin& spin) {
  return {wide(spin.world_from_body), wide(spin.angular_velocity_body)};
}

/// In units of the angular velocity.
inline SpinValue narrow(const SpinL& spin) {
  const auto speed = static_cast<double>(spin.omega.norm());
  return {{narrow(spin.q), narrow(spin.omega)}, speed > 0.0 ? speed : 1.0};
}

/// What a method returned, as a value of a trial.
inline SpinValue value_of(const common::Spin& spin) {
  const double speed = spin.angular_velocity_body.norm();
  return {spin, speed > 0.0 ? speed : 1.0};
}

/// Three distinct moments of a body without symmetry, in any order.
inline common::Vec3 random_moments(Random& random) {
  const double a = random.uniform(0.2, 1.0);
  const double b = a + random.uniform(0.2, 1.0);
  const double c = b + random.uniform(0.2, 1.0);
  common::Vec3 moments(b + c, a + c, a + b);
  if (random.uniform(0.0, 1.0) < 0.5) std::swap(moments.x(), moments.y());
  if (random.uniform(0.0, 1.0) < 0.5) std::swap(moments.y(), moments.z());
  if (random.uniform(0.0, 1.0) < 0.5) std::swap(moments.x(), moments.y());
  return moments;
}

inline common::Spin random_spin(Random& random, double speed = 3.0) {
  return {random.attitude(), random.vector(speed)};
}

/// Inputs on which mistakes are told apart: of either sign in dt, at ordinary speeds.
struct SpinCase {
  common::Vec3 moments;
  common::Spin spin;
  common::Vec3 other;  ///< one more angular velocity [rad/s]
  double dt;
};
inline std::vector<SpinCase> spin_cases() {
  Random random(219);
  std::vector<SpinCase> all;
  for (int i = 0; i < 12; ++i) {
    const common::Vec3 moments = random_moments(random);
    const common::Spin spin = random_spin(random);
    const common::Vec3 other = random.vector(3.0);
    all.push_back({moments, spin, other, i % 2 == 0 ? 0.05 : -0.04});
  }
  return all;
}

inline Trial spin_trial(const std::string& function, const common::Vec3& moments,
                        const common::Spin& spin, int index = 1, int count = 1) {
  return trial_of(function, index, count)
      .given("moments", moments)
      .given("spin.world_from_body", spin.world_from_body)
      .given("spin.angular_velocity_body", spin.angular_velocity_body);
}

/// Moments whose inverses are scaled and shifted.
inline VecL corrected(const VecL& I, Real scale, Real shift) {
  return ((1 + scale) * I.cwiseInverse().array() + shift).inverse();
}

/// A motion at any pace: s times as fast for 1/s of the time is the same. A guard against slow
/// spins or long steps, or a step that is clamped, shows here.
struct Paced {
  common::Spin spin;
  double dt;
};
inline Paced random_pace(Random& random, double largest_turn) {
  const double speed = std::pow(10.0, random.uniform(-9.0, 6.0));
  const double turn = largest_turn * std::pow(10.0, random.uniform(-6.0, 0.0));
  const double sign = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  return {{random.attitude(), speed * random.direction()}, sign * turn / speed};
}

inline const char* const guarded =
    "nothing changes, because a guard against small numbers is too wide: test only for exactly "
    "zero";
inline const char* const half_is_zero =
    "nothing changes, because 1/2 is 0 in whole numbers: write 0.5";

/// Requires that a step at some pace is its formula; where nothing was done it says so.
/// step     () -> Spin
/// at_rest  why: a guard, unless nothing happens at ordinary paces either
template <typename Step>
void expect_paced(const Trial& trial, const Paced& paced, const Step& step, const SpinL& wanted,
                  const std::string& at_rest = guarded) {
  const Trial here = Trial(trial).given("dt", paced.dt);
  here.expect(value_of(here.returned(step)), narrow(wanted),
              {4096.0 * eps, "the same as at ordinary speeds, in units of the angular velocity"},
              {{value_of(paced.spin), at_rest}});
}

/// Stories that several steps tell.
inline const char* const flipped =
    "the sign of the gyroscopic term is flipped: the torque is -omega x I omega";
inline const char* const forgotten =
    "the gyroscopic term is missing: add the torque -omega x I omega";

}  // namespace tests

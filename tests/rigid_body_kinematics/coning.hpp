#pragma once

#include <algorithm>
#include <cmath>

#include "common/rotation/attitude.hpp"
#include "common/rotation/coning_motion.hpp"
#include "trial.hpp"

namespace tests {

/// A cone about z swept twice in the two seconds of a run; ω changes direction all the time.
inline common::ConingMotion coning_motion() {
  common::ConingMotion motion;
  motion.rate = 6.0;
  motion.angular_velocity = {1.5, 0.0, 1.0};
  motion.world_from_body = common::Quat(0.5, 0.5, -0.5, 0.5);
  return motion;
}

inline common::Mat3 matrix_from(const common::Mat3& R) { return R; }
inline common::Mat3 matrix_from(const common::Quat& q) { return q.toRotationMatrix(); }

/// The largest error [rad] over all of `steps` equal steps through two seconds of the motion.
///
/// start  the attitude at time 0, as a matrix or a quaternion
/// step   (motion, attitude, time, dt) -> attitude
template <typename Attitude, typename Step>
double coning_error(const Attitude& start, const Step& step, int steps) {
  const common::ConingMotion motion = coning_motion();
  const double dt = 2.0 / steps;
  Attitude now = start;
  double largest = 0.0;
  for (int i = 0; i < steps; ++i) {
    now = step(motion, now, i * dt, dt);
    if (!is_finite(now)) return std::nan("");
    const common::Mat3 exact = common::attitude(motion, (i + 1) * dt).toRotationMatrix();
    largest = std::max(largest, common::chordal_distance(matrix_from(now), exact));
  }
  return largest;
}

/// Requires that halving the step from 2/256 s divides the error by 2^order.
///
/// The next term of the error's expansion is dt smaller, with a constant of the size of the rates:
/// 6 rad/s * 2/256 s = 0.05 of the ratio, 0.07 in its binary logarithm.
template <typename Attitude, typename Step>
void expect_order(const Trial& trial, const Attitude& start, const Step& step, double order) {
  const double measured =
      std::log2(coning_error(start, step, 256) / coning_error(start, step, 512));
  trial.expect(measured, order,
               {0.1,
                "the slope between 256 and 512 steps; the next term of the error bends it by at "
                "most 0.07; a slope of 0 means that another motion is integrated"});
}

}  // namespace tests

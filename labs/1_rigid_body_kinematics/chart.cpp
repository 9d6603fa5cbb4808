// This chart shows attitude error against computing time for a coning body. Its angular velocity is
// given and sweeps a cone once a second, and its attitude has a closed form.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "common/rotation/attitude.hpp"
#include "common/rotation/coning_motion.hpp"
#include "render/chart/chart_program.hpp"
#include "rigid_body_kinematics.hpp"

using namespace lab::rigid_body_kinematics;

namespace {

constexpr int turns = 10;
constexpr int checkpoints_a_turn = 4;
constexpr double no_attitude_is_further = 2.0;  // |R − R'| / √2 of two rotations is at most 2

common::ConingMotion coning_motion() {
  common::ConingMotion motion;
  motion.rate = 2.0 * std::numbers::pi;
  motion.angular_velocity = {3.0, 0.0, 2.0};
  return motion;
}

/// Returns ω at equal steps through one turn of the cone, beginning at `offset` of a step. It is
/// periodic, so the methods are timed without the cost of computing ω.
std::vector<Vec3> sampled_omega(int steps, double offset) {
  const common::ConingMotion motion = coning_motion();
  std::vector<Vec3> samples;
  samples.reserve(static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    samples.push_back(angular_velocity(motion, (i + offset) / steps));
  }
  return samples;
}

Mat3 matrix_from(const Mat3& R) { return R; }
Mat3 matrix_from(const Quat& q) { return q.toRotationMatrix(); }

/// Returns the largest error at the checkpoints of all turns.
template <typename Attitude, typename Step>
render::Judgement judge(const Step& step, int steps, double offset, Attitude attitude) {
  const common::ConingMotion motion = coning_motion();
  const std::vector<Vec3> omega = sampled_omega(steps, offset);
  double largest = 0.0;
  for (int i = 1; i <= turns * steps; ++i) {
    attitude = step(attitude, omega[static_cast<std::size_t>((i - 1) % steps)], 1.0 / steps);
    if (i % (steps / checkpoints_a_turn) != 0) continue;
    const Mat3 exact = common::attitude(motion, static_cast<double>(i) / steps).toRotationMatrix();
    const double error = common::chordal_distance(matrix_from(attitude), exact);
    largest = std::isfinite(error) ? std::max(largest, error) : HUGE_VAL;
  }
  return {std::min(largest, 1e300), static_cast<double>(steps), largest < no_attitude_is_further};
}

/// Returns a method whose parameter is the number of steps a turn. A step maps an attitude, ω and
/// dt to the next attitude. `offset` says at which part of a step ω is taken.
template <typename Attitude, typename Step>
render::Method method(const char* name, double order, render::Colour colour, double offset,
                      const Attitude& start, const Step& step) {
  render::Method result{name, order, colour, render::ladder(4, 16384), nullptr, nullptr, turns};
  result.judge = [=](double steps) { return judge(step, static_cast<int>(steps), offset, start); };
  result.run = [=, steps = 0, omega = std::vector<Vec3>()](double parameter) mutable {
    if (steps != static_cast<int>(parameter)) {
      steps = static_cast<int>(parameter);
      omega = sampled_omega(steps, offset);
    }
    Attitude attitude = start;
    for (int turn = 0; turn < turns; ++turn) {
      for (const Vec3& now : omega) attitude = step(attitude, now, 1.0 / steps);
    }
    volatile double kept = matrix_from(attitude)(0, 0);  // so that it is computed
    static_cast<void>(kept);
  };
  return result;
}

Mat3 projected_step(const Mat3& R, const Vec3& omega, double dt) {
  return nearest_rotation(step_matrix_euler(R, omega, dt));
}

std::vector<render::Method> methods() {
  namespace palette = render::palette;
  const Mat3 R = Mat3::Identity();
  const Quat q = Quat::Identity();
  constexpr double at_start = 0.0;
  constexpr double in_the_middle = 0.5;
  return {
      method("Euler on R", 1.0, palette::vermilion, at_start, R, step_matrix_euler),
      method("Euler on R, projected", 1.0, palette::orange, at_start, R, projected_step),
      method("Euler on q, normalised", 1.0, palette::sky, at_start, q, step_quaternion_euler),
      method("exponential, ω at the start", 1.0, palette::purple, at_start, q, step_exponential),
      method("Euler on q, ω at the middle", 2.0, palette::blue, in_the_middle, q,
             step_quaternion_euler),
      method("exponential, ω at the middle", 2.0, palette::green, in_the_middle, q,
             step_exponential),
  };
}

}  // namespace

int main(int argc, char** argv) {
  render::Chart chart;
  chart.lab = "1_rigid_body_kinematics";
  chart.title = "Attitude of a coning body: error against computing time";
  chart.subtitle =
      "ω sweeps a cone once per second, ten turns, 4 to 16384 steps per turn; dashed: order in "
      "theory";
  chart.error_name = "largest attitude error";
  chart.error_unit = "rad";
  chart.work_unit = "turn";
  chart.parameter_name = "steps a turn";
  chart.failure_error = no_attitude_is_further;
  chart.failure_text = "above 2, R is not a rotation any more";
  chart.rounding_floor = 2.2e-16;
  return render::chart_main(argc, argv, {{{chart, methods()}}, {}, {}});
}

#include "common/rotation/rk4_one_exponential.hpp"

#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "common/rotation/free_rotation.hpp"
#include "free_rotation_cases.hpp"
#include "values.hpp"

using namespace common;
using tests::turn;

namespace {

const Vec3 moments(1.0, 2.0, 3.0);
const Spin tumble{Quat(0.5, 0.1, -0.7, 0.3).normalized(), turn / std::sqrt(3.0) * Vec3::Ones()};

struct Errors {
  double angle = 0.0;
  double energy = 0.0;
};

/// The largest at each of some turns.
Errors worst(int turns, int steps_per_turn) {
  const auto energy = [](const Spin& spin) {
    return 0.5 * moments.dot(spin.angular_velocity_body.cwiseAbs2());
  };
  const FreeRotation exact(moments, tumble);
  Spin spin = tumble;
  Errors errors;
  for (int i = 1; i <= turns; ++i) {
    for (int step = 0; step < steps_per_turn; ++step) {
      spin = step_rk4_one_exponential(moments, spin, 1.0 / steps_per_turn);
    }
    errors.angle =
        std::max(errors.angle, angle_between(spin.world_from_body, exact.at(i).world_from_body));
    errors.energy = std::max(errors.energy, std::abs(energy(spin) / energy(tumble) - 1.0));
  }
  return errors;
}

}  // namespace

TEST_CASE("One exponential for four stages hides an attitude of order two under its energy",
          "[rk4_one_exponential]") {
  const Errors coarse = worst(10, 64);
  const Errors fine = worst(10, 128);
  CHECK(std::abs(std::log2(coarse.angle / fine.angle) - 2.0) < 0.1);
  CHECK(std::log2(coarse.energy / fine.energy) > 3.9);
}

TEST_CASE("One exponential for four stages errs over fifty turns as measured",
          "[rk4_one_exponential]") {
  const Errors errors = worst(50, 64);
  CHECK(std::abs(errors.angle - 4.10e-2) < 5e-5);  // as MuJoCo's own, to three digits
  CHECK(errors.energy < 1.3e-6);
}

TEST_CASE("One exponential for four stages turns a principal spin exactly",
          "[rk4_one_exponential]") {
  const Spin start{Quat(0.5, 0.5, -0.5, 0.5), turn * Vec3::UnitY()};
  const Spin after = step_rk4_one_exponential(moments, start, 0.3);
  const Quat wanted = start.world_from_body * exponential_map(0.3 * turn * Vec3::UnitY());
  CHECK(angle_between(after.world_from_body, wanted) < 1e-15);
  CHECK(tests::difference(after.angular_velocity_body, start.angular_velocity_body) == 0.0);
}

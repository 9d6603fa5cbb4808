#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "likely.hpp"
#include "random.hpp"
#include "scenes.hpp"

/// How the results of this lab are asked for, printed and judged.
namespace tests {

/// Sizes of A and of speeds from one end of the range to the other, with their products in it.
struct Scales {
  double yields;
  double speed;
};
inline constexpr std::array<Scales, 6> extreme_scales{
    {{1.0, 1e50}, {1.0, 1e-50}, {1e99, 1e99}, {1e99, 1e49}, {1e-99, 1e-49}, {1e-50, 1e-50}}};

inline const Bound counted{0.0, "it is counted"};
inline const Bound exact{0.0, "small fractions that doubles hold"};

inline Trial system_trial(const std::string& step_and_function, const ContactSystem& system,
                          int index = 1, int count = 1) {
  Trial trial = trial_of(step_and_function, index, count);
  return trial.given("A", system.A).given("u", system.u);
}

/// The system (A, b) of a function that takes both by themselves.
inline Trial system_trial(const std::string& step_and_function, const Matrix& A, const Vector& b,
                          int index = 1, int count = 1) {
  Trial trial = trial_of(step_and_function, index, count);
  return trial.given("A", A).given("b", b);
}

/// A finite entry for each contact, or the case ends here: what follows computes with them, and may
/// lose sight of NaN.
inline void expect_size(const Trial& trial, const Vector& lambda, Eigen::Index size) {
  trial.of("the number of impulses, one for each contact")
      .expect(static_cast<double>(lambda.size()), static_cast<double>(size), counted);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  trial.of("lambda").expect_small("an entry", lambda.allFinite() ? 0.0 : unknown, counted);
}

/// λ before what is counted: NaN is told of first.
inline void expect_impulses(const Trial& trial, const Impulses& got, const Impulses& wanted,
                            const Bound& bound) {
  trial.of("lambda").expect(got.lambda, wanted.lambda, bound);
  trial.of("the count")
      .expect(static_cast<double>(got.count), static_cast<double>(wanted.count), counted);
  trial.of("whether it ended").expect(Decision{got.ended}, Decision{wanted.ended}, counted);
}

/// The velocities of a scene after impulses, what was counted, and whether it ended.
inline void expect_outcome(const Trial& trial, const Scene& scene, const Impulses& got,
                           const Vector& wanted, int count, const Bound& bound) {
  expect_size(trial, got.lambda, scene.J.rows());
  trial.of("the velocities afterwards").expect(scene.after(got.lambda), wanted, bound);
  trial.of("the count").expect(static_cast<double>(got.count), static_cast<double>(count), counted);
  trial.of("whether it ended").expect(Decision{got.ended}, Decision{true}, counted);
}

/// Each in [−size, size).
Vector random_vector(Random& random, Eigen::Index count, double size);
/// A of as many contacts between twice as many bodies, well away from singular, and u of either
/// sign.
ContactSystem random_system(Random& random, Eigen::Index contacts);
/// The same contacts in another order: contact i becomes that of number order[i].
Vector reordered(const Vector& v, const std::vector<int>& order);
ContactSystem reordered(const ContactSystem& system, const std::vector<int>& order);

std::string text_of(const RigidBody& body);
/// As C++ that can be pasted.
Code code_of(const std::vector<RigidBody>& bodies);
Code code_of(const std::vector<Contact>& contacts);

}  // namespace tests

// What counts as an approach in step 7.6, and where there is nothing to stop or no way to do it.
#include "catch.hpp"
#include "impulses.hpp"
#include "refused.hpp"

using lab::multi_contact::Matrix;
using lab::multi_contact::Vector;
using tests::ContactSystem;
using tests::eps;

namespace {

void expect_zone(const ContactSystem& system, const Vector& lambda, int rounds,
                 const tests::Bound& bound, int index, int count) {
  const tests::Trial trial = tests::projection_trial(system, index, count);
  tests::expect_impulses(trial, tests::projected_by_answer(system, trial), {lambda, rounds, true},
                         bound);
}

/// Two contacts of one ball with opposite walls, which open as fast as this.
ContactSystem squeezed(double left, double right) {
  return {Matrix{{1.0, -1.0}, {-1.0, 1.0}}, Vector{{left, right}}};
}

}  // namespace

TEST_CASE("A contact joins a zone if it comes at 1e-12 of the largest speed", "[7.6]") {
  int index = 0;
  for (const double size : {1.0, 1e-6, 1e6}) {
    for (const double share : {0.5, 1.0 - 1e-12, 1.0 + 1e-12, 2.0, 1e3, 1e8}) {
      // Contacts that know nothing of each other; the other one parts.
      const double u = -share * 1e-12 * size;
      const bool comes = share > 1.0;
      expect_zone({Matrix::Identity(2, 2), Vector{{size, u}}}, Vector{{0.0, comes ? -u : 0.0}},
                  comes ? 1 : 0, {8.0 * eps * -u, "u, and A is one"}, ++index, 22);
    }
  }
  expect_zone({Matrix::Identity(2, 2), Vector{{-1.0, -0.9e-12}}}, Vector{{1.0, 0.0}}, 1,
              {8.0 * eps, "u, and A is one"}, ++index, 22);
  // It is the largest that counts, and not all of them together.
  expect_zone({Matrix::Identity(4, 4), Vector{{1.0, 1.0, 1.0, -1.2e-12}}},
              Vector{{0.0, 0.0, 0.0, 1.2e-12}}, 1, {1e-26, "u, and A is one"}, ++index, 22);
  // The first two go down to 1/2, and to rest. The last one comes at 0.7e-12, then at 0.93e-12.
  const ContactSystem calming{Matrix{{2.0, -1.0, -1.4e-12}, {-1.0, 2.0, 0.0}, {-1.4e-12, 0.0, 1.0}},
                              Vector{{-1.0, 0.0, 0.0}}};
  expect_zone(calming, Vector{{2.0, 1.0, 0.0}} / 3.0, 2, tests::of_solutions(1, 1.0), ++index, 22);
  // The same, and it comes at 1.4e-12 in the end.
  const ContactSystem late{Matrix{{2.0, -1.0, -2.1e-12}, {-1.0, 2.0, 0.0}, {-2.1e-12, 0.0, 1.0}},
                           Vector{{-1.0, 0.0, 0.0}}};
  expect_zone(late, Vector{{2.0, 1.0, 4.2e-12}} / 3.0, 2, tests::of_solutions(1, 1.0), ++index, 22);
}

TEST_CASE("What rests or parts is not stopped", "[7.6]") {
  int index = 0;
  for (const Vector& v : {Vector{{0.0, 0.0, 0.5, 2.0}}, Vector{{1.0, 1.0, 1.0, 1.0}}}) {
    expect_zone(tests::cradle(v).system(), Vector::Zero(3), 0, tests::exact, ++index, 3);
  }
  expect_zone({Matrix(0, 0), Vector(0)}, Vector(0), 0, tests::exact, ++index, 3);
}

TEST_CASE("Walls that close in on a body cannot be stopped", "[7.6]") {
  int index = 0;
  for (const ContactSystem& system : {squeezed(-1.0, -1.0), squeezed(-3.0, 1.0)}) {
    tests::projection_trial(system, ++index, 2)
        .expect_throw<std::domain_error>(
            [&] { return lab::multi_contact::inelastic_projection(system).lambda; },
            "the walls come, and no impulses stop both contacts");
  }
}

TEST_CASE("A heavy body on a light one is stopped in two rounds though rounding is large",
          "[7.6]") {
  // What is held may come at 1e-10 by rounding: it is in the zone already.
  int index = 0;
  for (const double ratio : {1e2, 1e4, 1e6, 1e8}) {
    const Vector masses{{0.3, 0.7 * ratio}};
    expect_zone(tests::column(masses, Vector{{-1.0, -1.0}}).system(),
                Vector{{masses.sum(), masses[1]}}, 2,
                tests::of_solutions(1, masses[1], 8.0 * ratio), ++index, 4);
  }
}

TEST_CASE("The least and the most masses and speeds are stopped alike", "[7.6]") {
  int index = 0;
  const ContactSystem system = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  for (const auto& [yields, speed] : tests::extreme_scales) {
    const double size = speed / yields;
    expect_zone({yields * system.A, speed * system.u}, Vector{{2.0, 1.0}} * (size / 3.0), 2,
                tests::of_solutions(1, size), ++index, 6);
  }
}

TEST_CASE("A matrix that is symmetric but for rounding is stopped", "[7.6]") {
  ContactSystem system = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  system.A(1, 0) -= 1e-10;
  expect_zone(system, Vector{{2.0, 1.0}} / 3.0, 2, {1e-9, "an entry of A is off by 1e-10"}, 1, 1);
}

TEST_CASE("A zone of bad input is refused", "[7.6]") {
  tests::refuse_systems("7.6 inelastic_projection", [](const ContactSystem& bad) {
    return lab::multi_contact::inelastic_projection(bad).lambda;
  });
}

// Step 7.4: on any system, sizes, and what is refused.
#include <numeric>

#include "catch.hpp"
#include "refused.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::Trial;

namespace {

Vector asked_for(const Vector& u, double e) { return u + e * u.cwiseMin(0.0); }

struct Judged {
  Trial trial;
  Vector lambda;
};

Judged judged(const ContactSystem& system, double e, int index, int count) {
  Trial trial = tests::system_trial("7.4 simultaneous_impulses", system, index, count);
  trial.given("restitution", e);
  Vector lambda = trial.returned([&] { return simultaneous_impulses(system, e); });
  tests::expect_size(trial, lambda, system.u.size());
  return {trial, lambda};
}

/// A λ + b as the exact solution has it. λ itself may be another where A is singular.
void expect_solution(const ContactSystem& system, double e, int index, int count) {
  const auto [trial, lambda] = judged(system, e, index, count);
  const Vector b = asked_for(system.u, e);
  const auto wanted = tests::exact_solution(system.A, b);
  REQUIRE(wanted.has_value());
  const double size = b.norm() + system.A.norm() * wanted->lambda.norm();
  const tests::Bound bound{1e-12 * size, "rounding, and what the supplied solver takes for zero"};
  trial.of("A lambda + b, b_i = u_i + e min(u_i, 0)")
      .expect(tests::exact_row_sums(system.A, lambda, b), wanted->u, bound);
  trial.expect_small("how far some lambda pulls", std::max(-lambda.minCoeff(), 0.0),
                     {0.0, "contacts push"});
}

/// Contacts between as few bodies that A is singular, all numbers so short that it is exactly so.
ContactSystem random_redundant(tests::Random& random, Eigen::Index contacts) {
  const auto velocities = std::max<Eigen::Index>(1, contacts / 2);
  const auto short_number = [&](double low, double high) {
    return std::floor(random.uniform(low, high)) / 4.0;
  };
  Scene scene{Matrix(contacts, velocities), Vector(velocities), Vector(velocities)};
  for (double& x : scene.J.reshaped()) x = short_number(-8.0, 9.0);
  // Something has to open everywhere, or there might be no solution for e > 0.
  scene.J.col(0) = scene.J.col(0).cwiseAbs().array() + 0.25;
  for (double& w : scene.W) w = std::exp2(std::floor(random.uniform(-2.0, 3.0)));
  for (double& v : scene.v) v = short_number(-12.0, 8.0);
  return scene.system();
}

}  // namespace

TEST_CASE("All at once is the exact solution of any system", "[7.4]") {
  tests::Random random(751);
  for (int i = 1; i <= 45; ++i) {
    const Eigen::Index m = i == 15 ? 12 : i == 30 ? 11 : 1 + i % 7;
    expect_solution(tests::random_system(random, m), i % 3 == 0 ? 1.0 : random.uniform(0.0, 1.0), i,
                    45);
  }
}

TEST_CASE("All at once is a solution where impulses are not the only ones", "[7.4]") {
  tests::Random random(752);
  for (int i = 1; i <= 30; ++i) {
    expect_solution(random_redundant(random, 2 + i % 7), i % 3 == 0 ? 1.0 : 0.25 * (i % 4), i, 30);
  }
}

TEST_CASE("The order of the contacts does not matter", "[7.4]") {
  tests::Random random(753);
  for (int i = 1; i <= 20; ++i) {
    const Eigen::Index m = 2 + i % 6;
    const ContactSystem system = tests::random_system(random, m);
    std::vector<int> order(static_cast<std::size_t>(m));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size() - 1; k > 0; --k) {
      std::swap(order[k],
                order[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(k + 1)))]);
    }
    const auto first = judged(system, 0.5, i, 20);
    const auto [trial, lambda] = judged(tests::reordered(system, order), 0.5, i, 20);
    const Vector wanted = tests::exact_solution(system.A, asked_for(system.u, 0.5)).value().lambda;
    const tests::Bound bound{1e-11 * (1.0 + wanted.norm()), "A has no eigenvalue below 1/4"};
    first.trial.of("lambda").expect(first.lambda, wanted, bound);
    trial.of("lambda in another order")
        .expect(lambda, tests::reordered(first.lambda, order), bound);
  }
}

TEST_CASE("What approaches leaves with e times its speed or more", "[7.4]") {
  tests::Random random(754);
  int approached = 0;
  for (int i = 1; i <= 30; ++i) {
    const ContactSystem system = tests::random_system(random, 1 + i % 7);
    const double e = 0.1 * (i % 11);
    const auto [trial, lambda] = judged(system, e, i, 30);
    const Vector after = tests::exact_row_sums(system.A, lambda, system.u);
    const double rounding = 1e-11 * (system.u.norm() + system.A.norm() * lambda.norm());
    for (Eigen::Index k = 0; k < after.size(); ++k) {
      const bool approaches = system.u[k] < 0.0;
      approached += approaches ? 1 : 0;
      const double least = approaches ? -e * system.u[k] : 0.0;
      trial.of("contact " + std::to_string(k))
          .expect_small("how much too slowly it leaves", std::max(least - after[k], 0.0),
                        {rounding, "rounding"});
      // Whoever is pushed leaves no faster than that.
      trial.of("contact " + std::to_string(k))
          .expect_small("by how much it leaves too fast although it is pushed",
                        lambda[k] > 1e-9 ? std::max(after[k] - least, 0.0) : 0.0,
                        {rounding, "rounding"});
    }
  }
  REQUIRE(approached > 40);
}

TEST_CASE("Elastic impulses keep the energy if all contacts approach and all push", "[7.4]") {
  tests::Random random(755);
  for (int i = 1; i <= 40; ++i) {
    const auto n = static_cast<Eigen::Index>(random.uniform(2.0, 7.0));
    Vector masses(n);
    for (double& mass : masses) mass = random.uniform(1.0, 9.0);
    Vector v(n);
    double speed = 3.0;
    for (double& x : v) x = speed -= random.uniform(0.0, 1.0);
    const Scene scene = tests::row_of_balls(masses, v);
    const ContactSystem system = scene.system();
    const auto [trial, lambda] = judged(system, 1.0, i, 40);
    const Vector after = scene.after(lambda);
    trial.of("the momentum")
        .expect(scene.momentum(after), scene.momentum(v),
                {1e-11 * 54.0 * 6.0, "masses up to 54, speeds up to 6"});
    trial.of("the energy")
        .expect(scene.energy(after), scene.energy(v),
                {1e-11 * 54.0 * 36.0, "masses up to 54, speeds up to 6"});
    trial.expect_small("how many contacts got nothing",
                       static_cast<double>((lambda.array() <= 0.0).count()), tests::counted);
  }
}

TEST_CASE("Impulses at once have the size of speeds and masses and no e is rounded", "[7.4]") {
  const ContactSystem cradle = tests::cradle(Vector{{1.0, 0.0, 0.0}}).system();
  const Vector wanted = Vector{{4.0, 2.0}} / 3.0;
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    const auto fast = judged({cradle.A, size * cradle.u}, 1.0, ++index, 12);
    fast.trial.expect(fast.lambda, Vector(size * wanted), {64.0 * eps * size, "ten operations"});
    const auto light = judged({size * cradle.A, cradle.u}, 1.0, ++index, 12);
    light.trial.expect(light.lambda, Vector(wanted / size), {64.0 * eps / size, "ten operations"});
  }
  int slow = 0;
  for (const double speed : {1e-3, 1e-6, 1e-9}) {  // beside a fast one
    const ContactSystem apart{Matrix{{1.0, 0.0}, {0.0, 2.0}}, Vector{{-1.0, -speed}}};
    const auto [trial, lambda] = judged(apart, 0.5, ++slow, 3);
    trial.expect(lambda, Vector(Vector{{1.5, 0.75 * speed}}), {1e-12, "it counts for zero"});
  }
  int number = 0;
  for (const double e : {1e-3, 1e-9, 1e-12, 1.0 - 1e-12, 1.0 - 1e-9, 1.0 - 1e-3}) {
    const auto [trial, lambda] = judged({Matrix{{2.0}}, Vector{{-1.0}}}, e, ++number, 6);
    trial.expect(lambda, Vector(Vector{{0.5 * (1.0 + e)}}), {4.0 * eps, "three operations"});
  }
}

TEST_CASE("Where nothing approaches and without contacts there is nothing to solve", "[7.4]") {
  const auto empty = judged({Matrix(0, 0), Vector(0)}, 1.0, 1, 2);
  empty.trial.expect(empty.lambda, Vector(Vector(0)), tests::exact);
  const ContactSystem rounded{Matrix{{2.0, -1.0}, {-1.0 + 1e-9, 2.0}}, Vector{{-1.0, 0.0}}};
  const auto [trial, lambda] = judged(rounded, 0.5, 2, 2);
  trial.expect(lambda, Vector(Vector{{1.0, 0.5}}), {2e-9, "A is symmetric to 1e-9"});
  const Matrix A{{2.0, -1.0}, {-1.0, 2.0}};
  int index = 0;
  for (const Vector& u : {Vector{{0.0, 0.0}}, Vector{{1.0, 0.0}}, Vector{{0.5, 2.0}}}) {
    for (const double e : {0.0, 1.0}) {
      const auto [nothing, none] = judged({A, u}, e, ++index, 6);
      nothing.expect(none, Vector(Vector::Zero(2)), tests::exact);
    }
  }
}

TEST_CASE("Impulses at once of what cannot be are refused", "[7.4]") {
  const std::string f = "7.4 simultaneous_impulses";
  tests::refuse_systems(f,
                        [](const ContactSystem& bad) { return simultaneous_impulses(bad, 0.5); });
  for (const Vector& u : {Vector{{-1.0, 0.0}}, Vector{{1.0, 1.0}}}) {  // and with nothing to do
    const ContactSystem system{tests::good_system().A, u};
    tests::refuse(f, tests::bad_fractions(), "restitution",
                  [&](double e) { return simultaneous_impulses(system, e); });
  }
}

// Step 7.4: outcomes that are pinned, and which laws hold.
#include "catch.hpp"
#include "judged.hpp"

using namespace lab::multi_contact;
using tests::eps;
using tests::Scene;
using tests::Trial;

namespace {

Trial simultaneous_trial(const ContactSystem& system, double restitution, int index = 1,
                         int count = 1) {
  return tests::system_trial("7.4 simultaneous_impulses", system, index, count)
      .given("restitution", restitution);
}

Vector simultaneous_by_answer(const Trial& trial, const ContactSystem& system, double restitution) {
  Vector got = trial.returned([&] { return simultaneous_impulses(system, restitution); });
  tests::expect_size(trial, got, system.u.size());
  return got;
}

const tests::Bound solved{64.0 * eps * 8.0, "some ten operations a contact, on numbers up to 8"};

/// The velocities alone: where A is singular λ is not the only one.
void expect_velocities(const Scene& scene, double restitution, const Vector& wanted, int index,
                       int count) {
  const ContactSystem system = scene.system();
  const Trial trial = simultaneous_trial(system, restitution, index, count);
  const Vector lambda = simultaneous_by_answer(trial, system, restitution);
  trial.of("the velocities afterwards").expect(scene.after(lambda), wanted, solved);
  trial.expect_small("how far some lambda pulls", std::max(-lambda.minCoeff(), 0.0),
                     {0.0, "contacts push"});
}

struct Pinned {
  Scene scene;
  Vector wanted;
  double restitution = 1.0;
};
void expect_pinned_velocities(const std::vector<Pinned>& all) {
  int index = 0;
  for (const auto& [scene, wanted, restitution] : all) {
    expect_velocities(scene, restitution, wanted, ++index, static_cast<int>(all.size()));
  }
}

}  // namespace

TEST_CASE("If one ball hits others that touch it comes back and they go as one", "[7.4]") {
  std::vector<Pinned> all{
      {tests::cradle(Vector{{1.0, 0.0, 0.0}}), Vector{{-1.0, 2.0, 2.0}} / 3.0},
      {tests::cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}), Vector{{-3.0, 2.0, 2.0, 2.0, 2.0}} / 5.0},
      {tests::cradle(Vector{{1.0, 1.0, 0.0, 0.0, 0.0}}), Vector{{-1.0, -1.0, 4.0, 4.0, 4.0}} / 5.0},
      {tests::cradle(Vector{{1.0, 1.0, 1.0, 0.0, 0.0}}), Vector{{1.0, 1.0, 1.0, 6.0, 6.0}} / 5.0},
      {tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, 0.0}}),
       Vector{{-1.0, 1.0, 1.0}} / 2.0},
      {tests::row_of_balls(Vector{{2.0, 1.0, 2.0}}, Vector{{1.0, 0.0, 0.0}}),
       Vector{{-1.0, 4.0, 4.0}} / 5.0}};
  for (int n = 2; n <= 8; ++n) {  // one on N − 1: (2 − N)/N and 2/N
    Vector wanted = Vector::Constant(n, 2.0 / n);
    wanted[0] = (2.0 - n) / n;
    all.push_back({tests::cradle(Vector::Unit(n, 0)), wanted});
  }
  expect_pinned_velocities(all);
}

TEST_CASE("Half of the speed comes back and is worked by hand", "[7.4]") {
  expect_pinned_velocities(
      {{tests::cradle(Vector{{1.0, 0.0, 0.0}}), Vector{{0.0, 0.5, 0.5}}, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, 0.0, 0.0, 0.0}}), Vector{{-2.0, 3.0, 3.0, 3.0, 3.0}} / 10.0,
        0.5},
       {tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{-0.5, 0.0, 0.5}}, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, 0.5}}), Vector{{1.0, 4.0, 4.0}} / 6.0, 0.5},
       {tests::break_shot(), Vector{{3.0, 0.0, 8.0, 6.0, 8.0, -6.0}} / 19.0, 0.5},
       {tests::cradle(Vector{{1.0, 0.0, 0.0}}), Vector{{1.0, 1.0, 1.0}} / 3.0, 0.0},
       {tests::break_shot(), Vector{{25.0, 0.0, 16.0, 12.0, 16.0, -12.0}} / 57.0, 0.0}});
}

TEST_CASE("What comes to many contacts at once leaves all of them as it came", "[7.4]") {
  const Vector falling{{-1.0, -1.0}};
  const Vector y{{0.0, 1.0}};
  expect_pinned_velocities(
      {{tests::cradle(Vector{{1.0, 0.0, -1.0}}), Vector{{-1.0, 0.0, 1.0}}},
       {tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}}),
        Vector{{-1.0, 0.0, 1.0}}},
       {tests::column(Vector{{3.0, 1.0}}, falling), Vector{{1.0, 1.0}}},
       {tests::column(Vector{{2.0, 1.0}}, falling), Vector{{1.0, 1.0}}},
       {tests::column(Vector{{1.0, 3.0}}, falling), Vector{{1.0, 1.0}}},
       {tests::column(Vector{{1.0, 100.0}}, falling), Vector{{1.0, 1.0}}},
       {tests::column(Vector::Ones(12), -Vector::Ones(12)), Vector::Ones(12)},
       {tests::rod(1.0 / 3.0, -1.0, 1.0), Vector{{1.0, -1.0}}},
       {tests::rod(1.0 / 3.0, -1.0, 0.0), Vector{{1.0, 0.0}}},
       {tests::dumb_bell(), Vector{{1.75, -0.25}}},
       {tests::break_shot(), Vector{{-7.0, 0.0, 32.0, 24.0, 32.0, -24.0}} / 57.0},
       {tests::wedge(Vector{{1.0, 0.0}}, y, Vector{{-1.0, -2.0}}), Vector{{1.0, 2.0}}},
       {tests::wedge(y, Vector{{0.8, -0.6}}, Vector{{-1.0, -0.5}}), Vector{{1.0, 0.5}}}});
}

TEST_CASE("A neighbour that parts is asked for no bounce and yet energy is gained", "[7.4]") {
  expect_pinned_velocities(
      {{tests::cradle(Vector{{1.0, 0.0, 0.5}}), Vector{{-1.0, 5.0, 5.0}} / 6.0},
       {tests::cradle(Vector{{1.0, 0.0, 2.0}}), Vector{{0.0, 1.0, 2.0}}}});
  // The energy rises by d (1 − d)/3.
  int index = 0;
  for (const double d : {0.0, 0.125, 0.25, 0.5, 0.75, 0.875, 1.0}) {
    const Scene scene = tests::cradle(Vector{{1.0, 0.0, d}});
    const Trial trial = simultaneous_trial(scene.system(), 1.0, ++index, 7);
    const Vector after = scene.after(simultaneous_by_answer(trial, scene.system(), 1.0));
    trial.of("the velocities afterwards")
        .expect(after, Vector(Vector{{d - 1.0, 2.0 + d, 2.0 + d}} / 3.0), solved);
    trial.of("the energy gained")
        .expect(scene.energy(after) - scene.energy(scene.v), d * (1.0 - d) / 3.0, solved);
  }
}

TEST_CASE("A table has one outcome though many impulses make it", "[7.4]") {
  expect_pinned_velocities({{tests::table(Vector{{-1.0, 0.0, 0.0}}), Vector{{1.0, 0.0, 0.0}}},
                            {tests::table(Vector{{-1.0, 0.0, 0.0}}), Vector{{0.5, 0.0, 0.0}}, 0.5},
                            {tests::table(Vector{{-1.0, 0.0, 0.0}}), Vector{{0.0, 0.0, 0.0}}, 0.0},
                            {tests::table(Vector{{-1.0, -0.5, -0.5}}), Vector{{1.0, 0.5, 0.5}}}});
}

TEST_CASE("A jam has no solution with restitution and one without", "[7.4]") {
  const std::string f = "7.4 simultaneous_impulses";
  const Scene jam = tests::jammed_ball();
  expect_velocities(jam, 0.0, Vector{{0.0}}, 1, 1);
  for (const Scene& scene : {jam, jam.backwards()}) {
    for (const double e : {1.0, 0.5, 1e-3}) {
      simultaneous_trial(scene.system(), e)
          .expect_throw<std::domain_error>(
              [&, r = e] { return simultaneous_impulses(scene.system(), r); },
              "no impulses open both contacts of a ball between two walls");
    }
  }
  // Three balls between two walls, and the middle one moves.
  const Scene row = tests::cradle(Vector{{0.0, 1.0, 0.0}});
  Scene between = row;
  between.J = Matrix::Zero(4, 3);
  between.J.middleRows(1, 2) = row.J;
  between.J(0, 0) = 1.0;
  between.J(3, 2) = -1.0;
  expect_velocities(between, 0.0, Vector{{0.0, 0.0, 0.0}}, 1, 1);
  simultaneous_trial(between.system(), 1.0)
      .expect_throw<std::domain_error>([&] { return simultaneous_impulses(between.system(), 1.0); },
                                       "no impulses open all contacts of balls between two walls");
}

TEST_CASE("The outcome is the mirror image if the scene is", "[7.4]") {
  // Each scene is its own mirror image, and contacts come in another order.
  const Scene row = tests::row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, -1.0}});
  const Scene shot = tests::break_shot();
  int index = 0;
  for (const double e : {1.0, 0.5, 0.0}) {
    expect_velocities(row, e, Vector{{-e, 0.0, e}}, ++index, 12);
    expect_velocities(row.backwards(), e, Vector{{-e, 0.0, e}}, ++index, 12);
    const double head = 1.0 - (1.0 + e) * 32.0 / 57.0;
    const double x = (1.0 + e) * 16.0 / 57.0;
    const Vector wanted{{head, 0.0, x, 0.75 * x, x, -0.75 * x}};
    expect_velocities(shot, e, wanted, ++index, 12);
    expect_velocities(shot.backwards(), e, wanted, ++index, 12);
  }
}

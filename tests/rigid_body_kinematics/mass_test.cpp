#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::Trial;

namespace {

Mat3 rounded(const tests::Mat3L& m) { return m.cast<double>(); }

std::vector<tests::Suspect<Mat3>> suspects_of_inertia(const Mat3& I0, const Quat& q) {
  const Mat3 R = rounded(tests::matrix_of(q));
  return {
      {R.transpose() * I0 * R, "the turn goes the wrong way: R^T I0 R instead of R I0 R^T"},
      {I0, "the body's inertia is used as the world's: turn it, R I0 R^T"},
      {R * I0, "the inertia is turned from one side only: multiply R I0 by R^T, too"},
      {I0 * R.transpose(), "the inertia is turned from one side only: multiply I0 R^T by R, too"}};
}

std::vector<tests::Suspect<Vec3>> suspects_of_torque(const Vec3& center,
                                                     const std::vector<AppliedForce>& forces) {
  Vec3 about_origin = Vec3::Zero();
  Vec3 right = Vec3::Zero();
  std::vector<Vec3> torques{Vec3::Zero()};
  for (const AppliedForce& applied : forces) {
    torques.push_back((applied.point - center).cross(applied.force));
    right += torques.back();
    about_origin += applied.point.cross(applied.force);
  }
  return {{-right, "the cross product is the wrong way round: f x r instead of r x f"},
          {about_origin, "the torque is about the world's origin: use p - x, not p"},
          {torques.back(), "only the last force counts: use += in the loop, not ="},
          {torques[forces.empty() ? 0 : 1], "only the first force counts: add up all forces"},
          {right - torques.back(), "the last force is left out: let the loop go to the end"},
          {right - torques[forces.empty() ? 0 : 1],
           "the first force is left out: start the loop at index 0"},
          {Vec3::Zero(), "no force makes a torque: add r x f of each force, however small"}};
}

Trial wrench_trial(const Vec3& center, const std::vector<AppliedForce>& forces, int index = 1,
                   int count = 1) {
  Trial trial = Trial("1.3 net_wrench", index, count).given("center_of_mass", center);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const std::string name = "forces[" + std::to_string(i) + "]";
    trial.given(name + ".force", forces[i].force).given(name + ".point", forces[i].point);
  }
  return trial;
}

/// Requires both parts, each by its name.
void expect_wrench(const Trial& trial, const Wrench& got, const Wrench& wanted, double force_bound,
                   double torque_bound, const std::vector<AppliedForce>& forces,
                   const Vec3& center) {
  std::vector<tests::Suspect<Vec3>> suspects_of_force;
  if (!forces.empty()) {
    suspects_of_force = {
        {forces.back().force, "only the last force counts: use += in the loop, not ="},
        {forces.front().force, "only the first force counts: add up all forces"},
        {wanted.force - forces.back().force,
         "the last force is left out: let the loop go to the end"},
        {wanted.force - forces.front().force,
         "the first force is left out: start the loop at index 0"},
        {Vec3::Zero(), "no force is added up: add each force, however small"}};
  }
  trial.of("the force")
      .expect(got.force, wanted.force, {force_bound, "a few additions, in any order"},
              suspects_of_force);
  trial.of("the torque")
      .expect(got.torque, wanted.torque,
              {torque_bound, "a few cross products and additions, in any order"},
              suspects_of_torque(center, forces));
}

double size_of(const Vec3& center, const std::vector<AppliedForce>& forces) {
  double size = 0.0;
  for (const AppliedForce& f : forces) size += (f.point.norm() + center.norm()) * f.force.norm();
  return size;
}

std::vector<AppliedForce> random_forces(tests::Random& random, int count, double size) {
  std::vector<AppliedForce> forces;
  for (int i = 0; i < count; ++i) {
    const Vec3 force = random.vector(size);
    forces.push_back({force, random.vector(2.0)});
  }
  return forces;
}

}  // namespace

TEST_CASE("A quarter turn about z swaps the moments about x and y", "[1.3]") {
  const Mat3 I0 = Vec3(1.0, 2.0, 3.0).asDiagonal();
  const Mat3 wanted = Vec3(2.0, 1.0, 3.0).asDiagonal();
  const Quat q = tests::rotation(std::acos(0.0), Vec3::UnitZ());
  Trial("1.3 world_inertia")
      .given("inertia_body", I0)
      .given("world_from_body", q)
      .expect(world_inertia(I0, q), wanted, {32.0 * eps * 3.0, "two products of 3 x 3 matrices"},
              suspects_of_inertia(I0, q));
}

TEST_CASE("The world inertia is R I0 R transposed for any symmetric I0", "[1.3]") {
  tests::Random random(31);
  for (int i = 1; i <= 100; ++i) {
    const Mat3 I0 = random.inertia();
    const Quat q = random.attitude();
    const tests::Mat3L R = tests::matrix_of(q);
    const Mat3 wanted = rounded(R * I0.cast<long double>() * R.transpose());
    Trial("1.3 world_inertia", i, 100)
        .given("inertia_body", I0)
        .given("world_from_body", q)
        .expect(
            world_inertia(I0, q), wanted,
            {32.0 * eps * I0.norm(), "two products of 3 x 3 matrices, 9 dot products of 3 each"},
            suspects_of_inertia(I0, q));
  }
}

TEST_CASE("A ball has the same inertia in every attitude", "[1.3]") {
  tests::Random random(32);
  const Mat3 I0 = 0.4 * Mat3::Identity();
  for (int i = 1; i <= 20; ++i) {
    const Quat q = random.attitude();
    Trial("1.3 world_inertia", i, 20)
        .given("inertia_body", I0)
        .given("world_from_body", q)
        .expect(world_inertia(I0, q), I0,
                {32.0 * eps * I0.norm(), "two products of 3 x 3 matrices"},
                suspects_of_inertia(I0, q));
  }
}

TEST_CASE("A turn keeps the kinetic energy of a spin that turns along", "[1.3]") {
  tests::Random random(33);
  for (int i = 1; i <= 20; ++i) {
    const Mat3 I0 = random.inertia();
    const Quat q = random.attitude();
    const Vec3 omega_body = random.vector(2.0);
    const Vec3 omega = tests::turned(q, omega_body);
    const Mat3 inertia = world_inertia(I0, q);
    const double error = std::abs(omega.dot(inertia * omega) - omega_body.dot(I0 * omega_body));
    Trial("1.3 world_inertia", i, 20)
        .given("inertia_body", I0)
        .given("world_from_body", q)
        .expect_small("|omega.I omega - omega_body.I0 omega_body|", error,
                      {64.0 * eps * I0.norm() * omega.squaredNorm(), "some 60 rounded operations"});
  }
}

TEST_CASE("A force on the x side along y turns about plus z", "[1.3]") {
  const Vec3 center(5.0, 0.0, 0.0);
  const std::vector<AppliedForce> forces{{Vec3(0.0, 3.0, 0.0), Vec3(7.0, 0.0, 0.0)}};
  const Wrench wanted{Vec3(0.0, 3.0, 0.0), Vec3(0.0, 0.0, 6.0)};
  expect_wrench(wrench_trial(center, forces), net_wrench(center, forces), wanted, 0.0, 0.0, forces,
                center);
}

TEST_CASE("Forces and torques add up whether large or small", "[1.3]") {
  tests::Random random(34);
  for (int i = 1; i <= 50; ++i) {
    const Vec3 center = random.vector(2.0);
    const double size = i % 2 == 0 ? 10.0 : 1e-9;
    const std::vector<AppliedForce> forces = random_forces(random, 2 + i % 5, size);
    Wrench wanted;
    tests::Vec3L torque = tests::Vec3L::Zero();
    double total = 0.0;
    for (const AppliedForce& applied : forces) {
      const tests::Vec3L r = applied.point.cast<long double>() - center.cast<long double>();
      wanted.force += applied.force;
      torque += r.cross(applied.force.cast<long double>());
      total += applied.force.norm();
    }
    wanted.torque = torque.cast<double>();
    expect_wrench(wrench_trial(center, forces, i, 50), net_wrench(center, forces), wanted,
                  8.0 * eps * total, 16.0 * eps * size_of(center, forces), forces, center);
  }
}

TEST_CASE("A couple moves nothing and turns the same about every centre", "[1.3]") {
  const std::vector<AppliedForce> couple{{Vec3(0.0, 2.0, 0.0), Vec3(1.0, 0.0, 0.0)},
                                         {Vec3(0.0, -2.0, 0.0), Vec3(-1.0, 0.0, 0.0)}};
  const Wrench wanted{Vec3::Zero(), Vec3(0.0, 0.0, 4.0)};
  for (const Vec3& center : {Vec3(0.0, 0.0, 0.0), Vec3(4.0, -3.0, 2.0)}) {
    // Small whole numbers are exact.
    expect_wrench(wrench_trial(center, couple), net_wrench(center, couple), wanted, 0.0, 0.0,
                  couple, center);
  }
}

TEST_CASE("Without forces there is neither force nor torque", "[1.3]") {
  const Vec3 center(1.0, 2.0, 3.0);
  expect_wrench(wrench_trial(center, {}), net_wrench(center, {}), {}, 0.0, 0.0, {}, center);
}

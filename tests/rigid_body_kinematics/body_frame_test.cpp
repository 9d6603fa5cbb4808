#include "catch.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "rigid_body_kinematics.hpp"
#include "trial.hpp"

using namespace lab::rigid_body_kinematics;
using tests::eps;
using tests::turned;
using tests::turned_back;

namespace {

/// A quarter turn about z at (1, 2, 3); body x points along world y.
RigidBodyState quarter_turned() {
  RigidBodyState state;
  state.position = {1.0, 2.0, 3.0};
  state.world_from_body = tests::rotation(std::acos(0.0), Vec3::UnitZ());
  state.velocity = {0.0, 0.0, 1.0};
  state.angular_velocity = {0.0, 0.0, 2.0};
  return state;
}

tests::Trial trial(const char* function, const RigidBodyState& state, int index = 1,
                   int count = 1) {
  return tests::Trial(function, index, count)
      .given("state.position", state.position)
      .given("state.world_from_body", state.world_from_body);
}

tests::Trial velocity_trial(const RigidBodyState& state, const Vec3& point, int index = 1,
                            int count = 1) {
  return trial("1.2 point_velocity", state, index, count)
      .given("state.velocity", state.velocity)
      .given("state.angular_velocity", state.angular_velocity)
      .given("point", point);
}

std::vector<tests::Suspect<Vec3>> suspects_of_world_point(const RigidBodyState& s, const Vec3& p) {
  const Quat& q = s.world_from_body;
  return {
      {s.position + turned_back(q, p),
       "the turn goes the wrong way, body from world: use R, not R^T"},
      {s.position + turned(q, turned(q, p)), "the turn is made twice: turn the point only once"},
      {turned(q, p), "the shift by the centre of mass is missing: add x"},
      {turned(q, s.position + p), "the shift comes before the turn: return x + R p, not R (x + p)"},
      {s.position + p, "the turn is missing: turn the point by R"}};
}

std::vector<tests::Suspect<Vec3>> suspects_of_body_point(const RigidBodyState& s, const Vec3& p) {
  const Quat& q = s.world_from_body;
  return {
      {turned(q, p - s.position), "the turn goes the wrong way, world from body: use R^T, not R"},
      {turned_back(q, p), "the shift by the centre of mass is missing: subtract x"},
      {turned_back(q, p) - s.position,
       "the turn comes before the shift: return R^T (p - x), not R^T p - x"},
      {p - s.position, "the turn is missing: turn p - x by R^T"}};
}

std::vector<tests::Suspect<Vec3>> suspects_of_velocity(const RigidBodyState& s, const Vec3& p) {
  const Vec3& omega = s.angular_velocity;
  const Vec3 r = p - s.position;
  return {
      {s.velocity + r.cross(omega),
       "the cross product is the wrong way round: r x omega instead of omega x r"},
      {s.velocity + omega.cross(p), "the lever arm starts at the world's origin: use p - x, not p"},
      {omega.cross(r), "the velocity of the centre of mass is missing: add v"},
      {s.velocity, "the spin contributes nothing: omega x r is missing, so add it"},
      {s.velocity + turned(s.world_from_body, omega).cross(r),
       "omega is already a world vector, but it is turned once more: use it as it is"},
      {s.velocity + omega.cross(turned_back(s.world_from_body, r)),
       "the lever arm is in the body frame, but omega in the world frame: use r = p - x"}};
}

/// Some 30 rounded operations on terms no larger than the sum; the quaternion is unit to 2 ulp.
tests::Bound rounding(double size) {
  return {16.0 * eps * size, "some 30 roundings on terms of this size"};
}

}  // namespace

TEST_CASE("A quarter turn takes body x to world y before the shift", "[1.2]") {
  const RigidBodyState state = quarter_turned();
  const Vec3 p(1.0, 0.0, 0.0);
  trial("1.2 world_point", state)
      .given("point_body", p)
      .expect(world_point(state, p), Vec3(1.0, 3.0, 3.0), rounding(5.0),
              suspects_of_world_point(state, p));
}

TEST_CASE("A point of the body goes to where the turn and the shift take it", "[1.2]") {
  tests::Random random(21);
  for (int i = 1; i <= 100; ++i) {
    const RigidBodyState state = random_state(random);
    const Vec3 p = random.vector(2.0);
    const Vec3 wanted = state.position + turned(state.world_from_body, p);
    trial("1.2 world_point", state, i, 100)
        .given("point_body", p)
        .expect(world_point(state, p), wanted, rounding(state.position.norm() + p.norm()),
                suspects_of_world_point(state, p));
  }
}

TEST_CASE("body_point takes a world point back to the body frame", "[1.2]") {
  tests::Random random(22);
  for (int i = 1; i <= 100; ++i) {
    const RigidBodyState state = random_state(random);
    const Vec3 wanted = random.vector(2.0);
    const Vec3 p = state.position + turned(state.world_from_body, wanted);
    trial("1.2 body_point", state, i, 100)
        .given("point", p)
        .expect(body_point(state, p), wanted, rounding(2.0 * state.position.norm() + p.norm()),
                suspects_of_body_point(state, p));
  }
}

TEST_CASE("The centre of mass is the origin of the body frame", "[1.2]") {
  tests::Random random(23);
  const RigidBodyState state = random_state(random);
  const tests::Bound a_few_ulp = rounding(state.position.norm());
  trial("1.2 world_point", state)
      .given("point_body", Vec3(Vec3::Zero()))
      .expect(world_point(state, Vec3::Zero()), state.position, a_few_ulp,
              suspects_of_world_point(state, Vec3::Zero()));
  trial("1.2 body_point", state)
      .given("point", state.position)
      .expect(body_point(state, state.position), Vec3(Vec3::Zero()), a_few_ulp,
              suspects_of_body_point(state, state.position));
}

TEST_CASE("Far from the origin a body point is as exact as the difference of the points", "[1.2]") {
  tests::Random random(24);
  RigidBodyState state = random_state(random);
  state.position = {1e9, -2e9, 3e9};
  const Vec3 p = state.position + Vec3(1.0, 2.0, -4.0);  // exact: the spacing there is 2^-22
  const Vec3 wanted = turned_back(state.world_from_body, Vec3(1.0, 2.0, -4.0));
  trial("1.2 body_point", state)
      .given("point", p)
      .expect(body_point(state, p), wanted,
              {16.0 * eps * 5.0,
               "p - x is exact here, so only the turn rounds; R^T p - R^T x loses "
               "nine digits"},
              suspects_of_body_point(state, p));
}

TEST_CASE("A spin about z carries a point on the x side along y", "[1.2]") {
  const RigidBodyState state = quarter_turned();
  const Vec3 p(2.0, 2.0, 3.0);
  velocity_trial(state, p).expect(point_velocity(state, p), Vec3(0.0, 2.0, 1.0), rounding(4.0),
                                  suspects_of_velocity(state, p));
}

TEST_CASE("The velocity of a material point is that of the centre and omega cross r", "[1.2]") {
  tests::Random random(25);
  for (int i = 1; i <= 100; ++i) {
    const RigidBodyState state = random_state(random);
    const Vec3 p = random.vector(4.0);
    const Vec3 r = p - state.position;
    const Vec3& w = state.angular_velocity;
    const Vec3 wanted =
        state.velocity + Vec3(w.y() * r.z() - w.z() * r.y(), w.z() * r.x() - w.x() * r.z(),
                              w.x() * r.y() - w.y() * r.x());
    velocity_trial(state, p, i, 100)
        .expect(point_velocity(state, p), wanted,
                rounding(state.velocity.norm() + w.norm() * (p.norm() + state.position.norm())),
                suspects_of_velocity(state, p));
  }
}

TEST_CASE("The velocity of a point is the rate at which it moves", "[1.2]") {
  // A central difference of x + v t + exp(omega t) R p over 2h errs by h² |omega|³ |p| / 6 and, by
  // rounding, by eps (|x| + |p|) / h.
  tests::Random random(26);
  const double h = 1e-5;
  for (int i = 1; i <= 20; ++i) {
    const RigidBodyState state = random_state(random);
    const Vec3 r = random.vector(2.0);
    const double speed = state.angular_velocity.norm();
    const Vec3 axis = state.angular_velocity / speed;
    const auto moved = [&](double t) {
      return Vec3(state.position + t * state.velocity +
                  turned(tests::rotation(speed * t, axis), r));
    };
    const Vec3 wanted = (moved(h) - moved(-h)) / (2.0 * h);
    const Vec3 p = state.position + r;
    velocity_trial(state, p, i, 20)
        .expect(point_velocity(state, p), wanted,
                {h * h * std::pow(speed, 3) * r.norm() + 8.0 * eps * (5.2 + r.norm()) / h,
                 "a central difference of the moving point, h = 1e-5"},
                suspects_of_velocity(state, p));
  }
}

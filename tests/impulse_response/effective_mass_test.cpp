#include "bodies.hpp"
#include "catch.hpp"

using namespace lab::impulse_response;
using tests::eps;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

Trial mass_trial(const RigidBody& a, const RigidBody& b, const Vec3& point, int index, int count) {
  return tests::trial_of("6.5 inverse_effective_mass", index, count)
      .given("a", tests::Code{tests::text_of(a)})
      .given("b", tests::Code{tests::text_of(b)})
      .given("point", point);
}

void expect_K(const RigidBody& a, const RigidBody& b, const Vec3& point, int index, int count) {
  const Mat3 wanted = tests::mass_matrix(a, b, point).cast<double>();
  const double size = a.inverse_mass + b.inverse_mass +
                      a.inverse_inertia.norm() * (point - a.position).squaredNorm() +
                      b.inverse_inertia.norm() * (point - b.position).squaredNorm() +
                      (a.inverse_inertia.norm() + b.inverse_inertia.norm()) * point.norm() * 4.0;
  mass_trial(a, b, point, index, count)
      .expect(inverse_effective_mass(a, b, point), wanted,
              {32.0 * eps * size, "two products of 3 x 3 matrices per body"});
}

Trial trial_of_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point, int index,
                       int count) {
  return tests::trial_of("6.5 with_impulse", index, count)
      .given("body", tests::Code{tests::text_of(body)})
      .given("impulse", impulse)
      .given("point", point);
}

void expect_body(const RigidBody& body, const Vec3& j, const Vec3& point, int index, int count) {
  const RigidBody wanted = tests::body_after(body, j, point);
  const RigidBody got = with_impulse(body, j, point);
  const Trial trial = trial_of_impulse(body, j, point, index, count);
  trial.of("the velocity")
      .expect(got.velocity, wanted.velocity,
              {8.0 * eps * (1.0 + 4.0 * j.norm()), "a product and a sum"});
  trial.of("the angular velocity")
      .expect(got.angular_velocity, wanted.angular_velocity,
              {64.0 * eps * (1.0 + body.inverse_inertia.norm() * j.norm() * (4.0 + point.norm())),
               "a cross product and a product with a matrix"});
  trial.of("the position").expect(got.position, body.position, {0.0, "an impulse moves nothing"});
  trial.of("the inverse mass")
      .expect(got.inverse_mass, body.inverse_mass, {0.0, "it stays the same"});
  trial.of("the inverse inertia")
      .expect(got.inverse_inertia, body.inverse_inertia, {0.0, "it stays the same"});
}

}  // namespace

TEST_CASE("K of a ball on the ground is worked by hand", "[6.5]") {
  // 1/m = 1/2 and r = (0, 0, -1) with 1/I = 4: across r a unit impulse turns it by 4.
  RigidBody ball;
  ball.inverse_mass = 0.5;
  ball.inverse_inertia = 4.0 * Mat3::Identity();
  ball.position = Vec3(7.0, 3.0, 1.0);
  const Vec3 point(7.0, 3.0, 0.0);
  mass_trial(tests::ground(), ball, point, 1, 1)
      .expect(inverse_effective_mass(tests::ground(), ball, point),
              Mat3(Vec3(4.5, 4.5, 0.5).asDiagonal()), {0.0, "small whole numbers"});
}

TEST_CASE("K is right for any two bodies", "[6.5]") {
  tests::Random random(671);
  for (int i = 1; i <= 100; ++i) {
    const tests::ContactInput in = tests::random_contact(random, i);
    expect_K(in.a, in.b, in.contact.point, i, 100);
  }
}

TEST_CASE("K times an impulse is the change of the relative velocity", "[6.5]") {
  tests::Random random(672);
  for (int i = 1; i <= 50; ++i) {
    const tests::ContactInput in = tests::random_contact(random, i);
    const Vec3& p = in.contact.point;
    const Vec3 j = random.vector(2.0);
    tests::RigidBody a = in.a;
    tests::RigidBody b = in.b;
    a.velocity -= a.inverse_mass * j;
    b.velocity += b.inverse_mass * j;
    a.angular_velocity -= a.inverse_inertia * (p - a.position).cross(j);
    b.angular_velocity += b.inverse_inertia * (p - b.position).cross(j);
    const Vec3 wanted = tests::narrow(tests::approach(a, b, p) - tests::approach(in.a, in.b, p));
    mass_trial(in.a, in.b, p, i, 50)
        .of("K j")
        .expect(
            Vec3(inverse_effective_mass(in.a, in.b, p) * j), wanted,
            {128.0 * eps * (4.0 + 40.0 * j.norm()), "some 50 operations; inertias are below 8"});
  }
}

TEST_CASE("K is symmetric and the same for either order of the bodies", "[6.5]") {
  tests::Random random(673);
  for (int i = 1; i <= 20; ++i) {
    const tests::ContactInput in = tests::random_contact(random, i);
    const Vec3& p = in.contact.point;
    const Mat3 K = inverse_effective_mass(in.a, in.b, p);
    const tests::Bound rounding{32.0 * eps * 100.0, "two products of 3 x 3 matrices per body"};
    mass_trial(in.a, in.b, p, i, 20).of("K transposed").expect(K, Mat3(K.transpose()), rounding);
    mass_trial(in.b, in.a, p, i, 20)
        .of("K of b and a")
        .expect(inverse_effective_mass(in.b, in.a, p), K, rounding);
  }
}

TEST_CASE("Two immovable bodies have a K of zero", "[6.5]") {
  const Vec3 point(1.0, 2.0, 3.0);
  mass_trial(tests::ground(), tests::ground(), point, 1, 1)
      .expect(inverse_effective_mass(tests::ground(), tests::ground(), point), Mat3(Mat3::Zero()),
              {0.0, "everything is zero"});
}

TEST_CASE("An impulse beside the centre moves and turns the body", "[6.5]") {
  RigidBody body;
  body.inverse_mass = 0.5;
  body.inverse_inertia = Vec3(1.0, 2.0, 4.0).asDiagonal();
  body.position = Vec3(5.0, 0.0, 0.0);
  const RigidBody got = with_impulse(body, Vec3(0.0, 3.0, 0.0), Vec3(7.0, 0.0, 0.0));
  const Trial trial = trial_of_impulse(body, Vec3(0.0, 3.0, 0.0), Vec3(7.0, 0.0, 0.0), 1, 1);
  const tests::Bound exact{0.0, "small whole numbers"};
  trial.of("the velocity").expect(got.velocity, Vec3(0.0, 1.5, 0.0), exact);
  trial.of("the angular velocity").expect(got.angular_velocity, Vec3(0.0, 0.0, 24.0), exact);
}

TEST_CASE("A hinged body cannot be moved but turns", "[6.5]") {
  RigidBody hinged;
  hinged.inverse_mass = 0.0;
  RigidBody ball;
  ball.position = Vec3(1.0, 0.0, 0.0);
  const Vec3 point(1.0, 0.0, 0.0);
  const tests::Bound exact{0.0, "small whole numbers"};
  const Mat3 wanted = Vec3(1.0, 2.0, 2.0).asDiagonal().toDenseMatrix();
  mass_trial(hinged, ball, point, 1, 2)
      .expect(inverse_effective_mass(hinged, ball, point), wanted, exact);
  mass_trial(ball, hinged, point, 2, 2)
      .expect(inverse_effective_mass(ball, hinged, point), wanted, exact);
  const Vec3 impulse(0.0, 3.0, 0.0);
  const RigidBody got = with_impulse(hinged, impulse, point);
  const Trial trial = trial_of_impulse(hinged, impulse, point, 1, 1);
  trial.of("the velocity").expect(got.velocity, Vec3(0.0, 0.0, 0.0), exact);
  trial.of("the angular velocity").expect(got.angular_velocity, Vec3(0.0, 0.0, 3.0), exact);
}

TEST_CASE("Even a very small impulse acts", "[6.5]") {
  RigidBody body;
  body.inverse_mass = 0.5;
  body.inverse_inertia = Vec3(1.0, 2.0, 4.0).asDiagonal();
  body.position = Vec3(5.0, 0.0, 0.0);
  int index = 0;
  for (const double size : {1e-3, 1e-9, 1e-12, 1e-15, 1e-90}) {
    const Vec3 impulse(0.0, 3.0 * size, 0.0);
    const Vec3 point(7.0, 0.0, 0.0);
    const RigidBody got = with_impulse(body, impulse, point);
    const Trial trial = trial_of_impulse(body, impulse, point, ++index, 5);
    const tests::Bound bound{4.0 * eps * 24.0 * size, "two products"};
    trial.of("the velocity").expect(got.velocity, Vec3(0.0, 1.5 * size, 0.0), bound);
    trial.of("the angular velocity")
        .expect(got.angular_velocity, Vec3(0.0, 0.0, 24.0 * size), bound);
  }
}

TEST_CASE("K is right for very heavy and very light bodies", "[6.5]") {
  int index = 0;
  for (const double size : {1e-90, 1e-12, 1e-9, 1e9, 1e12, 1e90}) {
    RigidBody ball;
    ball.inverse_mass = 0.5 * size;
    ball.inverse_inertia = 4.0 * size * Mat3::Identity();
    ball.position = Vec3(7.0, 3.0, 1.0);
    const Vec3 point(7.0, 3.0, 0.0);
    mass_trial(tests::ground(), ball, point, ++index, 6)
        .expect(inverse_effective_mass(tests::ground(), ball, point),
                Mat3(size * Vec3(4.5, 4.5, 0.5).asDiagonal().toDenseMatrix()),
                {16.0 * eps * size, "products and sums of size one"});
  }
}

TEST_CASE("An impulse acts on any body as momentum and angular momentum", "[6.5]") {
  tests::Random random(674);
  for (int i = 1; i <= 100; ++i) {
    RigidBody body = tests::random_body(random);
    if (i % 10 == 0) body = tests::ground();
    const Vec3 impulse = random.vector(2.0);
    expect_body(body, impulse, random.vector(2.0), i, 100);
  }
}

TEST_CASE("An impulse and its opposite keep both momenta of two bodies", "[6.5]") {
  tests::Random random(675);
  for (int i = 1; i <= 50; ++i) {
    const RigidBody a = tests::random_body(random);
    const RigidBody b = tests::random_body(random);
    const Vec3 impulse = random.vector(2.0);
    const Vec3 point = random.vector(2.0);
    const auto momentum = [](const RigidBody& body) {
      return VecL(wide(body.velocity) / wide(body.inverse_mass));
    };
    const auto about_origin = [&](const RigidBody& body) {
      const tests::MatL inertia = body.inverse_inertia.cast<tests::Real>().inverse();
      return VecL(wide(body.position).cross(momentum(body)) +
                  inertia * wide(body.angular_velocity));
    };
    const RigidBody a_after = with_impulse(a, -impulse, point);
    const RigidBody b_after = with_impulse(b, impulse, point);
    const Trial trial = trial_of_impulse(b, impulse, point, i, 50);
    trial.of("the momentum of both")
        .expect(tests::narrow(momentum(a_after) + momentum(b_after)),
                tests::narrow(momentum(a) + momentum(b)),
                {128.0 * eps * 5.0 * 10.0, "velocities err by eps 10, masses are at most 5"});
    trial.of("the angular momentum of both about the world's origin")
        .expect(
            tests::narrow(about_origin(a_after) + about_origin(b_after)),
            tests::narrow(about_origin(a) + about_origin(b)),
            {128.0 * eps * 5.0 * 200.0, "the same bound, with lever arms; spins are below 200"});
  }
}

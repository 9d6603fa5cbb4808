// Step 7.1: contacts as numbers.
#include "bodies.hpp"
#include "catch.hpp"

using namespace lab::multi_contact;
using tests::Bodies;
using tests::eps;
using tests::Trial;

namespace {

Trial trial_of_system(const Bodies& in, int index = 1, int count = 1) {
  return tests::bodies_trial("7.1 contact_system", in, index, count);
}

ContactSystem system_by_answer(const Trial& trial, const Bodies& in) {
  return trial.returned([&] { return contact_system(in.bodies, in.contacts); });
}

void expect_system(const Trial& trial, const ContactSystem& got, const ContactSystem& wanted,
                   const tests::Bound& of_A, const tests::Bound& of_u) {
  trial.of("u").expect(got.u, wanted.u, of_u);
  trial.of("A").expect(got.A, wanted.A, of_A);
}

/// To the bits, or to a rounding or two where masses are no powers of two.
void expect_pinned(const Bodies& in, const Matrix& A, const Vector& u, double rounding = 0.0) {
  const tests::Bound bound{
      rounding, rounding == 0.0 ? "small whole numbers" : "a mass of 3 is rounded once, and a sum"};
  const Trial trial = trial_of_system(in);
  expect_system(trial, system_by_answer(trial, in), {A, u}, bound, bound);
}

tests::Bound rounding_of_A(const Bodies& in) {
  return {64.0 * eps * tests::size_of_A(in) * static_cast<double>(in.contacts.size()),
          "two cross products and a product with a matrix for each of two bodies"};
}
tests::Bound rounding_of_u(const Bodies& in) {
  return {32.0 * eps * tests::size_of_u(in) * static_cast<double>(in.contacts.size()),
          "a cross product and a dot product for each of two bodies"};
}

}  // namespace

TEST_CASE("The system of balls in a row and in a column is worked by hand", "[7.1]") {
  expect_pinned(tests::row_of_balls_as_bodies(Vector::Ones(3), Vector{{1.0, 0.0, 0.0}}),
                Matrix{{2.0, -1.0}, {-1.0, 2.0}}, Vector{{-1.0, 0.0}});
  expect_pinned(tests::column_as_bodies(Vector{{3.0, 1.0}}, Vector{{-1.0, -1.0}}),
                Matrix{{1.0 / 3.0, -1.0 / 3.0}, {-1.0 / 3.0, 4.0 / 3.0}}, Vector{{-1.0, 0.0}},
                2.0 * eps);
}

TEST_CASE("The system of a rod and of a table is worked by hand", "[7.1]") {
  expect_pinned(tests::rod_as_bodies(1.0 / 3.0, -1.0, 1.0), Matrix{{4.0, -2.0}, {-2.0, 4.0}},
                Vector{{-2.0, 0.0}}, 8.0 * eps);
  expect_pinned(tests::table_as_bodies(Vector{{-1.0, -0.5, -0.5}}),
                Matrix{{7.0, 1.0, 1.0, -5.0},
                       {1.0, 7.0, -5.0, 1.0},
                       {1.0, -5.0, 7.0, 1.0},
                       {-5.0, 1.0, 1.0, 7.0}},
                Vector{{-2.0, -1.0, -1.0, 0.0}});
}

TEST_CASE("The system is that of any bodies and contacts", "[7.1]") {
  tests::Random random(711);
  for (int i = 1; i <= 40; ++i) {
    const Bodies in = tests::random_bodies(random, i % 2 == 0);
    const Trial trial = trial_of_system(in, i, 40);
    expect_system(trial, system_by_answer(trial, in), tests::system_of(in), rounding_of_A(in),
                  rounding_of_u(in));
  }
}

TEST_CASE("Contacts that share no body do not notice each other", "[7.1]") {
  tests::Random random(713);
  Bodies in = tests::random_bodies(random, false);
  const Vec3 n = Vec3::UnitX();
  // Bodies 0 and 1, then 2 and 3, then 1 and 2, which links them; 4 touches nothing.
  in.contacts = {
      {0, 1, random.vector(), n}, {2, 3, random.vector(), n}, {1, 2, random.vector(), n}};
  const Trial trial = trial_of_system(in);
  const ContactSystem got = system_by_answer(trial, in);
  expect_system(trial, got, tests::system_of(in), rounding_of_A(in), rounding_of_u(in));
  trial.of("A between two pairs of bodies").expect(got.A(0, 1), 0.0, {0.0, "a sum of nothing"});
  trial.of("A between two pairs of bodies").expect(got.A(1, 0), 0.0, {0.0, "a sum of nothing"});
}

TEST_CASE("Which body comes first does not matter if the normal turns with it", "[7.1]") {
  tests::Random random(714);
  for (int i = 1; i <= 10; ++i) {
    const Bodies in = tests::random_bodies(random, true);
    Bodies turned = in;
    for (Contact& c : turned.contacts) c = {c.b, c.a, c.point, -c.normal};
    const Trial trial = trial_of_system(turned, i, 10);
    expect_system(trial, system_by_answer(trial, turned), tests::system_of(in), rounding_of_A(in),
                  rounding_of_u(in));
  }
}

TEST_CASE("Two contacts of one pair count each by itself", "[7.1]") {
  // Ball and ball, once in line with the centres and once beside: the first does not turn them.
  Bodies in = tests::row_of_balls_as_bodies(Vector::Ones(2), Vector{{1.0, 0.0}});
  in.bodies[1].inverse_inertia *= 4.0;
  in.contacts.push_back({1, 0, Vec3(0.5, 0.5, 0.0), -Vec3::UnitX()});
  in.contacts.push_back({0, 1, Vec3(0.5, 0.5, 0.0), Vec3::UnitX()});
  // Beside by 1/2: 1 + 1 of the masses, and (1 + 4)/4 of the inertias.
  expect_pinned(in, Matrix{{2.0, 2.0, 2.0}, {2.0, 3.25, 3.25}, {2.0, 3.25, 3.25}},
                Vector{{-1.0, -1.0, -1.0}});
}

TEST_CASE("Where the world has its origin does not matter", "[7.1]") {
  Bodies in = tests::rod_as_bodies(0.25, -1.0, 1.0);
  const Vec3 far_away(0x1p20, -0x1p22, 0x1p21);
  for (RigidBody& body : in.bodies) body.position += far_away;
  for (Contact& c : in.contacts) c.point += far_away;
  expect_pinned(in, Matrix{{5.0, -3.0}, {-3.0, 5.0}}, Vector{{-2.0, 0.0}});
}

TEST_CASE("A hinged body yields by turning alone and a wall may move", "[7.1]") {
  Bodies in = tests::rod_as_bodies(0.25, -1.0, 1.0);
  in.bodies[0].inverse_mass = 1.0;  // the ground is a free body, and the rod is hinged
  in.bodies[1].inverse_mass = 0.0;
  expect_pinned(in, Matrix{{5.0, -3.0}, {-3.0, 5.0}}, Vector{{-2.0, 0.0}});
  Bodies moving = tests::column_as_bodies(Vector{{1.0}}, Vector{{-1.0}});
  moving.bodies[0].velocity = Vec3(5.0, 5.0, 2.0);
  moving.bodies[0].angular_velocity = Vec3(0.0, 4.0, 0.0);
  moving.contacts[0].point = Vec3(0.5, 0.0, 0.0);
  // The wall's point moves at 2 − 4/2; the ball is hit beside its centre by 1/2.
  expect_pinned(moving, Matrix{{1.25}}, Vector{{-1.0}});
}

TEST_CASE("However heavy or fast bodies are the system has their size", "[7.1]") {
  int index = 0;
  for (const double size : {1e-100, 1e-50, 1e-12, 1e12, 1e50, 1e100}) {
    Bodies in = tests::rod_as_bodies(0.25, -1.0, 1.0);
    in.bodies[1].inverse_mass *= size;
    in.bodies[1].inverse_inertia *= size;
    in.bodies[1].velocity /= size;
    in.bodies[1].angular_velocity /= size;
    const Trial trial = trial_of_system(in, ++index, 6);
    expect_system(trial, system_by_answer(trial, in),
                  {size * Matrix{{5.0, -3.0}, {-3.0, 5.0}}, Vector{{-2.0, 0.0}} / size},
                  {32.0 * eps * size, "products and sums of size one"},
                  {16.0 * eps / size, "products and sums of size one"});
  }
}

TEST_CASE("A normal that is rounded and no contacts at all are taken", "[7.1]") {
  Bodies in = tests::column_as_bodies(Vector{{1.0}}, Vector{{-2.0}});
  in.bodies[1].inverse_inertia = Mat3::Identity();
  in.bodies[1].inverse_inertia(0, 1) = 4e-10;  // symmetric to 1e-9 of the largest entry
  in.contacts[0].normal = Vec3(0.0, 0.0, 1.0 + 4e-10);
  const tests::Bound bound{2e-9, "a normal is of length one to 1e-9"};
  const Trial trial = trial_of_system(in);
  expect_system(trial, system_by_answer(trial, in), {Matrix{{1.0}}, Vector{{-2.0}}}, bound, bound);

  const Bodies nothing_touches{in.bodies, {}};
  const Trial empty = trial_of_system(nothing_touches);
  expect_system(empty, system_by_answer(empty, nothing_touches), {Matrix(0, 0), Vector(0)},
                tests::exact, tests::exact);
  const Trial nobody = trial_of_system({});
  expect_system(nobody, system_by_answer(nobody, {}), {Matrix(0, 0), Vector(0)}, tests::exact,
                tests::exact);
}

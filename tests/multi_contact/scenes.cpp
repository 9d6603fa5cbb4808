#include "scenes.hpp"

namespace tests {
namespace {

Vector inverse(const Vector& masses) { return masses.cwiseInverse(); }

Contact contact(int a, int b, const common::Vec3& point, const common::Vec3& normal) {
  return {a, b, point, normal};
}

const Matrix& legs() {
  static const Matrix at{{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}};
  return at;
}

}  // namespace

ContactSystem Scene::system() const {
  const Matrix weighted = W.asDiagonal() * J.transpose();
  return {J.lazyProduct(weighted), common::product(J, v)};
}
Vector Scene::after(const Vector& lambda) const {
  return v + W.cwiseProduct(common::product(J.transpose(), lambda));
}
double Scene::energy(const Vector& velocities) const {
  return 0.5 * velocities.cwiseQuotient(W).dot(velocities);
}
double Scene::momentum(const Vector& velocities) const { return velocities.cwiseQuotient(W).sum(); }
Scene Scene::backwards() const { return {J.colwise().reverse(), W, v}; }

Scene row_of_balls(const Vector& masses, const Vector& velocities) {
  const Eigen::Index m = masses.size() - 1;
  Scene scene{Matrix::Zero(m, m + 1), inverse(masses), velocities};
  for (Eigen::Index i = 0; i < m; ++i) {
    scene.J(i, i) = -1.0;
    scene.J(i, i + 1) = 1.0;
  }
  return scene;
}

Scene cradle(const Vector& velocities) {
  return row_of_balls(Vector::Ones(velocities.size()), velocities);
}

Scene column(const Vector& masses, const Vector& velocities) {
  Scene scene{Matrix::Identity(masses.size(), masses.size()), inverse(masses), velocities};
  for (Eigen::Index i = 1; i < masses.size(); ++i) scene.J(i, i - 1) = -1.0;
  return scene;
}

Scene rod(double inertia, double upwards, double w) {
  return {Matrix{{1.0, -1.0}, {1.0, 1.0}}, Vector{{1.0, 1.0 / inertia}}, Vector{{upwards, w}}};
}

Scene dumb_bell() { return rod(3.0, -1.25, 0.75); }

Scene table(const Vector& velocities) {
  Scene scene{Matrix::Ones(4, 3), Vector{{1.0, 3.0, 3.0}}, velocities};
  scene.J.rightCols(2) = legs();
  return scene;
}

Scene break_shot() {
  return {Matrix{{-0.8, -0.6, 0.8, 0.6, 0.0, 0.0}, {-0.8, 0.6, 0.0, 0.0, 0.8, -0.6}},
          Vector::Ones(6), Vector{{1.0, 0.0, 0.0, 0.0, 0.0, 0.0}}};
}

Scene wedge(const Vector& first_normal, const Vector& second_normal, const Vector& velocity) {
  Scene scene{Matrix(2, 2), Vector::Ones(2), velocity};
  scene.J.row(0) = first_normal;
  scene.J.row(1) = second_normal;
  return scene;
}

Scene jammed_ball() { return {Matrix{{1.0}, {-1.0}}, Vector::Ones(1), Vector{{-1.0}}}; }

Scene counting_pi(double mass_ratio) {
  return column(Vector{{1.0, mass_ratio}}, Vector{{0.0, -1.0}});
}

RigidBody immovable() {
  RigidBody body;
  body.inverse_mass = 0.0;
  body.inverse_inertia = common::Mat3::Zero();
  return body;
}

Bodies row_of_balls_as_bodies(const Vector& masses, const Vector& velocities) {
  Bodies row;
  for (int i = 0; i < masses.size(); ++i) {
    RigidBody ball;
    ball.inverse_mass = 1.0 / masses[i];
    ball.position.x() = i;
    ball.velocity.x() = velocities[i];
    row.bodies.push_back(ball);
    if (i == 0) continue;
    row.contacts.push_back(contact(i - 1, i, {i - 0.5, 0.0, 0.0}, common::Vec3::UnitX()));
  }
  return row;
}

Bodies column_as_bodies(const Vector& masses, const Vector& velocities) {
  Bodies stack{{immovable()}, {}};
  for (int i = 0; i < masses.size(); ++i) {
    RigidBody ball;
    ball.inverse_mass = 1.0 / masses[i];
    ball.position.z() = i + 0.5;
    ball.velocity.z() = velocities[i];
    stack.bodies.push_back(ball);
    stack.contacts.push_back(
        contact(i, i + 1, {0.0, 0.0, static_cast<double>(i)}, common::Vec3::UnitZ()));
  }
  return stack;
}

Bodies rod_as_bodies(double inertia, double upwards, double w) {
  RigidBody body;
  body.inverse_inertia = common::Mat3::Identity() / inertia;
  body.position = {0.0, 0.0, 0.25};
  body.velocity.z() = upwards;
  body.angular_velocity.y() = -w;
  return {{immovable(), body},
          {contact(0, 1, {-1.0, 0.0, 0.0}, common::Vec3::UnitZ()),
           contact(0, 1, {1.0, 0.0, 0.0}, common::Vec3::UnitZ())}};
}

Bodies table_as_bodies(const Vector& velocities) {
  RigidBody body;
  body.inverse_inertia = 3.0 * common::Mat3::Identity();
  body.position = {0.0, 0.0, 1.0};
  body.velocity.z() = velocities[0];
  // A leg at (x, y) rises by ω_x y − ω_y x.
  body.angular_velocity = {velocities[2], -velocities[1], 0.0};
  Bodies all{{immovable(), body}, {}};
  for (int i = 0; i < 4; ++i) {
    all.contacts.push_back(contact(0, 1, {legs()(i, 0), legs()(i, 1), 0.0}, common::Vec3::UnitZ()));
  }
  return all;
}

}  // namespace tests

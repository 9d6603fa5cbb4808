#include "judged.hpp"

namespace tests {

Vector random_vector(Random& random, Eigen::Index count, double size) {
  Vector v(count);
  for (double& x : v) x = random.uniform(-size, size);
  return v;
}

ContactSystem random_system(Random& random, Eigen::Index contacts) {
  Matrix J(contacts, 2 * contacts);
  for (double& x : J.reshaped()) x = random.uniform(-1.0, 1.0);
  Matrix A = J.lazyProduct(J.transpose());
  A = (0.5 * (A + A.transpose())).eval();
  A.diagonal().array() += 0.25;
  Vector u(contacts);
  for (double& x : u) x = random.uniform(-2.0, 1.0);
  return {A, u};
}

Vector reordered(const Vector& v, const std::vector<int>& order) { return v(order); }

ContactSystem reordered(const ContactSystem& system, const std::vector<int>& order) {
  return {system.A(order, order), system.u(order)};
}

std::string text_of(const RigidBody& b) {
  return "RigidBody{" + text(b.inverse_mass) + ", " + text(b.inverse_inertia) + ", " +
         text(b.position) + ", " + text(b.velocity) + ", " + text(b.angular_velocity) + "}";
}

Code code_of(const std::vector<RigidBody>& bodies) {
  std::string words;
  for (const RigidBody& body : bodies) words += (words.empty() ? "" : ", ") + text_of(body);
  return {"std::vector<RigidBody>{" + words + "}"};
}

Code code_of(const std::vector<Contact>& contacts) {
  std::string words;
  for (const Contact& c : contacts) {
    words += (words.empty() ? "Contact{" : ", Contact{") + std::to_string(c.a) + ", " +
             std::to_string(c.b) + ", " + text(c.point) + ", " + text(c.normal) + "}";
  }
  return {"std::vector<Contact>{" + words + "}"};
}

}  // namespace tests

// Returns NaN everywhere: every test must fail it, and say that the value is not finite. Where
// there are no contacts an answer has no numbers.
#include <limits>
#include <stdexcept>

#include "multi_contact.hpp"

namespace lab::multi_contact {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Vector nan_vector(const Vector& like) {
  if (like.size() == 0) throw std::domain_error("not a number");
  return Vector::Constant(like.size(), nan);
}

}  // namespace

ContactSystem contact_system(const std::vector<RigidBody>&, const std::vector<Contact>& contacts) {
  const auto m = static_cast<Eigen::Index>(contacts.size());
  return {Matrix::Constant(m, m, nan), nan_vector(Vector(m))};
}
std::vector<RigidBody> with_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<Contact>&, const Vector&) {
  if (bodies.empty()) throw std::domain_error("not a number");
  const Vec3 none = Vec3::Constant(nan);
  return std::vector<RigidBody>(bodies.size(), {nan, Mat3::Constant(nan), none, none, none});
}
double energy_gained(const ContactSystem&, const Vector&) { return nan; }
Impulses sequential_impulses(const ContactSystem& system, double, int) {
  return {nan_vector(system.u)};
}
Vector gauss_seidel(const Matrix&, const Vector& b, const Vector&, int) { return nan_vector(b); }
double residual(const Matrix&, const Vector&, const Vector&) { return nan; }
Vector simultaneous_impulses(const ContactSystem& system, double) { return nan_vector(system.u); }
Impulses generalized_reflections(const ContactSystem& system, double, int) {
  return {nan_vector(system.u)};
}
Impulses inelastic_projection(const ContactSystem& system) { return {nan_vector(system.u)}; }
Vec2 limited(const Vec2&, double, FrictionRule) { return Vec2::Constant(nan); }
Vector friction_sweeps(const Matrix&, const Vector& b, const Vector&, double, FrictionRule, int) {
  return nan_vector(b);
}
double coulomb_residual(const Matrix&, const Vector&, const Vector&, double) { return nan; }
Vector accelerated(const Matrix&, const Vector& b, int) { return nan_vector(b); }

}  // namespace lab::multi_contact

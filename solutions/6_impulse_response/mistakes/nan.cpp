// Returns NaN everywhere: every test must fail it, and say that the value is not finite.
#include <limits>

#include "impulse_response.hpp"

namespace lab::impulse_response {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 nan_vector = Vec3::Constant(nan);
const Mat3 nan_matrix = Mat3::Constant(nan);
const Particle nan_particle{nan, nan_vector, nan_vector};

}  // namespace

double normal_impulse(double, const Vec3&, const Vec3&, double) { return nan; }
Vec3 friction_impulse(double, const Vec3&, const Vec3&, double, double) { return nan_vector; }
Vec3 normal_correction(double, const Vec3&) { return nan_vector; }
Vec3 tangential_correction(const Vec3&, const Vec3&, double, double) { return nan_vector; }
ProjectedStep step_by_projection(const Particle&, const Obstacle&, const Material&, const Vec3&,
                                 double, const Corrections&) {
  return {nan_particle, nan_vector};
}
ImpactStep step_to_impact(const Particle&, const Obstacle&, const Material&, const Vec3&, double,
                          int) {
  return {nan_particle, {{nan, nan_vector}}, nan};
}
Mat3 inverse_effective_mass(const RigidBody&, const RigidBody&, const Vec3&) { return nan_matrix; }
Vec3 contact_impulse(const RigidBody&, const RigidBody&, const Contact&, const Material&) {
  return nan_vector;
}
RigidBody with_impulse(const RigidBody&, const Vec3&, const Vec3&) {
  return {nan, nan_matrix, nan_vector, nan_vector, nan_vector};
}

}  // namespace lab::impulse_response

#include "proxy.hpp"

#include "remote.hpp"

namespace lab::impulse_response {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

double normal_impulse(double mass, const Vec3& velocity, const Vec3& normal, double restitution) {
  return remote<&impulse_response::normal_impulse>(mass, velocity, normal, restitution);
}
Vec3 friction_impulse(double mass, const Vec3& velocity, const Vec3& normal, double normal_impulse,
                      double friction) {
  return remote<&impulse_response::friction_impulse>(mass, velocity, normal, normal_impulse,
                                                     friction);
}
Vec3 normal_correction(double gap, const Vec3& normal) {
  return remote<&impulse_response::normal_correction>(gap, normal);
}
Vec3 tangential_correction(const Vec3& displacement, const Vec3& normal, double normal_length,
                           double friction) {
  return remote<&impulse_response::tangential_correction>(displacement, normal, normal_length,
                                                          friction);
}
ProjectedStep step_by_projection(const Particle& particle, const Obstacle& obstacle,
                                 const Material& material, const Vec3& gravity, double dt,
                                 const Corrections& corrections) {
  return remote<&impulse_response::step_by_projection>(particle, obstacle, material, gravity, dt,
                                                       corrections);
}
ImpactStep step_to_impact(const Particle& particle, const Obstacle& obstacle,
                          const Material& material, const Vec3& gravity, double dt,
                          int max_impacts) {
  return remote<&impulse_response::step_to_impact>(particle, obstacle, material, gravity, dt,
                                                   max_impacts);
}
Mat3 inverse_effective_mass(const RigidBody& a, const RigidBody& b, const Vec3& point) {
  return remote<&impulse_response::inverse_effective_mass>(a, b, point);
}
Vec3 contact_impulse(const RigidBody& a, const RigidBody& b, const Contact& contact,
                     const Material& material) {
  return remote<&impulse_response::contact_impulse>(a, b, contact, material);
}
RigidBody with_impulse(const RigidBody& body, const Vec3& impulse, const Vec3& point) {
  return remote<&impulse_response::with_impulse>(body, impulse, point);
}

}  // namespace lab::impulse_response

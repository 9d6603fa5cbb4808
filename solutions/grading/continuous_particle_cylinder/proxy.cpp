#include "proxy.hpp"

#include "remote.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

std::optional<double> time_of_impact_textbook(const MovingParticle& particle,
                                              const Cylinder& cylinder, double dt) {
  return remote<&continuous_particle_cylinder::time_of_impact_textbook>(particle, cylinder, dt);
}
double difference_of_products(double a, double b, double c, double d) {
  return remote<&continuous_particle_cylinder::difference_of_products>(a, b, c, d);
}
std::optional<double> time_of_impact(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt) {
  return remote<&continuous_particle_cylinder::time_of_impact>(particle, cylinder, dt);
}
std::optional<double> time_of_impact_certified(const MovingParticle& particle,
                                               const Cylinder& cylinder, double dt) {
  return remote<&continuous_particle_cylinder::time_of_impact_certified>(particle, cylinder, dt);
}
Advancement conservative_advancement(const MovingParticle& particle, const Cylinder& cylinder,
                                     double dt, double tolerance) {
  return remote<&continuous_particle_cylinder::conservative_advancement>(particle, cylinder, dt,
                                                                         tolerance);
}
ParticleContact contact_at(const MovingParticle& particle, const Cylinder& cylinder, double time) {
  return remote<&continuous_particle_cylinder::contact_at>(particle, cylinder, time);
}
std::vector<double> times_of_impact(const MovingParticles& particles, const Cylinder& cylinder,
                                    double dt) {
  return remote<&continuous_particle_cylinder::times_of_impact>(particles, cylinder, dt);
}
std::optional<double> time_of_impact_of_edge(const MovingEdge& edge, const Cylinder& cylinder,
                                             double dt) {
  return remote<&continuous_particle_cylinder::time_of_impact_of_edge>(edge, cylinder, dt);
}

}  // namespace lab::continuous_particle_cylinder

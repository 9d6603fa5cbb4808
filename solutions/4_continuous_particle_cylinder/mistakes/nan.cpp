// Returns NaN everywhere: every test must fail it, and say that the value is not finite.
#include <limits>
#include <stdexcept>

#include "continuous_particle_cylinder.hpp"

namespace lab::continuous_particle_cylinder {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 nan_vector = Vec3::Constant(nan);

}  // namespace

std::optional<double> time_of_impact_textbook(const MovingParticle&, const Cylinder&, double) {
  return nan;
}
double difference_of_products(double, double, double, double) { return nan; }
std::optional<double> time_of_impact(const MovingParticle&, const Cylinder&, double) { return nan; }
std::optional<double> time_of_impact_certified(const MovingParticle&, const Cylinder&, double) {
  return nan;
}
Advancement conservative_advancement(const MovingParticle&, const Cylinder&, double, double) {
  return {nan, 0};
}
ParticleContact contact_at(const MovingParticle&, const Cylinder&, double) {
  return {nan_vector, nan_vector, nan_vector, nan, nan};
}
std::vector<double> times_of_impact(const MovingParticles& p, const Cylinder&, double) {
  const std::size_t size = p.y.size();
  const bool alike =
      p.z.size() == size && p.velocity_y.size() == size && p.velocity_z.size() == size;
  if (size == 0 || !alike) throw std::domain_error("not a number");
  return std::vector<double>(size, nan);
}
std::optional<double> time_of_impact_of_edge(const MovingEdge&, const Cylinder&, double) {
  return nan;
}

}  // namespace lab::continuous_particle_cylinder

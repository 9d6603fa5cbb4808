// Returns NaN everywhere: every test must fail it, and say that the value is not finite.
#include <limits>

#include "discrete_particle_cylinder.hpp"

namespace lab::discrete_particle_cylinder {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const Vec3 nan_vector = Vec3::Constant(nan);
const ParticleContact nan_contact{nan_vector, nan_vector, nan_vector, nan, nan};
/// The index that a cast makes of NaN; no list is as long.
const std::vector<std::size_t> nan_indices{std::numeric_limits<std::size_t>::max()};

}  // namespace

double gap(const Vec3&, double, const Cylinder&) { return nan; }
Vec3 gap_gradient(const Vec3&) { return nan_vector; }
std::optional<ParticleContact> contact(const Vec3&, double, const Cylinder&, double) {
  return nan_contact;
}
std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>&, double, const Cylinder&) {
  return nan_indices;
}
std::optional<ParticleContact> first_sampled_contact(const StraightPath&, int, double,
                                                     const Cylinder&) {
  return nan_contact;
}
EdgeGap edge_gap(const Vec3&, const Vec3&, double, const Cylinder&) { return {nan, nan}; }
TriangleGap triangle_gap(const Vec3&, const Vec3&, const Vec3&, double, const Cylinder&) {
  return {nan, nan_vector};
}
SheetContacts sheet_contacts(const Sheet&, const Cylinder&) {
  return {nan_indices, nan_indices, nan_indices};
}
double particle_margin(double, double, const Cylinder&) { return nan; }

}  // namespace lab::discrete_particle_cylinder

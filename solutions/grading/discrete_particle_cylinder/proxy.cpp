#include "proxy.hpp"

#include "remote.hpp"

namespace lab::discrete_particle_cylinder {
namespace {

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}  // namespace

double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::gap>(position, particle_radius, cylinder);
}
Vec3 gap_gradient(const Vec3& position) {
  return remote<&discrete_particle_cylinder::gap_gradient>(position);
}
std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time) {
  return remote<&discrete_particle_cylinder::contact>(position, particle_radius, cylinder, time);
}
std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::particles_in_contact>(positions, particle_radius,
                                                                   cylinder);
}
std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::first_sampled_contact>(path, samples, particle_radius,
                                                                    cylinder);
}
EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::edge_gap>(a, b, particle_radius, cylinder);
}
TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::triangle_gap>(a, b, c, particle_radius, cylinder);
}
SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::sheet_contacts>(sheet, cylinder);
}
double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder) {
  return remote<&discrete_particle_cylinder::particle_margin>(longest_edge, particle_radius,
                                                              cylinder);
}

}  // namespace lab::discrete_particle_cylinder

#include "discrete_particle_cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "common/course/require.hpp"

namespace lab::discrete_particle_cylinder {
namespace {

/// Returns the sum of the radii, and throws if one of them is not above zero.
double sum_of_radii(double particle_radius, const Cylinder& cylinder) {
  common::require_positive(particle_radius, "particle_radius");
  common::require_positive(cylinder.radius, "cylinder.radius");
  return cylinder.radius + particle_radius;
}

double distance_from_axis(const Vec3& position) {
  return std::hypot(position.y(), position.z());  // squares overflow at 1e200, vanish at 1e-200
}

/// The point of an edge or a triangle that is nearest to the axis.
struct EdgePoint {
  double distance;
  double fraction;
};
struct TrianglePoint {
  double distance;
  Vec3 weights;
};

EdgePoint nearest_on_edge(const Vec3& a, const Vec3& b) {
  const double distance_a = distance_from_axis(a);
  if (distance_from_axis(b) < distance_a) {  // from the nearer end, whose ulp are smaller
    const EdgePoint reversed = nearest_on_edge(b, a);
    return {reversed.distance, 1.0 - reversed.fraction};
  }
  const Vec3 edge = b - a;
  const double length = distance_from_axis(edge);
  if (length == 0.0) return {distance_a, 0.0};

  const double along = -(a.y() * (edge.y() / length) + a.z() * (edge.z() / length));
  const double fraction = std::clamp(along / length, 0.0, 1.0);
  return {distance_from_axis(a + fraction * edge), fraction};
}

/// Returns a b − c d to 2 ulp, so its sign is certain: the rounding error of c d is added (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

double cross(const Vec3& p, const Vec3& q) {
  return difference_of_products(p.y(), q.z(), p.z(), q.y());
}

/// Returns the weights with which the corners add up to the axis, if it goes through the triangle.
std::optional<Vec3> weights_of_axis(Vec3 a, Vec3 b, Vec3 c) {
  const double size = std::max({std::abs(a.y()), std::abs(a.z()), std::abs(b.y()), std::abs(b.z()),
                                std::abs(c.y()), std::abs(c.z())});
  if (size == 0.0) return std::nullopt;
  for (Vec3* corner : {&a, &b, &c}) {  // a power of two, so nothing is rounded
    corner->y() = std::scalbn(corner->y(), -std::ilogb(size));
    corner->z() = std::scalbn(corner->z(), -std::ilogb(size));
  }
  const Vec3 areas(cross(b, c), cross(c, a), cross(a, b));
  const double total = areas.sum();
  const bool pierced = areas.minCoeff() >= 0.0 || areas.maxCoeff() <= 0.0;
  if (!pierced || total == 0.0) return std::nullopt;
  return areas / total;
}

TrianglePoint nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (const auto weights = weights_of_axis(a, b, c)) return {0.0, *weights};
  const EdgePoint ab = nearest_on_edge(a, b);
  const EdgePoint bc = nearest_on_edge(b, c);
  const EdgePoint ca = nearest_on_edge(c, a);
  if (ab.distance <= std::min(bc.distance, ca.distance)) {
    return {ab.distance, Vec3(1.0 - ab.fraction, ab.fraction, 0.0)};
  }
  if (bc.distance <= ca.distance) {
    return {bc.distance, Vec3(0.0, 1.0 - bc.fraction, bc.fraction)};
  }
  return {ca.distance, Vec3(ca.fraction, 0.0, 1.0 - ca.fraction)};
}

}  // namespace

double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder) {
  common::require_finite(position, "position");
  return distance_from_axis(position) - sum_of_radii(particle_radius, cylinder);  // eq. (1)
}

Vec3 gap_gradient(const Vec3& position) {
  common::require_finite(position, "position");
  const double distance = distance_from_axis(position);
  if (distance == 0.0) return Vec3::UnitY();
  return {0.0, position.y() / distance, position.z() / distance};  // eq. (2)
}

std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time) {
  common::require_finite(time, "time");
  const double phi = gap(position, particle_radius, cylinder);
  if (phi > 0.0) return std::nullopt;

  const Vec3 n = gap_gradient(position);
  const double R = cylinder.radius;
  ParticleContact contact;
  contact.point_on_cylinder = {position.x(), R * n.y(), R * n.z()};
  contact.point_on_particle = position - particle_radius * n;
  contact.normal = n;
  contact.gap = phi;
  contact.time = time;
  return contact;
}

std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder) {
  const double rho = sum_of_radii(particle_radius, cylinder);
  for (const Vec3& position : positions) common::require_finite(position, "positions");

  // With ρ scaled to near 1, squares may overflow or vanish only if that does not change the
  // answer. They err by 4 ulp. So within 16 ε of ρ² the distance itself decides, as in gap.
  const double scale = std::scalbn(1.0, -std::clamp(std::ilogb(rho), -1000, 1000));
  const double square_of_rho = (scale * rho) * (scale * rho);
  const double unsure = 16.0 * std::numeric_limits<double>::epsilon() * square_of_rho;
  const auto touches = [&](const Vec3& position) {
    const double y = scale * position.y();
    const double z = scale * position.z();
    const double excess = y * y + z * z - square_of_rho;
    if (std::abs(excess) > unsure) return excess < 0.0;
    return distance_from_axis(position) <= rho;
  };

  std::vector<std::size_t> indices;
  indices.reserve(
      static_cast<std::size_t>(std::count_if(positions.begin(), positions.end(), touches)));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (touches(positions[i])) indices.push_back(i);
  }
  return indices;
}

std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder) {
  common::require_finite(path.position, "path.position");
  common::require_finite(path.velocity, "path.velocity");
  common::require_not_negative(path.duration, "path.duration");
  if (samples < 1) throw std::invalid_argument("samples: want at least 1");

  for (std::int64_t k = 0; k <= samples; ++k) {
    const double time = path.duration * (static_cast<double>(k) / samples);  // eq. (4)
    const Vec3 position = path.position + time * path.velocity;
    auto found = contact(position, particle_radius, cylinder, time);
    if (found) return found;
  }
  return std::nullopt;
}

EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder) {
  common::require_finite(a, "a");
  common::require_finite(b, "b");
  const double rho = sum_of_radii(particle_radius, cylinder);
  const EdgePoint nearest = nearest_on_edge(a, b);
  return {nearest.distance - rho, nearest.fraction};  // eq. (5)
}

TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder) {
  common::require_finite(a, "a");
  common::require_finite(b, "b");
  common::require_finite(c, "c");
  const double rho = sum_of_radii(particle_radius, cylinder);
  const TrianglePoint nearest = nearest_on_triangle(a, b, c);
  return {nearest.distance - rho, nearest.weights};  // eq. (6)
}

SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder) {
  const double rho = sum_of_radii(sheet.particle_radius, cylinder);
  const auto particle = [&](std::size_t index) -> const Vec3& {
    if (index < sheet.positions.size()) return sheet.positions[index];
    throw std::invalid_argument("sheet: an edge or a triangle has an index of no particle");
  };

  SheetContacts contacts;
  contacts.particles = particles_in_contact(sheet.positions, sheet.particle_radius, cylinder);
  for (std::size_t i = 0; i < sheet.edges.size(); ++i) {
    const auto& [a, b] = sheet.edges[i];
    const double distance = nearest_on_edge(particle(a), particle(b)).distance;
    if (distance <= rho) contacts.edges.push_back(i);
  }
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    const auto& [a, b, c] = sheet.triangles[i];
    const double distance = nearest_on_triangle(particle(a), particle(b), particle(c)).distance;
    if (distance <= rho) contacts.triangles.push_back(i);
  }
  return contacts;
}

double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder) {
  common::require_not_negative(longest_edge, "longest_edge");
  const double rho = sum_of_radii(particle_radius, cylinder);
  const double edge_touches = std::hypot(rho, 0.5 * longest_edge);  // eq. (7)
  const double triangle_pierced = longest_edge / std::sqrt(3.0);    // eq. (8)
  return std::max(edge_touches, triangle_pierced) - rho;
}

}  // namespace lab::discrete_particle_cylinder

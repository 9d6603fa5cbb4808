// The lab once more, built otherwise: lengths by scaled squares and a root, the nearest point of an
// edge by bisection, the axis in a triangle by the turning of a sight line round its corners.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "discrete_particle_cylinder.hpp"

namespace lab::discrete_particle_cylinder {
namespace {

using Vec2 = Eigen::Vector2d;

void check(bool right, const char* what) {
  if (!right) throw std::invalid_argument(what);
}

void check_position(const Vec3& position) {
  for (int i = 0; i < 3; ++i) check(std::isfinite(position(i)), "a position is not finite");
}

void check_radii(double particle_radius, const Cylinder& cylinder) {
  for (const double radius : {particle_radius, cylinder.radius}) {
    check(radius > 0.0 && std::isfinite(radius), "a radius is not a finite number above zero");
  }
}

Vec2 yz(const Vec3& position) { return {position.y(), position.z()}; }

/// √(y² + z²), squared only when the greater of the two is between 1 and 2.
double length(const Vec2& v) {
  const double size = v.cwiseAbs().maxCoeff();
  if (size == 0.0) return 0.0;
  const int exponent = std::ilogb(size);
  const double y = std::ldexp(v.x(), -exponent);
  const double z = std::ldexp(v.y(), -exponent);
  return std::ldexp(std::sqrt(y * y + z * z), exponent);
}

Vec2 unit(const Vec2& v) {
  const double size = length(v);
  return size > 0.0 ? Vec2(v / size) : Vec2(Vec2::UnitX());
}

/// The distance from the axis changes its sign of growth once along the edge.
double nearest_fraction(const Vec2& a, const Vec2& b) {
  const Vec2 direction = unit(b - a);
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const Vec2 point = (1.0 - middle) * a + middle * b;
    (point.dot(direction) < 0.0 ? low : high) = middle;
  }
  if (low == 0.0) return 0.0;
  return high == 1.0 ? 1.0 : 0.5 * (low + high);
}

double distance_at(const Vec2& a, const Vec2& b, double fraction) {
  return length((1.0 - fraction) * a + fraction * b);
}

/// The angle by which one turns who looks from the axis at p, then at q.
double turn(const Vec2& p, const Vec2& q) {
  const Vec2 u = unit(p);
  const Vec2 v = unit(q);
  return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
}

/// Who looks along the edges of a triangle about the axis turns once round, and nowhere by half a
/// turn at once: there the axis is on an edge, or is a corner.
bool surrounds_axis(const std::array<Vec2, 3>& p) {
  double turned = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = turn(p[i], p[(i + 1) % 3]);
    if (p[i].isZero(0.0) || std::abs(angle) > std::numbers::pi - 1e-15) return false;
    turned += angle;
  }
  return std::abs(turned) > std::numbers::pi;
}

/// From one corner through the axis to the far edge: what is left of the way is that corner's
/// weight. The corner is the farthest, so that its direction is the surest.
Vec3 weights_of_axis(const std::array<Vec2, 3>& p) {
  std::size_t far = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (length(p[i]) > length(p[far])) far = i;
  }
  const std::size_t next = (far + 1) % 3;
  const std::size_t last = (far + 2) % 3;
  const Vec2 sight = -unit(p[far]);
  // How far to the two sides of the line of sight the other corners are.
  const double left = std::abs(sight.x() * p[next].y() - sight.y() * p[next].x());
  const double right = std::abs(sight.x() * p[last].y() - sight.y() * p[last].x());
  const double fraction = left + right > 0.0 ? left / (left + right) : 0.0;
  const double beyond = distance_at(p[next], p[last], fraction);
  const double share = beyond / (beyond + length(p[far]));
  Vec3 weights;
  weights(static_cast<Eigen::Index>(far)) = share;
  weights(static_cast<Eigen::Index>(next)) = (1.0 - share) * (1.0 - fraction);
  weights(static_cast<Eigen::Index>(last)) = (1.0 - share) * fraction;
  return weights;
}

}  // namespace

double gap(const Vec3& position, double particle_radius, const Cylinder& cylinder) {
  check_position(position);
  check_radii(particle_radius, cylinder);
  return (length(yz(position)) - cylinder.radius) - particle_radius;
}

Vec3 gap_gradient(const Vec3& position) {
  check_position(position);
  const Vec2 direction = unit(yz(position));
  return {0.0, direction.x(), direction.y()};
}

std::optional<ParticleContact> contact(const Vec3& position, double particle_radius,
                                       const Cylinder& cylinder, double time) {
  check(std::isfinite(time), "the time is not finite");
  ParticleContact contact;
  contact.gap = gap(position, particle_radius, cylinder);
  if (!(contact.gap <= 0.0)) return {};
  contact.time = time;
  contact.normal = gap_gradient(position);
  const Vec3 axis_point(position.x(), 0.0, 0.0);
  contact.point_on_cylinder = axis_point + cylinder.radius * contact.normal;
  contact.point_on_particle = position - particle_radius * contact.normal;
  return contact;
}

std::vector<std::size_t> particles_in_contact(const std::vector<Vec3>& positions,
                                              double particle_radius, const Cylinder& cylinder) {
  check_radii(particle_radius, cylinder);
  std::vector<std::size_t> indices(positions.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    indices[count] = i;
    if (gap(positions[i], particle_radius, cylinder) <= 0.0) ++count;
  }
  indices.resize(count);
  return indices;
}

std::optional<ParticleContact> first_sampled_contact(const StraightPath& path, int samples,
                                                     double particle_radius,
                                                     const Cylinder& cylinder) {
  check_position(path.position);
  check_position(path.velocity);
  check(path.duration >= 0.0 && std::isfinite(path.duration), "the duration is below zero");
  check(samples >= 1, "there must be a sample");
  // Backwards, so that the last one found is the first in time.
  std::optional<ParticleContact> first;
  for (int k = samples; k >= 0; --k) {
    const double time = k * path.duration / samples;
    const Vec3 position = path.position + path.velocity * time;
    const auto found = contact(position, particle_radius, cylinder, time);
    if (found) first = found;
  }
  return first;
}

EdgeGap edge_gap(const Vec3& a, const Vec3& b, double particle_radius, const Cylinder& cylinder) {
  check_position(a);
  check_position(b);
  check_radii(particle_radius, cylinder);
  const double fraction = nearest_fraction(yz(a), yz(b));
  return {(distance_at(yz(a), yz(b), fraction) - cylinder.radius) - particle_radius, fraction};
}

TriangleGap triangle_gap(const Vec3& a, const Vec3& b, const Vec3& c, double particle_radius,
                         const Cylinder& cylinder) {
  check_position(a);
  check_position(b);
  check_position(c);
  check_radii(particle_radius, cylinder);
  const std::array<Vec2, 3> p{yz(a), yz(b), yz(c)};
  if (surrounds_axis(p)) return {-(cylinder.radius + particle_radius), weights_of_axis(p)};

  double least = std::numeric_limits<double>::infinity();
  Vec3 weights = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double fraction = nearest_fraction(p[i], p[j]);
    const double distance = distance_at(p[i], p[j], fraction);
    if (distance >= least) continue;
    least = distance;
    weights.setZero();
    weights(static_cast<Eigen::Index>(i)) = 1.0 - fraction;
    weights(static_cast<Eigen::Index>(j)) = fraction;
  }
  return {(least - cylinder.radius) - particle_radius, weights};
}

SheetContacts sheet_contacts(const Sheet& sheet, const Cylinder& cylinder) {
  const double r = sheet.particle_radius;
  const auto& positions = sheet.positions;
  SheetContacts contacts;
  contacts.particles = particles_in_contact(positions, r, cylinder);
  for (const auto& triangle : sheet.triangles) {
    for (const std::size_t index : triangle) check(index < positions.size(), "no such particle");
  }
  for (const auto& edge : sheet.edges) {
    for (const std::size_t index : edge) check(index < positions.size(), "no such particle");
    const EdgeGap found = edge_gap(positions[edge[0]], positions[edge[1]], r, cylinder);
    const auto index = static_cast<std::size_t>(&edge - sheet.edges.data());
    if (found.gap <= 0.0) contacts.edges.push_back(index);
  }
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    const auto& [a, b, c] = sheet.triangles[i];
    const TriangleGap found = triangle_gap(positions[a], positions[b], positions[c], r, cylinder);
    if (found.gap <= 0.0) contacts.triangles.push_back(i);
  }
  return contacts;
}

double particle_margin(double longest_edge, double particle_radius, const Cylinder& cylinder) {
  check(longest_edge >= 0.0 && std::isfinite(longest_edge), "an edge's length is below zero");
  check_radii(particle_radius, cylinder);
  const double rho = cylinder.radius + particle_radius;
  // h/√3 > √(ρ² + h²/4) just where h/√12 > ρ.
  const bool pierced = longest_edge / std::sqrt(12.0) > rho;
  return (pierced ? longest_edge / std::sqrt(3.0) : length(Vec2(rho, longest_edge / 2.0))) - rho;
}

}  // namespace lab::discrete_particle_cylinder

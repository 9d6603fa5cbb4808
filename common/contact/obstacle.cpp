#include "common/contact/obstacle.hpp"

#include <cmath>

#include "common/course/require.hpp"
#include "common/exact/first_entry.hpp"

namespace common {
namespace {

DoubleDouble difference(double a, double b) { return two_sum(a, -b); }

/// u·v over the components from `first` on.
DoubleDouble dot(const Vec3& u, const Vec3& v, int first = 0) {
  DoubleDouble sum;
  for (int i = first; i < 3; ++i) sum = sum + two_product(u[i], v[i]);
  return sum;
}

std::optional<double> entry(const Plane& plane, const Flight& flight, double dt) {
  DoubleDouble gap;
  for (int i = 0; i < 3; ++i) {
    gap = gap + difference(flight.position[i], plane.point[i]) * DoubleDouble(plane.normal[i]);
  }
  return first_entry(Quadratic{gap, dot(plane.normal, flight.velocity),
                               DoubleDouble(0.5) * dot(plane.normal, flight.acceleration)},
                     dt);
}

/// y² + z² − R², a quartic in t, has the sign of the gap, and of its rate where that is zero.
std::optional<double> entry(const Cylinder& cylinder, const Flight& flight, double dt) {
  const Vec3& x = flight.position;
  const Vec3& v = flight.velocity;
  const Vec3& a = flight.acceleration;
  const double reach =
      dt * (std::hypot(v.y(), v.z()) + 0.5 * dt * std::hypot(a.y(), a.z()));  // no farther
  if (gap(cylinder, x) > 1.0001 * reach) return std::nullopt;
  return first_entry(Quartic{dot(x, x, 1) - two_product(cylinder.radius, cylinder.radius),
                             DoubleDouble(2.0) * dot(x, v, 1), dot(v, v, 1) + dot(x, a, 1),
                             dot(v, a, 1), DoubleDouble(0.25) * dot(a, a, 1)},
                     dt);
}

}  // namespace

void require_valid(const Obstacle& obstacle) {
  if (const auto* plane = std::get_if<Plane>(&obstacle)) {
    require_finite(plane->point, "plane.point");
    require_unit(plane->normal, "plane.normal");
  } else {
    require_positive(std::get<Cylinder>(obstacle).radius, "cylinder.radius");
  }
}

double gap(const Obstacle& obstacle, const Vec3& position) {
  if (const auto* plane = std::get_if<Plane>(&obstacle)) {
    return plane->normal.dot(position - plane->point);
  }
  return std::hypot(position.y(), position.z()) - std::get<Cylinder>(obstacle).radius;
}

Vec3 outward_normal(const Obstacle& obstacle, const Vec3& position) {
  if (const auto* plane = std::get_if<Plane>(&obstacle)) return plane->normal;
  const double distance = std::hypot(position.y(), position.z());
  if (distance == 0.0) return Vec3::UnitY();
  return {0.0, position.y() / distance, position.z() / distance};
}

Vec3 position_at(const Flight& flight, double time) {
  return flight.position + time * (flight.velocity + 0.5 * time * flight.acceleration);
}

Vec3 velocity_at(const Flight& flight, double time) {
  return flight.velocity + time * flight.acceleration;
}

std::optional<double> time_of_impact(const Obstacle& obstacle, const Flight& flight, double dt) {
  return std::visit([&](const auto& shape) { return entry(shape, flight, dt); }, obstacle);
}

}  // namespace common

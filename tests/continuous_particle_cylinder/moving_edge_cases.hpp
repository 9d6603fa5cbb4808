#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cases.hpp"
#include "continuous_particle_cylinder.hpp"
#include "random.hpp"

/// Moving edges on which a time of impact is judged, from the harmless to what rounding decides.
namespace tests {

using lab::continuous_particle_cylinder::MovingEdge;

struct EdgeCase {
  MovingEdge edge;
  double R = 1.0;
  double dt = 1.0;
};

inline double rho(const EdgeCase& c) { return c.R + c.edge.radius; }

inline int whole(Random& random, int low, int high) {
  return static_cast<int>(std::floor(random.uniform(low, high + 1)));
}

/// A unit vector in the yz-plane, and what is left of it.
inline Vec3 direction_in_plane(Random& random) {
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  return {0.0, std::cos(angle), std::sin(angle)};
}
inline Vec3 left_of(const Vec3& n) { return {0.0, -n.z(), n.y()}; }

/// From the axis to the edge at a time, but for rounding.
inline double distance(const MovingEdge& edge, double t) {
  const auto place = [t](const Vec3& x, const Vec3& v) {
    return Eigen::Vector2d((x + t * v).tail<2>());
  };
  const Eigen::Vector2d p = place(edge.a, edge.velocity_a);
  const Eigen::Vector2d d = place(edge.b, edge.velocity_b) - p;
  const double squared = d.squaredNorm();
  const double s = squared > 0.0 ? std::clamp(-p.dot(d) / squared, 0.0, 1.0) : 0.0;
  return (p + s * d).norm();
}

/// Draws until the edge is off the cylinder at these times, by a small part of its size; after many
/// draws the last.
template <typename Draw>
EdgeCase off_at(const std::vector<double>& times, const Draw& draw) {
  EdgeCase c;
  for (int i = 0; i < 100; ++i) {
    c = draw();
    const double off = (1.0 + 1e-6) * rho(c);
    if (std::all_of(times.begin(), times.end(),
                    [&](double t) { return distance(c.edge, t) > off; })) {
      break;
    }
  }
  return c;
}

inline EdgeCase random_edge(Random& random) {
  return {{random.vector(4.0), random.vector(4.0), random.vector(4.0), random.vector(4.0),
           random.uniform(0.005, 0.3)},
          random.uniform(0.3, 1.2),
          random.uniform(0.2, 2.0)};
}

/// As in a simulation: short, near the surface, a small part of its length a step.
inline EdgeCase cloth_edge(Random& random) {
  return off_at({0.0}, [&] {
    const double R = random.uniform(0.5, 1.5);
    const double r = random.uniform(0.005, 0.02);
    const double length = random.uniform(0.05, 0.3) * R;
    const Vec3 n = direction_in_plane(random);
    const Vec3 middle = (R + r + random.uniform(0.0, 0.2)) * n;
    const Vec3 half = 0.5 * length * (left_of(n) + 0.5 * random.vector()).normalized();
    const Vec3 velocity = random.vector(2.0) - random.uniform(0.0, 1.0) * n;
    return EdgeCase{{middle - half, middle + half, velocity + random.vector(0.3),
                     velocity + random.vector(0.3), r},
                    R,
                    random.uniform(0.001, 0.01)};
  });
}

/// Long edges that turn and cross the whole disc; their ends start and pass well beside it.
inline EdgeCase long_sweep(Random& random) {
  const double R = random.uniform(0.3, 0.8);
  const double r = random.uniform(0.01, 0.1);
  const Vec3 n = (R + r) * direction_in_plane(random);
  const Vec3 along = left_of(n);
  const auto end = [&](double side) {
    return Vec3(random.uniform(1.5, 6.0) * n + side * random.uniform(1.5, 4.0) * along);
  };
  const auto velocity = [&] {
    return Vec3(-random.uniform(12.0, 30.0) * n + random.uniform(-0.4, 0.4) * along);
  };
  return {{end(-1.0), end(1.0), velocity(), velocity(), r}, R, 1.0};
}

/// The edge's line touches the disc at one time and comes no nearer, but for a few ulp of a place.
inline EdgeCase grazing_edge(Random& random) {
  const double t = random.uniform(0.2, 0.8);
  EdgeCase c = off_at({0.0, t - 0.01, t + 0.01}, [&] {
    const double R = random.uniform(0.3, 1.2);
    const double r = random.uniform(0.01, 0.3);
    const Vec3 n = direction_in_plane(random);
    const Vec3 along = left_of(n);
    const double behind = random.uniform(0.2, 3.0);
    const double ahead = random.uniform(0.2, 3.0);
    // The point that touches moves along the line, which turns about it.
    const Vec3 slide = random.uniform(-2.0, 2.0) * along;
    const Vec3 turn = random.uniform(-2.0, 2.0) * n + random.uniform(-0.5, 0.5) * along;
    const Vec3 velocity_a = slide - behind * turn;
    const Vec3 velocity_b = slide + ahead * turn;
    return EdgeCase{{(R + r) * n - behind * along - t * velocity_a,
                     (R + r) * n + ahead * along - t * velocity_b, velocity_a, velocity_b, r},
                    R,
                    1.0};
  });
  c.edge.a.y() = nudged(random, c.edge.a.y(), 2);
  return c;
}

/// The same in whole numbers about a corner of a Pythagorean triangle: the touch is exact, or an
/// ulp of a coordinate away from it. Where the line dives through, it only begins or ends there.
inline EdgeCase exact_tangency(Random& random) {
  constexpr std::array<std::array<int, 3>, 3> triangles{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}}};
  return off_at({0.0}, [&] {
    const auto& triangle = triangles.at(static_cast<std::size_t>(whole(random, 0, 2)));
    const auto sign = [&] { return whole(random, 0, 1) == 0 ? 1.0 : -1.0; };
    const Vec3 n(0.0, sign() * triangle[0], sign() * triangle[1]);
    const Vec3 along = left_of(n);
    const double behind = whole(random, 1, 4);
    const double ahead = whole(random, 1, 4);
    const Vec3 turn = whole(random, -2, 2) * n;
    const Vec3 velocity_a = whole(random, -3, 3) * along - behind * turn;
    const Vec3 velocity_b = whole(random, -3, 3) * along + ahead * turn;
    const double t = whole(random, 1, 8) / 8.0;
    const double r = whole(random, 1, 8) / 4.0;
    MovingEdge edge{n - behind * along - t * velocity_a, n + ahead * along - t * velocity_b,
                    velocity_a, velocity_b, r};
    if (whole(random, 0, 1) == 0) edge.b.z() = nudged(random, edge.b.z(), 1);
    return EdgeCase{edge, triangle[2] - r, whole(random, 0, 1) == 0 ? 1.0 : t};
  });
}

/// Small whole numbers: edges parallel to x, of no length, that shrink to a point or change their
/// ends, at rest, along their own line, in no time, and every kind of touch, all without rounding.
inline EdgeCase lattice_edge(Random& random) {
  const auto vector = [&random](int size) {
    return Vec3(whole(random, -1, 1), whole(random, -size, size), whole(random, -size, size));
  };
  const auto draw = [&] {
    const double r = 0.25 * whole(random, 1, 3);
    EdgeCase c{{0.5 * vector(8), 0.5 * vector(8), vector(6), vector(6), r},
               0.5 * whole(random, 2, 4) - r,
               0.5 * whole(random, 0, 4)};
    MovingEdge& edge = c.edge;
    switch (whole(random, 0, 5)) {
      case 0:
        edge.velocity_b = edge.velocity_a;
        break;
      case 1:
        edge.b = edge.a;
        break;
      case 2:
        edge.velocity_b = edge.velocity_a + whole(random, -4, 4) * (edge.b - edge.a);
        break;
      case 3:
        edge.velocity_a.setZero();
        break;
      default:
        break;
    }
    return c;
  };
  return whole(random, 0, 3) == 0 ? draw() : off_at({0.0}, draw);
}

/// At any scale of length and of time.
inline EdgeCase scaled_edge(Random& random) {
  EdgeCase c = whole(random, 0, 1) == 0 ? exact_tangency(random) : long_sweep(random);
  const double size = std::ldexp(1.0, whole(random, -300, 300));
  const double time = std::ldexp(1.0, whole(random, -300, 300));
  for (Vec3* x : {&c.edge.a, &c.edge.b}) *x *= size;
  for (Vec3* v : {&c.edge.velocity_a, &c.edge.velocity_b}) *v *= size / time;
  c.edge.radius *= size;
  c.R *= size;
  c.dt *= time;
  return c;
}

/// One end so far away that its products swamp the rest.
inline EdgeCase far_edge(Random& random) {
  EdgeCase c = long_sweep(random);
  c.edge.b += power_of_ten(random, 3.0, 12.0) * (c.edge.b - c.edge.a).normalized();
  return c;
}

struct EdgeSet {
  std::string name;
  EdgeCase (*draw)(Random&);
};

inline const std::array<EdgeSet, 8> edge_sets{{{"random", random_edge},
                                               {"cloth", cloth_edge},
                                               {"long sweeps", long_sweep},
                                               {"grazing", grazing_edge},
                                               {"tangent", exact_tangency},
                                               {"degenerate", lattice_edge},
                                               {"any scale", scaled_edge},
                                               {"far end", far_edge}}};

}  // namespace tests

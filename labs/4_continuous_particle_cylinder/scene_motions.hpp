#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "common/course/if_written.hpp"
#include "continuous_particle_cylinder.hpp"

/// The motions of the scene, and what each method finds in them.
namespace lab::continuous_particle_cylinder {

inline constexpr double flight = 2.2;  ///< dt [s]
inline constexpr int samples = 2;
inline constexpr double speed = 1.0;  ///< [m/s]
inline constexpr Cylinder cylinder{0.5};
inline constexpr double bullet_radius = 5.0 / 64.0;  ///< its sum with R is exact, so one grazes
inline constexpr double reach = cylinder.radius + bullet_radius;

/// The distance from the axis at which a bullet passes, in reaches, and the place of its start.
struct Lane {
  double offset;
  double height;  ///< [m]
};
inline constexpr std::array<Lane, 6> lanes{{{-1.0, 1.3},
                                            {-1.0 / 3.0, 1.0},
                                            {0.0, 1.35},
                                            {1.0 / 3.0, 1.65},
                                            {2.0 / 3.0, 1.3},
                                            {1.45, 1.5}}};

inline MovingParticle bullet(const Lane& lane) {
  return {{0.0, lane.offset * reach, lane.height}, {0.0, 0.0, -speed}, bullet_radius};
}

inline bool does_hit(const MovingParticle& particle) {
  return std::abs(particle.position.y()) <= reach;
}

inline Vec3 position_at(const MovingParticle& particle, double time) {
  return particle.position + time * particle.velocity;
}

/// A bullet as one method sees it.
struct Shot {
  MovingParticle particle;
  std::optional<ParticleContact> contact;
};

/// One method, and the place of its cylinder in the picture.
struct Group {
  const char* name;
  double shift;
  bool has_samples;
  std::vector<Shot> shots;
};

inline std::optional<double> first_sampled_time(const MovingParticle& particle) {
  for (int k = 0; k <= samples; ++k) {
    const double time = k * flight / samples;
    const Vec3 position = position_at(particle, time);
    if (std::hypot(position.y(), position.z()) <= reach) return time;
  }
  return std::nullopt;
}

inline std::optional<double> exact_time(const MovingParticle& particle) {
  return time_of_impact(particle, cylinder, flight);
}

template <typename Look>
std::optional<Group> watched(Group group, const Look& look, std::vector<std::string>& missing) {
  return common::if_written(missing, [&] {
    for (const Lane& lane : lanes) {
      Shot shot{bullet(lane), std::nullopt};
      const std::optional<double> time = look(shot.particle);
      if (time) shot.contact = contact_at(shot.particle, cylinder, *time);
      group.shots.push_back(shot);
    }
    return group;
  });
}

inline MovingEdge falling_edge() {
  return {{0.0, -0.75, 1.55}, {0.0, 0.75, 1.1}, {0.0, 0.0, -1.1}, {0.0, 0.0, -0.8}, bullet_radius};
}

/// The edge's impact, at its place that is nearest to the axis, and what its ends see.
struct EdgeImpact {
  std::optional<ParticleContact> contact;
  bool has_end_contact = false;
};

inline std::optional<EdgeImpact> edge_impact(std::vector<std::string>& missing) {
  const MovingEdge edge = falling_edge();
  return common::if_written(missing, [&] {
    EdgeImpact impact;
    for (const MovingParticle& end : {MovingParticle{edge.a, edge.velocity_a, edge.radius},
                                      MovingParticle{edge.b, edge.velocity_b, edge.radius}}) {
      impact.has_end_contact = impact.has_end_contact || exact_time(end).has_value();
    }
    const std::optional<double> time = time_of_impact_of_edge(edge, cylinder, flight);
    if (!time) return impact;
    const Vec3 a = edge.a + *time * edge.velocity_a;
    const Vec3 span = edge.b + *time * edge.velocity_b - a;
    const double s = std::clamp(-a.dot(span) / span.squaredNorm(), 0.0, 1.0);
    const MovingParticle nearest{edge.a + s * (edge.b - edge.a),
                                 edge.velocity_a + s * (edge.velocity_b - edge.velocity_a),
                                 edge.radius};
    impact.contact = contact_at(nearest, cylinder, *time);
    return impact;
  });
}

}  // namespace lab::continuous_particle_cylinder

#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "common/course/if_written.hpp"
#include "impulse_response.hpp"

/// The left side of the scene: particles that pour on the cylinder, stepped by option 2.
namespace lab::impulse_response {

inline constexpr double duration = 3.2;
inline constexpr double frame_time = 0.04;
inline constexpr int frames = 80;
inline constexpr common::Cylinder cylinder{1.0};
inline const common::Plane ground{{0.0, 0.0, -1.5}, Vec3::UnitZ()};
inline const Vec3 gravity(0.0, 0.0, -9.81);

inline constexpr int particle_count = 10000;
inline constexpr double particle_mass = 0.001;
inline constexpr double pouring = 2.4;  // until when [s]
inline constexpr Material sand{0.4, 0.5};
inline constexpr int steps_a_frame = 10;
inline constexpr double dt = frame_time / steps_a_frame;

/// A particle in a frame.
struct Grain {
  Vec3 position;
  double impulse;  ///< the largest in a step since the last frame [N s]
};

/// The particles through the whole film.
struct Pour {
  std::vector<std::vector<Grain>> frames;
  long steps = 0;        ///< of single particles
  double deepest = 0.0;  ///< by which a particle is inside at a step's end [m]
};

/// Returns the particles in the order of their release.
inline std::vector<Particle> poured_particles() {
  std::mt19937 engine(6);
  const auto from_to = [&](double low, double high) {  // the same on every platform
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  std::vector<Particle> particles;
  for (int i = 0; i < particle_count; ++i) {
    Particle particle;
    particle.mass = particle_mass;
    particle.position = {from_to(-2.9, -0.5), from_to(-0.95, 0.95), 2.3};
    particle.velocity = {0.0, 0.0, from_to(-1.5, 0.0)};
    particles.push_back(particle);
  }
  return particles;
}

/// Returns the obstacle that a particle can hit next.
inline Obstacle nearest_obstacle(const Vec3& position) {
  if (common::gap(cylinder, position) < common::gap(ground, position)) return cylinder;
  return ground;
}

/// Takes one step of one particle. Its impulse counts for the grain.
inline void step(Particle& particle, Grain& grain, Pour& pour) {
  const Obstacle obstacle = nearest_obstacle(particle.position);
  const ProjectedStep next = step_by_projection(particle, obstacle, sand, gravity, dt);
  particle = next.particle;
  grain.impulse = std::max(grain.impulse, next.impulse.norm());
  pour.deepest = std::max(pour.deepest, -common::gap(obstacle, particle.position));
  ++pour.steps;
}

/// Returns nothing, and adds an entry to `missing`, if the step is not written yet.
inline std::optional<Pour> poured(std::vector<std::string>& missing) {
  std::vector<Particle> particles = poured_particles();
  const double released_a_second = particle_count / pouring;
  Pour pour;
  return common::if_written(missing, [&] {
    for (int frame = 0; frame <= frames; ++frame) {
      const double released =
          std::min(released_a_second * frame * frame_time, static_cast<double>(particle_count));
      std::vector<Grain> grains;
      for (std::size_t i = 0; i < static_cast<std::size_t>(released); ++i) {
        Grain grain{Vec3::Zero(), 0.0};
        const double age = frame * frame_time - static_cast<double>(i) / released_a_second;
        const int steps = std::min(steps_a_frame, static_cast<int>(age / dt));
        for (int k = 0; k < steps; ++k) step(particles[i], grain, pour);
        grain.position = particles[i].position;
        grains.push_back(grain);
      }
      pour.frames.push_back(grains);
    }
    return pour;
  });
}

}  // namespace lab::impulse_response

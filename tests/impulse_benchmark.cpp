// Particle-steps a second of lab 6's option 2, and what a contact costs beside a flight: ten
// thousand particles each, the two kinds by turns. At most three flights, says the lab.
//
//   impulse_benchmark --benchmark_repetitions=9 --benchmark_enable_random_interleaving
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "impulse_response.hpp"

using namespace lab::impulse_response;

namespace {

constexpr int particles = 10000;
const Vec3 gravity(0.0, 0.0, -9.81);
constexpr double dt = 1e-3;

/// Over the top half of the unit cylinder, `height` above it, coming down.
std::vector<Particle> shower(double height) {
  std::vector<Particle> result(particles);
  for (int i = 0; i < particles; ++i) {
    const double angle = 1.5 * (2.0 * i / particles - 1.0);
    const Vec3 out(0.0, std::sin(angle), std::cos(angle));
    Particle& particle = result[static_cast<std::size_t>(i)];
    particle.position = (1.0 + height) * out + 1e-3 * i * Vec3::UnitX();
    particle.velocity = Vec3(0.1, 0.3, 0.0) - 0.5 * out;
  }
  return result;
}

void step(benchmark::State& state, const Obstacle& obstacle, double height) {
  const std::vector<Particle> start = shower(height);
  const Material material{0.3, 0.2};
  for (auto _ : state) {
    for (const Particle& particle : start) {
      benchmark::DoNotOptimize(
          step_by_projection(particle, obstacle, material, gravity, dt, Corrections{}));
    }
  }
  state.SetItemsProcessed(state.iterations() * particles);
}

BENCHMARK_CAPTURE(step, cylinder_flight, common::Cylinder{1.0}, 1.0);
BENCHMARK_CAPTURE(step, cylinder_contact, common::Cylinder{1.0}, 0.0);
BENCHMARK_CAPTURE(step, plane_flight, common::Plane{{0.0, 0.0, -2.0}, Vec3::UnitZ()}, 0.0);
BENCHMARK_CAPTURE(step, plane_contact, common::Plane{{0.0, 0.0, 2.0}, Vec3::UnitZ()}, 0.0);

}  // namespace

BENCHMARK_MAIN();

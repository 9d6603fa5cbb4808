// Times of lab 4's fast answer, for_speed, a million queries each: milliseconds are nanoseconds a
// query. Of the ties, a query each. Run with --benchmark_enable_random_interleaving
// --benchmark_repetitions=9 and quote medians as ratios of one run.
//
//                       the bar
//   cross_form          2.5 of textbook
//   certified           9 of textbook
//   batch               1/3 of certified
//   certified_tie       5000 ns
#include <benchmark/benchmark.h>

#include <optional>
#include <vector>

#include "continuous_particle_cylinder.hpp"
#include "random.hpp"

using namespace lab::continuous_particle_cylinder;

namespace {

constexpr Cylinder cylinder{1.0};
constexpr double radius = 0.1;
constexpr double dt = 1.0;

/// From places around the cylinder in any direction: two of nine hit, one starts inside.
const std::vector<MovingParticle>& particles() {
  static const std::vector<MovingParticle> drawn = [] {
    tests::Random random(1);
    std::vector<MovingParticle> some(1'000'000);
    for (MovingParticle& particle : some) {
      particle = {random.vector(3.0), random.vector(6.0), radius};
    }
    return some;
  }();
  return drawn;
}

using TimeOfImpact = std::optional<double>(const MovingParticle&, const Cylinder&, double);

void single(benchmark::State& state, TimeOfImpact* time) {
  while (state.KeepRunning()) {
    for (const MovingParticle& particle : particles()) {
      benchmark::DoNotOptimize(time(particle, cylinder, dt));
    }
  }
}

void batch(benchmark::State& state) {
  MovingParticles arrays;
  arrays.radius = radius;
  for (const MovingParticle& particle : particles()) {
    arrays.y.push_back(particle.position.y());
    arrays.z.push_back(particle.position.z());
    arrays.velocity_y.push_back(particle.velocity.y());
    arrays.velocity_z.push_back(particle.velocity.z());
  }
  while (state.KeepRunning()) benchmark::DoNotOptimize(times_of_impact(arrays, cylinder, dt));
}

/// Triangles of sides 3, 4 and 5: rounding of any kind would decide these.
void certified_tie(benchmark::State& state, const common::Vec3& position,
                   const common::Vec3& velocity) {
  const MovingParticle particle{position, velocity, 2.0};
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(time_of_impact_certified(particle, Cylinder{3.0}, 1.0));
  }
}

BENCHMARK_CAPTURE(single, textbook, time_of_impact_textbook)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, cross_form, time_of_impact)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(single, certified, time_of_impact_certified)->Unit(benchmark::kMillisecond);
BENCHMARK(batch)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(certified_tie, start, common::Vec3(0.0, 3.0, 4.0), common::Vec3(0.0, 1.0, 0.7));
BENCHMARK_CAPTURE(certified_tie, graze, common::Vec3(0.0, 11.0, -2.0),
                  common::Vec3(0.0, -12.0, 9.0));
BENCHMARK_CAPTURE(certified_tie, arrival, common::Vec3(0.0, 10.3, 4.0),
                  common::Vec3(0.0, -7.3, 0.0));
BENCHMARK_CAPTURE(certified_tie, far_apart, common::Vec3(0.0, 5.0, 5e-324),
                  common::Vec3(0.0, -1e-300, 1.0));

}  // namespace

BENCHMARK_MAIN();

#include "allocations.hpp"
#include "catch.hpp"
#include "continuous_particle_cylinder.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::continuous_particle_cylinder;

namespace {

const std::string allocations_step = "4.5 times_of_impact";

/// The last of the particles takes the way of a 3-4-5 triangle.
MovingParticles random_particles(tests::Random& random, std::size_t size) {
  MovingParticles particles;
  particles.radius = 1.0;
  for (std::size_t i = 0; i < size; ++i) {
    const bool last = i + 1 == size;
    particles.y.push_back(last ? 10.0 : random.uniform(-16.0, 16.0));
    particles.z.push_back(last ? 3.0 : random.uniform(-16.0, 16.0));
    particles.velocity_y.push_back(last ? -2.0 : random.uniform(-3.0, 3.0));
    particles.velocity_z.push_back(last ? 0.0 : random.uniform(-3.0, 3.0));
  }
  return particles;
}

double allocations_of(tests::Random& random, std::size_t size) {
  const MovingParticles particles = random_particles(random, size);
  const std::size_t before = tests::allocations;
  const std::vector<double> times = times_of_impact(particles, {4.0}, 10.0);
  const auto count = static_cast<double>(tests::allocations - before);
  tests::Trial(allocations_step)
      .given("number of particles", static_cast<double>(size))
      .expect(static_cast<double>(times.size()), static_cast<double>(size),
              {0.0, "one time for each particle"});
  tests::Trial(allocations_step)
      .given("number of particles", static_cast<double>(size))
      .of("the last time")
      .expect(times.back(), 3.0, {2.0 * tests::eps, "1 ulp"});
  return count;
}

}  // namespace

TEST_CASE("The allocations of a batch do not grow with the number of particles", "[4.5]") {
  tests::Random random(453);
  const double few = allocations_of(random, 1000);
  const double many = allocations_of(random, 100000);
  tests::Trial(allocations_step)
      .expect_small(
          "allocations for 100000 particles minus those for 1000", many - few,
          {8.0, "an array that doubles as it grows takes seven more; a particle may take none"},
          "every particle allocates: take the vector, string or ExactNumber out of the loop");
}

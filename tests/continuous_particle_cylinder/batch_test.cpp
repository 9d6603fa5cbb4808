#include <functional>

#include "bad_input.hpp"
#include "batch_beliefs.hpp"
#include "catch.hpp"
#include "narrow.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::infinity;
using tests::Query;
using tests::Time;

namespace {

const std::string batch_step = "4.5 times_of_impact";

/// Queries that share a particle radius, a cylinder and dt.
struct Batch {
  MovingParticles particles;
  Cylinder cylinder;
  double dt = 1.0;
};

Query query_of(const Batch& batch, std::size_t i) {
  const MovingParticles& p = batch.particles;
  return {{{0.0, p.y[i], p.z[i]}, {0.0, p.velocity_y[i], p.velocity_z[i]}, p.radius},
          batch.cylinder,
          batch.dt};
}

/// suspects_of  a query of the batch, whose time is wrong, and this time
void expect_batch(const Batch& batch,
                  const std::function<tests::TimeSuspects(const Query&, const Time&)>& suspects_of =
                      tests::suspects_in_batch) {
  const std::size_t size = batch.particles.y.size();
  const std::vector<double> got = times_of_impact(batch.particles, batch.cylinder, batch.dt);
  tests::Trial(batch_step)
      .given("number of particles", static_cast<double>(size))
      .expect(static_cast<double>(got.size()), static_cast<double>(size),
              {0.0, "one time for each particle"});
  for (std::size_t i = 0; i < size; ++i) {
    const Query query = query_of(batch, i);
    const auto trial =
        tests::trial(batch_step, query, static_cast<int>(i + 1), static_cast<int>(size))
            .suspecting(tests::nan_for_none);
    const Time time = tests::batch_time(got[i]);
    tests::expect_exact(trial, time, query, 1.0, [&] { return suspects_of(query, time); });
  }
}

Batch random_batch(tests::Random& random, std::size_t size) {
  Batch batch;
  batch.particles.radius = random.uniform(0.01, 1.0);
  batch.cylinder.radius = random.uniform(0.2, 2.0);
  batch.dt = random.uniform(0.5, 2.0);
  for (std::size_t i = 0; i < size; ++i) {
    const Vec3 position = random.vector(4.0);
    tests::add(batch.particles, position, random.vector(5.0));
  }
  return batch;
}

/// Particles that leave the surface, on which they start but for a few ulp. The last one hits.
Batch leaving_batch(tests::Random& random, std::size_t size) {
  Batch batch = random_batch(random, 0);
  const double rho = batch.cylinder.radius + batch.particles.radius;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    const double place = random.uniform(0.0, 6.2);
    const Vec3 out(0.0, std::cos(place), std::sin(place));
    const Vec3 position(0.0, tests::nudged(random, rho * out.y(), 3), rho * out.z());
    tests::add(batch.particles, position, random.uniform(0.5, 2.0) * out);
  }
  tests::add(batch.particles, {0.0, 2.0 * rho, 0.0}, {0.0, -3.0 * rho / batch.dt, 0.0});
  return batch;
}

/// All take the same way of whole numbers through a batch but for one, which is a tie.
Batch with_tie(const tests::Tie& tie, std::size_t size, std::size_t place) {
  Batch batch;
  batch.particles.radius = tie.query.particle.radius;
  batch.cylinder = tie.query.cylinder;
  batch.dt = tie.query.dt;
  for (std::size_t i = 0; i < size; ++i) {
    if (i == place) {
      tests::add(batch.particles, tie.query.particle.position, tie.query.particle.velocity);
    } else {
      tests::add(batch.particles, {0, 10, 3}, {0, -7, 0.5});
    }
  }
  return batch;
}

}  // namespace

TEST_CASE("A batch is right on paths of whole numbers", "[4.5]") {
  Batch batch;
  batch.particles.radius = 1.0;
  batch.cylinder.radius = 4.0;
  batch.dt = 10.0;
  for (const auto& [query, time] : tests::hand_cases()) {
    if (query.dt == 10.0)
      tests::add(batch.particles, query.particle.position, query.particle.velocity);
  }
  expect_batch(batch);
}

TEST_CASE("A batch of any size holds every time to one ulp", "[4.5]") {
  tests::Random random(451);
  for (const std::size_t size : {7U, 8U, 9U, 63U, 64U, 65U, 1U, 0U, 1000U}) {
    Batch batch = random_batch(random, size);
    if (size > 0) {  // the last one hits, so that it shows where it is left out
      const double start = 2.0 * (batch.particles.radius + batch.cylinder.radius);
      batch.particles.y.back() = start;
      batch.particles.z.back() = 0.0;
      batch.particles.velocity_y.back() = -start / batch.dt;
      batch.particles.velocity_z.back() = 0.1 * start / batch.dt;
    }
    expect_batch(batch);
  }
}

TEST_CASE("Touches in the middle of a batch are decided as for one particle", "[4.5]") {
  for (const tests::Tie& tie : tests::ties()) {
    for (const std::size_t place : {0U, 5U, 8U, 12U}) expect_batch(with_tie(tie, 19, place));
  }
}

// For about a third of them c <= 0, but not c as the sum of rounded squares, or the other way
// round.
TEST_CASE("A batch is right for particles that leave the surface", "[4.5]") {
  const auto suspects_of = [](const Query& query, const Time& got) {
    const Batch whole = with_tie(tests::ties().front(), 9, 4);
    const bool right = times_of_impact(whole.particles, whole.cylinder, whole.dt)[4] == 0.0;
    const bool alike = got.seconds == tests::certified(query);  // a mistake in 4.3 is named there
    if (alike && !got.seconds) return tests::TimeSuspects{};
    if (!right || got.seconds) return tests::suspects_in_batch(query, got);
    return tests::TimeSuspects{{{},
                                "a start on the surface is missed, because c is rounded: if it is "
                                "within its error bound, use step 4.3"}};
  };
  tests::Random random(454);
  for (int k = 0; k < 20; ++k) expect_batch(leaving_batch(random, 50), suspects_of);
}

TEST_CASE("A batch of touching and grazing paths is right to one ulp", "[4.5]") {
  tests::Random random(452);
  for (int k = 0; k < 20; ++k) {
    Batch batch;
    batch.particles.radius = 1.0;
    batch.cylinder.radius = 4.0;
    batch.dt = 3.0;
    for (int i = 0; i < 50; ++i) {
      const Query lattice = tests::lattice_query(random);
      tests::add(batch.particles, lattice.particle.position, lattice.particle.velocity);
      const double course = random.uniform(0.0, 6.2);
      const Vec3 along(0.0, std::cos(course), std::sin(course));
      const Vec3 across(0.0, -along.z(), along.y());
      const double offset = tests::nudged(random, 5.0, 3);
      const double back = random.uniform(0.0, 9.0);
      tests::add(batch.particles, offset * across - back * along, 3.0 * along);
    }
    expect_batch(batch);
  }
}

TEST_CASE("A batch finds nothing if paths stay just outside", "[4.5]") {
  const auto in_a_batch = [](const Query& query) {
    Batch batch;
    batch.particles.radius = query.particle.radius;
    batch.cylinder = query.cylinder;
    batch.dt = query.dt;
    for (int i = 0; i < 9; ++i)
      tests::add(batch.particles, query.particle.position, query.particle.velocity);
    return tests::batch_time(times_of_impact(batch.particles, batch.cylinder, batch.dt)[8]).seconds;
  };
  tests::expect_narrow_misses_missed(batch_step, in_a_batch, 453);
}

TEST_CASE("A batch of no particles refuses bad arguments like any other", "[4.5]") {
  const std::string likely =
      "dt and the radii are not checked if there are no particles: check them first";
  const Query good = tests::query({0, 10, 20}, {0, -1, 0}, 1.0);
  for (const auto& [why, query] : tests::bad_queries()) {
    const bool shared = query.dt != good.dt || query.cylinder.radius != good.cylinder.radius ||
                        query.particle.radius != good.particle.radius;  // by all particles
    if (!shared) continue;
    MovingParticles none;
    none.radius = query.particle.radius;
    tests::Trial(batch_step)
        .given("number of particles", 0.0)
        .given("particles.radius", query.particle.radius)
        .given("cylinder.radius", query.cylinder.radius)
        .given("dt", query.dt)
        .expect_throw(
            [&, &query = query] {
              return static_cast<double>(times_of_impact(none, query.cylinder, query.dt).size());
            },
            why, likely);
  }
}

TEST_CASE("A batch refuses bad arguments at any index", "[4.5]") {
  const std::string likely =
      "the arguments are not checked: throw std::invalid_argument for a bad one";
  for (const auto& [why, query] : tests::bad_queries()) {
    const bool along_x = !std::isfinite(query.particle.position.x() + query.particle.velocity.x());
    if (along_x) continue;  // x is not in it
    for (const std::size_t place : {0U, 150U, 299U}) {
      Batch batch = with_tie(tests::ties()[0], 300, 300);
      batch.particles.radius = query.particle.radius;
      batch.cylinder = query.cylinder;
      batch.dt = query.dt;
      batch.particles.y[place] = query.particle.position.y();
      batch.particles.z[place] = query.particle.position.z();
      batch.particles.velocity_y[place] = query.particle.velocity.y();
      batch.particles.velocity_z[place] = query.particle.velocity.z();
      tests::trial(batch_step, query, static_cast<int>(place + 1), 300)
          .expect_throw(
              [&] {
                return Time{times_of_impact(batch.particles, batch.cylinder, batch.dt)[place]};
              },
              why, likely);
    }
  }
}

TEST_CASE("A batch refuses arrays of different lengths", "[4.5]") {
  const Batch whole = with_tie(tests::ties()[0], 9, 9);
  const auto count = [](const std::vector<double>& array) {
    return static_cast<double>(array.size());
  };
  constexpr std::size_t sizes[] = {9, 8, 0};
  int index = 0;
  for (std::size_t pattern = 0; pattern < 81; ++pattern) {  // four digits to the base of three
    MovingParticles p = whole.particles;
    std::size_t rest = pattern;
    for (auto* array : {&p.y, &p.z, &p.velocity_y, &p.velocity_z}) {
      array->resize(sizes[rest % 3]);
      rest /= 3;
    }
    const bool alike = p.y.size() == p.z.size() && p.z.size() == p.velocity_y.size() &&
                       p.velocity_y.size() == p.velocity_z.size();
    if (alike) continue;
    tests::Trial(batch_step, ++index, 78)
        .given("particles.y.size()", count(p.y))
        .given("particles.z.size()", count(p.z))
        .given("particles.velocity_y.size()", count(p.velocity_y))
        .given("particles.velocity_z.size()", count(p.velocity_z))
        .expect_throw([&] { return count(times_of_impact(p, whole.cylinder, whole.dt)); },
                      "the arrays differ in length",
                      "the lengths of the four arrays are not compared, or not each with the "
                      "others: throw if any differ");
  }
}

#include "allocations.hpp"
#include "catch.hpp"
#include "discrete_particle_cylinder.hpp"
#include "judgement.hpp"
#include "random.hpp"
#include "trial.hpp"

using namespace lab::discrete_particle_cylinder;
using tests::IndexList;
using tests::Suspect;
using tests::Trial;
namespace story = tests::story;

namespace {

struct Batch {
  std::vector<Vec3> positions;
  double particle_radius = 0.5;
  Cylinder cylinder;
};

IndexList answer(const Batch& batch) {
  return {particles_in_contact(batch.positions, batch.particle_radius, batch.cylinder)};
}

Trial batch_trial(const Batch& batch, int index = 1, int count = 1) {
  return tests::radii_trial("3.3 particles_in_contact", batch.particle_radius, batch.cylinder,
                            index, count)
      .given("positions", tests::Positions{batch.positions});
}

/// The indices for which the predicate of a position holds.
template <typename Predicate>
IndexList indices_where(const Batch& batch, const Predicate& holds) {
  IndexList list;
  for (std::size_t i = 0; i < batch.positions.size(); ++i) {
    if (holds(batch.positions[i])) list.indices.push_back(i);
  }
  return list;
}

IndexList wanted(const Batch& batch) {
  const tests::Exact rho = tests::rho(batch.particle_radius, batch.cylinder);
  const tests::Exact rho_squared = rho * rho;
  return indices_where(batch, [&](const Vec3& p) { return tests::square(p) <= rho_squared; });
}

std::vector<Suspect<IndexList>> suspects(const Batch& batch) {
  const double rho = batch.cylinder.radius + batch.particle_radius;
  const tests::Exact exact_rho = tests::rho(batch.particle_radius, batch.cylinder);
  const IndexList right = wanted(batch);
  IndexList falling = right;
  std::reverse(falling.indices.begin(), falling.indices.end());
  IndexList by_depth = right;
  std::stable_sort(by_depth.indices.begin(), by_depth.indices.end(), [&](auto i, auto j) {
    return tests::distance(batch.positions[i]) < tests::distance(batch.positions[j]);
  });
  IndexList from_one = right;
  for (std::size_t& index : from_one.indices) ++index;
  return {{falling, "the indices fall: they must rise"},
          {by_depth, "the deepest comes first: the indices must rise"},
          {from_one, "the indices are counted from 1: count from 0"},
          {indices_where(batch, [&](const Vec3& p) { return tests::distance(p) < exact_rho; }),
           story::touching},
          {indices_where(
               batch, [&](const Vec3& p) { return tests::distance(p) <= batch.cylinder.radius; }),
           story::no_r},
          {indices_where(batch, [&](const Vec3& p) { return tests::length(p) <= rho; }),
           story::keeps_x},
          {indices_where(batch, [&](const Vec3& p) { return tests::distance(p) > exact_rho; }),
           story::reversed_gap}};
}

void expect_right(const Batch& batch, int index = 1, int count = 1) {
  batch_trial(batch, index, count)
      .expect(answer(batch), wanted(batch), {0.0, "both lists must be equal"},
              [&] { return suspects(batch); });
}

/// `share` of the particles are in contact, the rest are apart; none is near to touching.
Batch random_batch(tests::Random& random, int count, double share = 0.3) {
  Batch batch;
  batch.particle_radius = random.uniform(0.1, 1.0);
  batch.cylinder.radius = random.uniform(0.2, 2.0);
  const double rho = batch.cylinder.radius + batch.particle_radius;
  for (int i = 0; i < count; ++i) {
    const bool inside = random.uniform(0.0, 1.0) < share;
    const double distance = inside ? random.uniform(0.0, 0.999) : random.uniform(1.001, 3.0);
    batch.positions.push_back(
        tests::around_axis(random.uniform(-3.0, 3.0), distance * rho, tests::random_angle(random)));
  }
  return batch;
}

}  // namespace

TEST_CASE("Of six particles those inside and the one that touches are listed", "[3.3]") {
  expect_right({{Vec3(0.0, 6.0, 0.0), Vec3(1.0, 3.0, 4.0), Vec3(2.0, 0.0, 0.5),
                 Vec3(3.0, 0.0, -5.5), Vec3(9.0, -2.0, 2.0), Vec3(0.0, 4.5, 0.0)},
                1.0,
                {4.0}});
}

TEST_CASE("A batch agrees with each of its particles in a hundred digits", "[3.3]") {
  tests::Random random(331);
  for (int i = 1; i <= 20; ++i) expect_right(random_batch(random, 100), i, 20);
}

TEST_CASE("All or none of the particles or an empty batch give the right list", "[3.3]") {
  tests::Random random(332);
  for (const double share : {1.0, 0.0}) expect_right(random_batch(random, 40, share));
  expect_right({});
  expect_right({{Vec3::Zero()}, 0.5, {1.0}});
}

TEST_CASE("Whole batches that only touch are in contact", "[3.3]") {
  int index = 0;
  for (const double size : {1.0, 0x1p-600, 0x1p600, 0x1p990}) {
    const double s = size;
    expect_right({{Vec3(s, 3.0 * s, 4.0 * s), Vec3(0.0, -4.0 * s, 3.0 * s), Vec3(s, 0.0, 5.0 * s),
                   Vec3(0.0, 5.0 * s, 0.0), Vec3(0.0, 5.5 * s, 0.0)},
                  s,
                  {4.0 * s}},
                 ++index, 4);
  }
}

TEST_CASE("Very large and very small lengths are judged rightly", "[3.3]") {
  int index = 0;
  for (const double rho : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
    Batch batch{{}, 0.25 * rho, {0.75 * rho}};
    for (const double length : {0.0, 1e-300, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e300}) {
      batch.positions.emplace_back(length, 0.8 * length, -0.9 * length);
      batch.positions.emplace_back(0.0, 0.5 * length, 0.5 * length);
    }
    expect_right(batch, ++index, 5);
  }
}

TEST_CASE("A particle within a hundred roundings of touching is judged rightly", "[3.3]") {
  // The gap errs by a few ulp of 2 ρ: a relative 1e-14 is 45.
  tests::Random random(333);
  for (int i = 1; i <= 20; ++i) {
    Batch batch = random_batch(random, 10);
    const double rho = batch.cylinder.radius + batch.particle_radius;
    for (const double off : {1e-14, 1e-13, 1e-11, 1e-8}) {
      for (const double sign : {1.0, -1.0}) {
        batch.positions.push_back(
            tests::around_axis(1.0, rho * (1.0 + sign * off), tests::random_angle(random)));
      }
    }
    batch_trial(batch, i, 20)
        .expect(answer(batch), wanted(batch), {0.0, "both lists must be equal"}, [&] {
          const auto near = [&](const Vec3& p) { return tests::distance(p) <= rho + 1e-9; };
          return std::vector<Suspect<IndexList>>{{indices_where(batch, near), story::tolerance}};
        });
  }
}

TEST_CASE("A hundred times as many particles take no more allocations", "[3.3]") {
  tests::Random random(334);
  std::vector<double> counts;
  for (const int size : {1000, 100000}) {
    Batch batch = random_batch(random, size);
    const std::size_t before = tests::allocations;
    const std::vector<std::size_t> got =
        particles_in_contact(batch.positions, batch.particle_radius, batch.cylinder);
    counts.push_back(static_cast<double>(tests::allocations - before));
    const double rho = batch.cylinder.radius + batch.particle_radius;
    const auto touches = [&](const Vec3& p) { return std::hypot(p.y(), p.z()) <= rho; };
    batch_trial(batch).expect(IndexList{got}, indices_where(batch, touches),
                              {0.0, "none is within rounding of touching"});
  }
  const double grown = counts[1] - counts[0];
  Trial("3.3 particles_in_contact")
      .expect_small(
          "allocations for 100,000 particles minus those for 1,000", std::max(grown, 0.0),
          {0.0, "their number must not grow with the number of particles"},
          grown < 100.0
              ? "the list grows by push_back, which moves it each time: reserve its space first"
              : "memory is allocated for each particle: allocate it once");
}

TEST_CASE("A batch refuses positions that are not finite and radii not above zero", "[3.3]") {
  const std::vector<Vec3> good{Vec3(1.0, 0.2, 0.3), Vec3(9.0, 9.0, 9.0)};
  tests::expect_radii_checked("3.3 particles_in_contact", [&](double r, const Cylinder& c) {
    return IndexList{particles_in_contact(good, r, c)};
  });
  tests::expect_radii_checked("3.3 particles_in_contact", [&](double r, const Cylinder& c) {
    return IndexList{particles_in_contact({}, r, c)};
  });
  for (const char* place : {"positions[0]", "positions[1]", "positions[2]"}) {
    const auto offset = place[std::string("positions[").size()] - '0';
    tests::expect_position_checked("3.3 particles_in_contact", place, [&](const Vec3& bad) {
      std::vector<Vec3> positions = good;
      positions.insert(positions.begin() + offset, bad);
      return IndexList{particles_in_contact(positions, 0.5, Cylinder{1.0})};
    });
  }
}

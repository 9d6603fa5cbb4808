// What students get wrong in step 7.2.
#include "fingerprint.hpp"
#include "sequential.hpp"

namespace tests {
namespace {

ContactSystem row(const Vector& masses, const Vector& velocities) {
  return row_of_balls(masses, velocities).system();
}

/// Small fractions all: outcomes in doubles are those of the oracle, to the last decision.
std::vector<SequentialInput> sequential_inputs() {
  const Vector both_come{{1.0, 0.0, -1.0}};
  const Vector masses{{1.0, 2.0, 1.0}};
  const Matrix apart{{1.0, 0.0}, {0.0, 2.0}};
  const Matrix coupled{{4.0, -2.0, -1.0}, {-2.0, 4.0, -2.0}, {-1.0, -2.0, 4.0}};
  std::vector<SequentialInput> all{{row(masses, both_come), 0.5, 100},
                                   {row(Vector::Ones(4), Vector{{0.5, 1.0, 0.0, -2.0}}), 0.5, 100},
                                   {{coupled, Vector{{-1.0, -1.0, -1.5}}}, 0.5, 100},
                                   {row(Vector::Ones(3), Vector{{1.0, 0.0, 2.0}}), 0.25, 100},
                                   {row(Vector::Ones(3), Vector{{1.0, 0.0, 0.0}}), 1.0, 100},
                                   {row(Vector::Ones(3), 0x1p-60 * both_come), 1.0, 100},
                                   {row(Vector::Ones(3), both_come), 1.0, 0},
                                   {row(Vector::Ones(2), Vector{{0.0, 1.0}}), 1.0, 0},
                                   {{apart, Vector{{-1.0, -0x1p-41}}}, 0.5, 100},
                                   {{apart, Vector{{-1.0, -0x1p-38}}}, 0.5, 100},
                                   {{apart, Vector{{-1.0, 0.0}}}, 0.5, 100},
                                   {row(Vector::Ones(3), Vector{{1.0, 0.0, 0.0}}), 0.0, 100}};
  for (int cap = 1; cap <= 4; ++cap) all.push_back({row(Vector::Ones(3), both_come), 1.0, cap});
  return all;
}

bool alike(const Impulses& got, const Impulses& wanted) {
  return near(got.lambda, wanted.lambda) && got.count == wanted.count && got.ended == wanted.ended;
}

}  // namespace

std::string likely_of_sequential_impulses() {
  std::vector<Mistake<SequentialInput, Impulses>> all;
  for (const auto& [flaw, story] : sequential_flaws()) {
    all.push_back({story, [f = flaw](const SequentialInput& in, const Impulses& got) {
                     return alike(got, sequential_outcome(in, f).done);
                   }});
  }
  return fingerprint(
      sequential_inputs(),
      [](const SequentialInput& in) {
        return lab::multi_contact::sequential_impulses(in.system, in.restitution, in.max_impulses);
      },
      all);
}

}  // namespace tests

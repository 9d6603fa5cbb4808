// Step 4.6's answer and four simpler methods against whole numbers, set by set: impacts missed,
// impacts found where there is none, the worst time in parts of dt, nanoseconds a query. Fails
// where the answer ever errs.
//
//   moving_edge_proof_<answer> <edges a set>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include "continuous_particle_cylinder.hpp"
#include "moving_edge_cases.hpp"
#include "moving_edge_truth.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::EdgeCase;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double by_quartic(const EdgeCase& c) {
  return time_of_impact_of_edge(c.edge, {c.R}, c.dt).value_or(never);
}

double by_ends(const EdgeCase& c) {
  const MovingEdge& e = c.edge;
  const auto end = [&](const Vec3& x, const Vec3& v) {
    return time_of_impact_certified({x, v, e.radius}, {c.R}, c.dt).value_or(never);
  };
  return std::min(end(e.a, e.velocity_a), end(e.b, e.velocity_b));
}

double by_samples(const EdgeCase& c) {
  constexpr int count = 64;
  for (int i = 0; i <= count; ++i) {
    const double t = i * c.dt / count;
    if (tests::distance(c.edge, t) <= rho(c)) return t;
  }
  return never;
}

/// No point of the edge is faster than the faster end. Tolerance in units of ρ; a touch that it
/// comes no nearer to, since steps round to nothing, is given up after many of them.
double by_advancement(const EdgeCase& c, double tolerance) {
  const auto speed = [](const Vec3& v) { return std::hypot(v.y(), v.z()); };
  const double fastest = std::max(speed(c.edge.velocity_a), speed(c.edge.velocity_b));
  double t = 0.0;
  for (int i = 0; i < 10000 && t <= c.dt; ++i) {
    const double gap = tests::distance(c.edge, t) - rho(c);
    if (gap <= tolerance * rho(c)) return t;
    if (fastest == 0.0) return never;
    t += gap / fastest;
  }
  return never;
}

struct Method {
  const char* name;
  double (*time)(const EdgeCase&);
};

constexpr std::array methods{
    Method{"quartic", by_quartic}, Method{"ends only", by_ends}, Method{"64 samples", by_samples},
    Method{"advance 1e-6", [](const EdgeCase& c) { return by_advancement(c, 1e-6); }},
    Method{"advance 1e-14", [](const EdgeCase& c) { return by_advancement(c, 1e-14); }}};

struct Tally {
  long missed = 0;
  long wrong = 0;
  double worst = 0.0;
};

void judge(Tally& tally, double got, const tests::Time& wanted, double dt) {
  if (got == never || !wanted.seconds) {
    tally.missed += wanted.seconds ? 1 : 0;
    tally.wrong += got != never ? 1 : 0;
  } else if (dt > 0.0) {
    tally.worst = std::max(tally.worst, std::abs(got - *wanted.seconds) / dt);
  } else if (got != *wanted.seconds) {
    tally.worst = never;
  }
}

double seconds_of(const Method& method, const std::vector<EdgeCase>& cases) {
  double sum = 0.0;
  const std::clock_t start = std::clock();
  for (const EdgeCase& c : cases) sum += std::min(method.time(c), c.dt);
  const std::clock_t end = std::clock();
  return std::isnan(sum) ? never : static_cast<double>(end - start) / CLOCKS_PER_SEC;
}

/// Medians of rounds in which the methods take turns.
std::array<double, methods.size()> nanoseconds(const std::vector<EdgeCase>& cases) {
  constexpr std::size_t rounds = 5;
  std::array<std::array<double, rounds>, methods.size()> seconds{};
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < methods.size(); ++i) {
      seconds[i][round] = seconds_of(methods[i], cases);
    }
  }
  std::array<double, methods.size()> medians{};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::sort(seconds[i].begin(), seconds[i].end());
    medians[i] = 1e9 * seconds[i][rounds / 2] / static_cast<double>(cases.size());
  }
  return medians;
}

bool prove(const tests::EdgeSet& set, long count) {
  constexpr std::size_t timed = 1000;
  constexpr long compared = 10000;
  tests::Random random(46);
  std::vector<EdgeCase> cases;
  std::array<Tally, methods.size()> tallies;
  long hits = 0;
  for (long i = 0; i < count; ++i) {
    const EdgeCase c = set.draw(random);
    if (cases.size() < timed) cases.push_back(c);
    const tests::Time wanted = tests::EdgeTruth(c).time();
    hits += wanted.seconds ? 1 : 0;
    for (std::size_t m = 0; m < (i < compared ? methods.size() : 1); ++m) {
      judge(tallies[m], methods[m].time(c), wanted, c.dt);
    }
  }
  const auto times = nanoseconds(cases);
  std::printf("%s: %ld edges, %ld hits\n", set.name.c_str(), count, hits);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Tally& tally = tallies[m];
    std::printf("  %-14s missed %7ld  false %7ld  worst %8.2g of dt  %9.0f ns\n", methods[m].name,
                tally.missed, tally.wrong, tally.worst, times[m]);
  }
  std::fflush(stdout);
  const Tally& quartic = tallies[0];
  return quartic.missed == 0 && quartic.wrong == 0 && quartic.worst <= 1e-14;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: moving_edge_proof_<answer> <edges a set>\n", stderr);
    return 2;
  }
  bool good = true;
  for (const tests::EdgeSet& set : tests::edge_sets) {
    if (!prove(set, std::atol(argv[1]))) {
      std::printf("  FAILED\n");
      good = false;
    }
  }
  return good ? 0 : 1;
}

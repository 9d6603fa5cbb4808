// Lab 4's answers against exact arithmetic: impacts missed, impacts found where there is none, and
// the worst time in units in the last place; that again where the path goes deep, nearer to the
// axis than ρ/2. Fails where the certified time or the batch ever errs, and where the cross form
// misses an impact or, in a well-conditioned class, is more than 4 ulp off a deep path's.
//
//   impact_proof_<answer> <queries a random class> <queries an adversarial class>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>

#include "continuous_particle_cylinder.hpp"
#include "impact_classes.hpp"

using namespace lab::continuous_particle_cylinder;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

struct Tally {
  long missed = 0;
  long wrong = 0;
  double worst = 0.0;
  double worst_deep = 0.0;
};

void judge(Tally& tally, double got, const std::optional<tests::Impact>& wanted) {
  if (!wanted) {
    if (got != never) ++tally.wrong;
    return;
  }
  if (got == never) {
    ++tally.missed;
    return;
  }
  const double error = tests::ulps(got, wanted->time);
  tally.worst = std::max(tally.worst, error);
  if (wanted->deep) tally.worst_deep = std::max(tally.worst_deep, error);
}

constexpr std::array methods{"textbook", "cross form", "certified", "batch"};
using Tallies = std::array<Tally, methods.size()>;

/// Turned and reflected so that nothing changes, in vectors of any width and with some left over.
MovingParticles images(const tests::Query& q) {
  MovingParticles particles;
  particles.radius = q.r;
  for (int i = 0; i < 9; ++i) {
    const double sign_y = (i & 1) != 0 ? -1.0 : 1.0;
    const double sign_z = (i & 2) != 0 ? -1.0 : 1.0;
    const bool swapped = (i & 4) != 0;
    (swapped ? particles.z : particles.y).push_back(sign_y * q.y);
    (swapped ? particles.y : particles.z).push_back(sign_z * q.z);
    (swapped ? particles.velocity_z : particles.velocity_y).push_back(sign_y * q.v_y);
    (swapped ? particles.velocity_y : particles.velocity_z).push_back(sign_z * q.v_z);
  }
  return particles;
}

/// The cross form promises nothing in the rest of a double's range.
bool is_ordinary(const tests::Query& q) {
  for (const double x : {q.y, q.z, q.v_y, q.v_z, q.R, q.r}) {
    if (x != 0.0 && (std::abs(x) < 1e-60 || std::abs(x) > 1e60)) return false;
  }
  return true;
}

void judge_all(Tallies& tallies, const tests::Query& q,
               const std::optional<tests::Impact>& wanted) {
  const MovingParticle particle{{0.0, q.y, q.z}, {0.0, q.v_y, q.v_z}, q.r};
  const Cylinder cylinder{q.R};
  if (is_ordinary(q)) {
    judge(tallies[0], time_of_impact_textbook(particle, cylinder, q.dt).value_or(never), wanted);
    judge(tallies[1], time_of_impact(particle, cylinder, q.dt).value_or(never), wanted);
  }
  judge(tallies[2], time_of_impact_certified(particle, cylinder, q.dt).value_or(never), wanted);
  for (const double time : times_of_impact(images(q), cylinder, q.dt)) {
    judge(tallies[3], time, wanted);
  }
}

bool holds(const tests::ImpactClass& kind, const Tallies& tallies) {
  const auto& [textbook, cross, certified, batch] = tallies;
  const auto is_certain = [](const Tally& tally) {
    return tally.missed == 0 && tally.wrong == 0 && tally.worst <= 1.0;
  };
  return is_certain(certified) && is_certain(batch) && cross.missed == 0 &&
         (!kind.well_conditioned || cross.worst_deep <= 4.0);
}

bool prove(const tests::ImpactClass& kind, long queries) {
  tests::Random random(4);
  Tallies tallies;
  long hits = 0;
  for (long i = 0; i < queries; ++i) {
    const tests::Query q = kind.draw(random);
    const std::optional<tests::Impact> wanted = tests::impact(q);
    hits += wanted ? 1 : 0;
    judge_all(tallies, q, wanted);
  }
  const bool good = holds(kind, tallies);
  std::printf("%-20s %9ld %9ld ", kind.name.c_str(), queries, hits);
  for (const Tally& tally : tallies) {
    std::printf(" | %7ld %7ld %8.3g %8.3g", tally.missed, tally.wrong, tally.worst,
                tally.worst_deep);
  }
  std::printf("%s\n", good ? "" : "  FAILED");
  std::fflush(stdout);
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: impact_proof_<answer> <queries a random class> <an adversarial class>\n",
               stderr);
    return 2;
  }
  std::printf("%-40s ", "");
  for (const char* method : methods) std::printf(" | %-33s", method);
  std::printf("\n%-20s %9s %9s ", "class", "queries", "hits");
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::printf(" | %7s %7s %8s %8s", "missed", "false", "ulp", "deep");
  }
  std::printf("\n");
  bool good = true;
  for (const tests::ImpactClass& kind : tests::impact_classes()) {
    good = prove(kind, std::atol(argv[kind.adversarial ? 2 : 1])) && good;
  }
  return good ? 0 : 1;
}

// Lab 5's for_speed.cpp beside a tree of eight-fold nodes and other libraries: building two trees,
// and all pairs that meet, at rest and turned; the kinds by turns. What a library does for a new
// pose before it can be asked is not timed.
//
//   bvh_benchmark --benchmark_repetitions=9 --benchmark_enable_random_interleaving
//
// TRIANGLES=1000000 in the environment takes meshes of that size, in place of 100,000.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <map>
#include <memory>

#include "bvh_traversal.hpp"
#include "chart_shapes.hpp"
#include "common/wide_bvh/wide_intersections.hpp"
#include "peers.hpp"

using namespace lab::bvh_traversal;
using common::WideBvh;

namespace {

constexpr int leaf_size = 64;
constexpr int bins = 16;

/// Anything that builds two trees, and anything that asks them.
using Ask = std::function<std::size_t()>;
using Build = std::function<Ask(const ShapePair&)>;

template <typename Tree>
Ask ask(Tree a, Tree b, const RigidTransform& a_from_b) {
  const bool is_at_rest = a_from_b.rotation.isIdentity(0.0);
  const auto trees = std::make_shared<const std::pair<Tree, Tree>>(std::move(a), std::move(b));
  return [=] {
    const auto& [tree_a, tree_b] = *trees;
    if constexpr (std::is_same_v<Tree, Bvh>) {
      return (is_at_rest ? find_intersections(tree_a, tree_b)
                         : find_intersections_moved(tree_a, tree_b, a_from_b))
          .pairs.size();
    } else {
      return (is_at_rest ? find_intersections(tree_a, tree_b, triangles_meet)
                         : find_intersections(tree_a, tree_b, a_from_b, triangles_meet))
          .pairs.size();
    }
  };
}

std::vector<std::pair<std::string, Build>> kinds() {
  std::vector<std::pair<std::string, Build>> all;
  all.emplace_back("median", [](const ShapePair& shapes) {
    return ask(build_median(shapes.a, leaf_size), build_median(shapes.b, leaf_size),
               shapes.a_from_b);
  });
  all.emplace_back("sah", [](const ShapePair& shapes) {
    return ask(build_sah(shapes.a, leaf_size, bins), build_sah(shapes.b, leaf_size, bins),
               shapes.a_from_b);
  });
  all.emplace_back("wide", [](const ShapePair& shapes) {
    return ask(WideBvh(shapes.a), WideBvh(shapes.b), shapes.a_from_b);
  });
  for (const Peer& peer : peers()) {
    if (!peer.make) continue;
    all.emplace_back(peer.name.substr(0, peer.name.find(' ')), [peer](const ShapePair& shapes) {
      const std::shared_ptr<PeerTrees> trees = peer.make(shapes.a, shapes.b);
      const auto placed = std::make_shared<bool>(false);
      return [=, pose = shapes.a_from_b] {
        if (!*placed) trees->place(pose);
        *placed = true;
        return trees->find().pairs.size();
      };
    });
  }
  return all;
}

void add(const std::string& name, const std::shared_ptr<const ShapePair>& shapes) {
  for (const auto& [kind, build] : kinds()) {
    const auto trees = std::make_shared<Ask>();
    benchmark::RegisterBenchmark((name + "/" + kind).c_str(), [=, build = build](
                                                                  benchmark::State& state) {
      if (!*trees) *trees = build(*shapes);
      std::size_t pairs = (*trees)();
      for (auto _ : state) pairs = (*trees)();
      state.counters["pairs"] = static_cast<double>(pairs);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const char* const wanted = std::getenv("TRIANGLES");
  const std::size_t triangles = wanted != nullptr ? std::stoul(wanted) : 100000;
  const std::map<std::string, ShapePair> shapes{
      {"tori", tori(triangles)}, {"spheres", spheres(triangles)}, {"shells", shells(triangles)}};
  for (const auto& [name, pair] : shapes) {
    add(name + "/rest", std::make_shared<const ShapePair>(pair));
    if (name == "shells") continue;  // turned, they meet
    add(name + "/turned", std::make_shared<const ShapePair>(ShapePair{pair.a, pair.b, turned()}));
  }
  const auto tori_at_rest = std::make_shared<const ShapePair>(shapes.at("tori"));
  for (const auto& [kind, build] : kinds()) {
    benchmark::RegisterBenchmark(("build/" + kind).c_str(), [=, build = build](
                                                                benchmark::State& state) {
      for (auto _ : state) {
        benchmark::DoNotOptimize(build(*tori_at_rest));
      }
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::RunSpecifiedBenchmarks();
}

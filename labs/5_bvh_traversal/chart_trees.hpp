#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "bvh_traversal.hpp"
#include "chart_shapes.hpp"
#include "common/wide_bvh/wide_intersections.hpp"
#include "peers.hpp"

/// The methods to find all pairs that the chart compares. Each builds its trees and returns a
/// function that queries them.
namespace lab::bvh_traversal {

using Ask = std::function<Intersections()>;
using Build = std::function<Ask(const ShapePair&)>;

inline bool is_at_rest(const ShapePair& shapes) { return shapes.a_from_b.rotation.isIdentity(0.0); }

/// Adds the pairs of two leaves. The searches below differ only in what comes before that.
inline void add_leaf_pair(const Bvh& a, const BvhNode& leaf_a, const Bvh& b, const BvhNode& leaf_b,
                          Intersections& found) {
  found.triangle_tests += std::uint64_t{leaf_a.count} * leaf_b.count;
  for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
    const Box box = box_of(a.corners[i]);
    for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
      if (overlap(box, box_of(b.corners[j])) && triangles_meet(a.corners[i], b.corners[j])) {
        found.pairs.push_back({a.triangles[i], b.triangles[j]});
      }
    }
  }
}

inline Ask brute_force(const ShapePair& shapes) {
  return [&shapes] {
    Intersections found;
    const std::size_t n_a = shapes.a.triangles.size();
    const std::size_t n_b = shapes.b.triangles.size();
    found.triangle_tests = n_a * n_b;
    for (std::uint32_t i = 0; i < n_a; ++i) {
      for (std::uint32_t j = 0; j < n_b; ++j) {
        if (triangles_meet(triangle(shapes.a, i), triangle(shapes.b, j))) {
          found.pairs.push_back({i, j});
        }
      }
    }
    return found;
  };
}

/// Runs the answer's own query.
inline Ask asked(Bvh a, Bvh b, const ShapePair& shapes) {
  const auto trees = std::make_shared<const std::pair<Bvh, Bvh>>(std::move(a), std::move(b));
  return [trees, rest = is_at_rest(shapes), pose = shapes.a_from_b] {
    return rest ? find_intersections(trees->first, trees->second)
                : find_intersections_moved(trees->first, trees->second, pose);
  };
}

inline Build by_halves(int leaf_size) {
  return [=](const ShapePair& shapes) {
    return asked(build_median(shapes.a, leaf_size), build_median(shapes.b, leaf_size), shapes);
  };
}

inline Build by_sah(int leaf_size) {
  constexpr int bins = 16;
  return [=](const ShapePair& shapes) {
    return asked(build_sah(shapes.a, leaf_size, bins), build_sah(shapes.b, leaf_size, bins),
                 shapes);
  };
}

/// Uses the pairs of leaves at which the pseudocode of step 5.3 ends; its other ends are lost.
inline Ask as_first_written(const ShapePair& shapes) {
  constexpr int leaf_size = 8;
  const auto trees = std::make_shared<const std::pair<Bvh, Bvh>>(build_median(shapes.a, leaf_size),
                                                                 build_median(shapes.b, leaf_size));
  return [trees] {
    const auto& [a, b] = *trees;
    Intersections found;
    for (const NodePair& end : traverse_as_first_written(a, b).ends) {
      const BvhNode& node_a = a.nodes[end.a];
      const BvhNode& node_b = b.nodes[end.b];
      if (node_a.count > 0 && node_b.count > 0) add_leaf_pair(a, node_a, b, node_b, found);
    }
    std::sort(found.pairs.begin(), found.pairs.end());
    return found;
  };
}

/// Rounds the tree's boxes outward to floats, as trees of half the size would store them.
inline Bvh in_floats(Bvh bvh) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (BvhNode& node : bvh.nodes) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      node.box.low[i] =
          static_cast<double>(std::nextafter(static_cast<float>(node.box.low[i]), -infinity));
      node.box.high[i] =
          static_cast<double>(std::nextafter(static_cast<float>(node.box.high[i]), infinity));
    }
  }
  return bvh;
}

inline Ask in_float_boxes(const ShapePair& shapes) {
  return asked(in_floats(build_sah(shapes.a, 64, 16)), in_floats(build_sah(shapes.b, 64, 16)),
               shapes);
}

/// Uses eight children a node, tested at once.
inline Ask by_eights(const ShapePair& shapes) {
  const auto trees = std::make_shared<const std::pair<common::WideBvh, common::WideBvh>>(
      common::WideBvh(shapes.a), common::WideBvh(shapes.b));
  return [trees, rest = is_at_rest(shapes), pose = shapes.a_from_b] {
    const auto& [a, b] = *trees;
    const common::WideIntersections wide = rest ? find_intersections(a, b, triangles_meet)
                                                : find_intersections(a, b, pose, triangles_meet);
    Intersections found{{}, wide.box_tests, wide.triangle_tests};
    found.pairs.reserve(wide.pairs.size());
    for (const auto& [i, j] : wide.pairs) found.pairs.push_back({i, j});
    return found;
  };
}

/// Builds the peer's tree for the pose before the query.
inline Build by_peer(const Peer& peer) {
  return [=](const ShapePair& shapes) -> Ask {
    const std::shared_ptr<PeerTrees> trees = peer.make(shapes.a, shapes.b);
    trees->place(shapes.a_from_b);
    return [trees] { return trees->find(); };
  };
}

}  // namespace lab::bvh_traversal

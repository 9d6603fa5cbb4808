#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "bvh_traversal.hpp"
#include "trial.hpp"

/// How the results of this lab are judged and printed.
namespace tests {

namespace lab = ::lab::bvh_traversal;

/// Points as an argument, which Trial prints when it must.
struct Points {
  std::vector<Vec3> points;
};
inline std::string text(const Points& list) {
  std::string points;
  for (const Vec3& p : list.points) points += (points.empty() ? "" : ", ") + text(p);
  return "{" + points + "}";
}

inline Points code(const common::Triangle& t) { return {{t[0], t[1], t[2]}}; }
inline Points code(const lab::Box& box) { return {{box.low, box.high}}; }

/// A box as a value: two corners.
struct Corners {
  lab::Box box;
};
inline bool is_finite(const Corners& v) { return is_finite(v.box.low) && is_finite(v.box.high); }
inline double length(const Corners& v) { return length(v.box.low) + length(v.box.high); }
inline double difference(const Corners& a, const Corners& b) {
  return difference(a.box.low, b.box.low) + difference(a.box.high, b.box.high);
}
inline std::string text(const Corners& v) { return text(code(v.box)); }

inline const Bound exactly{0.0, "the answer must be equal"};

/// Two indices in order, of nodes or of triangles.
using Indices = std::array<std::uint32_t, 2>;

/// A sorted list of pairs of indices as a value; its distance from another is the number of those
/// that are in one of the two alone, at least one where they differ.
struct Pairs {
  std::vector<Indices> pairs;
};
template <typename Pair>
Pairs pairs_of(const std::vector<Pair>& list) {
  Pairs pairs;
  for (const Pair& pair : list) pairs.pairs.push_back({pair.a, pair.b});
  return pairs;
}
inline bool is_finite(const Pairs&) { return true; }
inline double length(const Pairs&) { return 0.0; }
inline double difference(const Pairs& a, const Pairs& b) {
  if (a.pairs == b.pairs) return 0.0;
  std::vector<Indices> p = a.pairs;
  std::vector<Indices> q = b.pairs;
  std::sort(p.begin(), p.end());
  std::sort(q.begin(), q.end());
  std::vector<Indices> apart;
  std::set_symmetric_difference(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(apart));
  return std::max(1.0, static_cast<double>(apart.size()));
}
inline std::string text(const Pairs& v) {
  constexpr std::size_t shown = 12;
  std::string list = std::to_string(v.pairs.size()) + " {";
  for (std::size_t i = 0; i < std::min(v.pairs.size(), shown); ++i) {
    list += (i == 0 ? "{" : ", {") + std::to_string(v.pairs[i][0]) + ", " +
            std::to_string(v.pairs[i][1]) + "}";
  }
  return list + (v.pairs.size() > shown ? ", ...}" : "}");
}

inline Pairs doubled(Pairs pairs) {
  const std::vector<Indices> once = pairs.pairs;
  pairs.pairs.insert(pairs.pairs.end(), once.begin(), once.end());
  std::sort(pairs.pairs.begin(), pairs.pairs.end());
  return pairs;
}

inline Pairs swapped(Pairs pairs) {
  for (Indices& pair : pairs.pairs) std::swap(pair[0], pair[1]);
  std::sort(pairs.pairs.begin(), pairs.pairs.end());
  return pairs;
}

/// Requires that the right pairs are in order.
inline void expect_sorted(const Trial& trial, const Pairs& got, const Pairs& wanted,
                          const std::string& name) {
  if (std::is_sorted(got.pairs.begin(), got.pairs.end())) return;
  Pairs sorted = got;
  std::sort(sorted.pairs.begin(), sorted.pairs.end());
  if (sorted.pairs != wanted.pairs) return;
  trial.of("the order of the " + name)
      .expect_small("pairs out of order", difference(got, sorted), exactly,
                    "the " + name + " are not sorted: sort them at the end");
}

/// A tree as a value, where an exception is wanted instead.
struct Tree {
  lab::Bvh bvh;
};
inline bool has_finite_boxes(const lab::Bvh& bvh) {
  return std::all_of(bvh.nodes.begin(), bvh.nodes.end(),
                     [](const lab::BvhNode& node) { return is_finite(Corners{node.box}); });
}
inline bool is_finite(const Tree& v) { return has_finite_boxes(v.bvh); }
inline std::string text(const Tree& v) {
  return "a Bvh of " + std::to_string(v.bvh.nodes.size()) + " nodes";
}

}  // namespace tests

#pragma once

#include "rational.hpp"
#include "trees.hpp"

/// All pairs that meet, by trying all.
namespace tests {

inline bool apart_by_boxes(const common::Triangle& a, const common::Triangle& b) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (std::max({a[0][i], a[1][i], a[2][i]}) < std::min({b[0][i], b[1][i], b[2][i]})) return true;
    if (std::max({b[0][i], b[1][i], b[2][i]}) < std::min({a[0][i], a[1][i], a[2][i]})) return true;
  }
  return false;
}

/// Whether b is so clearly on one side of a's plane that no digits are needed to say so.
inline bool clearly_above_or_below(const common::Triangle& a, const common::Triangle& b) {
  const Vec3 e = a[1] - a[0];
  const Vec3 f = a[2] - a[0];
  const Vec3 n = e.cross(f);
  double reach = 0.0;
  int above = 0;
  int below = 0;
  for (const Vec3& p : b) reach = std::max(reach, (p - a[0]).norm());
  const double sure = 1e-12 * e.norm() * f.norm() * reach;
  for (const Vec3& p : b) {
    above += n.dot(p - a[0]) > sure ? 1 : 0;
    below += n.dot(p - a[0]) < -sure ? 1 : 0;
  }
  return above == 3 || below == 3;
}

inline bool meet(const common::Triangle& a, const common::Triangle& b) {
  return !apart_by_boxes(a, b) && !clearly_above_or_below(a, b) && !clearly_above_or_below(b, a) &&
         meet_exactly(a, b);
}

inline std::vector<common::Triangle> corners_of(const common::TriangleMesh& mesh) {
  std::vector<common::Triangle> corners;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) corners.push_back(triangle(mesh, i));
  return corners;
}

inline Pairs brute_force(const common::TriangleMesh& a, const common::TriangleMesh& b) {
  const std::vector<common::Triangle> corners_a = corners_of(a);
  const std::vector<common::Triangle> corners_b = corners_of(b);
  Pairs pairs;
  for (std::uint32_t i = 0; i < corners_a.size(); ++i) {
    for (std::uint32_t j = 0; j < corners_b.size(); ++j) {
      if (meet(corners_a[i], corners_b[j])) pairs.pairs.push_back({i, j});
    }
  }
  return pairs;
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

/// Entries of a tree where triangles of its mesh are meant.
inline Pairs by_entries(const Pairs& pairs, const lab::Bvh& a, const lab::Bvh& b) {
  const auto entry = [](const lab::Bvh& bvh, std::uint32_t triangle) {
    const auto at = std::find(bvh.triangles.begin(), bvh.triangles.end(), triangle);
    return static_cast<std::uint32_t>(at - bvh.triangles.begin());
  };
  Pairs entries;
  for (const Indices& pair : pairs.pairs) {
    entries.pairs.push_back({entry(a, pair[0]), entry(b, pair[1])});
  }
  std::sort(entries.pairs.begin(), entries.pairs.end());
  return entries;
}

inline const std::string unsorted = "the pairs are not sorted";

inline void expect_sorted(const Trial& trial, const Pairs& got, const Pairs& wanted) {
  Pairs sorted = got;
  std::sort(sorted.pairs.begin(), sorted.pairs.end());
  if (sorted.pairs != wanted.pairs) return;
  trial.of("the order of the pairs")
      .expect_small("pairs out of order", difference(got, sorted), exactly, unsorted);
}

/// Requires the pairs of the two meshes, and no other.
inline void expect_pairs(const Trial& trial, const lab::Intersections& found, const Pairs& wanted,
                         const lab::Bvh& a, const lab::Bvh& b,
                         std::vector<Suspect<Pairs>> suspects = {}) {
  const Pairs got = pairs_of(found.pairs);
  expect_sorted(trial, got, wanted);
  suspects.push_back({doubled(wanted), "each pair is reported twice"});
  suspects.push_back({swapped(wanted), "the two indices of a pair are swapped: a's comes first"});
  suspects.push_back({by_entries(wanted, a, b),
                      "these are entries, not triangles: look them up in Bvh::triangles"});
  trial.of("the pairs").expect(got, wanted, exactly, suspects);
}

}  // namespace tests

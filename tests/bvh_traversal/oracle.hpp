#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rational.hpp"
#include "trees.hpp"

/// All pairs that meet, by trying all.
namespace tests {

/// Whether b is so clearly beyond a along a direction, on either side, that no digits are needed to
/// say so. However the direction was rounded, it then parts the two.
inline bool clearly_parts(const Vec3& direction, const common::Triangle& a,
                          const common::Triangle& b) {
  std::pair<double, double> of_a{0.0, 0.0};
  std::pair<double, double> of_b{std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
  double reach = 0.0;
  const auto look_at = [&](const Vec3& corner, std::pair<double, double>& range) {
    const Vec3 from_a = corner - a[0];
    const double along = direction.dot(from_a);
    range = {std::min(range.first, along), std::max(range.second, along)};
    reach = std::max(reach, from_a.lpNorm<1>());
  };
  look_at(a[1], of_a);
  look_at(a[2], of_a);
  for (const Vec3& corner : b) look_at(corner, of_b);
  const double sure = 1e-12 * direction.lpNorm<1>() * reach;
  return of_a.second + sure < of_b.first || of_b.second + sure < of_a.first;
}

/// Across their planes, or across an edge of each.
inline bool clearly_apart(const common::Triangle& a, const common::Triangle& b) {
  const auto edge = [](const common::Triangle& t, std::size_t i) {
    return Vec3(t[(i + 1) % 3] - t[i]);
  };
  for (const common::Triangle* t : {&a, &b}) {
    if (clearly_parts(edge(*t, 0).cross(edge(*t, 1)), a, b)) return true;
  }
  for (std::size_t i = 0; i < 9; ++i) {
    if (clearly_parts(edge(a, i / 3).cross(edge(b, i % 3)), a, b)) return true;
  }
  return false;
}

/// On which side of the plane through a, b and c a point is, where no digits are needed to say so;
/// 0 where they are.
inline int clear_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 e = b - a;
  const Vec3 f = c - a;
  const Vec3 g = point - a;
  const double volume = e.cross(f).dot(g);
  const double sure = 1e-12 * e.norm() * f.norm() * g.norm();
  return volume > sure ? 1 : volume < -sure ? -1 : 0;
}

/// Whether an edge of a so clearly goes through the inside of b.
inline bool clearly_pierces(const common::Triangle& a, const common::Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& from = a[i];
    const Vec3& to = a[(i + 1) % 3];
    const int before = clear_side(b[0], b[1], b[2], from);
    if (before == 0 || clear_side(b[0], b[1], b[2], to) != -before) continue;
    const int turn = clear_side(from, to, b[0], b[1]);
    if (turn != 0 && clear_side(from, to, b[1], b[2]) == turn &&
        clear_side(from, to, b[2], b[0]) == turn) {
      return true;
    }
  }
  return false;
}

inline bool share_a_corner(const common::Triangle& a, const common::Triangle& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

/// By digits where these say so, by whole numbers where not. Of triangles whose boxes overlap.
inline bool meet(const common::Triangle& a, const common::Triangle& b) {
  if (share_a_corner(a, b)) return true;
  if (clearly_pierces(a, b) || clearly_pierces(b, a)) return true;
  return !clearly_apart(a, b) && meet_exactly(a, b);
}

struct Boxed {
  common::Triangle corners;
  lab::Box box;
};

inline std::vector<Boxed> boxed(const common::TriangleMesh& mesh) {
  std::vector<Boxed> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const common::Triangle corners = triangle(mesh, i);
    all.push_back({corners, box_around(corners)});
  }
  return all;
}

inline Pairs brute_force(const common::TriangleMesh& a, const common::TriangleMesh& b) {
  const std::vector<Boxed> boxed_a = boxed(a);
  const std::vector<Boxed> boxed_b = boxed(b);
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxed_a.size(); ++i) {
    for (std::uint32_t j = 0; j < boxed_b.size(); ++j) {
      if (boxes_meet(boxed_a[i].box, boxed_b[j].box) &&
          meet(boxed_a[i].corners, boxed_b[j].corners)) {
        pairs.pairs.push_back({i, j});
      }
    }
  }
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

using PairSuspects = std::vector<Suspect<Pairs>>;

/// Requires the pairs of the two meshes, and no other.
/// others  suspects besides those of every query: a function, as in Trial::expect
template <std::invocable Others>
void expect_pairs(const Trial& trial, const lab::Intersections& found, const Pairs& wanted,
                  const lab::Bvh& a, const lab::Bvh& b, const Others& others) {
  const Pairs got = pairs_of(found.pairs);
  expect_sorted(trial, got, wanted, "pairs");
  trial.of("the pairs").expect(got, wanted, exactly, [&] {
    PairSuspects suspects = others();
    suspects.push_back({doubled(wanted), "each pair is reported twice: report it once"});
    suspects.push_back({swapped(wanted), "the two indices of a pair are swapped: a's comes first"});
    suspects.push_back({by_entries(wanted, a, b),
                        "these are entries, not triangles: look them up in Bvh::triangles"});
    return suspects;
  });
}

}  // namespace tests

#include "common/wide_bvh/triangle_lanes.hpp"

#include <algorithm>
#include <bit>

namespace common {
namespace {

struct Vector {
  Doubles x, y, z;
};
using Corners = std::array<Vector, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// A plane's normal, and the sizes of the products that it is made of.
struct Normal {
  Vector n, size;
};

Normal normal(const Vector& a, const Vector& b, const Vector& c) {
  const Vector e = b - a;
  const Vector f = c - a;
  const Vector left{e.y * f.z, e.z * f.x, e.x * f.y};
  const Vector right{e.z * f.y, e.x * f.z, e.y * f.x};
  return {left - right,
          {size_of(left.x) + size_of(right.x), size_of(left.y) + size_of(right.y),
           size_of(left.z) + size_of(right.z)}};
}

/// Where a volume is surely above zero, and where surely below.
struct Sign {
  DoubleMask above, below;
};

Sign sign(const Normal& normal, const Vector& d) {
  const auto& [n, size] = normal;
  const Doubles volume = n.x * d.x + n.y * d.y + n.z * d.z;
  // Each of the six products of three differences is rounded less than a dozen times by 2⁻⁵³.
  const Doubles error =
      2e-15 * (size.x * size_of(d.x) + size.y * size_of(d.y) + size.z * size_of(d.z)) + 1e-240;
  return {volume > error, volume < -error};
}

using Sides = std::array<Sign, 3>;

Sides sides(const Corners& plane, const Corners& points) {
  const Normal n = normal(plane[0], plane[1], plane[2]);
  return {sign(n, points[0] - plane[0]), sign(n, points[1] - plane[0]),
          sign(n, points[2] - plane[0])};
}

DoubleMask one_side(const Sides& s) {
  return (s[0].above & s[1].above & s[2].above) | (s[0].below & s[1].below & s[2].below);
}
DoubleMask is_sure(const Sides& s) {
  return (s[0].above | s[0].below) & (s[1].above | s[1].below) & (s[2].above | s[2].below);
}

Vector pick(const DoubleMask& mask, const Vector& a, const Vector& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

/// A triangle turned so that the corner alone on its side comes first.
struct Turned {
  Corners corners;
  DoubleMask is_below;  ///< that corner
};

Turned alone_first(const Corners& t, const Sides& s) {
  const DoubleMask third = ~(s[0].above ^ s[1].above);
  const DoubleMask second = ~(s[0].above ^ s[2].above) & ~third;
  const auto turned = [&](std::size_t i) {
    return pick(third, t[(i + 2) % 3], pick(second, t[(i + 1) % 3], t[i]));
  };
  return {{turned(0), turned(1), turned(2)},
          ~((third & s[2].above) | (second & s[1].above) | (~third & ~second & s[0].above))};
}

struct Verdict {
  DoubleMask meet, apart;  ///< where neither is set, it is not sure
};

/// Guigue, Devillers 2003, JGT 8(1), where no corner is near the other's plane.
Verdict verdict(const Corners& corners_a, const Corners& corners_b) {
  const Sides side_a = sides(corners_b, corners_a);
  const Sides side_b = sides(corners_a, corners_b);
  const DoubleMask apart_by_plane = one_side(side_a) | one_side(side_b);
  const DoubleMask sure = is_sure(side_a) & is_sure(side_b) & ~apart_by_plane;
  if (bits(sure) == 0) return {DoubleMask{}, apart_by_plane};
  const auto [a, turn_b_over] = alone_first(corners_a, side_a);
  const auto [b, turn_a_over] = alone_first(corners_b, side_b);
  const Vector a1 = pick(turn_a_over, a[2], a[1]);
  const Vector a2 = pick(turn_a_over, a[1], a[2]);
  const Vector b1 = pick(turn_b_over, b[2], b[1]);
  const Vector b2 = pick(turn_b_over, b[1], b[2]);
  const Sign first = sign(normal(a[0], a1, b[0]), b1 - a[0]);
  const Sign second = sign(normal(a[0], a2, b2), b[0] - a[0]);
  return {sure & first.below & second.below,
          apart_by_plane | (sure & (first.above | second.above))};
}

/// Least digit first. Sorting by comparison would cost as much as finding the pairs.
void sort_by_digits(std::vector<std::uint64_t>& keys) {
  constexpr int digit = 11;
  constexpr std::size_t values = std::size_t{1} << digit;
  std::uint64_t used = 0;
  for (const std::uint64_t key : keys) used |= key;
  std::vector<std::uint64_t> sorted(keys.size());
  for (int shift = 0; shift < 64; shift += digit) {
    if ((used >> shift) % values == 0) continue;
    std::array<std::size_t, values + 1> begin{};
    for (const std::uint64_t key : keys) ++begin[(key >> shift) % values + 1];
    for (std::size_t i = 1; i < values; ++i) begin[i] += begin[i - 1];
    for (const std::uint64_t key : keys) sorted[begin[(key >> shift) % values]++] = key;
    keys.swap(sorted);
  }
}

/// The corners of a few triangles, side by side.
template <typename EntryOf>
Corners gathered(const EntryOf& entry_of) {
  std::array<const double*, double_lanes> from{};
  for (std::size_t i = 0; i < double_lanes; ++i) from[i] = entry_of(i).corners[0].data();
  const auto lanes = [&](std::size_t k) {
    Doubles result{};
    for (std::size_t i = 0; i < double_lanes; ++i) result[i] = from[i][k];
    return result;
  };
  return {{{lanes(0), lanes(1), lanes(2)},
           {lanes(3), lanes(4), lanes(5)},
           {lanes(6), lanes(7), lanes(8)}}};
}

/// As for one triangle, to the last bit.
Corners transformed(const RigidTransform& transform, Corners corners) {
  const Mat3& R = transform.rotation;
  const Vec3& t = transform.translation;
  const auto row = [&](Eigen::Index i, const Vector& p) {
    return ((R(i, 0) * p.x + R(i, 1) * p.y) + R(i, 2) * p.z) + t[i];
  };
  for (Vector& p : corners) p = {row(0, p), row(1, p), row(2, p)};
  return corners;
}

}  // namespace

template <bool moved>
void TriangleBatch<moved>::test() {
  for (std::size_t i = 0; i < size_; i += double_lanes) {
    test(&waiting_[i], std::min(double_lanes, size_ - i));
  }
  size_ = 0;
}

template <bool moved>
void TriangleBatch<moved>::test(const TriangleIndices* pairs, std::size_t count) {
  const auto pair = [&](std::size_t lane) { return pairs[std::min(lane, count - 1)]; };
  const Corners a = gathered([&](std::size_t lane) -> auto& { return a_.entries()[pair(lane).a]; });
  Corners b = gathered([&](std::size_t lane) -> auto& { return b_.entries()[pair(lane).b]; });
  if constexpr (moved) b = transformed(a_from_b_, b);
  const Verdict result = verdict(a, b);
  const std::uint32_t meet = bits(result.meet);
  const std::uint32_t apart = bits(result.apart);
  for (std::size_t i = 0; i < count; ++i) {
    if ((apart >> i & 1U) != 0) continue;
    const WideBvh::Entry& entry_a = a_.entries()[pairs[i].a];
    const WideBvh::Entry& entry_b = b_.entries()[pairs[i].b];
    if ((meet >> i & 1U) != 0 ||
        triangles_meet_(entry_a.corners, moved ? common::transformed(a_from_b_, entry_b.corners)
                                               : entry_b.corners)) {
      met_.push_back(std::uint64_t{entry_a.triangle} << 32 | entry_b.triangle);
    }
  }
}

template <bool moved>
std::vector<TriangleIndices> TriangleBatch<moved>::sorted_pairs() {
  test();
  constexpr std::size_t few = 1000;
  if (met_.size() < few) {
    std::sort(met_.begin(), met_.end());
  } else {
    sort_by_digits(met_);
  }
  std::vector<TriangleIndices> pairs;
  pairs.reserve(met_.size());
  for (const std::uint64_t key : met_) {
    pairs.push_back({static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)});
  }
  return pairs;
}

template class TriangleBatch<false>;
template class TriangleBatch<true>;

}  // namespace common

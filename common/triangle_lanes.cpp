#include "common/triangle_lanes.hpp"

#include <algorithm>
#include <bit>

namespace common {
namespace {

struct Vector {
  Doubles x, y, z;
};
using Corners = std::array<Vector, 3>;

Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// A plane's normal, and the sizes of the products of which it is made.
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

/// Turns the triangle so that the corner alone on its side comes first. Returns where it is below.
DoubleMask put_alone_first(Corners& t, const Sides& s) {
  const DoubleMask third = ~(s[0].above ^ s[1].above);
  const DoubleMask second = ~(s[0].above ^ s[2].above) & ~third;
  const Corners old = t;
  for (std::size_t i = 0; i < 3; ++i) {
    t[i] = pick(third, old[(i + 2) % 3], pick(second, old[(i + 1) % 3], old[i]));
  }
  return ~((third & s[2].above) | (second & s[1].above) | (~third & ~second & s[0].above));
}

void swap_where(const DoubleMask& mask, Vector& a, Vector& b) {
  const Vector old = a;
  a = pick(mask, b, a);
  b = pick(mask, old, b);
}

struct Verdict {
  DoubleMask meet, apart;  ///< where neither is set, it is not sure
};

/// Guigue, Devillers 2003, JGT 8(1), where no corner is near the other's plane.
Verdict verdict(Corners a, Corners b) {
  const Sides side_a = sides(b, a);
  const Sides side_b = sides(a, b);
  const DoubleMask apart_by_plane = one_side(side_a) | one_side(side_b);
  const DoubleMask sure = is_sure(side_a) & is_sure(side_b) & ~apart_by_plane;
  if (bits(sure) == 0) return {DoubleMask{}, apart_by_plane};
  const DoubleMask turn_b_over = put_alone_first(a, side_a);
  const DoubleMask turn_a_over = put_alone_first(b, side_b);
  swap_where(turn_b_over, b[1], b[2]);
  swap_where(turn_a_over, a[1], a[2]);
  const Sign first = sign(normal(a[0], a[1], b[0]), b[1] - a[0]);
  const Sign second = sign(normal(a[0], a[2], b[2]), b[0] - a[0]);
  return {sure & first.below & second.below, apart_by_plane | (sure & (first.above | second.above))};
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

}  // namespace

void TriangleBatch::test() {
  Corners a, b;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const auto coordinate = [&](std::size_t k) {
      return loaded<Doubles>(corners_[3 * corner + k].data());
    };
    a[corner] = {coordinate(0), coordinate(1), coordinate(2)};
    b[corner] = {coordinate(9), coordinate(10), coordinate(11)};
  }
  const Verdict result = verdict(a, b);
  const std::uint32_t meet = bits(result.meet);
  const std::uint32_t apart = bits(result.apart);
  for (std::size_t i = 0; i < size_; ++i) {
    bool is_meeting = (meet >> i & 1U) != 0;
    if (!is_meeting && (apart >> i & 1U) == 0) {
      Triangle t, u;
      for (std::size_t k = 0; k < 9; ++k) {
        t[k / 3][static_cast<Eigen::Index>(k % 3)] = corners_[k][i];
        u[k / 3][static_cast<Eigen::Index>(k % 3)] = corners_[9 + k][i];
      }
      is_meeting = triangles_meet_(t, u);
    }
    if (is_meeting) met_.push_back(std::uint64_t{pairs_[i].a} << 32 | pairs_[i].b);
  }
  size_ = 0;
}

std::vector<TriangleIndices> TriangleBatch::sorted_pairs() {
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

}  // namespace common

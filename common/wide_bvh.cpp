#include "common/wide_bvh.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "common/lanes.hpp"
#include "common/triangle_lanes.hpp"

namespace common {
namespace {

using Node = WideBvh::Node;
using Leaf = WideBvh::Leaf;
constexpr std::size_t width = WideBvh::width;
constexpr std::size_t leaf_size = WideBvh::leaf_size;

std::uint32_t first_bits(std::uint32_t count) { return (1U << count) - 1U; }

/// Calls `visit` with the places of the bits that are set.
template <typename Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1U) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Eight boxes of one tree, led to the other's frame and units as boxes around them.
class BoxMap {
 public:
  BoxMap(const Mat3& matrix, const Vec3& shift, double margin) : margin_(static_cast<float>(margin)) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto row = static_cast<std::size_t>(k);
      shift_[row] = static_cast<float>(shift[k]);
      for (Eigen::Index l = 0; l < 3; ++l) {
        matrix_[row][static_cast<std::size_t>(l)] = static_cast<float>(matrix(k, l));
      }
    }
  }

  /// By c → M c + t of the doubled centre, h → |M| h of the doubled half sides.
  template <bool turned>
  void map(const Node& from, Node& to) const {
    for (std::size_t part = 0; part < width; part += float_lanes) {
      std::array<Floats, 3> centre, half;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto low = loaded<Floats>(&from.low[k][part]);
        const auto high = loaded<Floats>(&from.high[k][part]);
        centre[k] = 0.5F * (low + high);
        half[k] = 0.5F * (high - low);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        Floats c = Floats{} + shift_[k];
        Floats h = Floats{} + margin_;
        for (std::size_t l = turned ? 0 : k; l < (turned ? 3 : k + 1); ++l) {
          c += matrix_[k][l] * centre[l];
          h += std::abs(matrix_[k][l]) * half[l];
        }
        store(c - h, &to.low[k][part]);
        store(c + h, &to.high[k][part]);
      }
    }
  }

 private:
  std::array<std::array<float, 3>, 3> matrix_{};
  std::array<float, 3> shift_{};
  float margin_;
};

/// Which of the eight boxes overlap box j of `others`; what is no number is not apart.
std::uint32_t overlaps(const Node& boxes, const Node& others, std::size_t j) {
  std::uint32_t result = 0;
  for (std::size_t part = 0; part < width; part += float_lanes) {
    FloatMask apart{};
    for (std::size_t k = 0; k < 3; ++k) {
      apart |= (loaded<Floats>(&boxes.low[k][part]) > others.high[k][j]) |
               (loaded<Floats>(&boxes.high[k][part]) < others.low[k][j]);
    }
    result |= (~bits(apart) & first_bits(float_lanes)) << part;
  }
  return result;
}

/// The triangles of a leaf side by side, moved, with their boxes. Lanes beyond `count` hold nothing
/// of use.
struct LeafLanes {
  std::uint32_t first = 0, count = 0;
  alignas(register_bytes) std::array<std::array<double, leaf_size>, 9> corners{};
  alignas(register_bytes) std::array<std::array<double, leaf_size>, 3> low{}, high{};
};

/// As transformed() does it, to the last bit.
template <bool moved>
void load(const WideBvh& bvh, const Leaf& leaf, const RigidTransform& transform, LeafLanes& lanes) {
  lanes.first = leaf.first;
  lanes.count = leaf.count;
  const double* const from = bvh.corners(leaf);
  const Mat3& R = transform.rotation;
  for (std::size_t part = 0; part < leaf_size; part += double_lanes) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<Doubles, 3> x;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = loaded<Doubles>(from + (3 * corner + k) * leaf.count + part);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        Doubles y = x[k];
        if constexpr (moved) {
          y = ((R(row, 0) * x[0] + R(row, 1) * x[1]) + R(row, 2) * x[2]) +
              transform.translation[row];
        }
        store(y, &lanes.corners[3 * corner + k][part]);
        if (corner == 0) {
          store(y, &lanes.low[k][part]);
          store(y, &lanes.high[k][part]);
        } else {
          store(least(loaded<Doubles>(&lanes.low[k][part]), y), &lanes.low[k][part]);
          store(greatest(loaded<Doubles>(&lanes.high[k][part]), y), &lanes.high[k][part]);
        }
      }
    }
  }
}

/// Which triangles of the leaf have a box that overlaps low … high.
std::uint32_t overlaps(const LeafLanes& leaf, const Vec3& low, const Vec3& high) {
  std::uint32_t result = 0;
  for (std::size_t part = 0; part < leaf_size; part += double_lanes) {
    DoubleMask apart{};
    for (std::size_t k = 0; k < 3; ++k) {
      apart |= (loaded<Doubles>(&leaf.low[k][part]) > high[static_cast<Eigen::Index>(k)]) |
               (loaded<Doubles>(&leaf.high[k][part]) < low[static_cast<Eigen::Index>(k)]);
    }
    result |= (~bits(apart) & first_bits(double_lanes)) << part;
  }
  return result & first_bits(leaf.count);
}

template <bool moved>
class Query {
 public:
  Query(const WideBvh& a, const WideBvh& b, const RigidTransform& a_from_b, TrianglesMeet meet)
      : a_(a), b_(b), a_from_b_(a_from_b), batch_(meet),
        to_a_(Mat3::Identity(), Vec3::Zero(), 0.0), to_b_(to_a_) {
    const Mat3& R = a_from_b.rotation;
    const double ratio = a.scale() / b.scale();
    const Vec3 shift = (R * b.centre() + a_from_b.translation - a.centre()) * a.scale();
    const double far = R.cwiseAbs().sum() * (b.centre().cwiseAbs().sum() + 3.0 / b.scale()) +
                       a_from_b.translation.cwiseAbs().sum() + a.centre().cwiseAbs().sum();
    const double skew = (R.transpose() * R - Mat3::Identity()).cwiseAbs().sum();
    // More than all roundings together: of floats in these units, and of doubles in metres.
    const double margin =
        1e-6 * (3.0 + 9.0 * R.cwiseAbs().maxCoeff() * ratio + shift.cwiseAbs().sum()) +
        1e-14 * far * a.scale();
    to_a_ = BoxMap(ratio * R, shift, margin);
    to_b_ = BoxMap(R.transpose() / ratio, -R.transpose() * shift / ratio,
                   (1.0 + R.cwiseAbs().maxCoeff()) * 3.0 * margin / ratio +
                       4.0 * skew * (1.0 + (1.0 + shift.cwiseAbs().sum()) / ratio));
  }

  WideIntersections run() {
    stack_.push_back({0, 0});
    while (!stack_.empty()) {
      const TriangleIndices pair = stack_.back();
      stack_.pop_back();
      test(node(a_, pair.a, scratch_a_), node(b_, pair.b, scratch_b_));
    }
    found_.pairs = batch_.sorted_pairs();
    return std::move(found_);
  }

 private:
  static bool is_leaf(std::uint32_t child) { return static_cast<std::int32_t>(child) < 0; }

  /// A leaf as a node of one child.
  static const Node& node(const WideBvh& bvh, std::uint32_t child, Node& scratch) {
    if (!is_leaf(child)) return bvh.nodes()[child];
    const Leaf& leaf = bvh.leaves()[~child];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      scratch.low[k][0] = static_cast<float>((leaf.low[i] - bvh.centre()[i]) * bvh.scale());
      scratch.high[k][0] = static_cast<float>((leaf.high[i] - bvh.centre()[i]) * bvh.scale());
    }
    scratch.child[0] = child;
    scratch.size = 1;
    return scratch;
  }

  /// All children of one with all of the other.
  void test(const Node& a, const Node& b) {
    found_.box_tests += std::uint64_t{a.size} * b.size;
    Node b_in_a, a_in_b;
    to_a_.map<moved>(b, b_in_a);
    if constexpr (moved) to_b_.map<true>(a, a_in_b);
    for (std::size_t j = 0; j < b.size; ++j) {
      std::uint32_t near = overlaps(a, b_in_a, j) & first_bits(a.size);
      if constexpr (moved) near &= overlaps(a_in_b, b, j);
      bool is_loaded = false;
      for_each_bit(near, [&](std::size_t i) {
        if (!is_leaf(a.child[i]) || !is_leaf(b.child[j])) {
          stack_.push_back({a.child[i], b.child[j]});
          return;
        }
        if (!is_loaded) take(b_.leaves()[~b.child[j]]);
        is_loaded = true;
        test_leaves(a_.leaves()[~a.child[i]]);
      });
    }
  }

  void take(const Leaf& leaf) {
    load<moved>(b_, leaf, a_from_b_, lanes_b_);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      low_b_[i] = *std::min_element(lanes_b_.low[k].begin(), lanes_b_.low[k].begin() + leaf.count);
      high_b_[i] =
          *std::max_element(lanes_b_.high[k].begin(), lanes_b_.high[k].begin() + leaf.count);
    }
  }

  /// With the leaf of b that was taken.
  void test_leaves(const Leaf& leaf) {
    found_.triangle_tests += std::uint64_t{leaf.count} * lanes_b_.count;
    const std::uint32_t near_b = overlaps(lanes_b_, leaf.low, leaf.high);
    if (near_b == 0) return;
    load<false>(a_, leaf, a_from_b_, lanes_a_);
    for_each_bit(overlaps(lanes_a_, low_b_, high_b_), [&](std::size_t i) {
      const Vec3 low(lanes_a_.low[0][i], lanes_a_.low[1][i], lanes_a_.low[2][i]);
      const Vec3 high(lanes_a_.high[0][i], lanes_a_.high[1][i], lanes_a_.high[2][i]);
      for_each_bit(near_b & overlaps(lanes_b_, low, high), [&](std::size_t j) {
        batch_.add({a_.triangle(lanes_a_.first + i), b_.triangle(lanes_b_.first + j)},
                   &lanes_a_.corners[0][i], &lanes_b_.corners[0][j]);
      });
    });
  }

  const WideBvh& a_;
  const WideBvh& b_;
  const RigidTransform& a_from_b_;
  TriangleBatch batch_;
  BoxMap to_a_, to_b_;
  std::vector<TriangleIndices> stack_;
  Node scratch_a_, scratch_b_;
  LeafLanes lanes_a_, lanes_b_;
  Vec3 low_b_, high_b_;
  WideIntersections found_;
};

}  // namespace

WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     TrianglesMeet triangles_meet) {
  return Query<false>(a, b, {}, triangles_meet).run();
}

WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     const RigidTransform& a_from_b, TrianglesMeet triangles_meet) {
  if (!a_from_b.rotation.allFinite() || !a_from_b.translation.allFinite()) {
    throw std::invalid_argument("a_from_b: an entry is not finite");
  }
  return Query<true>(a, b, a_from_b, triangles_meet).run();
}

}  // namespace common

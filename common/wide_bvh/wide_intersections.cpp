#include "common/wide_bvh/wide_intersections.hpp"

#include <algorithm>
#include <bit>

#include "common/wide_bvh/lanes.hpp"
#include "common/wide_bvh/triangle_lanes.hpp"

namespace common {
namespace {

using Node = WideBvh::Node;
constexpr std::size_t width = WideBvh::width;

std::uint32_t first_bits(std::uint32_t count) { return (1U << count) - 1U; }

/// Calls `visit` with the places of the bits that are set.
template <typename Visit>
void for_each_bit(std::uint64_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Where eight boxes reach from and to along a direction.
struct Slabs {
  alignas(register_bytes) std::array<float, width> from, to;
};

/// Eight boxes of one tree, led to the other's frame and units as boxes around them.
class BoxMap {
 public:
  BoxMap(const Mat3& matrix, const Vec3& shift, double margin)
      : margin_(static_cast<float>(margin)) {
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
        constexpr std::size_t columns = turned ? 3 : 1;
        Floats c = Floats{} + shift_[k];
        Floats h = Floats{} + margin_;
        for (std::size_t i = 0; i < columns; ++i) {
          const std::size_t l = (k + i) % 3;
          c += matrix_[k][l] * centre[l];
          h += std::abs(matrix_[k][l]) * half[l];
        }
        store(c - h, &to.low[k][part]);
        store(c + h, &to.high[k][part]);
      }
    }
  }

  /// How far eight children reach along the other's normal n. What n has in common with their own
  /// normal m is told by their slabs, the rest by their boxes: x·n = (m·n) x·m + x·(n − (m·n) m).
  void project(const Node& of, const std::array<float, 3>& normal, Slabs& to) const {
    std::array<float, 3> n{};
    float shift = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      shift += normal[k] * shift_[k];
      for (std::size_t l = 0; l < 3; ++l) n[l] += normal[k] * matrix_[k][l];
    }
    const float common = n[0] * of.normal[0] + n[1] * of.normal[1] + n[2] * of.normal[2];
    for (std::size_t l = 0; l < 3; ++l) n[l] -= common * of.normal[l];
    for (std::size_t part = 0; part < width; part += float_lanes) {
      const auto from = loaded<Floats>(&of.from[part]);
      const auto until = loaded<Floats>(&of.to[part]);
      Floats centre = 2.0F * shift + common * (from + until);
      Floats half = 4.0F * margin_ + std::abs(common) * (until - from);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto low = loaded<Floats>(&of.low[k][part]);
        const auto high = loaded<Floats>(&of.high[k][part]);
        centre += n[k] * (low + high);
        half += std::abs(n[k]) * (high - low);
      }
      store(0.5F * (centre - half), &to.from[part]);
      store(0.5F * (centre + half), &to.to[part]);
    }
  }

 private:
  std::array<std::array<float, 3>, 3> matrix_{};
  std::array<float, 3> shift_{};
  float margin_;
};

/// Where the boxes, from `part` on, are apart from the box that `low` and `high` tell of an axis;
/// what is no number is not apart.
template <typename Low, typename High>
FloatMask apart(const Node& boxes, std::size_t part, const Low& low, const High& high) {
  FloatMask result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result |= (loaded<Floats>(&boxes.low[k][part]) > high(k)) |
              (loaded<Floats>(&boxes.high[k][part]) < low(k));
  }
  return result;
}

/// From box j of the others.
FloatMask apart(const Node& boxes, std::size_t part, const Node& others, std::size_t j) {
  return apart(
      boxes, part, [&](std::size_t k) { return others.low[k][j]; },
      [&](std::size_t k) { return others.high[k][j]; });
}

/// The same of slabs.
template <typename Some>
FloatMask apart_along(const Some& slabs, std::size_t part, float from, float to) {
  return (loaded<Floats>(&slabs.from[part]) > to) | (loaded<Floats>(&slabs.to[part]) < from);
}

/// The lanes where apart(part) is not set.
template <typename Apart>
std::uint32_t near_ones(const Apart& apart) {
  std::uint32_t result = 0;
  for (std::size_t part = 0; part < width; part += float_lanes) {
    result |= (~bits(apart(part)) & first_bits(float_lanes)) << part;
  }
  return result;
}

template <bool moved>
class Query {
 public:
  Query(const WideBvh& a, const WideBvh& b, const RigidTransform& a_from_b, TrianglesMeet meet)
      : a_(a),
        b_(b),
        batch_(a, b, a_from_b, meet),
        to_a_(Mat3::Identity(), Vec3::Zero(), 0.0),
        to_b_(to_a_) {
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
    Mat3 back = R;
    back.transposeInPlace();
    back /= ratio;
    to_b_ = BoxMap(back, -(back * shift),
                   (1.0 + R.cwiseAbs().maxCoeff()) * 3.0 * margin / ratio +
                       4.0 * skew * (1.0 + (1.0 + shift.cwiseAbs().sum()) / ratio));
  }

  WideIntersections run() {
    push(a_.root(), b_.root());
    while (!nodes_.empty() || !leaves_.empty()) {
      while (!nodes_.empty() && leaves_.size() < waiting) {
        const TriangleIndices pair = nodes_.back();
        nodes_.pop_back();
        test(pair.a, pair.b);
      }
      for (const TriangleIndices& pair : leaves_) test_leaves(pair.a, pair.b);
      leaves_.clear();
    }
    found_.pairs = batch_.sorted_pairs();
    return std::move(found_);
  }

 private:
  static constexpr std::size_t waiting = 32;

  static bool is_leaf(std::uint32_t child) { return (child >> 31) != 0; }
  static const Node& node(const WideBvh& bvh, std::uint32_t child) {
    return bvh.nodes()[is_leaf(child) ? ~child : child];
  }
  static void fetch(const Node& node) {
    const auto* const bytes = reinterpret_cast<const char*>(&node);
    for (std::size_t i = 0; i < sizeof node; i += 64) __builtin_prefetch(bytes + i);
  }

  /// Memory is slow: what is wanted is asked for now and used when others have been done.
  void push(std::uint32_t a, std::uint32_t b) {
    fetch(node(a_, a));
    fetch(node(b_, b));
    (is_leaf(a) && is_leaf(b) ? leaves_ : nodes_).push_back({a, b});
  }

  /// Which children overlap: bit 8 j + i tells of child i of a and child j of b. All 64 are asked:
  /// a branch that cannot be foretold costs more.
  std::uint64_t overlaps(const Node& a, const Node& b) {
    if (&b != mapped_) to_a_.map<moved>(b, b_in_a_);
    mapped_ = &b;
    Slabs slabs_a, slabs_b;
    to_a_.project(b, a.normal, slabs_b);
    const std::uint32_t near_all = near_ones([&](std::size_t part) {
      return apart(
                 b_in_a_, part, [&](std::size_t k) { return a.all_low[k]; },
                 [&](std::size_t k) { return a.all_high[k]; }) |
             apart_along(slabs_b, part, a.all_from, a.all_to);
    });
    if ((near_all & first_bits(b.size)) == 0) return 0;
    if constexpr (moved) to_b_.map<true>(a, a_in_b_);
    to_b_.project(a, b.normal, slabs_a);
    std::uint64_t result = 0;
    for (std::size_t j = 0; j < width; ++j) {
      const std::uint64_t near = near_ones([&](std::size_t part) {
        FloatMask mask = apart(a, part, b_in_a_, j) |
                         apart_along(a, part, slabs_b.from[j], slabs_b.to[j]) |
                         apart_along(slabs_a, part, b.from[j], b.to[j]);
        if constexpr (moved) mask |= apart(a_in_b_, part, b, j);
        return mask;
      });
      result |= near << (width * j);
    }
    constexpr std::uint64_t each_row = 0x0101010101010101;
    const std::uint64_t rows = ~std::uint64_t{0} >> (64 - width * b.size);
    return result & rows & (each_row * first_bits(a.size));
  }

  void test(std::uint32_t child_a, std::uint32_t child_b) {
    const Node& a = node(a_, child_a);
    const Node& b = node(b_, child_b);
    found_.box_tests += std::uint64_t{a.size} * b.size;
    const std::uint64_t near = overlaps(a, b);
    if (is_leaf(child_a)) {
      for (std::size_t j = 0; j < width; ++j) {
        if ((near >> (width * j) & 255U) != 0) push(child_a, b.child[j]);
      }
    } else if (is_leaf(child_b)) {
      for (std::size_t i = 0; i < width; ++i) {
        if ((near >> i & 0x0101010101010101) != 0) push(a.child[i], child_b);
      }
    } else {
      for_each_bit(near, [&](std::size_t i) { push(a.child[i % width], b.child[i / width]); });
    }
  }

  void test_leaves(std::uint32_t child_a, std::uint32_t child_b) {
    const Node& a = node(a_, child_a);
    const Node& b = node(b_, child_b);
    found_.triangle_tests += std::uint64_t{a.size} * b.size;
    for_each_bit(overlaps(a, b),
                 [&](std::size_t i) { batch_.add(a.child[i % width], b.child[i / width]); });
  }

  const WideBvh& a_;
  const WideBvh& b_;
  TriangleBatch<moved> batch_;
  BoxMap to_a_, to_b_;
  std::vector<TriangleIndices> nodes_;   ///< pairs of children that are not both leaves
  std::vector<TriangleIndices> leaves_;  ///< pairs of leaves
  const Node* mapped_ = nullptr;         ///< b_in_a_ is this node, moved
  Node b_in_a_, a_in_b_;
  WideIntersections found_;
};

}  // namespace

WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     TrianglesMeet triangles_meet) {
  return Query<false>(a, b, {}, triangles_meet).run();
}

WideIntersections find_intersections(const WideBvh& a, const WideBvh& b,
                                     const RigidTransform& a_from_b, TrianglesMeet triangles_meet) {
  require_finite(a_from_b, "a_from_b");
  return Query<true>(a, b, a_from_b, triangles_meet).run();
}

}  // namespace common

// Top down, by bins: a node's range is cut until it is in eight parts, or in parts that are leaves.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "common/wide_bvh/wide_bvh.hpp"

namespace common {
namespace {

using Quad [[gnu::vector_size(16)]] = float;  // x, y, z and nothing

constexpr std::size_t bins = 16;
constexpr int depth_of_last_sah_cut = 24;  // from there on halves, so that no tree is deep
constexpr float infinity = std::numeric_limits<float>::infinity();

Quad least(const Quad& a, const Quad& b) { return a < b ? a : b; }
Quad greatest(const Quad& a, const Quad& b) { return a > b ? a : b; }

struct QuadBox {
  Quad low = Quad{} + infinity;
  Quad high = Quad{} - infinity;

  void add(const QuadBox& other) {
    low = least(low, other.low);
    high = greatest(high, other.high);
  }
  [[nodiscard]] float half_area() const {
    const Quad side = high - low;
    return side[0] >= 0.0F ? side[0] * side[1] + side[1] * side[2] + side[2] * side[0] : 0.0F;
  }
};

/// A triangle while the tree is built.
struct Part {
  QuadBox box;
  std::uint32_t triangle = 0;
  [[nodiscard]] Quad place() const { return box.low + box.high; }  // twice its middle
};

struct Range {
  std::size_t begin = 0, end = 0;
  QuadBox box;
  [[nodiscard]] std::size_t count() const { return end - begin; }
};

struct Bin {
  QuadBox box;
  float count = 0.0F;
  void add(const Bin& other) {
    box.add(other.box);
    count += other.count;
  }
  [[nodiscard]] float cost() const { return box.half_area() * count; }
};

struct Plane {
  float cost = infinity;
  int axis = 0;
  std::int32_t bin = 0;  ///< the first beyond the plane
};

using Bins = std::array<std::array<Bin, bins>, 3>;

Plane best_plane(const Bins& all) {
  Plane best;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& of_axis = all[static_cast<std::size_t>(axis)];
    std::array<float, bins> right_cost{};
    Bin right;
    for (std::size_t i = bins; --i > 0;) {
      right.add(of_axis[i]);
      right_cost[i] = right.count > 0.0F ? right.cost() : infinity;
    }
    Bin left;
    for (std::size_t i = 1; i < bins; ++i) {
      left.add(of_axis[i - 1]);
      const float cost = left.count > 0.0F ? left.cost() + right_cost[i] : infinity;
      if (cost < best.cost) best = {cost, axis, static_cast<std::int32_t>(i)};
    }
  }
  return best;
}

/// From where to where the corners of some entries are along n, from a centre.
template <typename Entries>
std::pair<double, double> reach(const Entries& entries, std::size_t begin, std::size_t end,
                                const Vec3& n, const Vec3& centre) {
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (std::size_t i = begin; i < end; ++i) {
    for (const Vec3& corner : entries[i].corners) {
      const double place = n.dot(corner - centre);
      from = std::min(from, place);
      to = std::max(to, place);
    }
  }
  return {from, to};
}

/// To which bins a place belongs, by axis.
struct Binning {
  Quad low, factor;
  using Numbers [[gnu::vector_size(16)]] = std::int32_t;
  [[nodiscard]] Numbers operator()(const Quad& place) const {
    return __builtin_convertvector((place - low) * factor, Numbers);
  }
};

/// Cuts ranges of entries and makes nodes of them.
class WideBvhBuilder {
 public:
  explicit WideBvhBuilder(std::vector<Part>& entries) : entries_(entries) {}

  /// The range as a child.
  std::uint32_t build(const Range& range, int depth) {
    if (range.count() <= WideBvh::width) return leaf(range);
    const auto index = static_cast<std::uint32_t>(nodes.size());
    add_node(range.box);
    std::array<Range, WideBvh::width> parts;
    parts[0] = range;
    std::size_t size = 1;
    while (size < parts.size()) {
      auto* const end = parts.data() + size;
      auto* const largest = std::max_element(parts.data(), end, [](const Range& a, const Range& b) {
        return worth_cutting(a) < worth_cutting(b);
      });
      if (largest->count() <= WideBvh::width) break;
      const std::size_t middle = cut(*largest, depth);
      std::move_backward(largest + 1, end, end + 1);  // the parts stay in order
      largest[1] = range_of(middle, largest->end);
      *largest = range_of(largest->begin, middle);
      ++size;
    }
    for (std::size_t i = 0; i < size; ++i) {
      add_child(index, build(parts[i], depth + 1), parts[i].box);
    }
    return index;
  }

  [[nodiscard]] Range range_of(std::size_t begin, std::size_t end) const {
    Range range{begin, end, {}};
    for (std::size_t i = begin; i < end; ++i) range.box.add(entries_[i].box);
    return range;
  }

  std::vector<WideBvh::Node> nodes;

 private:
  static float worth_cutting(const Range& range) {
    return range.count() <= WideBvh::width ? -1.0F : range.box.half_area();
  }

  void add_node(const QuadBox& box) {
    nodes.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      nodes.back().all_low[k] = box.low[k];
      nodes.back().all_high[k] = box.high[k];
    }
  }

  void add_child(std::uint32_t index, std::uint32_t child, const QuadBox& box) {
    WideBvh::Node& node = nodes[index];
    for (std::size_t k = 0; k < 3; ++k) {
      node.low[k][node.size] = box.low[k];
      node.high[k][node.size] = box.high[k];
    }
    node.child[node.size++] = child;
  }

  std::uint32_t leaf(const Range& range) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    add_node(range.box);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      add_child(index, static_cast<std::uint32_t>(i), entries_[i].box);
    }
    return ~index;
  }

  /// Where the second part begins; neither is empty.
  std::size_t cut(const Range& range, int depth) {
    const auto begin = entries_.begin() + static_cast<std::ptrdiff_t>(range.begin);
    const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(range.end);
    QuadBox spread;
    for (auto i = begin; i != end; ++i) spread.add({i->place(), i->place()});
    const Quad span = spread.high - spread.low;
    // A span that is nothing has all in bin 0; the factor keeps the furthest out of bin 16.
    const Binning bin_of{spread.low, span > 0.0F ? (0.99999F * bins) / span : Quad{}};
    Plane plane;
    if (depth <= depth_of_last_sah_cut) {
      Bins all;
      for (auto i = begin; i != end; ++i) {
        const Binning::Numbers number = bin_of(i->place());
        for (std::size_t k = 0; k < 3; ++k) {
          all[k][static_cast<std::size_t>(number[k])].add({i->box, 1.0F});
        }
      }
      plane = best_plane(all);
    }
    if (plane.bin == 0) {
      const int axis = span[0] >= span[1] && span[0] >= span[2] ? 0 : span[1] >= span[2] ? 1 : 2;
      const auto middle = begin + (end - begin) / 2;
      std::nth_element(begin, middle, end, [axis](const Part& a, const Part& b) {
        return a.place()[axis] < b.place()[axis];
      });
      return range.begin + range.count() / 2;
    }
    const auto middle = std::partition(begin, end, [&](const Part& entry) {
      return bin_of(entry.place())[plane.axis] < plane.bin;
    });
    return static_cast<std::size_t>(middle - entries_.begin());
  }

  std::vector<Part>& entries_;
};

}  // namespace

WideBvh::WideBvh(const TriangleMesh& mesh) {
  require_sound(mesh);
  const std::size_t n = mesh.triangles.size();
  Vec3 low = mesh.vertices[mesh.triangles[0][0]];
  Vec3 high = low;
  for (std::size_t i = 0; i < n; ++i) {
    for (const Vec3& corner : triangle(mesh, i)) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  centre_ = low + 0.5 * (high - low);
  const double size = (high - low).maxCoeff();
  scale_ = size > 0.0 ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;

  std::vector<Part> entries(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Triangle corners = triangle(mesh, i);
    const Vec3 l = scale_ * (corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - centre_);
    const Vec3 h = scale_ * (corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) - centre_);
    Part& entry = entries[i];
    entry.triangle = static_cast<std::uint32_t>(i);
    entry.box = {Quad{}, Quad{}};
    for (int k = 0; k < 3; ++k) {
      entry.box.low[k] = std::nextafter(static_cast<float>(l[k]), -infinity);
      entry.box.high[k] = std::nextafter(static_cast<float>(h[k]), infinity);
    }
  }
  WideBvhBuilder builder(entries);
  builder.nodes.reserve(n / 4 + 1);
  root_ = builder.build(builder.range_of(0, n), 0);
  nodes_ = std::move(builder.nodes);
  entries_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    entries_[i] = {common::triangle(mesh, entries[i].triangle), entries[i].triangle};
  }
  std::size_t end = 0;
  lay_slabs(root_, end);
}

/// Of the node that is the child, whose entries begin at `end`, which goes on to where they end.
void WideBvh::lay_slabs(std::uint32_t child, std::size_t& end) {
  const bool is_leaf = (child >> 31) != 0;
  Node& node = nodes_[is_leaf ? ~child : child];
  std::array<std::size_t, width + 1> bounds{};
  bounds[0] = end;
  for (std::size_t i = 0; i < node.size; ++i) {
    if (is_leaf) {
      ++end;
    } else {
      lay_slabs(node.child[i], end);
    }
    bounds[i + 1] = end;
  }
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = bounds[0]; i < end; ++i) {
    const auto& [a, b, c] = entries_[i].corners;
    sum += (scale_ * (b - a)).cross(scale_ * (c - a));
  }
  const double length = sum.norm();
  const Eigen::Vector3f normal = (length > 0.0 ? Vec3(sum / length) : Vec3::UnitX()).cast<float>();
  Eigen::Map<Eigen::Vector3f>(node.normal.data()) = normal;
  const Vec3 n = scale_ * normal.cast<double>();
  for (std::size_t i = 0; i < node.size; ++i) {
    const auto [from, to] = reach(entries_, bounds[i], bounds[i + 1], n, centre_);
    node.from[i] = static_cast<float>(from);
    node.to[i] = static_cast<float>(to);
    node.all_from = i == 0 ? node.from[i] : std::min(node.all_from, node.from[i]);
    node.all_to = i == 0 ? node.to[i] : std::max(node.all_to, node.to[i]);
  }
}

}  // namespace common

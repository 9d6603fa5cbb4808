# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab bvh_traversal)

# ---- 5.1 ----

# A loop that ends one early.
add_mutant(${lab} box_without_third_corner 5.1
  "{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)}" "{a.cwiseMin(b), a.cwiseMax(b) + 0.0 * c}"
  "third corner")

# Intersection and union are mixed up.
add_mutant(${lab} merged_is_common_part 5.1
  "{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}" "{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)}"
  "in common")

# Touching is believed not to count.
add_mutant(${lab} touching_boxes_dropped 5.1
  "static_cast<int>(a.low[i] <= b.high[i]) & static_cast<int>(b.low[i] <= a.high[i])"
  "static_cast<int>(a.low[i] < b.high[i]) & static_cast<int>(b.low[i] < a.high[i])"
  "touching boxes are taken for apart")

# Shadows that overlap along one axis are believed to be enough.
add_mutant(${lab} overlap_along_one_axis 5.1
  "reach(0) & reach(1) & reach(2)" "reach(0) | reach(1) | reach(2)" "one coordinate is enough")

# The word heuristic is remembered, the surface is not.
add_mutant(${lab} area_is_volume 5.1
  "2.0 * (side.x() * side.y() + side.y() * side.z() + side.z() * side.x())" "side.prod()" "volume")

# Three faces are counted.
add_mutant(${lab} area_of_half_the_faces 5.1 "2.0 * (side.x() * side.y()" "(side.x() * side.y()"
  "factor 2 is missing")

# The empty box is forgotten.
add_mutant(${lab} area_of_empty_box 5.1 "if (!(side.x() >= 0.0)) return 0.0;" "" "")

# What has no surface is believed to be empty.
add_mutant(${lab} merged_without_flat_boxes 5.1
  "Box merged(const Box& a, const Box& b) {"
  "Box merged(const Box& a, const Box& b) {
  if (surface_area(b) == 0.0) return a;" "the second box is left out")

# One box begins before the other ends, and that is believed to be all.
add_mutant(${lab} overlap_by_one_half 5.1
  "static_cast<int>(a.low[i] <= b.high[i]) & static_cast<int>(b.low[i] <= a.high[i])"
  "static_cast<int>(a.low[i] <= b.high[i])" "half of this is missing")

# ---- 5.2 ----

# The middle of the span is taken for the median.
add_mutant(${lab} halved_by_place 5.2
  "const Iterator middle = begin + (end - begin) / 2;"
  "const double plane = 0.5 * (spread.low[axis] + spread.high[axis]);
  const Iterator part = std::partition(
      begin, end, [&](const Entry& entry) { return entry.centroid[axis] < plane; });
  if (part != begin && part != end) return part;
  const Iterator middle = begin + (end - begin) / 2;"
  "middle of their span")

# The same, and equal centroids leave one side empty for ever.
add_mutant(${lab} endless_on_equal_centroids 5.2
  "const Iterator middle = begin + (end - begin) / 2;"
  "const double plane = 0.5 * (spread.low[axis] + spread.high[axis]);
  if (begin != end) {
    return std::partition(begin, end,
                          [&](const Entry& entry) { return entry.centroid[axis] < plane; });
  }
  const Iterator middle = begin;"
  "middle of their span")

# One axis is believed to do for all nodes.
add_mutant(${lab} halved_along_x 5.2 "(spread.high - spread.low).maxCoeff(&axis);" "" "spread less")

# The list is cut in the middle without being sorted.
add_mutant(${lab} halved_unsorted 5.2
  "std::nth_element(begin, middle, end, [axis]" "std::nth_element(begin, begin, end, [axis]"
  "halves are mixed")

# The parent gets the box of one child.
add_mutant(${lab} boxes_not_merged 5.2
  "box = merged(box, build(node.first + 1, middle, end, depth + 1));"
  "build(node.first + 1, middle, end, depth + 1);" "merge those of its children")

# Off by one.
add_mutant(${lab} leaves_too_large 5.2
  "if (end - begin <= leaf_size_)" "if (end - begin <= leaf_size_ + 1)" "more than leaf_size")

# ---- 5.3 ----

# Bigger and smaller are mixed up.
add_mutant(${lab} first_descends_smaller 5.3
  "const bool bigger_is_a = a_is_bigger(node_a, node_b);"
  "const bool bigger_is_a = !a_is_bigger(node_a, node_b);" "smaller node is descended")

# The loop over the children is not one.
add_mutant(${lab} first_takes_one_child 5.3
  "{bigger.first, bigger.first + 1}" "{bigger.first}" "only one child")

# The order in which they are found is believed to be the sorted one.
add_mutant(${lab} first_unsorted 5.3
  "  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

// ---- Step 5.4 ----"
  "  return found;
}

// ---- Step 5.4 ----" "not sorted")

# ---- 5.4 ----

# Only equals are compared: a leaf with a leaf, an inner node with an inner node.
add_mutant(${lab} leaf_and_inner_lost 5.4
  "if (is_leaf(node_a) && is_leaf(node_b)) {"
  "if (is_leaf(node_a) != is_leaf(node_b)) continue;
    if (is_leaf(node_a) && is_leaf(node_b)) {" "are given up")

# The bigger node is always taken, and a leaf has no children.
add_mutant(${lab} stuck_at_bigger_leaf 5.4
  "const bool into_a = descend_a(node_a, node_b);"
  "const bool into_a = a_is_bigger(node_a, node_b);
    if (is_leaf(into_a ? node_a : node_b)) continue;" "bigger node is a leaf nothing is done")

# Bigger and smaller are mixed up.
add_mutant(${lab} smaller_descended 5.4
  "(is_leaf(b) || a_is_bigger(a, b))" "(is_leaf(b) || !a_is_bigger(a, b))" "smaller node is descended")

# The loop over the children is not one.
add_mutant(${lab} one_child_descended 5.4
  "for (const std::uint32_t child : {1U, 0U}) {"
  "box_tests -= 1;
    for (const std::uint32_t child : {0U}) {" "only one child")

# Both orders of a pair are gone through.
add_mutant(${lab} pairs_of_leaves_twice 5.4
  "at_leaves(node_a, node_b);"
  "at_leaves(node_a, node_b);
      at_leaves(node_a, node_b);" "reported twice")

# The order in which they are found is believed to be the sorted one.
add_mutant(${lab} ends_unsorted 5.4
  "for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, note);
  std::sort(found.ends.begin(), found.ends.end());"
  "for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, note);" "not sorted")

# ---- 5.5 ----

# Parallel planes are believed never to meet.
add_mutant(${lab} coplanar_dropped 5.5
  "return !are_skew(a, b) && meet_in_plane(a, b);"
  "const auto has_plane = [](const Triangle& t) {
    return !(t[1] - t[0]).cross(t[2] - t[0]).isZero(0.0);
  };
  if (has_plane(a) && has_plane(b)) return false;
  return !are_skew(a, b) && meet_in_plane(a, b);" "in one plane are taken for apart")

# Touching is believed not to count.
add_mutant(${lab} touching_triangles_dropped 5.5
  "orientation(a[0], a[1], b[0], b[1]) <= 0 && orientation(a[0], a[2], b[2], b[0]) <= 0"
  "orientation(a[0], a[1], b[0], b[1]) < 0 && orientation(a[0], a[2], b[2], b[0]) < 0"
  "that only touch")

# Crossing each other's plane is believed to be enough.
add_mutant(${lab} planes_are_enough 5.5
  "return intervals_overlap(a, side_a, b, side_b);" "return true;" "not in the same place")

# Doubles are believed.
add_mutant(${lab} sides_by_rounding 5.5
  "if (signs[i] == 0) signs[i] = orientation(plane[0], plane[1], plane[2], points[i]);"
  "signs[i] = static_cast<int>(n.dot(d[i]) > 0.0) - static_cast<int>(n.dot(d[i]) < 0.0);"
  "decided by rounding")

# A segment is believed to be no triangle.
add_mutant(${lab} segments_dropped 5.5
  "if (!all_zero(side_a)) return segment_pierces(a, side_a, b);"
  "if (!all_zero(side_a)) return false;" "is not seen")

# The pair is written as it was descended.
add_mutant(${lab} pair_swapped 5.5
  "found.pairs.push_back({a_.triangles[node_a.first + i], b_.triangles[node_b.first + j]});"
  "found.pairs.push_back({b_.triangles[node_b.first + j], a_.triangles[node_a.first + i]});" "are swapped")

# The order in which they are found is believed to be the sorted one.
add_mutant(${lab} pairs_unsorted 5.5
  "for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, test);
  std::sort(test.found.pairs.begin(), test.found.pairs.end());"
  "for_each_pair_of_leaves(a, b, OverlapAtRest{a, b}, test);" "not sorted")

# A test of two leaves is counted as one.
add_mutant(${lab} leaf_pairs_counted 5.5
  "found.triangle_tests += std::uint64_t{node_a.count} * node_b.count;"
  "found.triangle_tests += 1;" "number of pairs of leaves")

# A small number is believed to be zero, whatever the size of the triangles.
add_mutant(${lab} sides_by_threshold 5.5
  "const double error = 2e-15 * size.dot(furthest) + 1e-240;"
  "const double error = 1e-14 + 0.0 * size.dot(furthest);" "")

# Shadows are believed to need no exact arithmetic.
add_mutant(${lab} shadows_by_rounding 5.5
  "const Signs s{orientation(p, q, b[0]), orientation(p, q, b[1]), orientation(p, q, b[2])};"
  "const auto turn = [&](const Vec2& r) {
      const Vec2 e = q - p;
      const Vec2 f = r - p;
      const double area = e.x() * f.y() - e.y() * f.x();
      return area > 0.0 ? 1 : area < 0.0 ? -1 : 0;
    };
    const Signs s{turn(b[0]), turn(b[1]), turn(b[2])};" "")

# Planes are believed to need no margin.
add_mutant(${lab} planes_without_margin 5.5
  "return 2e-14 * n.cwiseAbs" "return 0.0 * n.cwiseAbs" "")

# ---- 5.6 ----

# The volume is believed to be what a box costs.
add_mutant(${lab} sah_by_volume 5.6
  "return surface_area(side.box) * side.count;"
  "return side.count > 0.0 ? (side.box.high - side.box.low).prod() * side.count : 0.0;"
  "weighs the sides by the volumes")

# The surfaces alone are added up.
add_mutant(${lab} sah_without_numbers 5.6
  "return surface_area(side.box) * side.count;" "return surface_area(side.box);"
  "not by their numbers")

# The axis is chosen as for the median.
add_mutant(${lab} sah_along_one_axis 5.6
  "for (Eigen::Index axis = 0; axis < 3; ++axis) try_planes(axis, best);"
  "Eigen::Index axis = 0;
    (spread_.high - spread_.low).maxCoeff(&axis);
    try_planes(axis, best);" "only the axis of the widest spread")

# The median is believed to do as well.
add_mutant(${lab} sah_is_median 5.6
  "if (depth > depth_of_last_sah_cut) return halved(begin, end);" "if (depth >= 0) return halved(begin, end);"
  "cuts at the median")

# Equal centroids are forgotten: one side of the cut is empty.
add_mutant(${lab} sah_side_empty 5.6 "if (best.bin == 0) return halved(begin, end);" "" "")

# The last depth for the heuristic is taken for the first without it.
add_mutant(${lab} sah_one_level_further 5.6 "constexpr int depth_of_last_sah_cut = 31;"
  "constexpr int depth_of_last_sah_cut = 32;" "")

# ---- 5.7 ----

# The transform is believed to lead the other way.
add_mutant(${lab} moved_by_inverse 5.7
  "Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {"
  "Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& given) {
  const RigidTransform a_from_b{given.rotation.transpose(),
                                -(given.rotation.transpose() * given.translation)};"
  "moved by the inverse")

# A rotation is believed to be all.
add_mutant(${lab} moved_without_shift 5.7
  "Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& a_from_b) {"
  "Intersections find_intersections_moved(const Bvh& a, const Bvh& b, const RigidTransform& given) {
  const RigidTransform a_from_b{given.rotation, 0.0 * given.translation};"
  "turned but not shifted")

# The half sides are turned like a vector.
add_mutant(${lab} moved_box_too_small 5.7
  "R_size_(motion.rotation.cwiseAbs())" "R_size_(motion.rotation)" "")

# Rounding is forgotten.
add_mutant(${lab} moved_box_without_margin 5.7
  "return (1e-14 + 4.0 * skewness) * size;" "return 0.0 * skewness * size;" "")

# A margin is believed to cost nothing.
add_mutant(${lab} moved_box_too_wide 5.7
  "return (1e-14 + 4.0 * skewness) * size;" "return (0.02 + 4.0 * skewness) * size;" "")

# The leaves are thought of, their parents are not.
add_mutant(${lab} refit_of_leaves 5.7
  "node.box = merged(bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box);" "" "only the leaves")

# The corners are new, and the boxes are believed to follow.
add_mutant(${lab} refit_without_boxes 5.7
  "for (std::size_t i = bvh.nodes.size(); i-- > 0;) {" "for (std::size_t i = 0; i-- > 0;) {"
  "boxes are those of before")

# A box is extended where it should begin anew.
add_mutant(${lab} refit_only_grows 5.7 "node.box = Box{};" "" "boxes only grow")

# The copies of the corners are forgotten.
add_mutant(${lab} refit_without_corners 5.7
  "bvh.corners[i] = triangle(deformed, bvh.triangles[i]);" "" "corners are those of before")

# Rounding is thought of where b arrives, not where it was.
add_mutant(${lab} moved_margin_of_the_shift 5.7
  "const double size = furthest(a.nodes[0].box) + a_from_b.translation.cwiseAbs().sum() +
                        (1.0 + R.cwiseAbs().sum()) * furthest(b.nodes[0].box);"
  "const double size = a_from_b.translation.cwiseAbs().sum();" "")

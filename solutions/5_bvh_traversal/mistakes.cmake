# The bank of mistakes: each is a misconception that students have, as a small edit of the reference,
# or OF another right answer.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold> [OF <answer>])
set(lab bvh_traversal)

# ---- 5.1 ----

# A loop that ends one early.
add_mutant(${lab} box_without_third_corner 5.1
  "for (const Vec3& corner : triangle) box = merged(box, {corner, corner});"
  "for (std::size_t i = 0; i < 2; ++i) box = merged(box, {triangle[i], triangle[i]});"
  "third corner")

# Intersection and union are mixed up.
add_mutant(${lab} merged_is_common_part 5.1
  "box.low[i] = std::min(a.low[i], b.low[i]);  // eq. (2)
    box.high[i] = std::max(a.high[i], b.high[i]);"
  "box.low[i] = std::max(a.low[i], b.low[i]);
    box.high[i] = std::min(a.high[i], b.high[i]);"
  "in common")

# Touching is believed not to count.
add_mutant(${lab} touching_boxes_dropped 5.1
  "a.low[i] <= b.high[i] && b.low[i] <= a.high[i]" "a.low[i] < b.high[i] && b.low[i] < a.high[i]"
  "touching boxes are taken for apart")

# Shadows that overlap along one axis are believed to be enough.
add_mutant(${lab} overlap_along_one_axis 5.1
  "if (!(a.low[i] <= b.high[i] && b.low[i] <= a.high[i])) return false;  // eq. (3)
  }
  return true;"
  "if (a.low[i] <= b.high[i] && b.low[i] <= a.high[i]) return true;
  }
  return false;" "one coordinate is enough")

# The word heuristic is remembered, the surface is not.
add_mutant(${lab} area_is_volume 5.1
  "2.0 * (w * h + h * d + d * w)" "w * h * d" "volume")

# Three faces are counted.
add_mutant(${lab} area_of_half_the_faces 5.1 "2.0 * (w * h" "(w * h" "factor 2 is missing")

# The empty box is forgotten.
add_mutant(${lab} area_of_empty_box 5.1 "if (!(w >= 0.0)) return 0.0;" "" "")

# What has no surface is believed to be empty.
add_mutant(${lab} merged_without_flat_boxes 5.1
  "Box merged(const Box& a, const Box& b) {"
  "Box merged(const Box& a, const Box& b) {
  if (surface_area(b) == 0.0) return a;" "the second box is left out")

# One box begins before the other ends, and that is believed to be all.
add_mutant(${lab} overlap_by_one_half 5.1
  "a.low[i] <= b.high[i] && b.low[i] <= a.high[i]" "a.low[i] <= b.high[i]" "half of the test is missing")

# What has no volume is believed to be empty.
add_mutant(${lab} area_of_flat_boxes 5.1
  "if (!(w >= 0.0)) return 0.0;" "if (!(w > 0.0 && h > 0.0 && d > 0.0)) return 0.0;"
  "flat box has two faces")

# ---- 5.2 ----

# A reference is believed to follow what it refers to. Here the place that it keeps is still there.
add_mutant(${lab} node_reference_kept 5.2
  "    bvh.nodes[index] = node;"
  "    node.box = end - begin > leaf_size && depth == 0 && bvh.nodes.size() > 3 ? Box{} : node.box;
    bvh.nodes[index] = node;" "reference to a node is kept")

# The middle of a triangle's box is taken for its centroid.
add_mutant(${lab} halved_by_boxes 5.2
  "part.centroid[k] = (t[0][k] + t[1][k] + t[2][k]) / 3.0;"
  "part.centroid[k] = 0.5 * (part.box.low[k] + part.box.high[k]);" "middles of the triangles' boxes")

# The middle of the span is taken for the median.
add_mutant(${lab} halved_by_place 5.2
  "const Place middle = begin + (end - begin) / 2;"
  "const double plane = 0.5 * (spread.low[axis] + spread.high[axis]);
  const Place part = std::partition(
      begin, end, [&](std::uint32_t i) { return parts[i].centroid[axis] < plane; });
  if (part != begin && part != end) return part;
  const Place middle = begin + (end - begin) / 2;"
  "middle of their span")

# The same, and equal centroids leave one side empty for ever.
add_mutant(${lab} endless_on_equal_centroids 5.2
  "const Place middle = begin + (end - begin) / 2;"
  "const double plane = 0.5 * (spread.low[axis] + spread.high[axis]);
  if (begin != end) {
    return std::partition(begin, end,
                          [&](std::uint32_t i) { return parts[i].centroid[axis] < plane; });
  }
  const Place middle = begin;"
  "middle of their span")

# One axis is believed to do for all nodes.
add_mutant(${lab} halved_along_x 5.2
  "if (spread.high[i] - spread.low[i] > spread.high[axis] - spread.low[axis]) axis = i;" "" "spread less")

# The list is cut in the middle without being sorted.
add_mutant(${lab} halved_unsorted 5.2
  "std::nth_element(begin, middle, end, [&]" "std::nth_element(begin, begin, end, [&]"
  "halves are mixed")

# The parent gets the box of one child.
add_mutant(${lab} boxes_not_merged 5.2
  "grow(node.first + 1, middle, end, depth + 1);
      node.box = merged(bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box);"
  "grow(node.first + 1, middle, end, depth + 1);
      node.box = bvh.nodes[node.first].box;" "merge the boxes of its children")

# Off by one.
add_mutant(${lab} leaves_too_large 5.2
  "if (end - begin <= leaf_size)" "if (end - begin <= leaf_size + 1)" "more than leaf_size")

# ---- 5.3 ----

# Bigger and smaller are mixed up.
add_mutant(${lab} first_descends_smaller 5.3
  "const bool into_a = a_is_bigger(node_a.box, node_b.box);"
  "const bool into_a = !a_is_bigger(node_a.box, node_b.box);" "smaller node is descended")

# A tie is not thought of.
add_mutant(${lab} first_ties_to_b 5.3
  "const bool into_a = a_is_bigger(node_a.box, node_b.box);"
  "const bool into_a = surface_area(node_a.box) > surface_area(node_b.box);" "with the same area")

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

# Leaves are thought of, though the words do not.
add_mutant(${lab} first_is_complete 5.3
  "Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {"
  "Traversal traverse_as_first_written(const Bvh& a, const Bvh& b) {
  if (!a.nodes.empty()) return traverse(a, b);" "complete version of step 5.4")

# ---- 5.4 ----

# Only equals are compared: a leaf with a leaf, an inner node with an inner node.
add_mutant(${lab} leaf_and_inner_lost 5.4
  "if (is_leaf(node_a) && is_leaf(node_b)) {"
  "if (is_leaf(node_a) != is_leaf(node_b)) continue;
    if (is_leaf(node_a) && is_leaf(node_b)) {" "are given up")

# The bigger node is always taken, and a leaf has no children.
add_mutant(${lab} stuck_at_bigger_leaf 5.4
  "const bool into_a = !is_leaf(node_a) && (is_leaf(node_b) || a_is_bigger(node_a.box, box_b));"
  "const bool into_a = a_is_bigger(node_a.box, box_b);
    if (is_leaf(into_a ? node_a : node_b)) continue;" "bigger node is a leaf nothing is done")

# Bigger and smaller are mixed up.
add_mutant(${lab} smaller_descended 5.4
  "(is_leaf(node_b) || a_is_bigger(" "(is_leaf(node_b) || !a_is_bigger(" "smaller node is descended")

# The other child is forgotten.
add_mutant(${lab} one_child_descended 5.4
  "stack.push_back(into_a ? NodePair{child + 1, pair.b} : NodePair{pair.a, child + 1});" ""
  "only one child")

# Both orders of a pair are gone through.
add_mutant(${lab} pairs_of_leaves_twice 5.4
  "if (is_leaf(node_a) && is_leaf(node_b)) {"
  "if (is_leaf(node_a) && is_leaf(node_b)) {
      found.ends.push_back(pair);" "reported twice")

# The order in which they are found is believed to be the sorted one.
add_mutant(${lab} ends_unsorted 5.4
  "  std::sort(found.ends.begin(), found.ends.end());
  return found;
}

}  // namespace"
  "  return found;
}

}  // namespace" "not sorted")

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
  "for (std::size_t i = 0; i < 3; ++i) s[i] = orientation(plane[0], plane[1], plane[2], points[i]);"
  "const Vec3 n = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double volume = n.dot(points[i] - plane[0]);
    s[i] = volume > 0.0 ? 1 : volume < 0.0 ? -1 : 0;
  }"
  "decided by rounding")

# A segment is believed to be no triangle.
add_mutant(${lab} segments_dropped 5.5
  "if (!all_zero(side_a)) return segment_pierces(a, side_a, b);"
  "if (!all_zero(side_a)) return false;" "is not seen")

# The pair is written as it was descended.
add_mutant(${lab} pair_swapped 5.5
  "found.pairs.push_back({a.triangles[i], b.triangles[j]});"
  "found.pairs.push_back({b.triangles[j], a.triangles[i]});" "are swapped")

# The order in which they are found is believed to be the sorted one.
add_mutant(${lab} pairs_unsorted 5.5
  "std::sort(found.pairs.begin(), found.pairs.end());" "" "not sorted")

# A test of two leaves is counted as one.
add_mutant(${lab} leaf_pairs_counted 5.5
  "found.triangle_tests += std::uint64_t{leaf_a.count} * leaf_b.count;"
  "found.triangle_tests += 1;" "number of pairs of leaves")

# A number is believed to be sure if it is not small, whatever the size of the triangles.
add_mutant(${lab} sides_by_threshold 5.5
  "for (std::size_t i = 0; i < 3; ++i) s[i] = orientation(plane[0], plane[1], plane[2], points[i]);"
  "const Vec3 n = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double volume = n.dot(points[i] - plane[0]);
    s[i] = volume > 1e-14    ? 1
           : volume < -1e-14 ? -1
                             : orientation(plane[0], plane[1], plane[2], points[i]);
  }" "")

# Shadows are believed to need no exact arithmetic.
add_mutant(${lab} shadows_by_rounding 5.5
  "return orientation(Vec2(p[x], p[y]), Vec2(q[x], q[y]), Vec2(c[x], c[y]));"
  "const double area = (q[x] - p[x]) * (c[y] - p[y]) - (q[y] - p[y]) * (c[x] - p[x]);
      return area > 0.0 ? 1 : area < 0.0 ? -1 : 0;" "")

# Planes are believed to need no margin.
add_mutant(${lab} planes_without_margin 5.5
  "return 2e-14 * n.cwiseAbs" "return 0.0 * n.cwiseAbs" "" OF for_speed)

# ---- 5.6 ----

# The volume is believed to be what a box costs.
add_mutant(${lab} sah_by_volume 5.6
  "return surface_area(box) * count;"
  "return count > 0.0 ? (box.high - box.low).prod() * count : 0.0;"
  "weighs the sides by the volumes")

# The surfaces alone are added up.
add_mutant(${lab} sah_without_numbers 5.6
  "return surface_area(box) * count;" "return surface_area(box);"
  "multiply by their numbers")

# The axis is chosen as for the median.
add_mutant(${lab} sah_along_one_axis 5.6
  "for (int axis = 0; axis < 3; ++axis) {"
  "int widest = 0;
  (spread.high - spread.low).maxCoeff(&widest);
  for (int axis = widest; axis == widest; ++axis) {" "only the axis of the widest spread")

# The loop over the planes ends one too early.
add_mutant(${lab} sah_without_last_plane 5.6
  "for (std::size_t i = 1; i < size; ++i) {
      left.add" "for (std::size_t i = 1; i + 1 < size; ++i) {
      left.add" "last plane is left out")

# The median is believed to do as well.
add_mutant(${lab} sah_is_median 5.6
  "if (depth >= 32) return halved(" "if (depth >= 0) return halved("
  "cuts at the median")

# Equal centroids are forgotten: one side of the cut is empty.
add_mutant(${lab} sah_side_empty 5.6 "if (best_bin == 0) return halved(parts, begin, end, depth, bins);" "" "")

# The last depth for the heuristic is taken for the first without it.
add_mutant(${lab} sah_one_level_further 5.6 "if (depth >= 32)" "if (depth >= 33)" "")

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
  "half += std::abs(motion.rotation(i, j)) * h;" "half += motion.rotation(i, j) * h;" "")

# Rounding is forgotten.
add_mutant(${lab} moved_box_without_margin 5.7
  "half += 1e-14 * size;" "half += 0.0 * size;" "")

# A margin is believed to cost nothing.
add_mutant(${lab} moved_box_too_wide 5.7
  "half += 1e-14 * size;" "half += 0.1 * size;" "")

# The leaves are thought of, their parents are not.
add_mutant(${lab} refit_of_leaves 5.7
  "} else {
      node.box = merged(bvh.nodes[node.first].box, bvh.nodes[node.first + 1].box);" "} else {" "only the leaves")

# The corners are new, and the boxes are believed to follow.
add_mutant(${lab} refit_without_boxes 5.7
  "for (std::size_t i = bvh.nodes.size(); i-- > 0;) {" "for (std::size_t i = 0; i-- > 0;) {"
  "boxes are still the old ones")

# Only a mesh with too few triangles is thought to be another one.
add_mutant(${lab} refit_of_more 5.7
  "deformed.triangles.size() != bvh.triangles.size()"
  "deformed.triangles.size() < bvh.triangles.size()" "")

# A box is extended where it should begin anew.
add_mutant(${lab} refit_only_grows 5.7 "node.box = Box{};" "" "boxes only grow")

# The copies of the corners are forgotten.
add_mutant(${lab} refit_without_corners 5.7
  "bvh.corners[i] = triangle(deformed, bvh.triangles[i]);" "" "corners are still the old ones")

# Rounding is thought of where b arrives, not where it was.
add_mutant(${lab} moved_margin_of_the_shift 5.7
  "size += std::abs(motion.rotation(i, j)) * (std::abs(c[j]) + h);" "" "")

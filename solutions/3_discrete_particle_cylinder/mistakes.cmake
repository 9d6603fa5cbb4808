# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab discrete_particle_cylinder)

# ---- 3.1 ----

# A particle is taken for a point.
add_mutant(${lab} gap_without_particle_radius 3.1
  "distance_from_axis(position) - sum_of_radii(particle_radius, cylinder)"
  "distance_from_axis(position) - sum_of_radii(particle_radius, cylinder) + particle_radius"
  "particle's radius is missing")

# The cylinder is taken for a ball at the world's origin.
add_mutant(${lab} gap_of_a_ball 3.1
  "return distance_from_axis(position) - sum_of_radii"
  "return position.stableNorm() - sum_of_radii" "x is kept")

# A penetration depth is returned for a gap.
add_mutant(${lab} gap_reversed 3.1
  "return distance_from_axis(position) - sum_of_radii(particle_radius, cylinder);"
  "return sum_of_radii(particle_radius, cylinder) - distance_from_axis(position);"
  "sign is reversed")

# The root of the sum of squares, as it is written: 1e-200 squared is 0, 1e200 squared infinite.
add_mutant(${lab} gap_by_squares 3.1
  "return distance_from_axis(position) - sum_of_radii"
  "return std::sqrt(position.y() * position.y() + position.z() * position.z()) - sum_of_radii"
  "squares vanish")

# The gradient is taken for the way to the surface.
add_mutant(${lab} gradient_reversed 3.1
  "return {0.0, position.y() / distance, position.z() / distance};"
  "return {0.0, -position.y() / distance, -position.z() / distance};" "points to the axis")

# The position's direction is taken for that of the gradient.
add_mutant(${lab} gradient_of_a_ball 3.1
  "return {0.0, position.y() / distance, position.z() / distance};"
  "return position.stableNormalized();" "x is kept")

# The gradient of half the square.
add_mutant(${lab} gradient_not_unit 3.1
  "return {0.0, position.y() / distance, position.z() / distance};"
  "return {0.0, position.y(), position.z()};" "not divided by the distance")

# Nothing is done about the axis: 0/0.
add_mutant(${lab} gradient_nan_on_axis 3.1
  "if (distance == 0.0) return Vec3::UnitY();" "" "")

# The axis has no direction, so none is returned.
add_mutant(${lab} gradient_zero_on_axis 3.1
  "if (distance == 0.0) return Vec3::UnitY();" "if (distance == 0.0) return Vec3::Zero();"
  "zero on the axis")

# Division by something small is feared.
add_mutant(${lab} gradient_up_near_axis 3.1
  "if (distance == 0.0) return Vec3::UnitY();" "if (distance < 1e-9) return Vec3::UnitY();"
  "near the axis is taken for one on it")

# NaN and infinity are left to spread.
add_mutant(${lab} gap_unchecked 3.1
  "common::require_finite(position, \"position\");\n  return" "return" "not checked")

# ---- 3.2 ----

# Contact is believed to begin with penetration.
add_mutant(${lab} contact_without_touching 3.2 "if (phi > 0.0)" "if (phi >= 0.0)" "touching counts")

# To be safe, what is near is taken for contact.
add_mutant(${lab} contact_with_tolerance 3.2 "if (phi > 0.0)" "if (phi > 1e-9)" "tolerance is added")

# Whoever asks for a contact gets one.
add_mutant(${lab} contact_always 3.2
  "if (phi > 0.0) return std::nullopt;" "" "returned although the surfaces are apart")

# The normal is taken from the particle to the cylinder.
add_mutant(${lab} contact_normal_reversed 3.2
  "contact.normal = n;" "contact.normal = -n;" "points into the cylinder")

# The deepest point is looked for behind the particle's centre.
add_mutant(${lab} contact_on_far_side 3.2
  "position - particle_radius * n" "position + particle_radius * n" "far side of the particle")

# The point is found in the yz-plane and stays there.
add_mutant(${lab} contact_point_at_origin 3.2
  "{position.x(), R * n.y(), R * n.z()}" "{0.0, R * n.y(), R * n.z()}" "x is lost")

# The surface is believed to be where a particle's centre touches.
add_mutant(${lab} contact_point_at_rho 3.2
  "const double R = cylinder.radius;" "const double R = cylinder.radius + particle_radius;"
  "the surface is at R")

# The particle is believed to touch with its centre.
add_mutant(${lab} contact_point_at_centre 3.2
  "position - particle_radius * n" "position" "the particle's centre")

# The time is checked and forgotten.
add_mutant(${lab} contact_without_time 3.2 "contact.time = time;" "" "time is not passed on")

# ---- 3.3 ----

# Contact is believed to begin with penetration.
add_mutant(${lab} batch_without_touching 3.3
  "return distance_from_axis(position) <= rho;" "return distance_from_axis(position) < rho;"
  "touching counts")

# Particles are taken for points.
add_mutant(${lab} batch_without_particle_radius 3.3
  "const double rho = sum_of_radii(particle_radius, cylinder);
  for (const Vec3& position : positions)"
  "const double rho = cylinder.radius + 0.0 * sum_of_radii(particle_radius, cylinder);
  for (const Vec3& position : positions)" "particle's radius is missing")

# The list is handed over as it was found: from the back.
add_mutant(${lab} batch_backwards 3.3
  "  return indices;" "  std::reverse(indices.begin(), indices.end());\n  return indices;"
  "indices fall")

# The deepest contact is believed to matter most.
add_mutant(${lab} batch_by_depth 3.3 "  return indices;"
  "  std::stable_sort(indices.begin(), indices.end(), [&](std::size_t i, std::size_t j) {
    return distance_from_axis(positions[i]) < distance_from_axis(positions[j]);
  });
  return indices;" "deepest comes first")

# Particles are counted as people count.
add_mutant(${lab} batch_from_one 3.3
  "indices.push_back(i);" "indices.push_back(i + 1);" "counted from 1")

# To be safe, what is near is taken for contact.
add_mutant(${lab} batch_with_tolerance 3.3
  "if (std::abs(excess) > unsure) return excess < 0.0;
    return distance_from_axis(position) <= rho;"
  "if (excess < -unsure) return true;
    return distance_from_axis(position) <= rho + 1e-9;" "tolerance is added")

# A list is believed to grow for free.
add_mutant(${lab} batch_grows 3.3 "  indices.reserve(
      static_cast<std::size_t>(std::count_if(positions.begin(), positions.end(), touches)));\n" ""
  "grows by push_back")

# Each particle is put into a list of its own first.
add_mutant(${lab} batch_of_small_lists 3.3
  "if (touches(positions[i])) indices.push_back(i);"
  "const std::vector<Vec3> one{positions[i]};
    if (touches(one.front())) indices.push_back(i);" "memory is allocated for each particle")

# ---- 3.4 ----

# The loop goes on after the first contact.
add_mutant(${lab} path_last_contact 3.4
  "for (std::int64_t k = 0; k <= samples; ++k)" "for (std::int64_t k = samples; k >= 0; --k)"
  "not the first sample")

# The start is believed to be known to be free.
add_mutant(${lab} path_without_start 3.4 "std::int64_t k = 0;" "std::int64_t k = 1;"
  "start is a sample too")

# N samples are believed to be N, not N + 1.
add_mutant(${lab} path_without_end 3.4 "k <= samples" "k < samples" "end is a sample too")

# The fraction of the path is taken for its time.
add_mutant(${lab} path_without_duration 3.4
  "path.duration * (static_cast<double>(k) / samples)" "static_cast<double>(k) / samples"
  "the samples end at 1 s")

# The contact is asked for without its time.
add_mutant(${lab} path_without_time 3.4
  "contact(position, particle_radius, cylinder, time);"
  "contact(position, particle_radius, cylinder, 0.0);" "time is not passed on")

# To be safe, what is near is taken for contact, and so it begins a sample early.
add_mutant(${lab} path_with_tolerance 3.4 "if (phi > 0.0)" "if (phi > 1e-9)" "tolerance is added")

# A loop over no sample is believed to be harmless.
add_mutant(${lab} path_samples_unchecked 3.4
  "if (samples < 1) throw std::invalid_argument(\"samples: want at least 1\");" "" "not checked")

# ---- 3.5 ----

# An edge is believed to be as near as its ends.
add_mutant(${lab} edge_by_ends 3.5
  "std::clamp(along / length, 0.0, 1.0)" "(along < 0.0 ? 0.0 : 0.0)" "only the ends")

# An edge is taken for the line that carries it.
add_mutant(${lab} edge_not_clamped 3.5
  "std::clamp(along / length, 0.0, 1.0)" "along / length" "not held on the edge")

# The nearest point is believed to be halfway.
add_mutant(${lab} edge_by_middle 3.5
  "std::clamp(along / length, 0.0, 1.0)" "(along < 0.0 ? 0.5 : 0.5)" "middle is taken")

# An edge is believed to have one length.
add_mutant(${lab} edge_length_in_space 3.5
  "const double length = distance_from_axis(edge);" "const double length = edge.stableNorm();"
  "length is that in space")

# A length of zero is divided by.
add_mutant(${lab} edge_along_x_divided_by_zero 3.5
  "if (length == 0.0) return {distance_a, 0.0};" "" "")

# The fraction is left as it was counted from the nearer end.
add_mutant(${lab} edge_fraction_from_other_end 3.5
  "return {reversed.distance, 1.0 - reversed.fraction};" "return reversed;" "counted from b")

# A particle's thickness is left out where it has become an edge's.
add_mutant(${lab} edge_without_particle_radius 3.5
  "return {nearest.distance - rho, nearest.fraction};"
  "return {nearest.distance - rho + particle_radius, nearest.fraction};"
  "particle's radius is missing")

# What the axis pierces is believed to show at the edges.
add_mutant(${lab} triangle_by_edges 3.5
  "areas.minCoeff() >= 0.0 || areas.maxCoeff() <= 0.0" "false" "only the edges")

# Two edges have all three corners, so they are believed to be enough.
add_mutant(${lab} triangle_of_two_edges 3.5
  "const EdgePoint ca = nearest_on_edge(c, a);"
  "const EdgePoint ca{std::max(ab.distance, bc.distance), 0.0};" "never checked")

# Corners are believed to go round one way only.
add_mutant(${lab} triangle_of_one_winding 3.5
  "areas.minCoeff() >= 0.0 || areas.maxCoeff() <= 0.0" "areas.minCoeff() >= 0.0" "only the edges")

# Products as they are written: in a sliver their rounding has the sign that decides.
add_mutant(${lab} triangle_by_rounded_signs 3.5
  "return std::fma(a, b, -cd) + std::fma(-c, d, cd);" "return a * b - cd;"
  "areas of the size of rounding")

# Each area is given to the wrong corner.
add_mutant(${lab} triangle_weights_shifted 3.5
  "const Vec3 areas(cross(b, c), cross(c, a), cross(a, b));"
  "const Vec3 areas(cross(a, b), cross(b, c), cross(c, a));" "those of other corners")

# Corners without area are taken for pierced: 0/0.
add_mutant(${lab} triangle_without_area_pierced 3.5
  "if (!pierced || total == 0.0)" "if (!pierced)"
  "areas of the size of rounding")

# ---- 3.6 ----

# It is believed to be enough that no particle is inside.
add_mutant(${lab} sheet_edges_by_ends 3.6
  "const double distance = nearest_on_edge(particle(a), particle(b)).distance;"
  "const double distance =
        std::min(distance_from_axis(particle(a)), distance_from_axis(particle(b)));"
  "only the ends")

# It is believed to be enough that no edge is inside.
add_mutant(${lab} sheet_triangles_by_edges 3.6
  "nearest_on_triangle(particle(a), particle(b), particle(c)).distance;"
  "std::min({nearest_on_edge(particle(a), particle(b)).distance,
                                      nearest_on_edge(particle(b), particle(c)).distance,
                                      nearest_on_edge(particle(c), particle(a)).distance});"
  "only the edges")

# To be safe, what is near is taken for contact.
add_mutant(${lab} sheet_with_tolerance 3.6
  "if (distance <= rho) contacts.edges" "if (distance <= rho + 1e-10) contacts.edges"
  "tolerance is added")

# Sheets are believed to come with good indices.
add_mutant(${lab} sheet_indices_unchecked 3.6
  "if (index < sheet.positions.size()) return sheet.positions[index];
    throw std::invalid_argument(\"sheet: an edge or a triangle has an index of no particle\");"
  "return sheet.positions[std::min(index, sheet.positions.size() - 1)];" "not checked")

# A cloth's thickness is left out of its margin.
add_mutant(${lab} margin_without_particle_radius 3.6
  "std::hypot(rho, 0.5 * longest_edge)" "std::hypot(cylinder.radius, 0.5 * longest_edge)"
  "R is used instead of rho")

# The root of a sum of squares, as it is written.
add_mutant(${lab} margin_by_squares 3.6
  "std::hypot(rho, 0.5 * longest_edge)"
  "std::sqrt(rho * rho + 0.25 * longest_edge * longest_edge)" "squares vanish")

# A whole edge is put where half of one belongs.
add_mutant(${lab} margin_of_whole_edge 3.6
  "std::hypot(rho, 0.5 * longest_edge)" "std::hypot(rho, longest_edge)" "h is used instead of h/2")

# It is believed to be enough that no edge sinks.
add_mutant(${lab} margin_without_triangles 3.6
  "std::max(edge_touches, triangle_pierced) - rho" "edge_touches - rho + 0.0 * triangle_pierced"
  "large triangle is forgotten")

# The distance from the axis is taken for the gap.
add_mutant(${lab} margin_from_the_axis 3.6
  "std::max(edge_touches, triangle_pierced) - rho" "std::max(edge_touches, triangle_pierced)"
  "a margin is a gap")

# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab continuous_particle_cylinder)

# ---- 4.1 ----

# The particle is taken for a point.
add_mutant(${lab} textbook_without_particle_radius 4.1
  "const double rho = R + r;" "const double rho = R + 0.0 * r;" "particle's radius is forgotten")

# The distance is taken from a point, where it is from an axis.
add_mutant(${lab} textbook_keeps_x 4.1
  "const double b = 2.0 * (y * v_y + z * v_z);
  const double c = y * y + z * z - rho * rho;"
  "const Vec3& x = particle.position;
  const Vec3& v = particle.velocity;
  const double b = 2.0 * x.dot(v);
  const double c = x.dot(x) - rho * rho;
  if (c > 0.0) {
    const double u = (-b - std::sqrt(b * b - 4.0 * v.dot(v) * c)) / (2.0 * v.dot(v));
    return u >= 0.0 && u <= dt ? std::optional(u) : std::nullopt;
  }"
  "x is kept in the distance")

# Of two roots the one with the plus is taken, as it is written first.
add_mutant(${lab} textbook_later_root 4.1 "(-b - std::sqrt(" "(-b + std::sqrt(" "later root")

# Nobody asks whether the impact is still to come.
add_mutant(${lab} textbook_in_the_past 4.1
  "if (t >= 0.0 && t <= dt) return t;" "if (t <= dt) return t;" "in the past")

# Nobody asks whether the step lasts that long.
add_mutant(${lab} textbook_beyond_dt 4.1
  "if (t >= 0.0 && t <= dt) return t;" "if (t >= 0.0) return t;" "dt is ignored")

# The step is taken to end just before dt.
add_mutant(${lab} textbook_without_arrival_at_dt 4.1
  "t >= 0.0 && t <= dt" "t >= 0.0 && t < dt" "arrival at dt")

# What is neither too early nor too late is believed to be a time: NaN is neither.
add_mutant(${lab} textbook_nan_at_rest 4.1
  "if (t >= 0.0 && t <= dt) return t;" "if (!(t < 0.0 || t > dt)) return t;"
  "NaN is returned where there is no root")

# b is remembered from the other form of the formula, with b/2.
add_mutant(${lab} textbook_half_of_b 4.1 "const double b = 2.0 * (" "const double b = (" "b lacks")

# The start is not looked at, since the roots are believed to say it all.
add_mutant(${lab} textbook_start_inside_missed 4.1
  "if (c <= 0.0) return 0.0;" "if (c <= 0.0) return std::nullopt;" "start inside is missed")

# The better method is handed in where the textbook's was asked for.
add_mutant(${lab} textbook_too_good 4.1
  "if (c <= 0.0) return 0.0;" "if (c <= dt + infinity) return time_of_impact(particle, cylinder, dt);"
  "not the textbook's formula")

# The discriminant is remembered from the other form of the formula.
add_mutant(${lab} textbook_discriminant_without_4 4.1
  "b * b - 4.0 * a * c"
  "b * b - a * c"
  "4 a c lacks its 4")

# The divisor is remembered from the other form of the formula.
add_mutant(${lab} textbook_divided_by_a 4.1
  "/ (2.0 * a)"
  "/ a"
  "divided by a")

# The minus before b is lost.
add_mutant(${lab} textbook_sign_of_b 4.1
  "(-b - std::sqrt"
  "(b - std::sqrt"
  "b has the wrong sign")

# The square of a sum is believed to be the sum of the squares.
add_mutant(${lab} textbook_sum_of_squared_radii 4.1
  "y * y + z * z - rho * rho;
  if (c <= 0.0) return 0.0;
  const double t = (-b"
  "y * y + z * z - (R * R + r * r) + 0.0 * rho;
  if (c <= 0.0) return 0.0;
  const double t = (-b"
  "R^2 + r^2")

# An impact after dt is believed to be one at dt.
add_mutant(${lab} textbook_clamped_to_dt 4.1
  "if (t >= 0.0 && t <= dt) return t;"
  "if (t >= 0.0) return t < dt ? t : dt;"
  "returned as dt")

# ---- 4.2 ----

# One fused operation is believed to make both products exact.
add_mutant(${lab} difference_not_corrected 4.2
  "return std::fma(a, b, -cd) + rest;" "return std::fma(a, b, -cd) + 0.0 * rest;" "not put back")

# The sign of what was rounded away is guessed.
add_mutant(${lab} difference_corrected_backwards 4.2
  "std::fma(-c, d, cd)" "std::fma(c, d, -cd)" "wrong sign")

# A difference of products is a difference of products.
add_mutant(${lab} difference_of_rounded_products 4.2
  "return std::fma(a, b, -cd) + rest;" "return a * b - cd + 0.0 * rest;"
  "rounded before they cancel")

# Only the root is believed to cancel, so the textbook's discriminant is kept.
add_mutant(${lab} cross_form_of_rounded_squares 4.2
  "(w_touching - w) * (w_touching + w)" "b * b - a * c" "discriminant cancels")

# The particle is taken for a point.
add_mutant(${lab} cross_form_without_particle_radius 4.2
  "const DoubleDouble rho = common::two_sum(R, r);" "const DoubleDouble rho = R;"
  "particle's radius is forgotten")

# Of two roots the one is taken that has no cancellation as it stands.
add_mutant(${lab} cross_form_later_root 4.2
  "c / (std::sqrt(std::max(discriminant, 0.0)) - b)"
  "(std::sqrt(std::max(discriminant, 0.0)) - b) / a" "later root")

# Nobody asks whether the particle approaches.
add_mutant(${lab} cross_form_in_the_past 4.2
  "if (b >= 0.0 || w > lean * w_touching)" "if (w > lean * w_touching)" "in the past")

# Nobody asks whether the step lasts that long.
add_mutant(${lab} cross_form_beyond_dt 4.2
  "const double y_end = std::fma(dt, v_y, y);"
  "dt = infinity;
  const double y_end = std::fma(dt, v_y, y);" "dt is ignored")

# The velocity is made unit, and what comes out is taken for a time.
add_mutant(${lab} cross_form_way_for_time 4.2
  "return std::min(t, dt);" "return std::min(t, dt) * std::sqrt(a);" "scaled by the speed")

# A particle that is inside cannot come in any more, it is thought.
add_mutant(${lab} cross_form_start_inside_missed 4.2
  "if (c <= 8.0 * eps * eps * rho_squared) return 0.0;"
  "if (c <= 8.0 * eps * eps * rho_squared) return std::nullopt;" "start inside is missed")

# A particle on the surface that leaves it is believed to be outside.
add_mutant(${lab} cross_form_start_touching_missed 4.2
  "if (c <= 8.0 * eps * eps * rho_squared)" "if (c < -8.0 * eps * eps * rho_squared)"
  "touching at the start")

# The rounded gap is believed to have the right sign.
add_mutant(${lab} cross_form_start_without_margin 4.2
  "if (c <= 8.0 * eps * eps * rho_squared) return 0.0;"
  "if (std::hypot(y, z) - rho.high <= 0.0) return 0.0;" "margin of a few eps of rho")

# One point in common is believed to be none.
add_mutant(${lab} cross_form_tangent_missed 4.2
  "w > lean * w_touching" "w >= w_touching" "touching in passing")

# The computed root is compared with dt as if it were exact.
add_mutant(${lab} cross_form_root_against_dt 4.2
  "return std::min(t, dt);" "return t <= dt ? std::optional(t) : std::nullopt;"
  "root beyond dt by rounding alone")

# The cross product is written down as it is, though all that counts of it is what is left.
add_mutant(${lab} cross_form_of_rounded_cross_product 4.2
  "difference_of_products(y, v_z, z, v_y)" "y * v_z - z * v_y" "products of x × v are rounded")

# A margin is chosen by feeling, not by what the rounding is.
add_mutant(${lab} cross_form_wide_margin_of_discriminant 4.2
  "w > lean * w_touching" "w * w > (1.0 + 1e-9) * w_touching * w_touching"
  "passes just outside")
add_mutant(${lab} cross_form_wide_margin_of_start 4.2
  "c <= 8.0 * eps * eps * rho_squared" "c <= 2e-7 * rho_squared" "start just outside")
add_mutant(${lab} cross_form_wide_margin_of_end 4.2
  "z_end * z_end > lean * rho_squared" "z_end * z_end > (1.0 + 1e-9) * rho_squared"
  "end just outside")

# The two products of x and v are taken for one another.
add_mutant(${lab} cross_form_of_dot_product 4.2
  "std::abs(difference_of_products(y, v_z, z, v_y))"
  "std::abs(difference_of_products(y, v_y, -z, v_z))"
  "w is x.v")

# The b of the textbook is kept, which is twice as large.
add_mutant(${lab} cross_form_with_textbook_b 4.2
  "c / (std::sqrt(std::max(discriminant, 0.0)) - b)"
  "c / (std::sqrt(std::max(discriminant, 0.0)) - 2.0 * b)"
  "textbook's 2 in b")

# c is believed to be the gap at the start.
add_mutant(${lab} cross_form_of_gap 4.2
  "c / (std::sqrt(std::max(discriminant, 0.0)) - b)"
  "(std::hypot(y, z) - rho.high) / (std::sqrt(std::max(discriminant, 0.0)) - b)"
  "c is taken as the gap")

# The speed is believed to be one.
add_mutant(${lab} cross_form_without_speed 4.2
  "(w_touching - w) * (w_touching + w)"
  "(rho.high - w) * (rho.high + w)"
  "lacks |v|^2")

# The sign of a rounded discriminant is believed.
add_mutant(${lab} cross_form_without_margin 4.2
  "w > lean * w_touching)"
  "(w_touching - w) * (w_touching + w) < 0.0)"
  "below zero by rounding alone")

# What is outside at dt is believed never to have been inside.
add_mutant(${lab} cross_form_passage_missed 4.2
  "if (outside_at_end && -b > lean * (a * dt)) return"
  "if (outside_at_end) return"
  "passed through by dt")

# ---- 4.3 ----

# A sum of two doubles is believed to be one.
add_mutant(${lab} certified_rounded_radius 4.3
  "cylinder.radius, r};" "cylinder.radius + r, 0.0};" "R + r is rounded")

# More digits are believed to be enough, without a bound of their error.
add_mutant(${lab} certified_without_bound 4.3
  "std::abs(X.high) > 1e-30 * X_terms.value + 1e-280" "std::abs(X.high) > 1e-280" "sign is trusted")

# The rounded root decides whether it is past dt.
add_mutant(${lab} certified_rounded_arrival 4.3
  "if (at_end > 0 && sign(x.slope, terms.slope, &Exact::slope) < 0) return infinity;"
  "if (at_end > 0 && (x.c / (sqrt(x.discriminant) - x.b)).high > dt) return infinity;"
  "rounded t* is compared with dt")

# Zero is taken to be outside.
add_mutant(${lab} certified_start_touching_missed 4.3
  "sign(x.c, terms.c, &Exact::c) <= 0" "sign(x.c, terms.c, &Exact::c) < 0" "touching at the start")

# A double root is taken for none.
add_mutant(${lab} certified_tangent_missed 4.3
  "&Exact::discriminant) < 0" "&Exact::discriminant) <= 0" "touching in passing")

# The step is taken to end just before dt.
add_mutant(${lab} certified_without_arrival_at_dt 4.3
  "if (at_end > 0 &&" "if (at_end >= 0 &&" "arrival at dt")

# The margins of step 4.2 are kept, though there is no doubt any more.
add_mutant(${lab} certified_with_margins 4.3
  "sign(x.c, terms.c, &Exact::c) <= 0" "x.c.high <= 8.0 * eps * terms.c.value"
  "start just outside")

# The gap is a length, the step a time.
add_mutant(${lab} advancement_by_lengths 4.3
  "t + gap / speed" "t + gap" "not divided by the speed")

# The speed of a particle is that of all its coordinates.
add_mutant(${lab} advancement_by_spatial_speed 4.3
  "const double speed = std::hypot(v_y, v_z);"
  "const double speed = particle.velocity.norm();" "all three axes")

# Only what touches is believed to be an impact, though no step ever gets there.
add_mutant(${lab} advancement_never_there 4.3
  "advancement.time = t;" "if (gap <= 0.0) advancement.time = t;" "within the tolerance is taken")

# The step is made before the gap is looked at.
add_mutant(${lab} advancement_one_too_far 4.3
  "advancement.time = t;" "advancement.time = next;" "steps once more")

# Steps are counted instead of evaluations.
add_mutant(${lab} advancement_counts_steps 4.3
  "    ++advancement.iterations;" "    if (t > 0.0) ++advancement.iterations;" "is not counted")

# The count stands at the end of the loop, and the last round leaves before it.
add_mutant(${lab} advancement_counts_at_the_end 4.3
  "    ++advancement.iterations;
    const double next = t + gap / speed;  // eq. (8); infinite at rest
    if (gap <= tolerance || next == t) {  // or φ/|v| is too small to change t
      advancement.time = t;
      break;
    }
    t = next;"
  "    const double next = t + gap / speed;
    if (gap <= tolerance || next == t) {
      advancement.time = t;
      break;
    }
    t = next;
    ++advancement.iterations;" "is not counted")

# What is at dt is believed to be past it.
add_mutant(${lab} advancement_without_arrival_at_dt 4.3
  "    t = next;" "    if (next >= dt) break;
    t = next;" "arrival at dt is lost")

# A gap within the tolerance is taken to be one below it.
add_mutant(${lab} advancement_below_tolerance 4.3
  "gap <= tolerance ||" "gap < tolerance ||" "equals the tolerance")

# A particle that rests is believed to need no look.
add_mutant(${lab} advancement_at_rest_not_evaluated 4.3
  "  for (double t = 0.0; t <= dt;) {
    const double gap"
  "  if (speed == 0.0) return advancement;
  for (double t = 0.0; t <= dt;) {
    const double gap" "before you look at the speed")

# The tolerance is met by eye.
add_mutant(${lab} advancement_wide_tolerance 4.3
  "gap <= tolerance ||" "gap <= (1.0 + 1e-8) * tolerance ||" "tolerance is taken too wide")

# What is outside at dt is believed never to have been inside.
add_mutant(${lab} certified_passage_missed 4.3
  "if (at_end > 0 && sign(x.slope, terms.slope, &Exact::slope) < 0) return infinity;"
  "if (at_end > 0) return infinity;"
  "passed through by dt")

# The order of the decisions is believed not to matter.
add_mutant(${lab} certified_approach_asked_first 4.3
  "if (sign(x.c, terms.c, &Exact::c) <= 0) return 0.0;
  if (sign(x.b, terms.b, &Exact::b) >= 0) return infinity;"
  "if (sign(x.b, terms.b, &Exact::b) >= 0) return infinity;
  if (sign(x.c, terms.c, &Exact::c) <= 0) return 0.0;"
  "ask c <= 0 before b >= 0")

# A sign that is certain is believed to have all its digits.
add_mutant(${lab} certified_time_never_exact 4.3
  ": exact_root(quadratic<ExactNumber>(m, dt));"
  ": (x.c / (root - x.b)).high;"
  "lost digits")

# The tolerance is taken for a share of the size.
add_mutant(${lab} advancement_relative_tolerance 4.3
  "if (gap <= tolerance ||"
  "if (gap <= tolerance * (R + r) ||"
  "multiplied by R + r")

# The gap is taken from the squares, as in the quadratic.
add_mutant(${lab} advancement_of_squares 4.3
  "std::hypot(y + t * v_y, z + t * v_z) - (R + r);"
  "std::pow(std::hypot(y + t * v_y, z + t * v_z), 2) - (R + r) * (R + r);"
  "difference of squares")

# The particle is taken for a point.
add_mutant(${lab} advancement_without_particle_radius 4.3
  "z + t * v_z) - (R + r);"
  "z + t * v_z) - R - 0.0 * r;"
  "radius is forgotten")

# The loop is written to end before dt.
add_mutant(${lab} advancement_before_dt 4.3
  "for (double t = 0.0; t <= dt;)"
  "for (double t = 0.0; t < dt;)"
  "arrival at dt is lost")

# ---- 4.4 ----

# The normal is taken to point at what it is the normal of.
add_mutant(${lab} contact_normal_reversed 4.4
  "{0.0, y / std::hypot(y, z), z / std::hypot(y, z)}"
  "{0.0, -y / std::hypot(y, z), -z / std::hypot(y, z)}" "normal is reversed")

# The contact is built where the particle is now, not where it will be.
add_mutant(${lab} contact_at_start 4.4
  "const Vec3 p = x + time * v;" "const Vec3 p = x + 0.0 * v;" "not moved to")

# The particle is taken for its centre.
add_mutant(${lab} contact_at_center 4.4
  "{p.x(), p.y() - r * n.y(), p.z() - r * n.z()}" "p" "particle's centre")

# Where the particle's centre is at the impact is taken for the surface.
add_mutant(${lab} contact_beyond_surface 4.4
  "cylinder.radius * n.y(), cylinder.radius * n.z()"
  "(cylinder.radius + r) * n.y(), (cylinder.radius + r) * n.z()"
  "ends at R")

# The normal is taken from a point, where it is from an axis.
add_mutant(${lab} contact_normal_keeps_x 4.4
  "{0.0, y / std::hypot(y, z), z / std::hypot(y, z)}" "Vec3(p.x() / size, y, z).normalized()"
  "x is kept in the normal")

# The gap is taken to the particle's centre.
add_mutant(${lab} contact_gap_without_particle_radius 4.4
  "std::hypot(p.y(), p.z()) - (cylinder.radius + r)" "std::hypot(p.y(), p.z()) - cylinder.radius"
  "particle's radius is forgotten")

# The axis is believed never to be met.
add_mutant(${lab} contact_nan_on_axis 4.4 "if (size > 0.0) n" "n" "divided by 0 on the axis")

# The particle is believed to hit head-on.
add_mutant(${lab} contact_normal_against_velocity 4.4
  "if (size > 0.0) n = {0.0, y / std::hypot(y, z), z / std::hypot(y, z)};"
  "if (size > 0.0) n = Vec3(0.0 * (y + z), -v.y(), -v.z()).normalized();"
  "normal is -v")

# The direction is believed not to change on the way.
add_mutant(${lab} contact_normal_of_start 4.4
  "{0.0, y / std::hypot(y, z), z / std::hypot(y, z)}"
  "Vec3(0.0 * (y + z), x.y(), x.z()).normalized()"
  "normal is that of the start")

# The distance is believed to be R + r.
add_mutant(${lab} contact_normal_by_radii 4.4
  "{0.0, y / std::hypot(y, z), z / std::hypot(y, z)}"
  "Vec3(0.0 * (y + z), p.y(), p.z()) / (cylinder.radius + r)"
  "divided by R + r")

# The two points are believed to be one.
add_mutant(${lab} contact_point_from_particle 4.4
  "{p.x(), cylinder.radius * n.y(), cylinder.radius * n.z()}"
  "{p.x(), p.y() - r * n.y(), p.z() - r * n.z()}"
  "the point on the particle")

# The points are assigned the wrong way round.
add_mutant(${lab} contact_points_swapped 4.4
  "  contact.time = time;"
  "  std::swap(contact.point_on_cylinder, contact.point_on_particle);
  contact.time = time;"
  "two points are swapped")

# Motion along x plays no part in detection, so it is left out here, too.
add_mutant(${lab} contact_without_motion_along_x 4.4
  "const Vec3 p = x + time * v;"
  "const Vec3 p = x + time * Vec3(0.0, v.y(), v.z());"
  "motion along x is left out")

# The distance is taken from a point, where it is from an axis.
add_mutant(${lab} contact_gap_keeps_x 4.4
  "contact.gap = std::hypot(p.y(), p.z()) - ("
  "contact.gap = p.norm() - ("
  "x is kept in the gap")

# The division by 0 is avoided, and nothing is put in its place.
add_mutant(${lab} contact_zero_normal_on_axis 4.4
  "  if (size > 0.0) n ="
  "  n = Vec3::Zero();
  if (size > 0.0) n ="
  "left at zero")

# ---- 4.5 ----

# The loop ends one too early.
add_mutant(${lab} batch_last_missed 4.5
  "    times[i] = certified_time(" "    if (i + 1 < y.size()) times[i] = certified_time("
  "last particle")

# No impact is told by a number that a time cannot be.
add_mutant(${lab} batch_minus_one_for_none 4.5
  "  return times;"
  "  for (double& time : times) time = time < infinity ? time : -1.0;
  return times;" "infinity does")

# No impact is told by no number.
add_mutant(${lab} batch_nan_for_none 4.5
  "  return times;"
  "  for (double& time : times) time = time < infinity ? time : NAN;
  return times;" "returned as NaN")

# Only the first of the particles is looked at.
add_mutant(${lab} batch_checks_first_particle 4.5
  "    for (const double entry : {y[i], z[i], v_y[i], v_z[i]}) common"
  "    for (const double entry : {y[0], z[0], v_y[0], v_z[0]}) common" "arguments are not checked")

# Arrays are believed to be as long as the first: what one lacks at its end is zero.
add_mutant(${lab} batch_lengths_not_compared 4.5
  "throw std::invalid_argument(\"particles: the arrays differ in length\");"
  "MovingParticles filled = particles;
    for (auto* one : {&filled.z, &filled.velocity_y, &filled.velocity_z}) one->resize(y.size());
    return times_of_impact(filled, cylinder, dt);" "lengths of the four arrays")

# The coordinates are compared with each other, and so are the velocities.
add_mutant(${lab} batch_lengths_compared_in_pairs 4.5
  "if (z.size() != y.size() || v_y.size() != y.size() || v_z.size() != y.size()) {"
  "MovingParticles filled = particles;
  for (auto* one : {&filled.velocity_y, &filled.velocity_z}) one->resize(y.size());
  if (v_y.size() != y.size() && z.size() == y.size() && v_z.size() == v_y.size()) {
    return times_of_impact(filled, cylinder, dt);
  }
  if (z.size() != y.size() || v_y.size() != y.size() || v_z.size() != y.size()) {"
  "lengths of the four arrays")

# A filter in plain doubles is believed to need no bound of its error.
add_mutant(${lab} batch_filter_without_bounds 4.5
  "    times[i] = certified_time("
  "    const double rho = cylinder.radius + r;
    const bool outside = y[i] * y[i] + z[i] * z[i] - rho * rho > 0.0;
    times[i] = infinity;
    if (outside && y[i] * v_y[i] + z[i] * v_z[i] > 0.0) continue;
    times[i] = certified_time(" "because c is rounded")

# Without particles there is nothing to do, so nothing is looked at.
add_mutant(${lab} batch_of_none_not_checked 4.5
  "  common::require_positive(r, \"particle radius\");
  common::require_positive(cylinder.radius, \"cylinder radius\");
  common::require_not_negative(dt, \"dt\");
  std::vector"
  "  if (y.empty()) return {};
  common::require_positive(r, \"particle radius\");
  common::require_positive(cylinder.radius, \"cylinder radius\");
  common::require_not_negative(dt, \"dt\");
  std::vector" "if there are no particles")

# No impact is told by the end of the step.
add_mutant(${lab} batch_dt_for_none 4.5
  "  return times;"
  "  for (double& time : times) time = std::min(time, dt);
  return times;"
  "returned as dt")

# The rest after the last register is forgotten.
add_mutant(${lab} batch_of_full_blocks 4.5
  "for (std::size_t i = 0; i < y.size(); ++i) {"
  "for (std::size_t i = 0; i < y.size() / 4 * 4; ++i) {"
  "last full block")

# The index of the block is used for that of the particle.
add_mutant(${lab} batch_with_mixed_lanes 4.5
  "certified_time({y[i], z[i], v_y[i], v_z[i],"
  "certified_time({y[i], z[i], v_y[i / 4 * 4], v_z[i / 4 * 4],"
  "different particles are mixed")

# The arrays are passed in the wrong order.
add_mutant(${lab} batch_velocities_swapped 4.5
  "certified_time({y[i], z[i], v_y[i], v_z[i],"
  "certified_time({y[i], z[i], v_z[i], v_y[i],"
  "velocity_y and velocity_z are swapped")

# The fast form is believed to be good enough for many.
add_mutant(${lab} batch_by_cross_form 4.5
  "    times[i] = certified_time({y[i], z[i], v_y[i], v_z[i], cylinder.radius, r}, dt);"
  "    const MovingParticle one{{0.0, y[i], z[i]}, {0.0, v_y[i], v_z[i]}, r};
    times[i] = time_of_impact(one, cylinder, dt).value_or(infinity);"
  "those of step 4.2")

# ---- 4.6 ----

# A cloth's particles are believed to stand for its edges.
add_mutant(${lab} edge_by_its_ends 4.6
  "return s ? *s * T : if_finite(end);" "return s ? if_finite(end) : if_finite(end);" "ends alone")

# An edge is believed to be as long as its line.
add_mutant(${lab} edge_as_its_line 4.6
  "ExactPolynomial{} - dot(p, d) * dot(q, d)" "ExactPolynomial{1.0}"
  "line is taken for the edge")

# The edge is taken for a thread without thickness.
add_mutant(${lab} edge_without_radius 4.6
  "ExactNumber(cylinder.radius) + ExactNumber(edge.radius)" "ExactNumber(cylinder.radius)"
  "edge's radius is forgotten")

# The edge keeps its length and its direction, as if it were a rod that is carried along.
add_mutant(${lab} edge_with_one_velocity 4.6
  "exact_path(edge.b, edge.velocity_b, T)" "exact_path(edge.b, edge.velocity_a, T)" "velocity of a")

# The search goes to the right first.
add_mutant(${lab} edge_last_touch 4.6
  "  if (const auto s = first_touch(inside, {piece.from, middle, f_left, foot_left})) return s;
  return first_touch(inside, {middle, piece.to, f_right, foot_right});"
  "  if (const auto s = first_touch(inside, {middle, piece.to, f_right, foot_right})) return s;
  return first_touch(inside, {piece.from, middle, f_left, foot_left});" "later root")

# The quartic is believed to tell of every touch, but it has no root where one is there already.
add_mutant(${lab} edge_start_missed 4.6
  "if (inside.f[0].sign() <= 0 && inside.foot[0].sign() > 0) return 0.0;" "" "inside touches is missed")

# The sign at the start is asked with a margin by feeling.
add_mutant(${lab} edge_wide_margin_of_start 4.6
  "inside.f[0].sign() <= 0" "inside.f[0].rounded().high <= 1e-6" "near miss is taken")

# What rounding cannot decide is taken for a miss.
add_mutant(${lab} edge_touch_missed 4.6
  "touches.count(piece.from, piece.to) == 0" "touches.count(piece.from, piece.to) <= 1"
  "touch is not counted")

# The bracket is as wide as can be told by eye.
add_mutant(${lab} edge_time_not_refined 4.6
  "constexpr double time_accuracy = 0x1p-50;" "constexpr double time_accuracy = 0x1p-30;"
  "too few digits")

# Only one end of the edge is checked.
add_mutant(${lab} edge_checks_one_end 4.6
  "  require_valid(end_b, cylinder, dt);
" "" "arguments are not checked")

# The sign of the product of both conditions is guessed.
add_mutant(${lab} edge_foot_on_wrong_side 4.6
  "ExactPolynomial{} - dot(p, d) * dot(q, d)"
  "dot(p, d) * dot(q, d)"
  "wrong side of an end")

# One of the two conditions is believed to imply the other.
add_mutant(${lab} edge_foot_one_sided 4.6
  "ExactPolynomial{} - dot(p, d) * dot(q, d)"
  "ExactPolynomial{} - dot(p, d)"
  "one end only")

# The foot is checked for roots only.
add_mutant(${lab} edge_line_at_start 4.6
  "if (inside.f[0].sign() <= 0 && inside.foot[0].sign() > 0) return 0.0;"
  "if (inside.f[0].sign() <= 0) return 0.0;"
  "at the start")

# The cross product is taken for the distance of the line.
add_mutant(${lab} edge_without_length 4.6
  "{C * C - rho * rho * dot(d, d),"
  "{C * C - rho * rho,"
  "lacks |q - p|^2")

# The ends are taken for points.
add_mutant(${lab} edge_ends_without_radius 4.6
  "  const double end = std::min("
  "  const auto motion = [](const MovingParticle& p, const Cylinder& c) {
    const auto& [x, v, r] = p;
    return Motion{x.y(), x.z(), v.y(), v.z(), c.radius, 0.0 * r};
  };
  const double end = std::min("
  "forgotten for its ends")

# The edge is believed to begin the contact at a.
add_mutant(${lab} edge_with_one_end 4.6
  "std::min(certified_time(motion(end_a, cylinder), dt),
                              certified_time(motion(end_b, cylinder), dt));"
  "certified_time(motion(end_a, cylinder), dt);"
  "one end is left out")

# The parameter of Bernstein's form is taken for a time.
add_mutant(${lab} edge_share_for_time 4.6
  "return s ? *s * T :"
  "return s ? *s :"
  "share s")

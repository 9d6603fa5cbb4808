# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab continuous_particle_cylinder)

# ---- 4.6 ----

# A cloth's particles are believed to stand for its edges.
add_mutant(${lab} edge_by_its_ends 4.6
  "return inside ? inside : end;" "return inside && end ? end : end;" "ends alone")

# An edge is believed to be as long as its line.
add_mutant(${lab} edge_as_its_line 4.6
  "return p_d < 0 && q_d > 0 ? 1 : p_d * q_d > 0 ? -1 : 0;" "return p_d * q_d > 2 ? -1 : 1;"
  "line is taken for the edge")

# The edge is taken for a thread without thickness.
add_mutant(${lab} edge_without_radius 4.6
  "Number(query.cylinder.radius) + Number(edge.radius);" "Number(query.cylinder.radius);"
  "edge's radius is forgotten")

# The edge keeps its length and its direction, as if it were a rod that is carried along.
add_mutant(${lab} edge_with_one_velocity 4.6
  "difference(edge.velocity_b, edge.velocity_a)" "difference(edge.velocity_a, edge.velocity_a)"
  "velocity of a")

# The search goes to the right first.
add_mutant(${lab} edge_last_touch 4.6
  "if (const auto time = first_touch(left)) return time;"
  "if (const auto time = first_touch(right)) return time;
    return first_touch(left);" "later root")

# The quartic is believed to tell of every touch, but it has no root where one is there already.
add_mutant(${lab} edge_start_missed 4.6
  "if (!off && touches_at_start_exactly(query)) return 0.0;" "" "inside touches is missed")

# What rounding cannot decide is taken for a miss.
add_mutant(${lab} edge_touch_missed 4.6
  "if (touches.count(from, to) == 0)" "if (touches.count(from, to) <= 1)"
  "touch is not counted")

# The bracket is as wide as can be told by eye.
add_mutant(${lab} edge_time_not_refined 4.6
  "constexpr double time_accuracy = 0x1p-50;" "constexpr double time_accuracy = 0x1p-30;" "")

# The check of the arguments is left to the ends, of which one is looked at.
add_mutant(${lab} edge_checks_one_end 4.6
  "  require_valid(end_b, cylinder, dt);
" "" "arguments are not checked")

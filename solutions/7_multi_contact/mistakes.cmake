# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab multi_contact)

# ---- 7.1 ----

# Contacts are believed not to feel each other.
add_mutant(${lab} diagonal_alone 7.1
  "for (int j = 0; j < m; ++j) {" "for (int j = i; j <= i; ++j) {" "nothing off its diagonal")

# An impulse is believed to open its neighbours, too.
add_mutant(${lab} coupling_sign 7.1
  "system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "const double sign = i == j ? 1.0 : -1.0;
        system.A(i, j) += sign * body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += sign * turn_i.dot(body.inverse_inertia * turn_j);"
  "off its diagonal A has the wrong sign")

# Bodies are believed to yield like point masses.
add_mutant(${lab} lever_arms_not_in_A 7.1
  "system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);" "" "left out of A")

# Bodies are believed to meet as fast as their centres do.
add_mutant(${lab} spins_not_in_u 7.1
  "+ turn_i.dot(body.angular_velocity)" "" "spins are left out of u")

# Points are measured from the world's origin.
add_mutant(${lab} levers_from_the_origin 7.1
  "const auto [n_i, turn_i] = row_part(at(contacts, i), k, body.position);
      system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        if (k != at(contacts, j).a && k != at(contacts, j).b) continue;
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, body.position);"
  "const auto [n_i, turn_i] = row_part(at(contacts, i), k, Vec3::Zero());
      system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        if (k != at(contacts, j).a && k != at(contacts, j).b) continue;
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, Vec3::Zero());" "world's origin")

# All masses are believed to be alike.
add_mutant(${lab} W_forgotten 7.1
  "system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "system.A(i, j) += n_i.dot(n_j) + turn_i.dot(turn_j);" "W is missing")
add_mutant(${lab} inverse_inertias_forgotten 7.1
  "turn_i.dot(body.inverse_inertia * turn_j)" "turn_i.dot(turn_j)"
  "inverse inertias are missing from A")

# The first body is believed to stand fast.
add_mutant(${lab} A_of_b_alone 7.1
  "for (int j = 0; j < m; ++j) {"
  "if (k == at(contacts, i).a) continue;
      for (int j = 0; j < m; ++j) {" "a's part of A is missing")

# u is believed to be how fast a contact closes.
add_mutant(${lab} u_closes 7.1
  "system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);"
  "system.u[i] -= n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);"
  "u has the wrong sign")

# Only what touches is believed to need a check.
add_mutant(${lab} bodies_unchecked 7.1
  "common::require_bodies(bodies);
  for" "for" "")

# The impulse is believed to act on b.
add_mutant(${lab} impulse_on_b_alone 7.1
  "for (int k : {at(contacts, i).a, at(contacts, i).b}) {  // eq. (2)"
  "for (int k : {at(contacts, i).b}) {"
  "the impulse on body a is missing: give it -lambda n")

# Both bodies are believed to be pushed alike.
add_mutant(${lab} same_impulse_on_both 7.1
  "const auto [n, turn] = row_part(at(contacts, i), k, body.position);"
  "const Contact as_b{-1, k, at(contacts, i).point, at(contacts, i).normal};
      const auto [n, turn] = row_part(as_b, k, body.position);" "both bodies get lambda n")

# An impulse is believed to move the centre alone.
add_mutant(${lab} impulse_without_torque 7.1
  "body.angular_velocity += body.inverse_inertia * (lambda[i] * turn);" "" "do not turn the bodies")

# Impulses are believed to push.
add_mutant(${lab} pulling_left_out 7.1
  "for (int k : {at(contacts, i).a, at(contacts, i).b}) {  // eq. (2)"
  "if (lambda[i] < 0.0) continue;
    for (int k : {at(contacts, i).a, at(contacts, i).b}) {" "may have either sign")

# An impulse is believed to work with the speed afterwards, or before.
add_mutant(${lab} work_at_the_end 7.1
  "system.u + 0.5 * common::product(system.A, lambda)" "system.u + common::product(system.A, lambda)"
  "the half is missing")

# ---- 7.2 ----

# All is believed to be done when each contact had its turn.
add_mutant(${lab} one_sweep 7.2
  "done.ended = approaching(u, tol).empty();
  }" "done.ended = approaching(u, tol).empty();
    break;
  }" "ends after one sweep")

# A sweep is believed to happen at one instant.
add_mutant(${lab} u_of_the_sweeps_start 7.2
  "for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {
      if (u[i] >= -tol) continue;
      const double d = -(1.0 + restitution) * u[i] / A(i, i);"
  "const Vector old = u;
    for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {
      if (old[i] >= -tol) continue;
      const double d = -(1.0 + restitution) * old[i] / A(i, i);" "u of its start")

# A contact is believed to act whether it opens or closes.
add_mutant(${lab} pulls_what_parts 7.2
  "if (u[i] >= -tol) continue;" "" "that do not approach get impulses")

# An impulse is believed to stop the approach, and no more.
add_mutant(${lab} impulses_without_e 7.2
  "-(1.0 + restitution) * u[i] / A(i, i)" "-u[i] / A(i, i)" "e is missing")

# Neighbours are believed to notice nothing.
add_mutant(${lab} neighbours_not_told 7.2
  "u += d * A.col(i);
      ++done.count;" "u[i] += d * A(i, i);
      ++done.count;" "changes u_i alone")

# Whoever approaches first in the list is believed to be next.
add_mutant(${lab} begins_again 7.2
  "u += d * A.col(i);
      ++done.count;" "u += d * A.col(i);
      ++done.count;
      break;" "begins again with the first")

# What is fastest is believed to come first.
add_mutant(${lab} fastest_first 7.2
  "for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {
      if (u[i] >= -tol) continue;"
  "int i = 0;
    u.minCoeff(&i);
    {" "fastest contact comes first")

# The order is believed not to matter.
add_mutant(${lab} from_the_last 7.2
  "for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {"
  "for (int i = static_cast<int>(u.size()) - 1; i >= 0 && done.count < max_impulses; --i) {"
  "from the last contact to the first")

# The cap is looked at between sweeps.
add_mutant(${lab} cap_a_sweep 7.2
  "for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {"
  "for (int i = 0; i < u.size(); ++i) {" "once a sweep")

# The cap is counted from zero.
add_mutant(${lab} one_impulse_too_many 7.2
  "done.count < max_impulses" "done.count <= max_impulses" "one impulse more")

# It is believed to end, always.
add_mutant(${lab} always_ended 7.2
  "    done.ended = approaching(u, tol).empty();
  }
  return done;"
  "    done.ended = approaching(u, tol).empty();
  }
  done.ended = true;
  return done;" "ended is always true")

# Zero is believed to need no tolerance, or one in m/s, or a wide one.
add_mutant(${lab} no_tolerance 7.2
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching"
  "const double tol = 0.0;
  Impulses done{Vector::Zero(u.size()), 0, approaching" "tolerance is missing")
add_mutant(${lab} absolute_tolerance 7.2
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching"
  "const double tol = 1e-12;
  Impulses done{Vector::Zero(u.size()), 0, approaching" "1e-12 m/s")

# ---- 7.3 ----

# The rows are believed to be equations.
add_mutant(${lab} no_clamp 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "lambda[i] - row(A, b, lambda, i) / A(i, i);" "the clamp is missing")

# Each change is believed to be an impulse, which pushes.
add_mutant(${lab} clamped_change 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "lambda[i] + std::max(0.0, -row(A, b, lambda, i) / A(i, i));" "the change is clamped")

# What is below zero is believed to be repaired in the end.
add_mutant(${lab} clamped_at_the_end 7.3
  "lambda[i] = std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)
    }
  }
  return lambda;"
  "lambda[i] -= row(A, b, lambda, i) / A(i, i);
    }
  }
  return lambda.cwiseMax(0.0);" "after all sweeps")

# A sweep is believed to happen at one instant: Jacobi's.
add_mutant(${lab} jacobi 7.3
  "for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));"
  "const Vector old = lambda;
    for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max(0.0, old[i] - row(A, b, old, i) / A(i, i));" "as Jacobi's does")

# The order is believed not to matter.
add_mutant(${lab} sweep_from_the_last 7.3
  "for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max(0.0, lambda[i] - row"
  "for (int i = static_cast<int>(b.size()) - 1; i >= 0; --i) {
      lambda[i] = std::max(0.0, lambda[i] - row" "from the last contact to the first")

# A speed is taken for an impulse.
add_mutant(${lab} sweep_without_A_ii 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "std::max(0.0, lambda[i] - row(A, b, lambda, i));" "A_ii is missing")

# Sweeps are believed to begin at zero.
add_mutant(${lab} start_ignored 7.3
  "Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {"
  "Vector lambda = Vector::Zero(b.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {" "start is not used")

# b is believed to be what the contacts shall have.
add_mutant(${lab} b_on_the_other_side 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "std::max(0.0, lambda[i] - row(A, -b, lambda, i) / A(i, i));" "b has the wrong sign")

# What changes little is believed to be done.
add_mutant(${lab} stops_early 7.3
  "for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max"
  "for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (sweep > 0 && residual(A, b, lambda) < 1e-6) break;
    for (int i = 0; i < b.size(); ++i) {
      lambda[i] = std::max" "")

# Only what is below zero is believed to be a breach.
add_mutant(${lab} breach_below_zero 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b).cwiseMin(0.0))"
  "only what is below zero")

# Complementarity is believed to be a product.
add_mutant(${lab} breach_as_product 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(lambda.cwiseProduct(common::product(A, lambda) + b))"
  "lambda_i times")

# All breaches are believed to count.
add_mutant(${lab} breaches_added_up 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "lambda.cwiseMin(common::product(A, lambda) + b).lpNorm<1>()" "are added up")

# ---- 7.4 ----

# The problem is believed to know of e.
add_mutant(${lab} at_once_without_e 7.4
  "common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "common::complementary(A, u);" "e is missing")

# All contacts are believed to bounce, or their impulses to grow by 1 + e. That is the same.
add_mutant(${lab} bounce_of_what_parts 7.4
  "u + restitution * u.cwiseMin(0.0)" "u + restitution * u" "what parts is asked for a bounce")
add_mutant(${lab} impulses_times_one_plus_e 7.4
  "common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "(1.0 + restitution) * common::complementary(A, u);" "what parts is asked for a bounce")

# The bounce is believed to be added to 1 + e.
add_mutant(${lab} e_twice 7.4
  "u + restitution * u.cwiseMin(0.0)" "u + 2.0 * restitution * u.cwiseMin(0.0)" "e counts twice")

# What parts is believed to bounce.
add_mutant(${lab} max_for_min 7.4
  "u + restitution * u.cwiseMin(0.0)" "u + restitution * u.cwiseMax(0.0)" "max stands where min")

# The contacts are believed to be equations, and impulses that pull to be of no harm.
add_mutant(${lab} solved_as_equations 7.4
  "common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "common::least_norm_solution(A, -u - restitution * u.cwiseMin(0.0));" "so contacts pull")
add_mutant(${lab} equations_then_clamped 7.4
  "common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "common::least_norm_solution(A, -u - restitution * u.cwiseMin(0.0)).cwiseMax(0.0);"
  "solved and clamped")

# The impact is believed to have two phases.
add_mutant(${lab} poisson 7.4
  "return common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "const Vector both = (1.0 + restitution) * common::complementary(A, u);
  return both + common::complementary(A, u + common::product(A, both));" "(Poisson)")

# Many sweeps are believed to be the solution.
add_mutant(${lab} hundred_sweeps 7.4
  "return common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "return gauss_seidel(A, u + restitution * u.cwiseMin(0.0), Vector::Zero(u.size()), 100);" "")

# Where there is no solution, none is believed to be needed.
add_mutant(${lab} jam_left_alone 7.4
  "return common::complementary(A, u + restitution * u.cwiseMin(0.0));  // eq. (6)"
  "try {
    return common::complementary(A, u + restitution * u.cwiseMin(0.0));
  } catch (const std::domain_error&) {
    return Vector::Zero(u.size());
  }" "")

# ---- 7.5 ----

# The problem of all contacts is believed to be that of those which approach.
add_mutant(${lab} all_contacts_reflected 7.5
  "const Vector x = common::complementary(common::block(A, V), common::entries(u, V));"
  "V.clear();
    for (int i = 0; i < u.size(); ++i) V.push_back(i);
    const Vector x = common::complementary(common::block(A, V), common::entries(u, V));"
  "all contacts are solved for")

# Contacts are believed to be reflected one after the other.
add_mutant(${lab} one_contact_reflected 7.5
  "const Vector x = common::complementary(common::block(A, V), common::entries(u, V));"
  "V.resize(1);
    const Vector x = common::complementary(common::block(A, V), common::entries(u, V));"
  "one contact is reflected at a time")

# To stop is believed to be to reflect.
add_mutant(${lab} stopped_not_reflected 7.5
  "common::spread(2.0 * x, V"
  "common::spread(x, V"
  "x is added once")

# One reflection is believed to leave nothing that approaches.
add_mutant(${lab} one_reflection 7.5
  "while (!V.empty() && done.count < max_reflections) {"
  "if (!V.empty() && done.count < max_reflections) {"
  "there is one reflection only")

# Restitution is believed to act at each meeting, as one after the other.
add_mutant(${lab} restitution_in_each 7.5
  "    const Vector twice = common::spread(2.0 * x, V, u.size());  // eq. (7)
    done.lambda += twice;
    u += common::product(A, twice);
    ++done.count;
    V = approaching(u, tol);
  }
  done.ended = V.empty();
  done.lambda = (1.0 - restitution) * inelastic + restitution * done.lambda;  // eq. (8)"
  "    const Vector twice = common::spread((1.0 + restitution) * x, V, u.size());  // eq. (7)
    done.lambda += twice;
    u += common::product(A, twice);
    ++done.count;
    V = approaching(u, tol);
  }
  done.ended = V.empty();"
  "e is in each reflection: take")

# The two shares of the blend are swapped.
add_mutant(${lab} blend_reversed 7.5
  "(1.0 - restitution) * inelastic + restitution * done.lambda"
  "restitution * inelastic + (1.0 - restitution) * done.lambda"
  "the wrong way round")

# Impulses are believed to blend as energies do.
add_mutant(${lab} blend_by_square 7.5
  "(1.0 - restitution) * inelastic + restitution * done.lambda"
  "(1.0 - restitution * restitution) * inelastic + restitution * restitution * done.lambda"
  "the square of e")

# Reflections are believed to be all that there is.
add_mutant(${lab} no_blend 7.5
  "done.lambda = (1.0 - restitution) * inelastic + restitution * done.lambda"
  "done.lambda = 1.0 * done.lambda"
  "there is no blend")

# What is left over is believed to be blended with.
add_mutant(${lab} rest_of_reflected 7.5
  "(1.0 - restitution) * inelastic + restitution * done.lambda"
  "(1.0 - restitution) * common::complementary(A, u) + restitution * done.lambda"
  "that of the reflected u")

# Contacts that do not approach are believed to notice nothing.
add_mutant(${lab} only_their_speeds 7.5
  "u += common::product(A, twice);"
  "for (int i : V) u[i] += common::row_product(A, i, twice);"
  "only the u of V")

# Reflections are believed to end by themselves.
add_mutant(${lab} reflections_without_cap 7.5
  "done.count < max_reflections"
  "done.count < 60 + 0 * max_reflections"
  "is passed over")

# A function that returns is believed to have ended its work.
add_mutant(${lab} reflections_always_ended 7.5
  "done.ended = V.empty();"
  "done.ended = true;"
  "it has ended though")

# Zero is believed to be the border, whatever rounding leaves.
add_mutant(${lab} reflections_to_zero 7.5
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "const double tol = 0.0 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "comes by rounding alone")

# ---- 7.6 ----

# To stop what approaches is believed to bring no other contact to approach.
add_mutant(${lab} zone_does_not_grow 7.6
  "done.lambda = common::spread(x, Z, u.size());  // eq. (9)
    ++done.count;"
  "done.lambda = common::spread(x, Z, u.size());  // eq. (9)
    ++done.count;
    return done;"
  "the zone does not grow")

# A contact is believed to push only, here as well.
add_mutant(${lab} zone_only_pushes 7.6
  "common::spread(x, Z,"
  "common::spread(x.cwiseMax(0.0), Z,"
  "lambda is cut off at zero")

# All contacts are believed to be held.
add_mutant(${lab} zone_of_all 7.6
  "Z.insert(Z.end(), more.begin(), more.end());"
  "Z.clear();
    for (int i = 0; i < u.size(); ++i) Z.push_back(i);"
  "all contacts are in the zone")

# What is stopped once is believed to stay so.
add_mutant(${lab} zone_of_the_new 7.6
  "const Vector x = common::least_norm_solution(common::block(A, Z), -common::entries(u, Z));
    done.lambda = common::spread(x, Z, u.size());  // eq. (9)"
  "const Vector x =
        common::least_norm_solution(common::block(A, more), -common::entries(now, more));
    done.lambda += common::spread(x, more, u.size());"
  "only the new contacts are stopped")

# The zone is believed to be what approaches now.
add_mutant(${lab} zone_is_left 7.6
  "for (int i : Z) now[i] = 0.0;
    const std::vector<int> more = approaching(now, tol);
    if (more.empty()) return done;
    Z.insert(Z.end(), more.begin(), more.end());"
  "const std::vector<int> more = approaching(now, tol);
    if (more.empty() || done.count == 50) return done;
    Z = more;
    done.lambda.setZero();"
  "a contact leaves the zone")

# A sign is lost.
add_mutant(${lab} zone_wrong_way 7.6
  "-common::entries(u, Z)"
  "common::entries(u, Z)"
  "the wrong sign")

# The fail-safe is believed to reflect.
add_mutant(${lab} zone_reflects 7.6
  "common::spread(x, Z,"
  "common::spread(2.0 * x, Z,"
  "twice those that stop")

# The contacts of the zone are counted.
add_mutant(${lab} zone_counts_contacts 7.6
  "done.lambda = common::spread(x, Z, u.size());  // eq. (9)
    ++done.count;"
  "done.lambda = common::spread(x, Z, u.size());  // eq. (9)
    done.count += static_cast<int>(more.size());"
  "is that of contacts")

# `ended` is left as it begins.
add_mutant(${lab} zone_not_ended 7.6
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, false};"
  "it always does")

# Zero is believed to be the border, whatever rounding leaves.
add_mutant(${lab} zone_to_zero 7.6
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "const double tol = 0.0 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "comes by rounding alone")

# ---- 7.7 ----

# Each tangent is believed to have a limit of its own.
add_mutant(${lab} disc_is_a_box 7.7
  "return length > limit ? limit / length * tangential : tangential;"
  "return tangential.cwiseMax(-limit).cwiseMin(limit);"
  "the disc is a box")

# The rule is passed over.
add_mutant(${lab} disc_for_all_rules 7.7
  "if (rule == FrictionRule::disc) return"
  "if (rule == FrictionRule::disc || length >= 0.0) return"
  "every rule is the disc")

# The nearest point is believed to lie towards the middle.
add_mutant(${lab} diamond_scaled 7.7
  "const double left = std::clamp(size.x() - 0.5 * (size.sum() - limit), 0.0, limit);  // eq. (10)"
  "if (size.sum() > 0.0) return limit / size.sum() * tangential;
  const double left = std::clamp(size.x() - 0.5 * (size.sum() - limit), 0.0, limit);  // eq. (10)"
  "the pair is scaled to the diamond")

# The corners of the diamond are forgotten.
add_mutant(${lab} diamond_past_zero 7.7
  "const double left = std::clamp(size.x() - 0.5 * (size.sum() - limit), 0.0, limit);  // eq. (10)
  return {std::copysign(left, tangential.x()), std::copysign(limit - left, tangential.y())};"
  "const double less = 0.5 * (size.sum() - limit);
  return {tangential.x() < 0.0 ? less - size.x() : size.x() - less,
          tangential.y() < 0.0 ? less - size.y() : size.y() - less};"
  "goes past zero")

# Friction is believed to be always at its limit.
add_mutant(${lab} disc_always_on_rim 7.7
  "return length > limit ?"
  "return length > 0.0 ?"
  "scales short pairs up")

# Each row is believed to take its own step, as without friction.
add_mutant(${lab} step_a_row 7.7
  "const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;"
  "const Vec2 next(lambda[t] - slip.x() / A(t, t), lambda[s] - slip.y() / A(s, s));"
  "a step of its own")

# The pair is believed to be solved best by the inverse of its block.
add_mutant(${lab} step_by_inverse 7.7
  "const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;"
  "const double det = A(t, t) * A(s, s) - A(t, s) * A(t, s);
      const Vec2 back(A(s, s) * slip.x() - A(t, s) * slip.y(),
                      A(t, t) * slip.y() - A(t, s) * slip.x());
      const Vec2 next = Vec2(lambda[t], lambda[s]) - back / det;"
  "inverse of A_TT is no step")

# The tangents are believed not to know of each other.
add_mutant(${lab} step_by_diagonal 7.7
  "std::hypot(half, A(t, s))"
  "std::hypot(half, 0.0)"
  "the diagonal of A_TT only")

# Rows are believed to come in any order.
add_mutant(${lab} tangents_first 7.7
  "lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)"
  "const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));"
  "the tangents come first")

# The limit is read before the normal impulse is worked out.
add_mutant(${lab} limit_of_before 7.7
  "lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)"
  "const double before = lambda[n];
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * std::max(0.0, before), rule);  // eq. (11)"
  "the old lambda_n")

# The pressure of a body is believed to be that of all its contacts.
add_mutant(${lab} limit_of_all 7.7
  "limited(next, friction * lambda[n], rule)"
  "limited(next, friction * [&] {
        double all = 0.0;
        for (int k = 0; k < b.size(); k += 3) all += lambda[k];
        return all;
      }(), rule)"
  "all contacts together")

# The limit is believed to be the pressure.
add_mutant(${lab} limit_without_mu 7.7
  "limited(next, friction * lambda[n], rule)"
  "limited(next, lambda[n], rule)"
  "mu is missing")

# The sign of friction is lost.
add_mutant(${lab} friction_along_the_slip 7.7
  "Vec2(lambda[t], lambda[s]) - q * slip"
  "Vec2(lambda[t], lambda[s]) + q * slip"
  "pushes along the slip")

# The change is clamped, so that nothing is given back.
add_mutant(${lab} friction_change_clamped 7.7
  "lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));"
  "lambda[n] += std::max(0.0, -row(A, b, lambda, n) / A(n, n));"
  "the change of lambda_n")

# All contacts are believed to see the same velocities, those of the sweep's start.
add_mutant(${lab} friction_all_at_once 7.7
  "  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n = 0; n < b.size(); n += 3) {
      const auto [t, s] = std::pair(n + 1, n + 2);
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));"
  "  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const Vector seen = lambda;
    for (int n = 0; n < b.size(); n += 3) {
      const auto [t, s] = std::pair(n + 1, n + 2);
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, seen, n) / A(n, n));
      const Vec2 slip(row(A, b, seen, t), row(A, b, seen, s));"
  "the start of the sweep")

# Rows are believed to come kind by kind.
add_mutant(${lab} rows_by_kind 7.7
  "    for (int n = 0; n < b.size(); n += 3) {
      const auto [t, s] = std::pair(n + 1, n + 2);
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)"
  "    const int m = static_cast<int>(b.size()) / 3;
    for (int n = 0; n < m; ++n) {
      const int t = m + n;
      const int s = 2 * m + n;
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      const Vec2 found = limited(next, friction * lambda[n], rule);  // eq. (11)
      lambda[t] = found.x();
      lambda[s] = found.y();"
  "all n, then all t")

# Friction is believed to be the law.
add_mutant(${lab} normals_not_judged 7.7
  "most = std::max(most, std::abs(std::min(lambda[n], row(A, b, lambda, n))));  // eq. (12)"
  ""
  "the normal rows are not judged")

# The law's bound is taken for a box.
add_mutant(${lab} judged_by_box 7.7
  "limit, FrictionRule::disc)).norm()"
  "limit, FrictionRule::box)).norm()"
  "each tangent is judged by itself")

# Friction is believed to be right if it is within its bounds.
add_mutant(${lab} bounds_alone_judged 7.7
  "limited(now - slip, limit"
  "limited(now, limit"
  "only the bound is judged")

# A pull is believed to be harmless.
add_mutant(${lab} pull_forgiven 7.7
  "std::abs(std::min(lambda[n], row(A, b, lambda, n)))"
  "std::abs(std::min(std::max(0.0, lambda[n]), row(A, b, lambda, n)))"
  "a pull is no breach")

# ---- 7.8 ----

# Momentum is believed to help always.
add_mutant(${lab} never_restarts 7.8
  "if (g.dot(next - lambda) > 0.0) c = 1.0;"
  ""
  "no step restarts")

# c is set back in every step.
add_mutant(${lab} always_restarts 7.8
  "if (g.dot(next - lambda) > 0.0) c = 1.0;"
  "c = 1.0;"
  "there is no momentum")

# The sign of the slope is mixed up.
add_mutant(${lab} restarts_downhill 7.8
  "if (g.dot(next - lambda) > 0.0) c = 1.0;"
  "if (g.dot(next - lambda) < 0.0) c = 1.0;"
  "there is no momentum")

# The point ahead is taken for the impulses.
add_mutant(${lab} returns_the_point_ahead 7.8
  "    c = c_next;
  }
  return lambda;"
  "    c = c_next;
  }
  return y;"
  "y is returned")

# The point ahead is believed to have to push as well.
add_mutant(${lab} clamps_the_point_ahead 7.8
  "y = next + (c - 1.0) / c_next * (next - lambda);"
  "y = (next + (c - 1.0) / c_next * (next - lambda)).cwiseMax(0.0);"
  "y is clamped")

# The slope is believed to be that of the impulses.
add_mutant(${lab} slope_at_lambda 7.8
  "common::product(A, y) + b"
  "common::product(A, lambda) + b"
  "the slope is taken at lambda")

# The gradient is believed to be all.
add_mutant(${lab} no_momentum 7.8
  "y = next + (c - 1.0) / c_next * (next - lambda);"
  "y = next;"
  "there is no momentum")

# The 4 is left out.
add_mutant(${lab} root_without_4 7.8
  "std::sqrt(1.0 + 4.0 * c * c)"
  "std::sqrt(1.0 + c * c)"
  "it is of 1 + 4 c^2")

# Any number above the largest eigenvalue is believed to do as well.
add_mutant(${lab} step_of_the_trace 7.8
  "const double L = common::largest_eigenvalue(A);"
  "const double L = A.trace();"
  "L is the trace of A")

# The impulses are believed to find their sign by themselves.
add_mutant(${lab} acceleration_not_clamped 7.8
  "(y - g / L).cwiseMax(0.0)"
  "(y - g / L)"
  "lambda is not clamped")

# Steps are counted from zero.
add_mutant(${lab} one_step_more 7.8
  "step < steps"
  "step <= steps"
  "one step more")

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

# A body is believed to be pushed the same way by all of its contacts.
add_mutant(${lab} coupling_unsigned 7.1
  "system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "const double sign = (k == at(contacts, i).a) == (k == at(contacts, j).a) ? 1.0 : -1.0;
        system.A(i, j) += sign * body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += sign * turn_i.dot(body.inverse_inertia * turn_j);"
  "a of one contact and b of the other")

# Bodies are believed to yield like point masses.
add_mutant(${lab} lever_arms_not_in_A 7.1
  "system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);" "" "left out of A")

# Bodies are believed to meet as fast as their centres do.
add_mutant(${lab} spins_not_in_u 7.1
  "+ turn_i.dot(body.angular_velocity)" "" "spins are left out of u")

# Both at once: bodies are believed to be particles.
add_mutant(${lab} particles 7.1
  "turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, body.position);
        system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "0.0;
      for (int j = 0; j < m; ++j) {
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, body.position);
        system.A(i, j) += body.inverse_mass * n_i.dot(n_j);" "left out, in A and in u")

# Points are measured from the world's origin.
add_mutant(${lab} levers_from_the_origin 7.1
  "const auto [n_i, turn_i] = row_part(at(contacts, i), k, body.position);
      system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, body.position);"
  "const auto [n_i, turn_i] = row_part(at(contacts, i), k, Vec3::Zero());
      system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);
      for (int j = 0; j < m; ++j) {
        const auto [n_j, turn_j] = row_part(at(contacts, j), k, Vec3::Zero());" "world's origin")

# All masses are believed to be alike.
add_mutant(${lab} W_forgotten 7.1
  "system.A(i, j) += body.inverse_mass * n_i.dot(n_j);
        system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "system.A(i, j) += n_i.dot(n_j) + turn_i.dot(turn_j);" "W is missing")
add_mutant(${lab} inverse_masses_forgotten 7.1
  "+= body.inverse_mass * n_i.dot(n_j);" "+= n_i.dot(n_j);" "inverse masses are missing from A")
add_mutant(${lab} inverse_inertias_forgotten 7.1
  "turn_i.dot(body.inverse_inertia * turn_j)" "turn_i.dot(turn_j)"
  "inverse inertias are missing from A")

# The first body is believed to stand fast.
add_mutant(${lab} A_of_b_alone 7.1
  "for (int j = 0; j < m; ++j) {"
  "if (k == at(contacts, i).a) continue;
      for (int j = 0; j < m; ++j) {" "a's part of A is missing")
add_mutant(${lab} u_of_b_alone 7.1
  "system.u[i] += n_i.dot(body.velocity)"
  "if (k == at(contacts, i).b)
        system.u[i] += n_i.dot(body.velocity)" "a's velocity is missing")

# u is believed to be how fast a contact closes.
add_mutant(${lab} u_closes 7.1
  "system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);"
  "system.u[i] -= n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);"
  "u has the wrong sign")

# Speeds are believed to add up at a contact.
add_mutant(${lab} u_adds_up 7.1
  "system.u[i] += n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity);"
  "system.u[i] += (k == at(contacts, i).a ? -1.0 : 1.0) *
                     (n_i.dot(body.velocity) + turn_i.dot(body.angular_velocity));"
  "two velocities are added")

# What cannot be moved is believed not to turn either.
add_mutant(${lab} hinge_not_in_A 7.1
  "system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);"
  "if (body.inverse_mass != 0.0) system.A(i, j) += turn_i.dot(body.inverse_inertia * turn_j);" "")

# What cannot be moved is believed not to move.
add_mutant(${lab} walls_at_rest 7.1
  "system.u[i] += n_i" "if (body.inverse_mass != 0.0) system.u[i] += n_i" "")

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

# A change of velocity is taken for an impulse.
add_mutant(${lab} impulse_without_mass 7.1
  "body.velocity += body.inverse_mass * lambda[i] * n;" "body.velocity += lambda[i] * n;"
  "the masses are missing")

# An impulse is believed to move the centre alone.
add_mutant(${lab} impulse_without_torque 7.1
  "body.angular_velocity += body.inverse_inertia * (lambda[i] * turn);" "" "do not turn the bodies")
add_mutant(${lab} torque_without_inertia 7.1
  "body.inverse_inertia * (lambda[i] * turn)" "lambda[i] * turn" "the inertias are missing")

# Each impulse is believed to act on the bodies as they were.
add_mutant(${lab} last_impulse_alone 7.1
  "RigidBody& body = at(next, k);" "RigidBody& body = at(next, k) = at(bodies, k);"
  "of its last contact only")

# Impulses are believed to push.
add_mutant(${lab} pulling_left_out 7.1
  "for (int k : {at(contacts, i).a, at(contacts, i).b}) {  // eq. (2)"
  "if (lambda[i] < 0.0) continue;
    for (int k : {at(contacts, i).a, at(contacts, i).b}) {" "may have either sign")

# An impulse is believed to work with the speed afterwards, or before.
add_mutant(${lab} work_at_the_end 7.1
  "system.u + 0.5 * common::product(system.A, lambda)" "system.u + common::product(system.A, lambda)"
  "the half is missing")
add_mutant(${lab} work_at_the_start 7.1
  "system.u + 0.5 * common::product(system.A, lambda)" "system.u"
  "u is that before the impulses")
add_mutant(${lab} work_halved 7.1
  "system.u + 0.5 * common::product(system.A, lambda)"
  "0.5 * (system.u + common::product(system.A, lambda))" "all of it is halved")

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

# Restitution is believed to be all that an impulse does.
add_mutant(${lab} e_for_one_plus_e 7.2
  "-(1.0 + restitution) * u[i] / A(i, i)" "-restitution * u[i] / A(i, i)" "e stands where")

# A change of speed is taken for an impulse.
add_mutant(${lab} impulse_without_A_ii 7.2
  "-(1.0 + restitution) * u[i] / A(i, i)" "-(1.0 + restitution) * u[i]" "A_ii is missing")

# A contact is believed to have one impulse.
add_mutant(${lab} last_impulse_of_a_contact 7.2
  "done.lambda[i] += d;" "done.lambda[i] = d;" "the last impulse only")

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

# The cap is taken for a number of sweeps.
add_mutant(${lab} cap_of_sweeps 7.2
  "while (!done.ended && done.count < max_impulses) {
    for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {"
  "for (int sweep = 0; !done.ended && sweep < max_impulses; ++sweep) {
    for (int i = 0; i < u.size(); ++i) {" "a number of sweeps")

# The cap is counted from zero.
add_mutant(${lab} one_impulse_too_many 7.2
  "done.count < max_impulses" "done.count <= max_impulses" "one impulse more")

# Whoever uses up the cap is believed to be cut short.
add_mutant(${lab} ended_below_the_cap 7.2
  "    done.ended = approaching(u, tol).empty();
  }
  return done;"
  "    done.ended = approaching(u, tol).empty();
  }
  done.ended = done.count < max_impulses;
  return done;" "the cap was not reached")

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
add_mutant(${lab} wide_tolerance 7.2
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching"
  "const double tol = 1e-9 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching" "wider than")

# The tolerance is believed to follow the speeds.
add_mutant(${lab} newest_tolerance 7.2
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching(u, tol).empty()};
  while (!done.ended && done.count < max_impulses) {
    for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {"
  "double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, approaching(u, tol).empty()};
  while (!done.ended && done.count < max_impulses) {
    for (int i = 0; i < u.size() && done.count < max_impulses; ++i) {
      tol = 1e-12 * common::largest_entry(u);" "of the newest u")

# Any e is believed to do.
add_mutant(${lab} restitution_unchecked 7.2
  "require_fraction(restitution, \"restitution\");
  require_not_negative(max_impulses" "require_not_negative(max_impulses" "")

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

# Impulses are believed to push from the start.
add_mutant(${lab} start_clamped 7.3
  "Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {"
  "Vector lambda = start.cwiseMax(0.0);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < b.size(); ++i) {" "start is clamped")

# What is added is taken for what there is.
add_mutant(${lab} change_for_lambda 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "std::max(0.0, -row(A, b, lambda, i) / A(i, i));" "replaced by its change")

# Two forms of Gauss-Seidel are mixed.
add_mutant(${lab} own_part_counts_twice 7.3
  "std::max(0.0, lambda[i] - row(A, b, lambda, i) / A(i, i));  // eq. (5)"
  "std::max(0.0, 2.0 * lambda[i] - row(A, b, lambda, i) / A(i, i));" "do one of the two")

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

# What is below zero is believed to be no breach.
add_mutant(${lab} breach_without_size 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "b.size() == 0 ? 0.0 : std::max(0.0, lambda.cwiseMin(common::product(A, lambda) + b).maxCoeff())"
  "below zero is no breach")

# Only what is below zero is believed to be a breach.
add_mutant(${lab} breach_below_zero 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b).cwiseMin(0.0))"
  "only what is below zero")

# The sizes are compared.
add_mutant(${lab} smaller_size 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(
      lambda.cwiseAbs().cwiseMin((common::product(A, lambda) + b).cwiseAbs()))"
  "min takes the two sizes")

# Complementarity is believed to be a product.
add_mutant(${lab} breach_as_product 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(lambda.cwiseProduct(common::product(A, lambda) + b))"
  "lambda_i times")

# All breaches are believed to count.
add_mutant(${lab} breaches_added_up 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "lambda.cwiseMin(common::product(A, lambda) + b).lpNorm<1>()" "are added up")

# Only the speeds are believed to matter.
add_mutant(${lab} breach_of_speeds_alone 7.3
  "common::largest_entry(lambda.cwiseMin(common::product(A, lambda) + b))"
  "common::largest_entry(common::product(A, lambda) + b)" "lambda_i is not asked")

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

# Restitution is believed to be all that impulses do.
add_mutant(${lab} at_once_e_alone 7.4
  "u + restitution * u.cwiseMin(0.0)" "u.cwiseMax(0.0) + restitution * u.cwiseMin(0.0)"
  "e stands where 1 + e belongs")

# b is believed to be the speed that is wanted.
add_mutant(${lab} bounce_with_other_sign 7.4
  "u + restitution * u.cwiseMin(0.0)" "u - restitution * u.cwiseMin(0.0)"
  "the bounce has the wrong sign")

# What parts is believed to bounce.
add_mutant(${lab} max_for_min 7.4
  "u + restitution * u.cwiseMin(0.0)" "u + restitution * u.cwiseMax(0.0)" "max stands where min")

# What parts is believed to take no part.
add_mutant(${lab} parting_forgotten 7.4
  "u + restitution * u.cwiseMin(0.0)" "(1.0 + restitution) * u.cwiseMin(0.0)"
  "contacts that part are forgotten")

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

# What rests is believed to have to take part.
add_mutant(${lab} what_rests_reflected 7.5
  "V = approaching(u, tol);"
  "V = approaching(u, tol);
  if (!V.empty()) V = approaching(u, -tol);"
  "contacts that rest are reflected")

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

# The same, and the blend is made as well.
add_mutant(${lab} restitution_twice 7.5
  "spread(2.0 * x"
  "spread((1.0 + restitution) * x"
  "in the blend again")

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

# Restitution is believed to scale the impulse.
add_mutant(${lab} blend_with_nothing 7.5
  "(1.0 - restitution) * inelastic + restitution * done.lambda"
  "restitution * done.lambda"
  "lambda_0 is missing")

# What is left over is believed to be blended with.
add_mutant(${lab} rest_of_reflected 7.5
  "(1.0 - restitution) * inelastic + restitution * done.lambda"
  "(1.0 - restitution) * common::complementary(A, u) + restitution * done.lambda"
  "that of the reflected u")

# The last reflection is believed to be the impulse.
add_mutant(${lab} reflection_overwrites 7.5
  "done.lambda += twice;"
  "for (int i : V) done.lambda[i] = twice[i];"
  "overwrites lambda")

# Contacts that do not approach are believed to notice nothing.
add_mutant(${lab} only_their_speeds 7.5
  "u += common::product(A, twice);"
  "for (int i : V) u[i] += common::row_product(A, i, twice);"
  "only the u of V")

# The cap is counted from zero.
add_mutant(${lab} one_reflection_more 7.5
  "done.count < max_reflections"
  "done.count <= max_reflections"
  "one reflection more")

# Reflections are believed to end by themselves.
add_mutant(${lab} reflections_without_cap 7.5
  "done.count < max_reflections"
  "done.count < 60 + 0 * max_reflections"
  "is passed over")

# The count is believed to tell whether it was cut short.
add_mutant(${lab} reflections_ended_by_count 7.5
  "done.ended = V.empty();"
  "done.ended = done.count < max_reflections;"
  "was just enough")

# A function that returns is believed to have ended its work.
add_mutant(${lab} reflections_always_ended 7.5
  "done.ended = V.empty();"
  "done.ended = true;"
  "it has ended though")

# e = 0 is believed to be a blend like any other.
add_mutant(${lab} reflections_without_e 7.5
  "if (restitution == 0.0) return {inelastic, 0, true};"
  ""
  "for e = 0 reflections are counted")

# Zero is believed to be the border, whatever rounding leaves.
add_mutant(${lab} reflections_to_zero 7.5
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "const double tol = 0.0 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "comes by rounding alone")

# What comes slowly is believed to rest.
add_mutant(${lab} reflections_of_the_fast 7.5
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "const double tol = 1e-9 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "a slow approach is taken for none")

# A speed is compared with a number without a unit.
add_mutant(${lab} reflections_by_metres 7.5
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size())};"
  "const double tol = 1e-12;
  Impulses done{Vector::Zero(u.size())};"
  "the border is 1e-12 at any speed")

# What counts as an approach is asked for anew each time.
add_mutant(${lab} border_follows_u 7.5
  "V = approaching(u, tol);"
  "V = approaching(u, 1e-12 * common::largest_entry(u));"
  "the border follows u")

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

# What is held is believed to be the problem of step 7.4.
add_mutant(${lab} zone_may_part 7.6
  "const Vector x = common::least_norm_solution(common::block(A, Z), -common::entries(u, Z));"
  "const Vector x = common::complementary(common::block(A, Z), common::entries(u, Z));"
  "what is held may part")

# All contacts are believed to be held.
add_mutant(${lab} zone_of_all 7.6
  "Z.insert(Z.end(), more.begin(), more.end());"
  "Z.clear();
    for (int i = 0; i < u.size(); ++i) Z.push_back(i);"
  "all contacts are in the zone")

# What rests is believed to have to be held, too.
add_mutant(${lab} zone_of_what_rests 7.6
  "for (int i : Z) now[i] = 0.0;
    const std::vector<int> more = approaching(now, tol);"
  "for (int i : Z) now[i] = 1.0;
    std::vector<int> more = approaching(now, tol);
    if (!more.empty()) more = approaching(now, -tol);"
  "contacts that rest are in the zone")

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

# The impulses of the round before are believed to be counted already.
add_mutant(${lab} zone_of_speeds_now 7.6
  "-common::entries(u, Z)"
  "-common::entries(now, Z)"
  "solved for u + A lambda")

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

# The last look is counted as a round.
add_mutant(${lab} zone_counts_the_look 7.6
  "if (more.empty()) return done;"
  "if (more.empty()) {
      ++done.count;
      return done;
    }"
  "the last look")

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

# What comes slowly is believed to rest.
add_mutant(${lab} zone_of_the_fast 7.6
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "const double tol = 1e-9 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "a slow approach is taken for none")

# A speed is compared with a number without a unit.
add_mutant(${lab} zone_by_metres 7.6
  "const double tol = 1e-12 * common::largest_entry(u);
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "const double tol = 1e-12;
  Impulses done{Vector::Zero(u.size()), 0, true};"
  "the border is 1e-12 at any speed")

# What counts as an approach is asked for anew each time.
add_mutant(${lab} zone_border_follows_u 7.6
  "const std::vector<int> more = approaching(now, tol);"
  "const std::vector<int> more = approaching(now, 1e-12 * common::largest_entry(now));"
  "the border follows u")

# ---- 7.7 ----

# Each tangent is believed to have a limit of its own.
add_mutant(${lab} disc_is_a_box 7.7
  "return length > limit ? limit / length * tangential : tangential;"
  "return tangential.cwiseMax(-limit).cwiseMin(limit);"
  "the disc is a box")

# Bounds are believed to be round.
add_mutant(${lab} box_is_a_disc 7.7
  "if (rule == FrictionRule::disc) return"
  "if (rule != FrictionRule::diamond) return"
  "the box is a disc")

# The rule is passed over.
add_mutant(${lab} disc_for_all_rules 7.7
  "if (rule == FrictionRule::disc) return"
  "if (rule == FrictionRule::disc || length >= 0.0) return"
  "every rule is the disc")

# The rule is passed over.
add_mutant(${lab} box_for_all_rules 7.7
  "if (rule == FrictionRule::disc) return"
  "if (length >= 0.0) return tangential.cwiseMax(-limit).cwiseMin(limit);
  if (rule == FrictionRule::disc) return"
  "every rule is the box")

# |t| + |s| is taken for each of the two.
add_mutant(${lab} diamond_is_a_box 7.7
  "if (rule == FrictionRule::box)"
  "if (rule != FrictionRule::disc)"
  "the diamond is a box")

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

# Each component is believed to have to make up for all that is too much.
add_mutant(${lab} diamond_by_whole 7.7
  "const double left = std::clamp(size.x() - 0.5 * (size.sum() - limit), 0.0, limit);  // eq. (10)
  return {std::copysign(left, tangential.x()), std::copysign(limit - left, tangential.y())};"
  "const double less = size.sum() - limit;
  const Vec2 left = (size - Vec2(less, less)).cwiseMax(0.0);
  return {std::copysign(left.x(), tangential.x()), std::copysign(left.y(), tangential.y())};"
  "each loses half of it")

# Sizes are returned for the components.
add_mutant(${lab} diamond_without_signs 7.7
  "return {std::copysign(left, tangential.x()), std::copysign(limit - left, tangential.y())};"
  "return {left, limit - left};"
  "the diamond loses the signs")

# Friction is believed to be always at its limit.
add_mutant(${lab} disc_always_on_rim 7.7
  "return length > limit ?"
  "return length > 0.0 ?"
  "scales short pairs up")

# The length is taken for the larger component.
add_mutant(${lab} disc_by_the_larger 7.7
  "limit / length * tangential"
  "limit / tangential.cwiseAbs().maxCoeff() * tangential"
  "divides by the larger component")

# The root is believed to be saved by squares, of one side only.
add_mutant(${lab} disc_by_squares 7.7
  "return length > limit ?"
  "return length * length > limit ?"
  "the squared length")

# A component is believed to have one end.
add_mutant(${lab} box_upper_end_only 7.7
  "return tangential.cwiseMax(-corner).cwiseMin(corner);"
  "return tangential.cwiseMin(corner);"
  "no lower end")

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

# The trace is taken for the eigenvalue.
add_mutant(${lab} step_by_trace 7.7
  "const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));"
  "const double q = 1.0 / (A(t, t) + A(s, s));"
  "the trace of A_TT")

# The tangents are believed not to know of each other.
add_mutant(${lab} step_by_diagonal 7.7
  "std::hypot(half, A(t, s))"
  "std::hypot(half, 0.0)"
  "the diagonal of A_TT only")

# The other root is taken.
add_mutant(${lab} step_by_smaller 7.7
  "+ std::hypot(half, A(t, s))"
  "- std::hypot(half, A(t, s))"
  "the smaller eigenvalue")

# The first tangent is believed to stand for both.
add_mutant(${lab} step_of_t 7.7
  "const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));"
  "const double q = 1.0 / A(t, t);"
  "q is 1/A_tt")

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

# Normal and tangents are believed not to know of each other.
add_mutant(${lab} slip_before_normal 7.7
  "lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));"
  "const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));"
  "before the normal impulse")

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

# Each sweep is believed to find friction from nothing.
add_mutant(${lab} friction_without_memory 7.7
  "Vec2(lambda[t], lambda[s]) - q * slip"
  "-q * slip"
  "so far are forgotten")

# The sign of friction is lost.
add_mutant(${lab} friction_along_the_slip 7.7
  "Vec2(lambda[t], lambda[s]) - q * slip"
  "Vec2(lambda[t], lambda[s]) + q * slip"
  "pushes along the slip")

# The rule is not handed on.
add_mutant(${lab} friction_always_box 7.7
  "lambda[n], rule);"
  "lambda[n], FrictionRule::box);"
  "taken for the box")

# The rule is not handed on.
add_mutant(${lab} friction_always_disc 7.7
  "lambda[n], rule);"
  "lambda[n], FrictionRule::disc);"
  "taken for the disc")

# Friction is believed to be mu times the pressure, whether it slips or not.
add_mutant(${lab} friction_on_the_rim 7.7
  "limited(next, friction"
  "limited(rule == FrictionRule::disc ? Vec2(1e9 * next) : next, friction"
  "sticks with less")

# A contact is believed to be able to pull.
add_mutant(${lab} friction_that_pulls 7.7
  "lambda[n] = std::max(0.0, lambda[n] - row(A, b, lambda, n) / A(n, n));
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, friction * lambda[n], rule);  // eq. (11)"
  "lambda[n] = lambda[n] - row(A, b, lambda, n) / A(n, n);
      const Vec2 slip(row(A, b, lambda, t), row(A, b, lambda, s));
      const double half = 0.5 * (A(t, t) - A(s, s));
      const double q = 1.0 / (0.5 * (A(t, t) + A(s, s)) + std::hypot(half, A(t, s)));
      const Vec2 next = Vec2(lambda[t], lambda[s]) - q * slip;
      lambda.segment<2>(t) = limited(next, std::max(0.0, friction * lambda[n]), rule);  // eq. (11)"
  "lambda_n is not clamped")

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

# Sweeps are believed to begin from zero.
add_mutant(${lab} friction_from_zero 7.7
  "Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n"
  "Vector lambda = Vector::Zero(start.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n"
  "it begins from zero")

# Sweeps are counted from zero.
add_mutant(${lab} friction_one_more 7.7
  "Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n"
  "Vector lambda = start;
  for (int sweep = 0; sweep <= sweeps; ++sweep) {
    for (int n"
  "one sweep more")

# One sweep is believed to do.
add_mutant(${lab} friction_one_sweep 7.7
  "Vector lambda = start;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int n"
  "Vector lambda = start;
  for (int sweep = 0; sweep < std::min(sweeps, 1); ++sweep) {
    for (int n"
  "there is one sweep only")

# The normals are believed to be the law.
add_mutant(${lab} friction_not_judged 7.7
  "most = std::max(most, (now - limited(now - slip, limit, FrictionRule::disc)).norm());"
  ""
  "friction is not judged")

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

# Contacts are believed not to slip.
add_mutant(${lab} slip_is_a_breach 7.7
  "(now - limited(now - slip, limit, FrictionRule::disc)).norm()"
  "slip.norm()"
  "all slip is a breach")

# The sign of the step is lost.
add_mutant(${lab} judged_along_the_slip 7.7
  "limited(now - slip, limit"
  "limited(now + slip, limit"
  "the step is along the slip")

# Friction is believed to be right if it is within its bounds.
add_mutant(${lab} bounds_alone_judged 7.7
  "limited(now - slip, limit"
  "limited(now, limit"
  "only the bound is judged")

# The limit is believed to be the pressure.
add_mutant(${lab} judged_without_mu 7.7
  "const double limit = friction * std::max(0.0, lambda[n]);"
  "const double limit = std::max(0.0, lambda[n]);"
  "mu is missing")

# A pull is believed to press.
add_mutant(${lab} judged_by_size 7.7
  "const double limit = friction * std::max(0.0, lambda[n]);"
  "const double limit = friction * std::abs(lambda[n]);"
  "a contact that pulls has friction")

# Breaches are believed to add up.
add_mutant(${lab} breaches_added 7.7
  "most = std::max(most, std::abs(std::min(lambda[n], row(A, b, lambda, n))));  // eq. (12)
    most = std::max(most, (now - limited(now - slip, limit, FrictionRule::disc)).norm());"
  "most += std::abs(std::min(lambda[n], row(A, b, lambda, n)));  // eq. (12)
    most += (now - limited(now - slip, limit, FrictionRule::disc)).norm();"
  "the breaches are added")

# The last contact is believed to be all.
add_mutant(${lab} last_breach 7.7
  "most = std::max(most, std::abs(std::min(lambda[n], row(A, b, lambda, n))));  // eq. (12)"
  "most = std::max(0.0, std::abs(std::min(lambda[n], row(A, b, lambda, n))));  // eq. (12)"
  "the last contact")

# The larger component is taken for the length.
add_mutant(${lab} breach_by_component 7.7
  "FrictionRule::disc)).norm()"
  "FrictionRule::disc)).cwiseAbs().maxCoeff()"
  "the larger component of the friction")

# A pull is believed to be harmless.
add_mutant(${lab} pull_forgiven 7.7
  "std::abs(std::min(lambda[n], row(A, b, lambda, n)))"
  "std::abs(std::min(std::max(0.0, lambda[n]), row(A, b, lambda, n)))"
  "a pull is no breach")

# Pressure at a contact that opens is believed to be harmless.
add_mutant(${lab} only_approach_judged 7.7
  "std::abs(std::min(lambda[n], row(A, b, lambda, n)))"
  "std::max(0.0, -row(A, b, lambda, n))"
  "only an approach is a breach")

# ---- 7.8 ----

# Momentum is believed to help always.
add_mutant(${lab} never_restarts 7.8
  "if (g.dot(next - lambda) > 0.0) s = 1.0;"
  ""
  "there is no restart")

# s is set back in every step.
add_mutant(${lab} always_restarts 7.8
  "if (g.dot(next - lambda) > 0.0) s = 1.0;"
  "s = 1.0;"
  "there is no momentum")

# The sign of the slope is mixed up.
add_mutant(${lab} restarts_downhill 7.8
  "if (g.dot(next - lambda) > 0.0) s = 1.0;"
  "if (g.dot(next - lambda) < 0.0) s = 1.0;"
  "there is no momentum")

# The momentum of the step that went uphill is kept.
add_mutant(${lab} restarts_late 7.8
  "    if (g.dot(next - lambda) > 0.0) s = 1.0;
    const double s_next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * s * s));
    y = next + (s - 1.0) / s_next * (next - lambda);
    lambda = next;
    s = s_next;
"
  "    const double s_next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * s * s));
    y = next + (s - 1.0) / s_next * (next - lambda);
    s = g.dot(next - lambda) > 0.0 ? 1.0 : s_next;
    lambda = next;
"
  "a step late")

# A step uphill is believed to be wasted.
add_mutant(${lab} step_taken_back 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);
    lambda = next;
    s = s_next;"
  "if (s == 1.0 && step > 0) {
      y = lambda;
      s = s_next;
      continue;
    }
    y = next + (s - 1.0) / s_next * (next - lambda);
    lambda = next;
    s = s_next;"
  "takes the step back")

# The point ahead is taken for the impulses.
add_mutant(${lab} returns_the_point_ahead 7.8
  "    s = s_next;
  }
  return lambda;"
  "    s = s_next;
  }
  return y;"
  "y is returned")

# The point ahead is believed to have to push as well.
add_mutant(${lab} clamps_the_point_ahead 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);"
  "y = (next + (s - 1.0) / s_next * (next - lambda)).cwiseMax(0.0);"
  "y is clamped")

# The slope is believed to be that of the impulses.
add_mutant(${lab} slope_at_lambda 7.8
  "common::product(A, y) + b"
  "common::product(A, lambda) + b"
  "the slope is taken at lambda")

# The gradient is believed to be all.
add_mutant(${lab} no_momentum 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);"
  "y = next;"
  "there is no momentum")

# All of the last step is believed to be its momentum.
add_mutant(${lab} full_momentum 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);"
  "y = next + (next - lambda);"
  "by the whole of the last step")

# s and s' are mixed up.
add_mutant(${lab} momentum_by_old_s 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);"
  "y = next + (s - 1.0) / s * (next - lambda);"
  "divide by the next s")

# The 1 is left out.
add_mutant(${lab} momentum_by_s 7.8
  "y = next + (s - 1.0) / s_next * (next - lambda);"
  "y = next + s / s_next * (next - lambda);"
  "the momentum is s/s'")

# The 4 is left out.
add_mutant(${lab} root_without_4 7.8
  "std::sqrt(1.0 + 4.0 * s * s)"
  "std::sqrt(1.0 + s * s)"
  "it is of 1 + 4 s^2")

# Any number above the largest eigenvalue is believed to do as well.
add_mutant(${lab} step_of_the_trace 7.8
  "const double L = common::largest_eigenvalue(A);"
  "const double L = A.trace();"
  "L is the trace of A")

# The diagonal is taken for the eigenvalues.
add_mutant(${lab} step_of_the_diagonal 7.8
  "const double L = common::largest_eigenvalue(A);"
  "const double L = A.rows() == 0 ? 0.0 : A.diagonal().maxCoeff();"
  "the largest of A's diagonal")

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

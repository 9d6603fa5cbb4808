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

# ---- 7.6 ----

# ---- 7.7 ----

# ---- 7.8 ----

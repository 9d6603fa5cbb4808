# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab impulse_response)

# ---- 6.1 ----

# A contact is believed to push whether the particle comes or goes.
add_mutant(${lab} parting_not_skipped 6.1
  "if (v_n >= 0.0) return 0.0;" "" "that moves away gets an impulse")

# Restitution is believed to be all that an impulse does; the approach is not stopped first.
add_mutant(${lab} e_for_one_plus_e 6.1
  "-(1.0 + e) * mass * v_n" "-e * mass * v_n" "e is used instead of 1 + e")

# The loss 1 - e is mixed up with the impulse.
add_mutant(${lab} one_minus_e 6.1
  "-(1.0 + e) * mass * v_n" "-(1.0 - e) * mass * v_n" "1 - e is used instead")

# The normal is believed to point into the obstacle.
add_mutant(${lab} normal_reversed 6.1
  "const double v_n = n.dot(velocity);" "const double v_n = -n.dot(velocity);" "other way round")

# A change of velocity is taken for an impulse.
add_mutant(${lab} normal_without_mass 6.1
  "-(1.0 + e) * mass * v_n" "-(1.0 + e) * v_n" "missing the mass")

# Speed is taken for its part along the normal.
add_mutant(${lab} whole_speed 6.1
  "-(1.0 + e) * mass * v_n" "(1.0 + e) * mass * velocity.norm()" "whole speed")

# What moves slowly is believed to rest.
add_mutant(${lab} least_speed 6.1
  "if (v_n >= 0.0) return 0.0;" "if (v_n >= -1e-9) return 0.0;" "small speed is taken for zero")

# Zero is believed to need a tolerance, here on the other side.
add_mutant(${lab} parting_by_tolerance 6.1
  "if (v_n >= 0.0) return 0.0;" "if (v_n >= 1e-9) return 0.0;" "moves away slowly gets")

# ---- 6.2 ----

# Friction is believed to stop whatever slips.
add_mutant(${lab} always_sticks 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "return against_slip(mass * velocity, normal, 1e300, 1.0 + 0.0 * friction);" "stops all slip")

# The minus sign is lost.
add_mutant(${lab} friction_along_slip 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "return -against_slip(mass * velocity, normal, normal_impulse, friction);" "along the slip")

# Friction is believed to be mu times the pressure, whatever slips.
add_mutant(${lab} always_on_the_cone 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "const Vec3 slip = velocity - normal.dot(velocity) * normal;
  if (slip.norm() == 0.0) return Vec3::Zero();
  return -friction * normal_impulse * slip.normalized();" "is always mu j_n")

# A velocity is compared with an impulse.
add_mutant(${lab} friction_without_mass 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "return against_slip(velocity, normal, normal_impulse, friction);" "mass is missing in m")

# The cone is believed to be as wide as it is high.
add_mutant(${lab} friction_without_mu 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "return against_slip(mass * velocity, normal, normal_impulse, 1.0 + 0.0 * friction);"
  "mu is missing")

# All of the velocity is braked, also what the normal impulse has dealt with.
add_mutant(${lab} whole_velocity_braked 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "const double speed = velocity.norm();
  if (speed == 0.0) return Vec3::Zero();
  return -std::min(friction * normal_impulse, mass * speed) / speed * velocity;"
  "brake only its tangential part")

# The direction of the slip is not made unit.
add_mutant(${lab} slip_not_unit 6.2
  "return against_slip(mass * velocity, normal, normal_impulse, friction);"
  "const Vec3 slip = velocity - normal.dot(velocity) * normal;
  return -std::min(friction * normal_impulse, mass * slip.norm()) * slip;" "not made a unit")

# A slip is believed to be zero where it is small.
add_mutant(${lab} least_slip 6.2
  "if (length == 0.0) return Vec3::Zero();" "if (length < 1e-10) return Vec3::Zero();"
  "a small slip is taken for zero")

# The direction of no slip is asked for.
add_mutant(${lab} slip_over_zero 6.2
  "if (length == 0.0) return Vec3::Zero();" "" "0/0: v_t has no direction")

# A small number is believed to keep off 0/0 at no cost.
add_mutant(${lab} slip_over_padded_length 6.2
  "/ length * slip" "/ (length + 1e-12) * slip" "something is added to |v_t|")

# Only what pushes is believed to have a length, not what slips.
add_mutant(${lab} slip_over_whole_speed 6.2
  "const double length = slip.norm();" "const double length = motion.norm();"
  "|v| is used instead of |v_t|")

# ---- 6.3 ----

# The gap is negative inside, so moving out by phi moves in.
add_mutant(${lab} pushed_inwards 6.3 "return -gap * normal;" "return gap * normal;" "pushed inwards")

# The correction is believed to hold on both sides of the surface.
add_mutant(${lab} pulled_to_the_surface 6.3
  "if (gap >= 0.0) return Vec3::Zero();" "" "pulled to the surface")

# Artificial sliding is undone together with the real one.
add_mutant(${lab} tangential_without_clamp 6.3
  "return against_slip(displacement, normal, normal_length, friction);"
  "return against_slip(displacement, normal, 1e300, 1.0 + 0.0 * normal_length * friction);"
  "no more than mu d_n")

# The minus sign is lost.
add_mutant(${lab} tangential_along_slip 6.3
  "return against_slip(displacement, normal, normal_length, friction);"
  "return -against_slip(displacement, normal, normal_length, friction);" "slides on")

# The whole displacement is undone, the approach as well.
add_mutant(${lab} whole_displacement 6.3
  "return against_slip(displacement, normal, normal_length, friction);"
  "const double length = displacement.norm();
  if (length == 0.0) return Vec3::Zero();
  return -std::min(friction * normal_length, length) / length * displacement;"
  "whole displacement")

# A way is believed to be zero where it is short.
add_mutant(${lab} least_way 6.3
  "if (length == 0.0) return Vec3::Zero();" "if (length < 1e-10) return Vec3::Zero();"
  "a small slip is taken for zero")

# The direction of no slip is asked for.
add_mutant(${lab} way_over_zero 6.3
  "if (length == 0.0) return Vec3::Zero();" "" "0/0: d_t has no direction")

# What is hardly inside is believed to be on the surface.
add_mutant(${lab} least_depth 6.3
  "if (gap >= 0.0) return Vec3::Zero();" "if (gap >= -1e-9) return Vec3::Zero();"
  "small depth is taken for zero")

# The depth is believed to allow any slip.
add_mutant(${lab} disc_without_mu 6.3
  "return against_slip(displacement, normal, normal_length, friction);"
  "return against_slip(displacement, normal, normal_length, 1.0 + 0.0 * friction);" "mu is missing")

# ---- 6.4 ----

# Position and velocity are believed to step side by side, as in explicit Euler.
add_mutant(${lab} position_with_old_velocity 6.4
  "particle.velocity += dt * gravity;
  const Vec3 d = dt * particle.velocity;"
  "const Vec3 d = dt * particle.velocity;
  particle.velocity += dt * gravity;" "before gravity acted")

# The normal is looked up once, before the step.
add_mutant(${lab} normal_of_the_start 6.4
  "const Vec3 n = common::outward_normal(obstacle, particle.position);
  const Vec3 impulse = particle_impulse(particle,"
  "const Vec3 n = common::outward_normal(obstacle, particle.position - d);
  const Vec3 impulse = particle_impulse(particle," "step's start")

# All of the repair is put behind the question whether it approaches.
add_mutant(${lab} repairs_only_impacts 6.4
  "particle.velocity += 1.0 / particle.mass * impulse;"
  "if (impulse.norm() == 0.0) return {particle, impulse};
  particle.velocity += 1.0 / particle.mass * impulse;" "only if there is an impulse")

# The gap is negative inside, so moving out by phi moves in.
add_mutant(${lab} step_pushed_inwards 6.4
  "particle.position += -phi * n;" "particle.position += phi * n;" "moved inwards")

# An impulse is taken for a change of velocity.
add_mutant(${lab} impulse_for_velocity 6.4
  "particle.velocity += 1.0 / particle.mass * impulse;" "particle.velocity += impulse;" "without 1/m")

# Artificial sliding is undone together with the real one.
add_mutant(${lab} step_without_clamp 6.4
  "against_slip(d, n, -phi, material.friction)" "against_slip(d, n, 1e300, 1.0)"
  "clamp mu d_n is missing")

# The velocity at hand is taken, which the impulse has changed already.
add_mutant(${lab} tangential_of_new_velocity 6.4
  "against_slip(d, n," "against_slip(dt * particle.velocity, n," "velocity after the impulse")

# The gap is asked for once more, after the particle is out.
add_mutant(${lab} depth_after_the_repair 6.4
  "against_slip(d, n, -phi,"
  "against_slip(d, n, std::max(0.0, -common::gap(obstacle, particle.position)),"
  "before the particle is moved out")

# Both corrections are made, whatever is asked for.
add_mutant(${lab} switches_ignored 6.4
  "if (corrections.normal) particle.position += -phi * n;
  if (corrections.tangential) particle.position"
  "particle.position += -phi * n;
  particle.position" "not asked for")

# The time is found, and the impulse given where the step ends.
add_mutant(${lab} impact_time_missed 6.4
  "const double flown = hit.value_or(dt - time);" "const double flown = dt - time;"
  "at the end of the step")

# Each flight is believed to last for the whole step.
add_mutant(${lab} time_does_not_go_on 6.4
  "time = std::min(time + flown, dt);" "time = 0.0 * flown;" "time does not go on")

# The velocity is not carried to the impact.
add_mutant(${lab} impact_with_old_velocity 6.4
  "const Vec3 impulse = particle_impulse(step.particle, n, material);"
  "const Vec3 impulse = particle_impulse({mass, x, flight.velocity}, n, material);"
  "flight's start")

# Bounces are believed to end by themselves.
add_mutant(${lab} no_cap 6.4
  "step.impacts.size() < static_cast<std::size_t>(max_impacts)" "step.impacts.size() < 60u"
  "may never end")

# The cap is counted from zero.
add_mutant(${lab} one_impact_too_many 6.4
  "step.impacts.size() < static_cast<std::size_t>(max_impacts)"
  "step.impacts.size() <= static_cast<std::size_t>(max_impacts)" "one impact more")

# The last step is made with dt, as if the step had just begun.
add_mutant(${lab} rest_of_dt 6.4
  "projected(step.particle, obstacle, material, gravity, step.projected, {}).particle;"
  "projected(step.particle, obstacle, material, gravity, dt, {}).particle;" "takes dt")

# After the last impact the particle is left where it is.
add_mutant(${lab} rest_forgotten 6.4
  "projected(step.particle, obstacle, material, gravity, step.projected, {}).particle;"
  "projected(step.particle, obstacle, material, gravity, 0.0, {}).particle;" "is forgotten")

# The tangential correction is given a velocity.
add_mutant(${lab} correction_of_speed 6.4
  "against_slip(d, n," "against_slip(particle.velocity - 1.0 / particle.mass * impulse, n,"
  "use the step's motion d = dt v")

# A motion is taken for a velocity.
add_mutant(${lab} time_counts_twice 6.4
  "against_slip(d, n," "against_slip(dt * d, n," "dt counts twice")

# Repairing the position is believed to repair the velocity.
add_mutant(${lab} velocity_repaired 6.4
  "if (corrections.normal) particle.position += -phi * n;"
  "if (corrections.normal) particle.position += -phi * n;
  const Vec3 back = against_slip(d, n, -phi, material.friction);
  if (dt > 0.0 && corrections.normal) particle.velocity += -phi / dt * n;
  if (dt > 0.0 && corrections.tangential) particle.velocity += back / dt;"
  "changed by the correction over dt")

# A little restitution is believed to be none.
add_mutant(${lab} least_restitution 6.4
  "material.restitution > 0.0 &&" "material.restitution > 1e-3 &&"
  "a small restitution is taken for zero")

# A particle that leaves slowly is believed to rest.
add_mutant(${lab} least_speed_to_leave 6.4
  ".dot(v) <= 0.0) break" ".dot(v) <= 1e-6) break" "leaves slowly is taken for one that rests")

# Between impacts a particle is believed to go straight on.
add_mutant(${lab} flight_without_gravity 6.4
  "const common::Flight flight{x, v, gravity};" "const common::Flight flight{x, v, Vec3::Zero()};"
  "gravity does not act in flight")

# A step is believed to have one impact.
add_mutant(${lab} one_impact_only 6.4
  "step.impacts.size() < static_cast<std::size_t>(max_impacts)" "max_impacts < 1"
  "one impact only")

# The step is believed to be over where nothing else is hit.
add_mutant(${lab} last_flight_forgotten 6.4
  "const double flown = hit.value_or(dt - time);" "const double flown = hit.value_or(0.0);"
  "the last impact is left out")

# Each flight is believed to start at time zero.
add_mutant(${lab} times_of_flights 6.4
  "step.impacts.push_back({time, impulse});" "step.impacts.push_back({flown, impulse});"
  "counted from the last impact")

# What is left is believed to be a flight like the others.
add_mutant(${lab} rest_flown 6.4
  "projected(step.particle, obstacle, material, gravity, step.projected, {}).particle;"
  "{mass, position_at(common::Flight{x, v, gravity}, step.projected),
                   velocity_at(common::Flight{x, v, gravity}, step.projected)};"
  "the last impact is flown")

# What is hardly inside is believed to be on the surface.
add_mutant(${lab} least_depth_of_step 6.4
  "if (phi >= 0.0)" "if (phi >= -1e-9)" "hardly inside is left alone")

# What is close is believed to touch.
add_mutant(${lab} touching_by_tolerance 6.4
  "common::gap(obstacle, x) <= 0.0 &&" "common::gap(obstacle, x) <= 1e-9 &&"
  "close to the surface is taken for touching")

# Each flight is believed to have the whole step before it.
add_mutant(${lab} looks_beyond_the_step 6.4
  "time_of_impact(obstacle, flight, dt - time)" "time_of_impact(obstacle, flight, dt)"
  "looked for in dt")

# ---- 6.5 ----

# The body is believed to yield like a point mass.
add_mutant(${lab} angular_part_missing 6.5
  "body.inverse_mass * Mat3::Identity() - r_cross * body.inverse_inertia * r_cross"
  "body.inverse_mass * Mat3::Identity() - 0.0 * r_cross" "angular part of the effective mass is missing")

# The square of a skew matrix is believed to be positive.
add_mutant(${lab} angular_part_negative 6.5
  "Mat3::Identity() - r_cross" "Mat3::Identity() + r_cross" "has the wrong sign")

# The first body is believed to stand fast.
add_mutant(${lab} part_of_a_missing 6.5
  "inverse_mass_at(a, point) + inverse_mass_at(b, point)" "inverse_mass_at(b, point)"
  "a's part of the effective mass")

# Points are measured from the world's origin.
add_mutant(${lab} lever_from_the_origin 6.5
  "skew(point - body.position)" "skew(point)" "starts at the world's origin")

# Bodies are believed to meet as fast as their centres do.
add_mutant(${lab} velocity_of_centers 6.5
  "const Vec3 u = velocity_at(b, contact.point) - velocity_at(a, contact.point);"
  "const Vec3 u = b.velocity - a.velocity + 0.0 * velocity_at(b, contact.point);" "velocity of the centres")

# A contact is believed to push whether the bodies come or go.
add_mutant(${lab} contact_that_parts 6.5
  "if (u_n >= 0.0) return Vec3::Zero();" "" "that moves apart gets an impulse")

# Restitution is believed to be all that an impulse does.
add_mutant(${lab} contact_with_e_alone 6.5
  "const double e = material.restitution;" "const double e = material.restitution - 1.0;"
  "e is used instead of 1 + e")

# The normal is believed to point from b to a.
add_mutant(${lab} contact_normal_reversed 6.5
  "const Vec3& n = contact.normal;" "const Vec3 n = -contact.normal;" "it points from a to b")

# The cone is forgotten.
add_mutant(${lab} contact_always_sticks 6.5
  "if (stick_t.norm() <= mu * stick_n) return stick;" "return stick;" "always sticks")

# Friction is believed to be mu times the pressure, whatever slips.
add_mutant(${lab} contact_always_slips 6.5
  "if (stick_t.norm() <= mu * stick_n) return stick;" "" "always slips")

# The direction of the slip is taken for that of friction.
add_mutant(${lab} contact_along_slip 6.5
  "const Vec3 edge = n + mu" "const Vec3 edge = n - mu" "it pushes on")

# The impulse of sticking is cut back to the cone: its normal part is then another's.
add_mutant(${lab} cut_back_to_the_cone 6.5
  "return -(1.0 + e) * u_n / n.dot(K * edge) * edge;" "return stick_n * edge;" "is that of sticking")

# Friction is that of the particles of step 6.2.
add_mutant(${lab} friction_of_particles 6.5
  "Vec3 stick = common::inverse(K)"
  "const double j_n = -(1.0 + e) * u_n / n.dot(K * n);
  const Vec3 slip = u - u_n * n;
  const double most = slip.norm() / (a.inverse_mass + b.inverse_mass);
  if (e >= 0.0) return j_n * n - std::min(mu * j_n, most) * slip.normalized();
  Vec3 stick = common::inverse(K)" "friction stops the slip of two particles")

# Normal and tangential impulse are believed not to know of each other.
add_mutant(${lab} one_after_the_other 6.5
  "Vec3 stick = common::inverse(K)"
  "const double j_n = -(1.0 + e) * u_n / n.dot(K * n);
  const Vec3 t = (u - u_n * n).normalized();
  const double most = (u - u_n * n).norm() / t.dot(K * t);
  if (e >= 0.0) return j_n * n - std::min(mu * j_n, most) * t;
  Vec3 stick = common::inverse(K)" "one after the other")

# The factors of the torque's cross product are swapped.
add_mutant(${lab} torque_sign 6.5
  "(point - body.position).cross(impulse)" "impulse.cross(point - body.position)"
  "torque has the wrong sign")

# An impulse is believed to move the centre alone.
add_mutant(${lab} no_torque 6.5
  "next.angular_velocity += body.inverse_inertia * (point - body.position).cross(impulse);" ""
  "does not make the body turn")

# The body that receives the opposite is mixed up with the one that receives the impulse.
add_mutant(${lab} impulse_subtracted 6.5
  "next.velocity += body.inverse_mass * impulse;" "next.velocity -= body.inverse_mass * impulse;"
  "is subtracted")

# K is believed to be one number.
add_mutant(${lab} one_number_for_K 6.5
  "const double e = material.restitution;
  const double mu = material.friction;
  Vec3 stick = common::inverse(K) * (-e * u_n * n - u);"
  "const double e = material.restitution;
  const double mu = material.friction;
  const double k = n.dot(K * n);
  Vec3 stick = (-e * u_n * n - u) / k;
  if (e >= 0.0) {
    const double most = mu * n.dot(stick);
    const Vec3 t = stick - n.dot(stick) * n;
    return t.norm() <= most ? stick : Vec3(-(1.0 + e) * u_n / k * (n + mu * t.normalized()));
  }" "which is a matrix")

# The two bodies are believed to pull at K in opposite directions, as they do at u.
add_mutant(${lab} K_of_b_less_a 6.5
  "inverse_mass_at(a, point) + inverse_mass_at(b, point)"
  "inverse_mass_at(b, point) - inverse_mass_at(a, point)" "subtracted from K of b")

# Only b is believed to turn.
add_mutant(${lab} spin_of_a_missing 6.5
  "velocity_at(b, contact.point) - velocity_at(a, contact.point)"
  "velocity_at(b, contact.point) - a.velocity" "spin of a is left out")

# Only a is believed to turn.
add_mutant(${lab} spin_of_b_missing 6.5
  "velocity_at(b, contact.point) - velocity_at(a, contact.point)"
  "b.velocity - velocity_at(a, contact.point)" "spin of b is left out")

# Sticking is believed to end the normal speed as well.
add_mutant(${lab} stick_without_e 6.5
  "(-e * u_n * n - u)" "(-u)" "e is missing if it sticks")

# Friction is believed to be against the slip, as for a particle.
add_mutant(${lab} against_the_slip 6.5
  "const Vec3 edge = n + mu * stick_t.normalized();"
  "const Vec3 edge = n - mu * (u - u_n * n).normalized();" "the impulse that sticks")

# The cone is asked for by squares, which have no sign.
add_mutant(${lab} cone_by_squares 6.5
  "if (stick_t.norm() <= mu * stick_n) return stick;"
  "if (stick_t.squaredNorm() <= mu * mu * stick_n * stick_n) return stick;" "cannot pull")

# The direction of no slip is asked for.
add_mutant(${lab} contact_over_zero 6.5
  "if (stick_t.norm() <= mu * stick_n) return stick;

  const Vec3 edge = n + mu * stick_t.normalized();"
  "if (stick_t.norm() < mu * stick_n) return stick;

  const Vec3 edge = n + mu * (stick_t / stick_t.norm());" "0/0: j_t has no direction")

# Bodies that meet slowly are believed to rest.
add_mutant(${lab} least_approach 6.5
  "if (u_n >= 0.0) return Vec3::Zero();" "if (u_n >= -1e-9) return Vec3::Zero();"
  "small speed is taken for zero")

# The inertia is believed to resist the impulse, not its torque.
add_mutant(${lab} inertia_before_lever 6.5
  "next.angular_velocity += body.inverse_inertia * (point - body.position).cross(impulse);"
  "next.angular_velocity += (point - body.position).cross(body.inverse_inertia * impulse);"
  "r x (inverse inertia j)")

# The cone is believed to need a tolerance.
add_mutant(${lab} cone_by_tolerance 6.5
  "if (stick_t.norm() <= mu * stick_n)" "if (stick_t.norm() <= mu * stick_n + 1e-9)"
  "a small impulse always sticks")

# Zero is believed to need a tolerance.
add_mutant(${lab} parts_by_tolerance 6.5
  "if (u_n >= 0.0) return Vec3::Zero();" "if (u_n >= 1e-12) return Vec3::Zero();"
  "move apart slowly get")

# A body that cannot be moved is believed not to turn either: hinges are forgotten.
add_mutant(${lab} hinge_without_K 6.5
  "const Mat3 r_cross = skew(point - body.position);"
  "if (body.inverse_mass == 0.0) return Mat3::Zero();
  const Mat3 r_cross = skew(point - body.position);" "")
add_mutant(${lab} hinge_without_spin 6.5
  "RigidBody next = body;" "RigidBody next = body;
  if (body.inverse_mass == 0.0) return next;" "")

# Points that rest are believed to need an impulse, too.
add_mutant(${lab} impulse_at_rest 6.5
  "if (u_n >= 0.0) return Vec3::Zero();" "if (u_n > 0.0) return Vec3::Zero();" "")

# Bodies are believed to be immovable only if nothing at all moves the contact.
add_mutant(${lab} immovable_by_K 6.5
  "if (a.inverse_mass == 0.0 && b.inverse_mass == 0.0) {" "if (K.isZero(0.0)) {" "")

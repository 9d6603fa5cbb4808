# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab gyroscopic_tumbling)

# ---- 2.1 ----

# The term is moved to the other side of the equation with its sign.
add_mutant(${lab} acceleration_flipped 2.1
  "torque - omega.cross(inertia * omega)" "torque + omega.cross(inertia * omega)" "is flipped")

# A torque turns a body as a force moves one: I dω/dt = T.
add_mutant(${lab} acceleration_without_term 2.1
  "torque - omega.cross(inertia * omega)" "torque" "term is missing")

# The inverse is applied to the torque alone.
add_mutant(${lab} acceleration_half_inverted 2.1
  "common::inverse(inertia) * (torque - omega.cross(inertia * omega))"
  "common::inverse(inertia) * torque - omega.cross(inertia * omega)" "not multiplied by the inverse")

# A determinant that is small is believed to be that of a singular matrix.
add_mutant(${lab} acceleration_small_determinant 2.1
  "  const Vec3& omega = angular_velocity;
  return common::inverse(inertia)"
  "  const Vec3& omega = angular_velocity;
  if (inertia.determinant() < 1e-12) return Vec3::Zero();
  return common::inverse(inertia)" "small is taken for zero")

# The energy of a particle is remembered without its half.
add_mutant(${lab} energy_without_half 2.1
  "return 0.5 * spin.angular_velocity_body" "return spin.angular_velocity_body" "1/2 is missing")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} energy_half_in_whole_numbers 2.1
  "return 0.5 * spin.angular_velocity_body" "return 1 / 2 * spin.angular_velocity_body"
  "1/2 is 0 in whole numbers")

# The momentum is left in the frame in which it was made.
add_mutant(${lab} momentum_in_body_axes 2.1
  "return spin.world_from_body * momentum_body(moments, spin);"
  "return momentum_body(moments, spin);" "still in body axes")

# The quaternion is believed to lead from the world to the body.
add_mutant(${lab} momentum_turned_backwards 2.1
  "return spin.world_from_body * momentum_body(moments, spin);"
  "return spin.world_from_body.conjugate() * momentum_body(moments, spin);" "turned backwards")

# The body's inertia is used on a world vector.
add_mutant(${lab} momentum_of_world_omega 2.1
  "return spin.world_from_body * momentum_body(moments, spin);"
  "return moments.cwiseProduct(spin.world_from_body * spin.angular_velocity_body);"
  "applied to omega in the world")

# Positive moments are believed to be enough.
add_mutant(${lab} moments_without_triangle 2.1
  "greatest > (moments.sum() - greatest) + 4.0 * eps * greatest" "false" "triangle inequality is not")

# A flat body is believed to be impossible.
add_mutant(${lab} moments_of_flat_bodies_refused 2.1
  "greatest > (moments.sum() - greatest) + 4.0 * eps * greatest"
  "greatest >= moments.sum() - greatest" "flat body is refused")

# The tolerance is a length of the number axis near one, whatever the moments are.
add_mutant(${lab} moments_with_absolute_tolerance 2.1
  "+ 4.0 * eps * greatest" "+ 1e-15 * std::max(greatest, 1.0)" "tolerance of the triangle")

# The tolerance is chosen by feeling.
add_mutant(${lab} moments_with_wide_tolerance 2.1
  "+ 4.0 * eps * greatest" "+ 1e-12 * greatest" "tolerance of the triangle")

# A torque is believed to turn a heavy body faster, as the formula reads without its exponent.
add_mutant(${lab} acceleration_by_inertia 2.1
  "return common::inverse(inertia) * (torque" "return inertia * (torque" "multiplies the torques")

# The torque is moved to the other side of the equation with its sign.
add_mutant(${lab} acceleration_with_flipped_torque 2.1
  "(torque - omega.cross" "(-torque - omega.cross" "torque has the wrong sign")

# Each of the two factors is right, but in its own frame.
add_mutant(${lab} energy_of_two_frames 2.1
  "0.5 * spin.angular_velocity_body.dot(momentum_body(moments, spin))"
  "0.5 * spin.angular_velocity_body.dot(angular_momentum(moments, spin))" "one is in the world frame")

# The inertia is turned into the world, and omega is left in body axes.
add_mutant(${lab} momentum_of_world_inertia 2.1
  "return spin.world_from_body * momentum_body(moments, spin);"
  "return spin.world_from_body * moments.cwiseProduct(spin.world_from_body.conjugate() * spin.angular_velocity_body);"
  "R I0 R^T suits omega in the world")

# The moments are believed to be in order, with the greatest last.
add_mutant(${lab} moments_with_one_triangle 2.1
  "greatest > (moments.sum() - greatest) + 4.0 * eps * greatest"
  "moments.z() > moments.x() + moments.y() + 4.0 * eps * greatest" "for some moments only")

# ---- 2.2 ----

# The term is moved to the other side of the equation with its sign.
add_mutant(${lab} loop_flipped 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "dt * angular_acceleration(inertia, state.angular_velocity, torque + 2.0 * state.angular_velocity.cross(inertia * state.angular_velocity))"
  "is flipped")

# As games do that call the term unstable and leave it out.
add_mutant(${lab} loop_without_term 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "dt * common::inverse(inertia) * torque" "term is missing")

# The body's inertia is used in the world.
add_mutant(${lab} loop_with_body_inertia 2.2
  "R * body.moments.asDiagonal() * R.transpose()" "body.moments.asDiagonal().toDenseMatrix() + 0.0 * R"
  "used as the world's")

# The rule for the change of frame is remembered with the transpose on the wrong side.
add_mutant(${lab} loop_with_inertia_turned_backwards 2.2
  "R * body.moments.asDiagonal() * R.transpose()" "R.transpose() * body.moments.asDiagonal() * R"
  "R^T I0 R")

# omega is taken for a body vector: it is put behind q.
add_mutant(${lab} loop_with_omega_on_the_right 2.2
  "pure(next.angular_velocity) * q;" "q * pure(next.angular_velocity);" "right of q")

# The rate of a quaternion is believed to be omega q.
add_mutant(${lab} loop_without_half 2.2
  "Quat(q.coeffs() + 0.5 * dt * rate.coeffs())" "Quat(q.coeffs() + dt * rate.coeffs())"
  "1/2 is missing")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} loop_half_in_whole_numbers 2.2
  "Quat(q.coeffs() + 0.5 * dt * rate.coeffs())" "Quat(q.coeffs() + 1 / 2 * dt * rate.coeffs())"
  "1/2 is 0 in whole numbers")

# One step hardly changes the length, so it is left as it is.
add_mutant(${lab} loop_not_normalised 2.2
  "next.world_from_body.normalize();
  return next;
}

Vec3 implicit_residual"
  "return next;
}

Vec3 implicit_residual" "not normalised")

# Positions are moved before the velocities are known.
add_mutant(${lab} loop_with_old_velocity 2.2
  "next.position += dt * next.velocity;" "next.position += dt * state.velocity;" "old velocit")

# The torque is summed about the world's origin.
add_mutant(${lab} loop_with_torque_about_origin 2.2
  "(applied.point - state.position).cross" "applied.point.cross" "about the world's origin")

# A force is taken for an acceleration.
add_mutant(${lab} loop_without_mass 2.2
  "next.velocity += dt / body.mass * force;" "next.velocity += dt * force;" "not divided by the mass")

# The cross product is believed to commute.
add_mutant(${lab} loop_with_arm_swapped 2.2
  "torque += (applied.point - state.position).cross(applied.force);"
  "torque += applied.force.cross(applied.point - state.position);" "torque has the wrong sign")

# The torque is assigned where it is to be added.
add_mutant(${lab} loop_with_last_torque 2.2
  "torque += (applied.point" "torque = (applied.point" "of the last force counts")

# The step is believed to belong to the torque alone.
add_mutant(${lab} loop_with_term_without_dt 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "common::inverse(inertia) * (dt * torque - state.angular_velocity.cross(inertia * state.angular_velocity))"
  "dt multiplies the torque alone")

# Euler's equations are solved in body axes, with the torque that was summed in the world.
add_mutant(${lab} loop_with_world_torque_in_body_axes 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "dt * (R * angular_acceleration(body.moments.asDiagonal(), R.transpose() * state.angular_velocity, torque))"
  "the torque is in the world frame")

# The same, but what comes out is added to omega in the world.
add_mutant(${lab} loop_with_change_in_body_axes 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "dt * angular_acceleration(body.moments.asDiagonal(), R.transpose() * state.angular_velocity, R.transpose() * torque)"
  "change of omega is in body axes")

# The rule for the change of frame is remembered with the transpose on the wrong side.
add_mutant(${lab} loop_with_inverse_turned_backwards 2.2
  "dt * angular_acceleration(inertia, state.angular_velocity, torque)"
  "dt * (R.transpose() * body.moments.cwiseInverse().asDiagonal() * R) * (torque - state.angular_velocity.cross(inertia * state.angular_velocity))"
  "R^T I0^-1 R")

# A parabola is believed to be more exact.
add_mutant(${lab} loop_by_mean_velocity 2.2
  "next.position += dt * next.velocity;"
  "next.position += 0.5 * dt * (state.velocity + next.velocity);" "mean of both velocities")

# ---- 2.3 ----

# The term is moved to the other side of the equation with its sign.
add_mutant(${lab} residual_flipped 2.3
  "return change + dt * next.cross" "return change - dt * next.cross" "is flipped")

# The new velocity is put into the difference only.
add_mutant(${lab} residual_at_old_velocity 2.3
  "dt * next.cross(moments.cwiseProduct(next))"
  "dt * angular_velocity_body.cross(moments.cwiseProduct(angular_velocity_body))"
  "at the old velocity")

# Newton's method with the derivative of the first term only.
add_mutant(${lab} jacobian_of_inertia_alone 2.3
  "dt * (moments(i) * omega.cross(e) - m.cross(e))" "0.0 * m" "I0 alone")

# The product rule with one of its two terms.
add_mutant(${lab} jacobian_with_one_term 2.3
  "moments(i) * omega.cross(e) - m.cross(e)" "moments(i) * omega.cross(e) - 0.0 * m"
  "[I0 omega]x is missing")

# The cross product is believed to commute.
add_mutant(${lab} jacobian_with_wrong_sign 2.3
  "moments(i) * omega.cross(e) - m.cross(e)" "moments(i) * omega.cross(e) + m.cross(e)"
  "wrong sign in Newton's")

# omega is taken for a world vector.
add_mutant(${lab} implicit_turned_in_the_world 2.3
  "spin.world_from_body * common::exponential_map(dt * next)"
  "common::exponential_map(dt * next) * spin.world_from_body" "left of q")

# The attitude is moved before the velocity is known.
add_mutant(${lab} implicit_turned_by_old_velocity 2.3
  "common::exponential_map(dt * next)" "common::exponential_map(dt * omega)" "old angular velocity")

# The new velocity is put into one of the two places.
add_mutant(${lab} residual_of_two_velocities 2.3
  "dt * next.cross(moments.cwiseProduct(next))"
  "dt * next.cross(moments.cwiseProduct(angular_velocity_body))" "mixes the old and the new")

# Matrices are believed to commute.
add_mutant(${lab} jacobian_with_factors_swapped 2.3
  "moments(i) * omega.cross(e) - m.cross(e)" "moments.cwiseProduct(omega.cross(e)) - m.cross(e)"
  "are swapped in Newton's")

# The step is forgotten in the derivative.
add_mutant(${lab} jacobian_without_dt 2.3
  "moments(i) * e + dt * (moments(i)" "moments(i) * e + 1.0 * (moments(i)" "dt is missing in Newton's")

# Newton's method is believed to add its change.
add_mutant(${lab} newton_step_added 2.3
  "omega - common::inverse(J)" "omega + common::inverse(J)" "omega changes with the wrong sign")

# The half of the quaternion's rate is put into the exponential map, too.
add_mutant(${lab} implicit_turned_by_half 2.3
  "common::exponential_map(dt * next)" "common::exponential_map(0.5 * dt * next)"
  "turns by half of omega dt")

# ---- 2.4 ----

# The term is moved to the other side of the equation with its sign.
add_mutant(${lab} rate_flipped 2.4
  "-gyroscopic.cwiseQuotient(moments)" "gyroscopic.cwiseQuotient(moments)" "is flipped")

# The spin is believed to be constant.
add_mutant(${lab} rate_without_term 2.4
  "-gyroscopic.cwiseQuotient(moments)" "0.0 * gyroscopic" "term is missing")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} rate_half_in_whole_numbers 2.4
  "Quat(0.5 * turning.coeffs())" "Quat(1 / 2 * turning.coeffs())" "1/2 is 0 in whole numbers")

# omega is taken for a world vector.
add_mutant(${lab} rate_with_omega_on_the_left 2.4
  "spin.world_from_body * pure(omega)" "pure(omega) * spin.world_from_body" "left of q")

# The four rates are averaged.
add_mutant(${lab} rk4_with_equal_weights 2.4
  "Spin next = moved(moved(spin, k1, dt / 6.0), k2, dt / 3.0);
  next = moved(moved(next, k3, dt / 3.0), k4, dt / 6.0);"
  "Spin next = moved(moved(spin, k1, dt / 4.0), k2, dt / 4.0);
  next = moved(moved(next, k3, dt / 4.0), k4, dt / 4.0);" "equal weights")

# The last rate is taken where the two before it were.
add_mutant(${lab} rk4_with_short_last_rate 2.4
  "spin_rate(moments, moved(spin, k3, dt))" "spin_rate(moments, moved(spin, k3, 0.5 * dt))"
  "taken at the middle")

# The attitude is turned once, by the mean of the angular velocities: the trap.
add_mutant(${lab} rk4_by_one_exponential 2.4
  "  next.world_from_body.normalize();
  return next;
}

Spin step_about_axis"
  "  const Vec3 mean = (spin.angular_velocity_body + 2.0 * moved(spin, k1, 0.5 * dt).angular_velocity_body +
                     2.0 * moved(spin, k2, 0.5 * dt).angular_velocity_body + moved(spin, k3, dt).angular_velocity_body) / 6.0;
  next.world_from_body = spin.world_from_body * common::exponential_map(dt * mean);
  return next;
}

Spin step_about_axis" "turns once by the mean")

# Every quaternion is believed to need normalising.
add_mutant(${lab} rk4_with_unit_stages 2.4
  "const SpinRate k2 = spin_rate(moments, moved(spin, k1, 0.5 * dt));
  const SpinRate k3 = spin_rate(moments, moved(spin, k2, 0.5 * dt));
  const SpinRate k4 = spin_rate(moments, moved(spin, k3, dt));"
  "const auto unit = [](Spin now) {
    now.world_from_body.normalize();
    return now;
  };
  const SpinRate k2 = spin_rate(moments, unit(moved(spin, k1, 0.5 * dt)));
  const SpinRate k3 = spin_rate(moments, unit(moved(spin, k2, 0.5 * dt)));
  const SpinRate k4 = spin_rate(moments, unit(moved(spin, k3, dt)));" "between the rates")

# The length is believed to be kept by a method of order four.
add_mutant(${lab} rk4_not_normalised 2.4
  "  next.world_from_body.normalize();
  return next;
}

Spin step_about_axis" "  return next;
}

Spin step_about_axis" "not normalised")

# The gyroscopic torque is taken for an acceleration.
add_mutant(${lab} rate_without_inverse 2.4
  "-gyroscopic.cwiseQuotient(moments)" "-gyroscopic" "inverse of the inertia is missing")

# A difference of moments is written in the order of the numbers, not of the cycle.
add_mutant(${lab} rate_with_component_slipped 2.4
  "-gyroscopic.cwiseQuotient(moments)"
  "-gyroscopic.cwiseQuotient(Vec3(moments.x(), -moments.y(), moments.z()))" "component 2 of")

# The two middle rates are believed to be taken at the same state.
add_mutant(${lab} rk4_with_third_rate_by_first 2.4
  "spin_rate(moments, moved(spin, k2, 0.5 * dt))" "spin_rate(moments, moved(spin, k1, 0.5 * dt))"
  "third rate is taken where the second")

# All rates after the first are believed to be those of the end.
add_mutant(${lab} rk4_with_late_middle 2.4
  "const SpinRate k2 = spin_rate(moments, moved(spin, k1, 0.5 * dt));
  const SpinRate k3 = spin_rate(moments, moved(spin, k2, 0.5 * dt));"
  "const SpinRate k2 = spin_rate(moments, moved(spin, k1, dt));
  const SpinRate k3 = spin_rate(moments, moved(spin, k2, dt));" "middle rates are taken at the end")

# The weights are remembered inside out.
add_mutant(${lab} rk4_with_weights_inside_out 2.4
  "Spin next = moved(moved(spin, k1, dt / 6.0), k2, dt / 3.0);
  next = moved(moved(next, k3, dt / 3.0), k4, dt / 6.0);"
  "Spin next = moved(moved(spin, k1, dt / 3.0), k2, dt / 6.0);
  next = moved(moved(next, k3, dt / 6.0), k4, dt / 3.0);" "weights are 2, 1, 1, 2")

# ---- 2.5 ----

# The momentum is believed to be carried along by the body.
add_mutant(${lab} momentum_turned_with_the_body 2.5
  "const double sine = 2.0 * t * scale;" "const double sine = -2.0 * t * scale;" "m turns with the body")

# A quaternion is believed to hold the whole angle.
add_mutant(${lab} sub_rotation_without_half 2.5
  "const double t = 0.5 * dt * now.m(i)" "const double t = dt * now.m(i)" "1/2 is missing in tan")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} sub_rotation_half_in_whole_numbers 2.5
  "const double t = 0.5 * dt * now.m(i)" "const double t = 1 / 2 * dt * now.m(i)"
  "1/2 is 0 in whole numbers")

# The turn is about a body axis, but put before the attitude.
add_mutant(${lab} sub_rotation_in_the_world 2.5
  "next.q.vec()(j) = v(j) + t * v(k);
  next.q.vec()(k) = v(k) - t * v(j);"
  "next.q.vec()(j) = v(j) - t * v(k);
  next.q.vec()(k) = v(k) + t * v(j);" "left of q")

# The angular velocity is believed to rest in the world.
add_mutant(${lab} omega_turned_for_momentum 2.5
  "cosine * now.m(j) + sine * now.m(k);  // eq. (16)
  next.m(k) = cosine * now.m(k) - sine * now.m(j);"
  "cosine * now.m(j) + sine * now.m(k) * moments(j) / moments(k);
  next.m(k) = cosine * now.m(k) - sine * now.m(j) * moments(k) / moments(j);"
  "omega is turned instead")

# The axes are taken from the last to the first and back.
add_mutant(${lab} splitting_from_the_last_axis 2.5
  "now = sub_rotation<0>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<0>(moments, now, 0.5 * dt);"
  "now = sub_rotation<2>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<0>(moments, now, dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, 0.5 * dt);" "3-2-1-2-3")

# One turn about each axis is believed to be enough.
add_mutant(${lab} splitting_one_way 2.5
  "now = sub_rotation<0>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<0>(moments, now, 0.5 * dt);"
  "now = sub_rotation<0>(moments, now, dt);
  now = sub_rotation<1>(moments, now, dt);
  now = sub_rotation<2>(moments, now, dt);" "first order only")

# The momentum is taken for the angular velocity at the start.
add_mutant(${lab} sub_rotation_by_momentum 2.5
  "0.5 * dt * now.m(i) / moments(i)" "0.5 * dt * now.m(i) + 0.0 * moments(i)" "m_i stands for omega_i")

# The same, at the end.
add_mutant(${lab} sub_rotation_returns_momentum 2.5
  "now.m.cwiseQuotient(moments)" "now.m + 0.0 * moments" "new m is returned as omega")

# An index is taken from the next axis.
add_mutant(${lab} sub_rotation_with_moment_of_another_axis 2.5
  "0.5 * dt * now.m(i) / moments(i)" "0.5 * dt * now.m(i) / moments(j)" "moment of another axis")

# The middle one is believed to be the short one.
add_mutant(${lab} splitting_with_times_swapped 2.5
  "now = sub_rotation<0>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, dt);
  now = sub_rotation<1>(moments, now, 0.5 * dt);
  now = sub_rotation<0>(moments, now, 0.5 * dt);"
  "now = sub_rotation<0>(moments, now, dt);
  now = sub_rotation<1>(moments, now, dt);
  now = sub_rotation<2>(moments, now, 0.5 * dt);
  now = sub_rotation<1>(moments, now, dt);
  now = sub_rotation<0>(moments, now, dt);" "dt and dt/2 are swapped")

# Two halves about the same axis are believed to be one whole.
add_mutant(${lab} splitting_with_middle_twice 2.5
  "now = sub_rotation<2>(moments, now, dt);"
  "now = sub_rotation<2>(moments, now, 0.5 * dt);
  now = sub_rotation<2>(moments, now, 0.5 * dt);" "axis 3 turns twice")

# ---- 2.6 ----

# Weight is believed to point along +z.
add_mutant(${lab} weight_points_up 2.6
  "Vec3(0.0, 0.0, -1.0)" "Vec3(0.0, 0.0, 1.0)" "the weight points down")

# Down is turned as if q led from the world to the body.
add_mutant(${lab} down_turned_backwards 2.6
  "world_from_body.conjugate() * Vec3" "world_from_body * Vec3" "the wrong way: use R^T")

# The torque is made in the world and used in the body.
add_mutant(${lab} torque_in_the_world 2.6
  "return top.weight_moment * Vec3::UnitZ().cross(down_body);"
  "return world_from_body * (top.weight_moment * Vec3::UnitZ().cross(down_body));"
  "torque is in the world")

# Each kick is made whole.
add_mutant(${lab} kicks_of_a_whole_step 2.6
  "0.5 * dt * torque" "dt * torque" "last dt/2")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} kicks_half_in_whole_numbers 2.6
  "0.5 * dt * torque" "1 / 2 * dt * torque" "1/2 is 0 in whole numbers")

# The torque is computed once a step.
add_mutant(${lab} second_kick_with_old_torque 2.6
  "Spin next = kicked(common::free_symmetric_step(top, kicked(spin), dt));"
  "Spin next = common::free_symmetric_step(top, kicked(spin), dt);
  next.angular_velocity_body +=
      0.5 * dt * weight_torque_body(top, spin.world_from_body).cwiseQuotient(moments);" "before the drift")

# A torque is taken for an angular acceleration.
add_mutant(${lab} kick_without_inertia 2.6
  "0.5 * dt * torque.cwiseQuotient(moments)" "0.5 * dt * torque + 0.0 * moments"
  "not divided by the moments")

# The arm is e_z of the world, as the weight is.
add_mutant(${lab} torque_of_a_vertical_arm 2.6
  "Vec3::UnitZ().cross(down_body);" "(0.0 * down_body + Vec3::UnitZ()).cross(Vec3(0.0, 0.0, -1.0));"
  "arm and weight are both vertical")

# One moment is believed to be enough for a symmetric body.
add_mutant(${lab} kick_by_axial_moment 2.6
  "0.5 * dt * torque.cwiseQuotient(moments)" "0.5 * dt * torque / moments.z()" "kick is divided by I3")

# All three parts are believed to last a half.
add_mutant(${lab} drift_of_half_a_step 2.6
  "common::free_symmetric_step(top, kicked(spin), dt)"
  "common::free_symmetric_step(top, kicked(spin), 0.5 * dt)" "drift lasts dt/2")

# ---- 2.7 ----

# The rate of a quaternion is believed to be omega q.
add_mutant(${lab} prediction_without_half 2.7
  "Quat(world_from_body.coeffs() + 0.5 * dt * rate.coeffs())"
  "Quat(world_from_body.coeffs() + dt * rate.coeffs())" "1/2 is missing")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} prediction_half_in_whole_numbers 2.7
  "Quat(world_from_body.coeffs() + 0.5 * dt * rate.coeffs())"
  "Quat(world_from_body.coeffs() + 1 / 2 * dt * rate.coeffs())" "1/2 is 0 in whole numbers")

# omega is taken for a body vector.
add_mutant(${lab} prediction_with_omega_on_the_right 2.7
  "const Quat rate = pure(angular_velocity) * world_from_body;"
  "const Quat rate = world_from_body * pure(angular_velocity);" "right of q")

# The inverse of a quaternion is taken for its projection.
add_mutant(${lab} projection_by_the_square 2.7
  "  Quat q(q_pred.coeffs() / greatest);  // a square neither over- nor underflows now
  q.normalize();"
  "  Quat q(q_pred.coeffs() / q_pred.squaredNorm());" "divided by |q|^2")

# The square of a long or a short quaternion is taken as it comes.
add_mutant(${lab} projection_underflows 2.7
  "  Quat q(q_pred.coeffs() / greatest);" "  Quat q(q_pred.coeffs());" "scale first")

# What is short is believed to have no direction.
add_mutant(${lab} projection_refuses_the_short 2.7
  "if (!(greatest > 0.0 &&" "if (!(greatest > 1e-3 &&" "only zero has no direction")

# The same, but of what is so short that its square underflows.
add_mutant(${lab} projection_refuses_the_very_short 2.7
  "if (!(greatest > 0.0 &&" "if (!(greatest > 1e-150 &&" "only zero has no direction")

# The prediction is believed to be good enough.
add_mutant(${lab} constrained_step_without_projection 2.7
  "project(predicted_attitude(state.world_from_body, next.angular_velocity, dt));"
  "predicted_attitude(state.world_from_body, next.angular_velocity, dt);" "not normalised")

# The positions are predicted with the velocities that were.
add_mutant(${lab} prediction_by_old_velocity 2.7
  "project(predicted_attitude(state.world_from_body, next.angular_velocity, dt));"
  "project(predicted_attitude(state.world_from_body, state.angular_velocity, dt));"
  "old velocities")

# The prediction is believed to be better if it is exact.
add_mutant(${lab} prediction_by_exponential 2.7
  "const Quat rate = pure(angular_velocity) * world_from_body;
  return Quat(world_from_body.coeffs() + 0.5 * dt * rate.coeffs());"
  "return common::exponential_map(dt * angular_velocity) * world_from_body;" "exponential map turns q")

# Of the two quaternions of an attitude the one with a positive real part is preferred.
add_mutant(${lab} projection_with_positive_real_part 2.7
  "  q.normalize();
  return q;" "  q.normalize();
  return q.w() < 0.0 ? Quat(-q.coeffs()) : q;" "sign of q_pred is changed")

# What has no direction is believed not to be turned.
add_mutant(${lab} projection_of_zero 2.7
  "throw std::invalid_argument(\"project: a quaternion that is zero or not finite\");"
  "return Quat::Identity();" "is not refused")

# ---- 2.8 ----

# The moments are corrected instead of their inverses.
add_mutant(${lab} moments_scaled_themselves 2.8
  "const Vec3 inverse = (1.0 + correction.scale) * moments.cwiseInverse();
  return (inverse + Vec3::Constant(correction.shift)).cwiseInverse();"
  "return (1.0 + correction.scale) * moments + Vec3::Constant(correction.shift);" "shift their inverses")

# The increment that belongs to the momentum at the end of the step.
add_mutant(${lab} increment_of_the_end 2.8
  "const Vec3 spread(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());"
  "const Vec3 spread(I.y() - I.z(), I.z() - I.x(), I.x() - I.y());" "end of the step")

# The products are taken for small.
add_mutant(${lab} increment_without_products 2.8
  "const Vec3 spread(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());"
  "const Vec3 spread = 0.0 * I;" "p_j p_k is missing")

# The half is believed to belong to the quaternion alone.
add_mutant(${lab} increment_of_whole_dt 2.8
  "const Vec3 half = 0.5 * dt * angular_momentum_body;" "const Vec3 half = dt * angular_momentum_body;"
  "or the half of dt m")

# A change must be below its bound, but at rest both are zero.
add_mutant(${lab} increment_never_at_rest 2.8
  "change.norm() <= 1e-10 * e.norm()" "change.norm() < 1e-10 * e.norm()" "stop by <=")

# Time is believed to run forwards.
add_mutant(${lab} increment_refuses_negative_dt 2.8
  "  const Vec3 half = 0.5 * dt * angular_momentum_body;"
  "  if (dt <= 0.0) throw std::domain_error(\"dt\");
  const Vec3 half = 0.5 * dt * angular_momentum_body;" "")

# The vector part alone is solved for, and taken for a unit quaternion.
add_mutant(${lab} increment_not_normalised 2.8
  "      p.normalize();
      return p;" "      return p;" "not normalised")

# The corrected moments are believed to replace the body's own everywhere.
add_mutant(${lab} momentum_of_corrected_moments 2.8
  "                                         momentum_body(moments, spin), dt);
  const Vec3 m = p.conjugate() * momentum_body(moments, spin);
  return {(spin.world_from_body * p).normalized(), m.cwiseQuotient(moments)};"
  "momentum_body(corrected_moments(moments, correction), spin), dt);
  const Vec3 tilde = corrected_moments(moments, correction);
  const Vec3 m = p.conjugate() * momentum_body(tilde, spin);
  return {(spin.world_from_body * p).normalized(), m.cwiseQuotient(tilde)};" "use the body's own")

# The square of the momentum is remembered without its half.
add_mutant(${lab} correction_without_halves 2.8
  "const double C = 0.5 * momentum_body(moments, spin).squaredNorm();"
  "const double C = momentum_body(moments, spin).squaredNorm();" "C lacks its factor")

# The step's square is forgotten.
add_mutant(${lab} correction_without_dt 2.8
  "return {dt * dt * (mixed * C" "return {dt * (mixed * C" "factor of scale is dt")

# The differences of moments are written in the order of the numbers, not of the cycle.
add_mutant(${lab} increment_with_difference_slipped 2.8
  "I.x() - I.z(), I.y() - I.x());" "I.z() - I.x(), I.y() - I.x());" "three differences")

# The second of the two numbers is believed to be needed for the speed about L alone.
add_mutant(${lab} moments_without_shift 2.8
  "(inverse + Vec3::Constant(correction.shift)).cwiseInverse()" "inverse.cwiseInverse()"
  "shift is left out")

# A third belongs to each of the three inverses.
add_mutant(${lab} correction_without_third 2.8
  "inverses * H / 3.0" "inverses * H" "a factor of eq. (26)")

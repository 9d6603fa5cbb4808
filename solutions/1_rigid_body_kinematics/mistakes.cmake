# The bank of mistakes: each is a misconception that students have, as a small edit of the reference.
# add_mutant(<lab> <mistake> <step> <find> <replace> <words its message must hold>)
set(lab rigid_body_kinematics)

# ---- 1.1 ----

# The matrix is filled by columns while it is read by rows.
add_mutant(${lab} skew_transposed 1.1 "return matrix;" "return matrix.transpose();" "of the transpose")

# Each component is remembered, but not that half of them are subtracted.
add_mutant(${lab} skew_without_signs 1.1
  "return matrix;" "return matrix.cwiseAbs();" "minus signs are missing")

# ---- 1.2 ----

# The quaternion is believed to lead from the world to the body.
add_mutant(${lab} point_turned_backwards 1.2
  "state.position + state.world_from_body * point_body"
  "state.position + state.world_from_body.conjugate() * point_body" "body from world")

# The body is turned about the world's origin instead of its own centre.
add_mutant(${lab} point_shifted_first 1.2
  "state.position + state.world_from_body * point_body"
  "state.world_from_body * (state.position + point_body)" "before the turn")

# A direction and a point are turned alike, so the shift is forgotten.
add_mutant(${lab} point_not_shifted 1.2
  "state.position + state.world_from_body * point_body" "state.world_from_body * point_body"
  "shift by the centre of mass is missing")

# The two steps are undone in the order in which they were made.
add_mutant(${lab} body_point_in_wrong_order 1.2
  "state.world_from_body.conjugate() * (point - state.position)"
  "state.world_from_body.conjugate() * point - state.position" "before the shift")

# The shift is undone, the turn is made once more.
add_mutant(${lab} body_point_turned_forwards 1.2
  "state.world_from_body.conjugate() * (point" "state.world_from_body * (point" "world from body")

# The factors of the cross product are swapped.
add_mutant(${lab} velocity_with_r_cross_omega 1.2
  "state.angular_velocity.cross(r)" "r.cross(state.angular_velocity)" "wrong way round: r x omega")

# Every point of the body is believed to turn about the world's origin.
add_mutant(${lab} velocity_about_the_origin 1.2
  "const Vec3 r = point - state.position;" "const Vec3 r = point;" "starts at the world's origin")

# The centre's velocity is believed to be that of every point.
add_mutant(${lab} velocity_without_spin 1.2
  "state.velocity + state.angular_velocity.cross(r)" "state.velocity + 0.0 * r" "omega x r is missing")

# omega is taken for a body vector, as engines that store it so do.
add_mutant(${lab} velocity_with_body_omega 1.2
  "state.angular_velocity.cross(r)" "(state.world_from_body * state.angular_velocity).cross(r)"
  "turned once more")

# ---- 1.3 ----

# The rule for the change of frame is remembered with the transpose on the wrong side.
add_mutant(${lab} inertia_turned_backwards 1.3
  "R * inertia_body * R.transpose()" "R.transpose() * inertia_body * R" "R^T I0 R")

# The inertia is computed once in the body frame and used in the world frame ever after.
add_mutant(${lab} inertia_not_turned 1.3
  "R * inertia_body * R.transpose()" "inertia_body + 0.0 * R" "used as the world's")

# A matrix is turned like a vector, from one side.
add_mutant(${lab} inertia_turned_once 1.3
  "R * inertia_body * R.transpose()" "R * inertia_body" "from one side only")

# The factors of the cross product are swapped.
add_mutant(${lab} torque_with_f_cross_r 1.3
  "r.cross(applied.force)" "applied.force.cross(r)" "wrong way round: f x r")

# The torque is summed about the world's origin.
add_mutant(${lab} torque_about_the_origin 1.3
  "applied.point - center_of_mass" "applied.point" "about the world's origin")

# The sum is overwritten in every turn of the loop.
add_mutant(${lab} last_torque_only 1.3
  "net.torque += r.cross" "net.torque = r.cross" "only the last force counts")

# The loop ends after its first turn, or one too early.
add_mutant(${lab} first_torque_only 1.3
  "net.torque += r.cross(applied.force);"
  "if (&applied == &forces.front()) net.torque += r.cross(applied.force);"
  "only the first force counts")
add_mutant(${lab} last_force_left_out 1.3
  "const Vec3 r = applied.point - center_of_mass;"
  "if (&applied == &forces.back()) continue;
    const Vec3 r = applied.point - center_of_mass;" "last force is left out")

# Small forces are taken for none.
add_mutant(${lab} small_forces_ignored 1.3
  "const Vec3 r = applied.point - center_of_mass;"
  "if (applied.force.norm() < 1e-6) continue;
    const Vec3 r = applied.point - center_of_mass;" "no force")

# ---- 1.4 ----

# omega is taken for a body vector: its matrix is put behind R.
add_mutant(${lab} matrix_step_in_body_frame 1.4
  "skew(dt * angular_velocity) * world_from_body" "world_from_body * skew(dt * angular_velocity)"
  "stands on the right")

# Slow spins are taken for none.
add_mutant(${lab} matrix_step_guard_too_wide 1.4
  "return world_from_body + skew(dt * angular_velocity) * world_from_body;"
  "if (angular_velocity.norm() < 1e-6) return world_from_body;
  return world_from_body + skew(dt * angular_velocity) * world_from_body;" "guard that is too wide")

# The derivative is returned instead of the next matrix.
add_mutant(${lab} matrix_step_without_start 1.4
  "return world_from_body + skew" "return skew" "R + is missing")

# The drift is hidden where it arises instead of being shown.
add_mutant(${lab} matrix_step_repaired 1.4
  "return world_from_body + skew(dt * angular_velocity) * world_from_body;"
  "return nearest_rotation(world_from_body + skew(dt * angular_velocity) * world_from_body);"
  "repaired already")

# The orthogonal factor is taken as it comes: it may be a mirror image.
add_mutant(${lab} nearest_may_reflect 1.4 "if (det < 0.0)" "if (det > 2.0)" "a reflection")

# The determinant is mended in the first column that comes to mind.
add_mutant(${lab} nearest_mends_the_greatest 1.4
  "U.col(2) = -U.col(2)" "U.col(0) = -U.col(0)" "greatest singular value is flipped")

# Any way to orthonormal columns is believed to give the nearest.
add_mutant(${lab} nearest_by_gram_schmidt 1.4 "return U * V.transpose();"
  "Mat3 Q = matrix;
  Q.col(0).normalize();
  Q.col(1) = (Q.col(1) - Q.col(0).dot(Q.col(1)) * Q.col(0)).normalized();
  Q.col(2) = Q.col(0).cross(Q.col(1));
  return Q;" "Gram-Schmidt")

# Unit columns are believed to be enough for a rotation.
add_mutant(${lab} nearest_by_unit_columns 1.4 "return U * V.transpose();"
  "return matrix.colwise().normalized();" "only the columns' lengths")

# ---- 1.5 ----

# The rate of a quaternion is believed to be omega q.
add_mutant(${lab} quaternion_step_without_half 1.5
  "0.5 * dt * rate.coeffs()" "dt * rate.coeffs()" "factor 1/2 is missing")

# omega is taken for a body vector: it is put behind q.
add_mutant(${lab} quaternion_step_in_body_frame 1.5
  "Quat(0.0, omega.x(), omega.y(), omega.z()) * world_from_body"
  "world_from_body * Quat(0.0, omega.x(), omega.y(), omega.z())" "stands on the right of q")

# One step hardly changes the length, so it is left as it is.
add_mutant(${lab} quaternion_not_normalised 1.5
  "next.normalize();" "" "not normalised")

# Division by zero is feared where none is.
add_mutant(${lab} quaternion_step_guard_too_wide 1.5
  "const Vec3& omega = angular_velocity;"
  "const Vec3& omega = angular_velocity;
  if (omega.norm() < 1e-6) return world_from_body;" "guard that is too wide")

# The step's length is forgotten.
add_mutant(${lab} quaternion_step_without_dt 1.5
  "0.5 * dt * rate.coeffs()" "0.5 * rate.coeffs()" "dt is missing")

# The order of Eigen's constructor (w, x, y, z) is mistaken for that of its coefficients.
add_mutant(${lab} quaternion_order_mixed_up 1.5
  "Quat(0.0, omega.x(), omega.y(), omega.z())" "Quat(omega.x(), omega.y(), omega.z(), 0.0)" "order")

# A vector of four is believed to be in the order of Eigen's constructor, (w, x, y, z).
add_mutant(${lab} quaternion_of_a_vector_mixed_up 1.5
  "Quat(0.0, omega.x(), omega.y(), omega.z())"
  "Quat(Eigen::Vector4d(0.0, omega.x(), omega.y(), omega.z()))" "a Vector4d for Quat is")

# Whole numbers are believed to be divided like any others.
add_mutant(${lab} quaternion_step_half_in_whole_numbers 1.5
  "0.5 * dt * rate.coeffs()" "1 / 2 * dt * rate.coeffs()" "1/2 is 0 in whole numbers")

# ---- 1.6 ----

# A quaternion is believed to hold the whole angle.
add_mutant(${lab} exponential_of_whole_angle 1.6 "0.5 * angle" "angle" "whole angle")

# A generous guard against the division by zero: small turns are lost.
add_mutant(${lab} exponential_guard_too_wide 1.6
  "if (angle == 0.0)" "if (angle < 1e-6)" "is too wide")

# No guard: 0/0.
add_mutant(${lab} exponential_nan_at_zero 1.6 "if (angle == 0.0) return Quat::Identity();" "" "")

# The plain norm squares: below 1e-154 nothing is left of the angle.
add_mutant(${lab} exponential_underflow 1.6 "std::hypot(a.x(), a.y(), a.z())" "a.norm()"
  "length underflows")

# The plain norm squares: from 1e155 on the angle is infinite.
add_mutant(${lab} exponential_overflow 1.6 "std::hypot(a.x(), a.y(), a.z())"
  "std::max(a.norm(), a.cwiseAbs().maxCoeff())" "")

# A generous guard in the step instead of the map: slow spins never turn.
add_mutant(${lab} exponential_step_guard_too_wide 1.6
  "return exponential_map(dt * angular_velocity) * world_from_body;"
  "if (dt * angular_velocity.norm() < 1e-8) return world_from_body;
  return exponential_map(dt * angular_velocity) * world_from_body;" "guard that is too wide")

# The series is cut after its linear term, as in step 1.5.
add_mutant(${lab} exponential_is_euler 1.6
  "return exponential_map(dt * angular_velocity) * world_from_body;"
  "return step_quaternion_euler(world_from_body, angular_velocity, dt);" "Euler step of 1.5")

# omega is taken for a body vector: the turn is put behind q.
add_mutant(${lab} exponential_in_body_frame 1.6
  "exponential_map(dt * angular_velocity) * world_from_body"
  "world_from_body * exponential_map(dt * angular_velocity)" "right of q")

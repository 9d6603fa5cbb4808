// Lab 1: you fill in this file and hand it in. The header beside it says what each function must
// do. README.md has the physics and the numbered equations. Test your file with:  ./tumble test 1
#include "rigid_body_kinematics.hpp"

#include "common/algebra/linear_algebra.hpp"
#include "common/course/not_implemented.hpp"

namespace lab::rigid_body_kinematics {

// ---- Step 1.1 ----

Mat3 skew(const Vec3& w) {
  // TODO step 1.1, eq. (1)
  // 1. Write w × u by components: each is a difference of two products.
  // 2. Row i of the matrix holds the factors of u.x, u.y and u.z in component i.
  throw common::NotImplemented("1.1 skew");
}

// ---- Step 1.2 ----

Vec3 world_point(const RigidBodyState& state, const Vec3& point_body) {
  // TODO step 1.2, eq. (2)
  // 1. Turn the point into the world frame.
  // 2. Then shift it by the centre of mass.
  throw common::NotImplemented("1.2 world_point");
}

Vec3 body_point(const RigidBodyState& state, const Vec3& point) {
  // TODO step 1.2, eq. (3)
  // 1. Undo the shift.
  // 2. Then undo the turn: for a unit quaternion the inverse is the conjugate.
  throw common::NotImplemented("1.2 body_point");
}

Vec3 point_velocity(const RigidBodyState& state, const Vec3& point) {
  // TODO step 1.2, eq. (4)
  // 1. Compute the lever arm, from the centre of mass to the point.
  // 2. Add the velocity that comes from the turning to the velocity of the centre of mass.
  throw common::NotImplemented("1.2 point_velocity");
}

// ---- Step 1.3 ----

Mat3 world_inertia(const Mat3& inertia_body, const Quat& world_from_body) {
  // TODO step 1.3, eq. (5)
  // 1. Take the rotation matrix R of the quaternion.
  // 2. Read R I0 Rᵀ from the right: world to body, inertia there, body to world.
  throw common::NotImplemented("1.3 world_inertia");
}

Wrench net_wrench(const Vec3& center_of_mass, const std::vector<AppliedForce>& forces) {
  // TODO step 1.3, eq. (6)
  // 1. Start with a default Wrench, which is zero.
  // 2. For each force add f to the force and (p − x) × f to the torque.
  throw common::NotImplemented("1.3 net_wrench");
}

// ---- Step 1.4 ----

Mat3 step_matrix_euler(const Mat3& world_from_body, const Vec3& angular_velocity, double dt) {
  // TODO step 1.4, eq. (7)
  // 1. The derivative is [ω]ₓ R: ω is a world vector, so its matrix is on the left.
  // 2. Add dt times the derivative. Do not repair the result here.
  throw common::NotImplemented("1.4 step_matrix_euler");
}

Mat3 nearest_rotation(const Mat3& matrix) {
  // TODO step 1.4, eq. (8)
  // 1. common::singular_values(matrix) gives U, S, V with matrix = U S Vᵀ, and throws on NaN.
  // 2. The nearest orthogonal matrix is U Vᵀ.
  // 3. If its determinant is −1, flip the direction of the least singular value.
  throw common::NotImplemented("1.4 nearest_rotation");
}

// ---- Step 1.5 ----

Quat step_quaternion_euler(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  // TODO step 1.5, eq. (9) and (10)
  // 1. Make ω a quaternion with real part 0. Quat's constructor takes (w, x, y, z).
  // 2. The derivative is half of ω q, in this order.
  // 3. Add dt times the derivative to q, coefficient by coefficient: q.coeffs().
  // 4. Normalise.
  throw common::NotImplemented("1.5 step_quaternion_euler");
}

// ---- Step 1.6 ----

Quat exponential_map(const Vec3& rotation_vector) {
  // TODO step 1.6, eq. (11)
  // 1. The angle is the length of the vector. std::hypot(x, y, z) neither under- nor overflows.
  // 2. If the angle is zero there is no axis: return the identity.
  // 3. Use half the angle in the quaternion.
  throw common::NotImplemented("1.6 exponential_map");
}

Quat step_exponential(const Quat& world_from_body, const Vec3& angular_velocity, double dt) {
  // TODO step 1.6, eq. (12)
  // 1. The rotation vector of this step is ω dt.
  // 2. ω is a world vector. On which side of q do you multiply its rotation?
  throw common::NotImplemented("1.6 step_exponential");
}

}  // namespace lab::rigid_body_kinematics

#pragma once

#include "codec.hpp"
#include "contract.hpp"
#include "rigid_body_kinematics.hpp"

namespace grading {

namespace student = lab::rigid_body_kinematics;

template <>
inline constexpr int fields_of<student::RigidBodyState> = 4;
template <>
inline constexpr int fields_of<student::AppliedForce> = 2;
template <>
inline constexpr int fields_of<student::Wrench> = 2;

/// The answers: a few numbers.
using LabContract = Contract<1U << 12, &student::skew, &student::world_point, &student::body_point,
                             &student::point_velocity, &student::world_inertia,
                             &student::net_wrench, &student::step_matrix_euler,
                             &student::nearest_rotation, &student::step_quaternion_euler,
                             &student::exponential_map, &student::step_exponential>;

}  // namespace grading

#pragma once

#include "codec.hpp"
#include "contract.hpp"
#include "gyroscopic_tumbling.hpp"

namespace grading {

namespace student = lab::gyroscopic_tumbling;

template <>
inline constexpr int fields_of<common::Spin> = 2;
template <>
inline constexpr int fields_of<common::HeavyTop> = 3;
template <>
inline constexpr int fields_of<common::MomentCorrection> = 2;
template <>
inline constexpr int fields_of<student::RigidBody> = 2;
template <>
inline constexpr int fields_of<student::RigidBodyState> = 4;
template <>
inline constexpr int fields_of<student::AppliedForce> = 2;
template <>
inline constexpr int fields_of<student::SpinRate> = 2;

/// The answers: a few numbers.
using LabContract =
    Contract<1U << 12, &student::checked_moments, &student::angular_acceleration,
             &student::rotational_energy, &student::angular_momentum, &student::step_explicit,
             &student::implicit_residual, &student::implicit_jacobian, &student::step_implicit,
             &student::spin_rate, &student::step_rk4, &student::step_about_axis,
             &student::step_splitting, &student::weight_torque_body, &student::step_kick_drift_kick,
             &student::predicted_attitude, &student::project, &student::step_constrained,
             &student::corrected_moments, &student::moser_veselov_increment,
             &student::step_moser_veselov, &student::fourth_order_correction>;

}  // namespace grading

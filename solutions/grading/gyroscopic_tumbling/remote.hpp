#pragma once

#include "codec.hpp"
#include "functions.hpp"

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
using LabContract = ContractOf<1U << 12>;

}  // namespace grading
